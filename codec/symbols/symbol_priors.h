// What symbols are like before anything is known of a mesh: learned from other meshes, and part of
// the format.
#ifndef CLERS_CODEC_SYMBOLS_SYMBOL_PRIORS_H
#define CLERS_CODEC_SYMBOLS_SYMBOL_PRIORS_H

#include <array>
#include <cstdint>

namespace clers::internal {

/// By valence of x (at most 15) * 4 + last symbol (S and E alike): the share of symbols below R, L,
/// S and E in 1/256. Where it is the default no mesh had the context.
inline constexpr std::array<std::uint8_t, 4> default_prior = {128, 205, 236, 246};
inline constexpr std::array<std::array<std::uint8_t, 4>, 64> symbol_priors = {{
    default_prior,        default_prior,        default_prior,      default_prior,
    default_prior,        default_prior,        {2, 145, 191, 230}, {2, 39, 73, 241},
    {17, 190, 202, 213},  {17, 100, 203, 237},  default_prior,      {37, 164, 196, 220},
    {68, 234, 239, 241},  {66, 166, 197, 209},  default_prior,      {128, 227, 234, 238},
    {85, 244, 247, 248},  {133, 242, 245, 246}, default_prior,      {102, 244, 247, 248},
    {159, 247, 249, 250}, {222, 251, 252, 253}, default_prior,      {205, 248, 251, 252},
    {160, 237, 239, 241}, {158, 251, 252, 254}, default_prior,      {205, 244, 246, 250},
    {214, 246, 248, 251}, {231, 250, 252, 254}, default_prior,      {212, 244, 246, 251},
    {184, 237, 241, 247}, {161, 245, 250, 253}, default_prior,      {218, 245, 248, 254},
    {178, 239, 242, 248}, {190, 247, 249, 253}, default_prior,      {196, 220, 234, 243},
    {164, 227, 232, 241}, {132, 241, 244, 250}, default_prior,      {165, 232, 234, 251},
    {161, 233, 234, 247}, {152, 245, 247, 254}, default_prior,      {151, 231, 241, 248},
    {146, 235, 241, 248}, {111, 240, 245, 250}, default_prior,      default_prior,
    {119, 233, 237, 249}, {101, 239, 243, 253}, default_prior,      default_prior,
    {155, 235, 240, 247}, {125, 247, 249, 253}, default_prior,      default_prior,
    {126, 239, 242, 247}, {80, 245, 247, 252},  default_prior,      {128, 185, 187, 203},
}};

}  // namespace clers::internal

#endif
