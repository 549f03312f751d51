// Names of other files in a glTF, and bytes that are part of it (RFC 2397).
#ifndef CLERS_CODEC_GLTF_URI_H
#define CLERS_CODEC_GLTF_URI_H

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clers::gltf {

/// "data:image/png;base64,": up to the bytes; none if a URI has no such bytes.
std::optional<std::string_view> data_head(std::string_view uri);
/// The bytes behind it; none if they are not base64.
std::optional<std::vector<std::byte>> data_bytes(std::string_view uri);
std::string base64(std::span<const std::byte> bytes);

/// The path that a URI is from where its glTF is, without escapes; none if it has a scheme, a host
/// or a query, or is no UTF-8.
std::optional<std::string> relative_path(std::string_view uri);
/// Whether a path leads to what is beside or below, and names a file.
bool leads_down(std::string_view path);

}  // namespace clers::gltf

#endif
