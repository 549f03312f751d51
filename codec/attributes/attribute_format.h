// What stands before the values of an attribute: its name, its type and how it is coded <-> bytes.
#ifndef CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_FORMAT_H
#define CLERS_CODEC_ATTRIBUTES_ATTRIBUTE_FORMAT_H

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "codec/attributes/prediction.h"
#include "codec/attributes/structure_format.h"
#include "codec/attributes/value_surface.h"
#include "codec/base/utf8.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/info.h"
#include "codec/mesh.h"
#include "codec/numbers/number_system.h"

namespace clers::internal {

/// How values are written. The numbers are the file format's.
enum class Coder : std::uint8_t {
  words = 0,    ///< the words that values are stored as, by planes (planes.h)
  planes = 1,   ///< all others write integers (lattice.h): by planes too,
  ordered = 2,  ///< by static shares, along the order of triangles (any level)
  sized = 3,    ///< positions by contexts of sizes (levels 5 to 9)
  mixed = 4,    ///< positions by experts, mixed (level 9)
  named = 5,    ///< anything else by contexts of sizes (levels 5 to 9)
  charts = 6,   ///< texture coordinates by the shape of the surface (levels 5 to 9)
  normals = 7,  ///< directions by formulas of the geometry (levels 5 to 9)
  weights = 8,  ///< parts of a whole (levels 5 to 9)
  joints = 9,   ///< tuples that neighbours have, too (levels 5 to 9)
  skin = 10,    ///< weights of joints that are known (levels 5 to 9)
};
inline constexpr unsigned coder_count = 11;

constexpr const char* name(Coder c) {
  constexpr const char* names[coder_count] = {"words",   "planes", "ordered", "sized",
                                              "mixed",   "named",  "charts",  "normals",
                                              "weights", "joints", "skin"};
  return names[static_cast<unsigned>(c)];
}

/// What stands for the number system of words.
inline constexpr char words_text[] = "words";

/// The number systems of all components: one, if they all have the same.
inline std::string in_words(const Numbers& numbers) {
  std::string all;
  bool same = true;
  const std::string first = describe(numbers, 0);
  for (std::size_t c = 0; c < numbers.systems.size(); ++c) {
    const std::string one = describe(numbers, c);
    same &= one == first;
    all += (c > 0 ? " | " : "") + one;
  }
  return same ? first : all;
}

struct AttributeHeader {
  Attribute attribute;        ///< without data
  StructureHeader structure;  ///< which elements have which values
  double error = 0;           ///< no value is further from what was encoded
  ErrorMeasure measure = ErrorMeasure::difference;
  Coder coder = Coder::words;
  bool narrow = true;                     ///< integers are std::int32_t
  Predictor predictor = Predictor::none;  ///< of words and planes
  std::uint64_t numbers_size = 0;         ///< of all but words: bytes of what follows the header,
                                          ///< before the integers
  std::size_t bytes = 0;                  ///< that the header takes

  /// How many values are coded, for so many elements.
  std::uint64_t values(std::uint64_t elements) const {
    return structure.any ? structure.values : elements;
  }
  /// How many come out, by index or expanded.
  std::uint64_t result_values(std::uint64_t elements) const {
    return structure.indexed ? structure.distinct : elements;
  }
  /// What values are coded as: those of corners with a structure along a surface of their own, as
  /// if they were of its vertices.
  Domain coded_domain() const {
    return structure.any && attribute.domain == Domain::corner ? Domain::vertex : attribute.domain;
  }

