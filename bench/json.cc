#include <cmath>
#include <iomanip>
#include <ostream>

#include "bench/result.h"

namespace clers::bench {
namespace {

struct Quoted {
  const std::string& text;
};

std::ostream& operator<<(std::ostream& out, const Quoted& quoted) {
  out << '"';
  for (const char c : quoted.text) {
    if (c == '"' || c == '\\') {
      out << '\\' << c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out << ' ';
    } else {
      out << c;
    }
  }
  return out << '"';
}

void write_result(std::ostream& out, const Result& r) {
  const Fidelity& f = r.trial.fidelity;
  out << "{\"mesh\": " << Quoted{r.mesh} << ", \"class\": " << Quoted{r.family}
      << ", \"codec\": " << Quoted{r.codec} << ", \"mode\": \"" << name(r.mode)
      << "\", \"triangles\": " << r.triangles << ", \"vertices\": " << r.vertices
      << ", \"manifold\": " << (r.manifold ? "true" : "false")
      << ", \"fanned\": " << (r.fanned ? "true" : "false")
      << ", \"corner_values\": " << (r.corner_values ? "true" : "false")
      << ", \"draco_connectivity_bytes\": " << r.draco_connectivity << ", \"groups\": [";
  const char* separator = "";
  for (const std::string& group : groups_of(r)) {
    out << separator << Quoted{group};
    separator = ", ";
  }
  out << "]";
  // What is not known is null, so that every result has every key.
  const auto put = [&](const char* key, bool known, auto value) {
    out << ", \"" << key << "\": ";
    if (known) {
      out << value;
    } else {
      out << "null";
    }
  };
  const bool done = !r.failed(), timed = done && r.timed;
  const double n = static_cast<double>(r.triangles);
  if (!done) out << ", \"failed\": " << Quoted{r.trial.failure};
  put("bytes", done, r.trial.bytes);
  put("position_bytes", done && r.trial.position_bytes, r.trial.position_bytes);
  put("bits_per_triangle", done, r.bits_per_triangle());
  put("bits_per_vertex", done, r.bits_per_vertex());
  put("encode_mtri_s", timed, r.encode_mtri_s());
  put("decode_mtri_s", timed, r.decode_mtri_s());
  put("encode_mtri_s_median", timed, 1e-6 * n / r.encode.median);
  put("decode_mtri_s_median", timed, 1e-6 * n / r.decode.median);
  put("encode_mtri_s_best", timed, 1e-6 * n / r.encode.best);
  put("decode_mtri_s_best", timed, 1e-6 * n / r.decode.best);
  put("encode_samples", timed, r.encode.samples);
  put("decode_samples", timed, r.decode.samples);
  put("peak_bytes_per_triangle", timed, r.peak_bytes_per_triangle());
  put("encode_peak_bytes_per_triangle", timed, double(r.trial.encode_peak) / n);
  put("decode_peak_bytes_per_triangle", timed, double(r.trial.decode_peak) / n);
  put("same_mesh", true, done && f.same() ? "true" : "false");
  put("triangles_lost", done, f.triangles_lost);
  put("triangles_added", done, f.triangles_added);
  put("vertices_lost", done, f.vertices_lost);
  put("vertices_added", done, f.vertices_added);
  put("positions_off", done, f.positions_off);
  out << "}";
}

}  // namespace

void write_json(std::ostream& out, const Setting& s, const std::vector<Result>& results) {
  out << std::setprecision(6);
  out << "{\n\"machine\": " << Quoted{s.machine} << ",\n\"system\": " << Quoted{s.system}
      << ",\n\"compiler\": " << Quoted{s.compiler} << ",\n\"flags\": " << Quoted{s.flags}
      << ",\n\"versions\": {";
  const char* separator = "";
  for (const auto& [what, version] : s.versions) {
    out << separator << Quoted{what} << ": " << Quoted{version};
    separator = ", ";
  }
  out << "},\n\"passes\": " << s.passes << ",\n\"repeats\": " << s.sampling.repeats
      << ",\n\"results\": [";
  separator = "\n";
  for (const Result& r : results) {
    out << separator;
    write_result(out, r);
    separator = ",\n";
  }
  out << "\n]\n}\n";
}

}  // namespace clers::bench
