// What the tests of files share: bytes from text, attributes from values, equality.
#ifndef CLERS_CODEC_IO_TEST_MESHES_H
#define CLERS_CODEC_IO_TEST_MESHES_H

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

#include "codec/io/io.h"

namespace clers::io {

inline std::vector<std::byte> bytes_of(std::string_view text) {
  const auto* from = reinterpret_cast<const std::byte*>(text.data());
  return {from, from + text.size()};
}

inline std::string text_of(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

template <class T>
Attribute attribute(std::string name, Domain domain, unsigned components,
                    const std::vector<T>& values) {
  Attribute a{std::move(name), domain, scalar_of<T>(), static_cast<std::uint8_t>(components), {}};
  a.data.resize(values.size() * sizeof(T));
  if (!values.empty()) std::memcpy(a.data.data(), values.data(), a.data.size());
  return a;
}

template <class T>
std::vector<T> values_of(const Attribute& a) {
  EXPECT_EQ(a.scalar, scalar_of<T>()) << a.name;
  std::vector<T> values(a.data.size() / sizeof(T));
  if (!values.empty()) std::memcpy(values.data(), a.data.data(), values.size() * sizeof(T));
  return values;
}

/// The attribute with a value for each element, zeros where one is missing.
inline Attribute by_element(Attribute a) {
  if (a.indices.empty()) return a;
  const std::vector<std::byte> values = std::move(a.data);
  a.data.assign(a.indices.size() * a.stride(), std::byte{0});
  for (std::size_t i = 0; i < a.indices.size(); ++i)
    if (a.indices[i] != no_value)
      std::memcpy(a.data.data() + i * a.stride(), values.data() + a.indices[i] * a.stride(),
                  a.stride());
  a.indices = {};
  return a;
}

/// The named attribute, which must be there.
inline const Attribute& get(const Mesh& mesh, std::string_view name, Domain domain) {
  static const Attribute none;
  for (const Attribute& a : mesh.attributes)
    if (a.name == name && a.domain == domain) return a;
  ADD_FAILURE() << "no attribute " << name;
  return none;
}

/// Reads a file that must be right.
inline ReadResult must_read(const std::vector<std::byte>& file, Format format) {
  Expected<ReadResult> result = read(file, format);
  if (result && result->meshes.size() == 1) return std::move(*result);
  ADD_FAILURE() << (result ? "not one mesh" : describe(result.error()));
  Mesh none;  // of which a test can ask for positions
  none.attributes = {Attribute{position_name, Domain::vertex, Scalar::float32, 3, {}}};
  return {{none}, {}};
}
inline ReadResult must_read(std::string_view file, Format format) {
  return must_read(bytes_of(file), format);
}

inline WriteResult must_write(const Mesh& mesh, Format format,
                              std::optional<Encoding> encoding = std::nullopt) {
  Expected<WriteResult> result = write({&mesh, 1}, format, encoding);
  if (result) return std::move(*result);
  ADD_FAILURE() << describe(result.error());
  return {};
}

/// Whether some note holds this text.
inline bool notes_say(const Notes& notes, std::string_view text) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const Note& note) { return note.text.find(text) != std::string::npos; });
}

/// "none" if there is no such entry.
inline std::string metadata_of(const Mesh& mesh, std::string_view key) {
  for (const MetadataEntry& e : mesh.metadata)
    if (e.key == key) return e.value;
  return "none";
}

/// Equal in all but the order in which attributes of vertices and others alternate, and in what
/// shares values.
inline ::testing::AssertionResult same(const Mesh& a, const Mesh& b) {
  const auto differ = [](auto&&... what) {
    ::testing::AssertionResult result = ::testing::AssertionFailure();
    (result << ... << what);
    return result;
  };
  if (a.vertex_count != b.vertex_count)
    return differ(a.vertex_count, " and ", b.vertex_count, " vertices");
  if (a.corners != b.corners) return differ("corners differ");
  if (a.face_sizes != b.face_sizes) return differ("face sizes differ");
  if (a.name != b.name) return differ("names '", a.name, "' and '", b.name, "'");
  if (a.attributes.size() != b.attributes.size())
    return differ(a.attributes.size(), " and ", b.attributes.size(), " attributes");
  std::vector<const Attribute*> of_a, of_b;
  for (const Attribute& x : a.attributes) of_a.push_back(&x);
  for (const Attribute& x : b.attributes) of_b.push_back(&x);
  for (auto* list : {&of_a, &of_b})
    std::stable_partition(list->begin(), list->end(),
                          [](const Attribute* x) { return x->domain == Domain::vertex; });
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    const Attribute &x = *of_a[i], &y = *of_b[i];
    if (x.name != y.name || x.domain != y.domain || x.scalar != y.scalar ||
        x.components != y.components)
      return differ("attribute ", i, ": '", x.name, "' and '", y.name, "' are of different kinds");
    const std::size_t elements = std::max(x.indices.size(), y.indices.size());
    const auto missing = [](const Attribute& z, std::size_t element) {
      return !z.indices.empty() && z.indices[element] == no_value;
    };
    for (std::size_t e = 0; e < elements; ++e)
      if (missing(x, e) != missing(y, e)) return differ("'", x.name, "' lacks other values");
    if (by_element(x).data != by_element(y).data) return differ("values of '", x.name, "' differ");
  }
  return ::testing::AssertionSuccess();
}

}  // namespace clers::io

#endif