  bool in_planes() const { return coder == Coder::words || coder == Coder::planes; }
  /// Residuals can be read before there are faces.
  bool begins_without_faces() const { return coder <= Coder::ordered; }
};

/// Whether values of faces are predicted along a surface of their own (face_surface.h).
inline bool is_along_faces(const AttributeHeader& header) {
  return header.attribute.domain == Domain::face && header.coder == Coder::normals;
}

/// What must be decoded before values can be.
enum class Along : std::uint8_t { nothing, surface, twins };
inline Along along(const AttributeHeader& header) {
  if (header.attribute.domain == Domain::corner)
    return header.structure.any || header.coder >= Coder::named ? Along::twins : Along::nothing;
  if (is_along_faces(header)) return Along::twins;
  if (header.attribute.domain != Domain::vertex) return Along::nothing;
  if (header.in_planes())
    return header.predictor == Predictor::parallelogram || header.structure.any ? Along::surface
                                                                                : Along::nothing;
  return header.coder == Coder::ordered ? Along::surface : Along::twins;
}

/// Whether values are predicted from the positions of vertices, which must be decoded before.
inline bool needs_position(const AttributeHeader& header) {
  return header.coder == Coder::charts || header.coder == Coder::normals;
}

/// Whether an attribute of the first name has the joints that one of the second has the weights of.
inline bool are_joints_of(std::string_view joints, std::string_view weights) {
  constexpr std::string_view begin = "JOINTS_", other = "WEIGHTS_";
  return joints.substr(0, begin.size()) == begin && weights.substr(0, other.size()) == other &&
         joints.substr(begin.size()) == weights.substr(other.size());
}
/// Whether values are weights of joints, which must be decoded before.
inline bool needs_joints(const AttributeHeader& header) {
  return header.coder == Coder::skin;
}
/// Whether these may be those joints: without a structure, as weights are then.
inline bool may_be_joints_of(const AttributeHeader& joints, const AttributeHeader& weights) {
  return joints.attribute.domain == Domain::vertex && !joints.structure.any &&
         joints.structure.at_places == weights.structure.at_places &&
         are_joints_of(joints.attribute.name, weights.attribute.name);
}

/// What a report says of it, by the header alone.
inline AttributeInfo info_of(const AttributeHeader& header) {
  const Attribute& a = header.attribute;
  AttributeInfo info{a.name, a.domain, a.scalar, a.components};
  info.coder = name(header.coder);
  info.structure = header.structure.in_words(a.domain);
  info.error = header.error;
  info.measure = header.measure;
  return info;
}

/// The surface that so many values are predicted along: where it has the corners of all values, or
/// their vertices.
inline ValueSurface surface_of(const AttributeHeader& header, std::size_t count,
                               const ValueSurface& along) {
  const Domain domain = header.coded_domain();
  const bool on_surface = domain == Domain::vertex ||
                          (domain == Domain::corner && along.surface.corners.size() == count);
  return on_surface ? along : ValueSurface{};
}

inline void put_attribute_header(Bytes& out, const AttributeHeader& header) {
  const Attribute& a = header.attribute;
  put_u8(out, static_cast<std::uint32_t>(a.name.size()));
  put_bytes(out, std::as_bytes(std::span(a.name)));
  put_u8(out, static_cast<std::uint32_t>(a.domain) | header.structure.bits());
  put_u8(out, static_cast<std::uint32_t>(a.scalar));
  put_u8(out, a.components);
  put_u8(out, static_cast<std::uint32_t>(header.coder) | (header.narrow ? 0 : 0x40) |
                  (header.measure == ErrorMeasure::angle ? 0x20 : 0) |
                  (header.error > 0 ? 0x80 : 0));
  if (header.error > 0) {
    const std::uint64_t error = std::bit_cast<std::uint64_t>(header.error);
    put_u32(out, static_cast<std::uint32_t>(error));
    put_u32(out, static_cast<std::uint32_t>(error >> 32));
  }
  header.structure.put(out);
  if (header.in_planes()) put_u8(out, static_cast<std::uint32_t>(header.predictor));
  if (header.coder != Coder::words) put_varint(out, header.numbers_size);
}

/// Reads and checks what put_attribute_header wrote. `at` is the offset of `bytes` in the file, for
/// errors: truncated, invalid.
inline Expected<AttributeHeader> read_attribute_header(std::span<const std::byte> bytes,
                                                       std::uint64_t at) {
  ByteReader in(bytes, at);
  AttributeHeader header;
  const auto name = in.take(in.u8());
  const std::uint32_t kind = in.u8(), domain = kind & 3, scalar = in.u8(), components = in.u8(),
                      how = in.u8();
  const bool changed = how & 0x80, by_angle = how & 0x20;
  if (changed) {
    const std::uint64_t low = in.u32(), high = in.u32();
    header.error = std::bit_cast<double>(low | high << 32);
  }
  header.structure.read(in, kind);
  const std::uint32_t coder = how & 0x1f;
  const std::uint32_t predictor = coder <= static_cast<std::uint32_t>(Coder::planes) ? in.u8() : 0;
  if (coder != static_cast<std::uint32_t>(Coder::words)) header.numbers_size = in.varint();
  if (header.numbers_size > in.left()) in.take(header.numbers_size);  // fails
  if (!in.ok()) return Failure{in.error()};
  const auto invalid = [&](const char* what, std::uint32_t value) {
    return fail(ErrorCode::invalid, Place::byte, at,
                "an attribute with " + std::string(what) + " " + std::to_string(value));
  };
  if (domain > static_cast<std::uint32_t>(Domain::face)) return invalid("domain", domain);
  if (std::string fault = header.structure.fault(static_cast<Domain>(domain), kind); !fault.empty())
    return fail(ErrorCode::invalid, Place::byte, at, std::move(fault));
  if (scalar >= scalar_count) return invalid("scalar type", scalar);
  if (components == 0) return invalid("components", components);
  if (coder >= coder_count) return invalid("coder", coder);
  const bool for_positions = coder == static_cast<std::uint32_t>(Coder::sized) ||
                             coder == static_cast<std::uint32_t>(Coder::mixed);
  if (for_positions && (components != 3 || header.structure.any ||
                        domain != static_cast<std::uint32_t>(Domain::vertex)))
    return fail(ErrorCode::invalid, Place::byte, at,
                "a coder of positions, which must be three components of vertices");
  const bool of_corners = domain == static_cast<std::uint32_t>(Domain::corner);
  if (coder == static_cast<std::uint32_t>(Coder::normals) &&
      (components != 3 ||
       (header.structure.any && domain == static_cast<std::uint32_t>(Domain::face)) ||
       (of_corners && !header.structure.any)))
    return fail(ErrorCode::invalid, Place::byte, at,
                "a coder of normals, which must be three components along a surface");
  if (coder == static_cast<std::uint32_t>(Coder::charts) &&
      (components < 2 || domain == static_cast<std::uint32_t>(Domain::face) ||
       (of_corners && !header.structure.any)))
    return fail(ErrorCode::invalid, Place::byte, at,
                "a coder of charts, which must be along a surface");
  if (coder == static_cast<std::uint32_t>(Coder::skin) &&
      (header.structure.any || domain != static_cast<std::uint32_t>(Domain::vertex)))
    return fail(ErrorCode::invalid, Place::byte, at,
                "a coder of weights of joints, which must be of vertices");
  if (changed && !(header.error > 0 && std::isfinite(header.error)))
    return fail(ErrorCode::invalid, Place::byte, at, "an attribute with an error that is none");
  if (by_angle && (!changed || components != 3))
    return fail(ErrorCode::invalid, Place::byte, at, "an attribute with an angle that is none");
  if (predictor > static_cast<std::uint32_t>(Predictor::parallelogram) ||
      (predictor == static_cast<std::uint32_t>(Predictor::parallelogram) &&
       (header.structure.any ? domain == static_cast<std::uint32_t>(Domain::face)
                             : domain != static_cast<std::uint32_t>(Domain::vertex))))
    return invalid("predictor", predictor);
  header.attribute.name.assign(reinterpret_cast<const char*>(name.data()), name.size());
  if (const std::size_t i = first_not_utf8(header.attribute.name); i < name.size())
    return fail(ErrorCode::invalid, Place::byte, at + 1 + i, "the name is not UTF-8 from here");
  header.attribute.domain = static_cast<Domain>(domain);
  header.attribute.scalar = static_cast<Scalar>(scalar);
  header.attribute.components = static_cast<std::uint8_t>(components);
  header.coder = static_cast<Coder>(coder);
  header.narrow = (how & 0x40) == 0;
  header.measure = by_angle ? ErrorMeasure::angle : ErrorMeasure::difference;
  if (header.coder == Coder::words && !header.narrow) return invalid("coder", how);
  header.predictor = static_cast<Predictor>(predictor);
  header.bytes = in.position();
  return header;
}

}  // namespace clers::internal

#endif
