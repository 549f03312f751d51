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
      << ", \"draco_connectivity_bytes\": " << r.draco_connectivity << ", \"groups\": [";
  const char* separator = "";
  for (const std::string& group : groups_of(r)) {
    out << separator << Quoted{group};
    separator = ", ";
  }
  out << "]";
  if (r.failed()) {
    out << ", \"failed\": " << Quoted{r.trial.failure}
        << ", \"bytes\": null, \"bits_per_triangle\": null, \"bits_per_vertex\": null, "
           "\"encode_mtri_s\": null, \"decode_mtri_s\": null, \"peak_bytes_per_triangle\": null, "
           "\"same_mesh\": false}";
    return;
  }
  const double n = static_cast<double>(r.triangles);
  out << ", \"bytes\": " << r.trial.bytes << ", \"bits_per_triangle\": " << r.bits_per_triangle()
      << ", \"bits_per_vertex\": " << r.bits_per_vertex()
      << ", \"encode_mtri_s\": " << r.encode_mtri_s()
      << ", \"decode_mtri_s\": " << r.decode_mtri_s()
      << ", \"encode_mtri_s_median\": " << 1e-6 * n / r.encode.median
      << ", \"decode_mtri_s_median\": " << 1e-6 * n / r.decode.median
      << ", \"encode_mtri_s_best\": " << 1e-6 * n / r.encode.best
      << ", \"decode_mtri_s_best\": " << 1e-6 * n / r.decode.best
      << ", \"encode_samples\": " << r.encode.samples
      << ", \"decode_samples\": " << r.decode.samples
      << ", \"peak_bytes_per_triangle\": " << r.peak_bytes_per_triangle()
      << ", \"encode_peak_bytes_per_triangle\": " << double(r.trial.encode_peak) / n
      << ", \"decode_peak_bytes_per_triangle\": " << double(r.trial.decode_peak) / n
      << ", \"same_mesh\": " << (f.same() ? "true" : "false")
      << ", \"triangles_lost\": " << f.triangles_lost
      << ", \"triangles_added\": " << f.triangles_added
      << ", \"vertices_lost\": " << f.vertices_lost << ", \"vertices_added\": " << f.vertices_added
      << ", \"positions_off\": " << f.positions_off << "}";
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
