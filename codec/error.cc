// Names of codes, and errors as sentences.
#include "codec/error.h"

namespace CLERS_VISIBLE clers {

const char* name(ErrorCode code) {
  switch (code) {
    case ErrorCode::inconsistent_mesh: return "inconsistent_mesh";
    case ErrorCode::duplicate_face: return "duplicate_face";
    case ErrorCode::degenerate_face: return "degenerate_face";
    case ErrorCode::nonmanifold_edge: return "nonmanifold_edge";
    case ErrorCode::nonmanifold_vertex: return "nonmanifold_vertex";
    case ErrorCode::nonorientable: return "nonorientable";
    case ErrorCode::too_large: return "too_large";
    case ErrorCode::bad_option: return "bad_option";
    case ErrorCode::not_on_grid: return "not_on_grid";
    case ErrorCode::not_clers: return "not_clers";
    case ErrorCode::unsupported_version: return "unsupported_version";
    case ErrorCode::truncated: return "truncated";
    case ErrorCode::trailing_bytes: return "trailing_bytes";
    case ErrorCode::corrupt: return "corrupt";
    case ErrorCode::invalid: return "invalid";
    case ErrorCode::limit: return "limit";
    case ErrorCode::out_of_memory: return "out_of_memory";
    case ErrorCode::io_failed: return "io_failed";
    case ErrorCode::malformed: return "malformed";
    case ErrorCode::unsupported: return "unsupported";
    case ErrorCode::internal: return "internal";
  }
  return "unknown";
}

std::string describe(const Error& error) {
  static constexpr const char* places[] = {"",      "byte ", "line ",   "face ",  "vertex ",
                                           "edge ", "mesh ", "symbol ", "corner "};
  if (error.place == Place::nowhere) return error.what;
  return places[static_cast<unsigned>(error.place)] + std::to_string(error.at) + ": " + error.what;
}

}  // namespace clers
