// Values of vertices of any type as numbers, for what averages them.
#ifndef CLERS_CODEC_CLI_VERTEX_VALUES_H
#define CLERS_CODEC_CLI_VERTEX_VALUES_H

#include <array>
#include <cstddef>

#include "codec/mesh.h"
#include "codec/scalar.h"

namespace clers::cli {

double load(Scalar scalar, const std::byte* at);
/// The first three components of value i, of which there are three or more.
std::array<double, 3> load_three(const Attribute& attribute, std::size_t i);
/// Rounded to what the type can hold: out of range is the end of it.
void store(Scalar scalar, double x, std::byte* at);

}  // namespace clers::cli

#endif
