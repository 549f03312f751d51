// Why something failed: a named code, where, and what was expected.
#ifndef CLERS_CODEC_ERROR_H
#define CLERS_CODEC_ERROR_H

#include <cstdint>
#include <string>

#include <clers/topology/export.h>
#include <clers/topology/result.h>

namespace CLERS_VISIBLE clers {

/// Stable numbers: they are part of the API and of the tests of the format.
enum class ErrorCode : std::uint16_t {
  // The input mesh cannot be coded.
  inconsistent_mesh = 1,   ///< sizes of the arrays disagree, or an index is out of range
  duplicate_face = 2,      ///< a face on the same vertices as another
  degenerate_face = 3,     ///< a face that uses a vertex twice, or has fewer than three corners
  nonmanifold_edge = 4,    ///< an edge of more than two faces
  nonmanifold_vertex = 5,  ///< a vertex whose faces form more than one fan
  nonorientable = 6,       ///< an edge that two faces run along the same way: one is reversed, or
                           ///< their component has no consistent orientation
  too_large = 7,           ///< more elements than ids
  bad_option = 8,          ///< an option out of its range, memory of another size than needed, or
                           ///< an index of what is not there
  not_on_grid = 9,  ///< a value that no point of a grid is near: NaN, an infinity, or one that
                    ///< is too far away for the steps asked for
  // The bytes cannot be decoded.
  not_clers = 20,            ///< the magic number is missing
  unsupported_version = 21,  ///< made by another version of the format
  truncated = 22,            ///< the bytes end too early
  trailing_bytes = 23,       ///< bytes after the end
  corrupt = 24,              ///< a checksum does not match
  invalid = 25,              ///< a rule of the format is broken
  // A limit.
  limit = 40,          ///< the caller's limits do not allow this input
  out_of_memory = 41,  ///< allocation failed
  // Files.
  io_failed = 60,    ///< the system refused to read or write
  malformed = 61,    ///< a mesh file breaks the rules of its format
  unsupported = 62,  ///< a feature of a mesh, or of a mesh file, that is not supported here
  internal = 99,     ///< a fault of this library
};

/// The code's name, as in the enumeration.
const char* name(ErrorCode code);

/// What `Error::at` counts.
enum class Place : std::uint8_t { nowhere, byte, line, face, vertex, edge, mesh, symbol, corner };

/// Which field of Limits does not allow an input.
enum class Limited : std::uint8_t { nothing, meshes, vertices, faces, memory };

struct Error {
  ErrorCode code = ErrorCode::internal;
  Place place = Place::nowhere;
  std::uint64_t at = 0;  ///< byte offset, line (from 1), or element index
  std::string what;      ///< what is wrong and what was expected, one line, no full stop
  /// For ErrorCode::limit: the field of Limits to raise, and what it must be at least to get past
  /// this error. `nothing`: no field would help.
  Limited limited = Limited::nothing;
  std::uint64_t needed = 0;
};

/// One line for people: "face 17 has 4 corners, expected 3".
std::string describe(const Error& error);

template <class T>
using Expected = Result<T, Error>;

inline Failure<Error> fail(ErrorCode code, std::string what) {
  return {Error{code, Place::nowhere, 0, std::move(what), Limited::nothing, 0}};
}
inline Failure<Error> fail(ErrorCode code, Place place, std::uint64_t at, std::string what) {
  return {Error{code, place, at, std::move(what), Limited::nothing, 0}};
}

}  // namespace clers

#endif
