// The rows of one mesh in one mode.
#include <ostream>

#include "bench/result.h"
#include "bench/text.h"

namespace clers::bench {
namespace {

const Result* find(const std::vector<Result>& rows, const std::string& codec) {
  for (const Result& r : rows)
    if (r.codec == codec && !r.failed()) return &r;
  return nullptr;
}

// As a multiple of the reference; a dash where one of them has no such figure.
std::string ratio(const Result& r, const Result* reference, double (*of)(const Result&)) {
  const double a = of(r), b = reference ? of(*reference) : 0;
  return a > 0 && b > 0 ? format("%7.3f", a / b) : std::string("      -");
}

std::string describe(const Fidelity& f) {
  if (f.same()) return "yes";
  std::string text = "no:";
  const auto add = [&](std::uint64_t n, const char* what) {
    if (n) text.append(" ").append(std::to_string(n)).append(" ").append(what).append(",");
  };
  add(f.triangles_lost, "triangles lost");
  add(f.triangles_added, "triangles added");
  add(f.vertices_lost, "vertices lost");
  add(f.vertices_added, "vertices duplicated");
  add(f.positions_off, "positions off");
  text.pop_back();
  return text;
}

}  // namespace

void print_rows(std::ostream& out, const Setting& setting, const std::vector<Result>& rows) {
  if (rows.empty()) return;
  const Result& first = rows.front();
  const std::vector<std::string> names = references(first.mode);
  const Result* fast = find(rows, names[0]);
  const Result* small = find(rows, names[1]);

  out << "\n"
      << first.mesh << ", " << name(first.mode) << ": " << first.triangles << " triangles, "
      << first.vertices << " vertices" << (first.fanned ? ", polygons fanned" : "")
      << (first.manifold ? "" : ", not manifold") << "; class " << first.family << "; "
      << setting.rivals() << "\n";
  const std::string fast_short = short_name(names[0]), small_short = short_name(names[1]);
  out << format("%-27s %10s %8s %8s %8s %8s %8s %7s |%7s |%7s %7s |%7s %7s  %s\n", "", "bytes",
                "bit/tri", "bit/vtx", "of them", "enc Mt/s", "dec Mt/s", "B/tri",
                "size:", "enc:", "enc:", "dec:", "dec:", "same mesh");
  out << format("%-27s %10s %8s %8s %8s %8s %8s %7s |%7.7s |%7.7s %7.7s |%7.7s %7.7s\n", "", "", "",
                "", "position", "", "", "peak", small_short.c_str(), fast_short.c_str(),
                small_short.c_str(), fast_short.c_str(), small_short.c_str());
  for (const Result& r : rows) {
    if (r.failed()) {
      out << format("%-27s fails: ", r.codec.c_str()) << r.trial.failure << "\n";
      continue;
    }
    const auto figure = [](bool known, const char* pattern, double value) {
      return known ? format(pattern, value) : std::string("       -");
    };
    out << format("%-27s %10llu %8.3f %8.3f ", r.codec.c_str(),
                  static_cast<unsigned long long>(r.trial.bytes), r.bits_per_triangle(),
                  r.bits_per_vertex())
        << figure(r.trial.position_bytes, "%8.3f", r.position_bits_per_vertex())
        << figure(r.timed, " %8.2f", r.encode_mtri_s())
        << figure(r.timed, " %8.2f", r.decode_mtri_s())
        << figure(r.timed, " %7.1f", r.peak_bytes_per_triangle()) << " |"
        << ratio(r, small, size_of_file) << " |" << ratio(r, fast, encode_speed) << " "
        << ratio(r, small, encode_speed) << " |" << ratio(r, fast, decode_speed) << " "
        << ratio(r, small, decode_speed) << "  " << describe(r.trial.fidelity) << "\n";
  }
  out.flush();
}

}  // namespace clers::bench
