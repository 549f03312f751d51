#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <ostream>
#include <set>

#include "bench/result.h"

namespace clers::bench {
namespace {

// The two rivals that ratios are taken to.
struct References {
  const char* fast;
  const char* small;
};
References references(Mode mode) {
  if (mode == Mode::connectivity) return {"draco-standard", "draco-valence"};
  return {"draco-cl7", "draco-cl10"};
}

const Result* find(const std::vector<Result>& rows, const std::string& codec) {
  for (const Result& r : rows)
    if (r.codec == codec && !r.failed()) return &r;
  return nullptr;
}

template <class... T>
std::string format(const char* pattern, T... values) {
  char line[256];
  std::snprintf(line, sizeof line, pattern, values...);
  return line;
}

std::string ratio(double a, const Result* reference,
                  const std::function<double(const Result&)>& of) {
  return reference ? format("%7.3f", a / of(*reference)) : std::string("      -");
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

// A set of meshes to take the mean over.
struct Group {
  std::string name;
  std::function<bool(const Result&)> has;
};

bool is_plant(const Result& r) {
  return r.mesh.rfind("many-components-plant", 0) == 0;
}

// Scans, isosurfaces and a TIN that no predictor of connectivity gets much out of.
bool is_irregular(const Result& r) {
  for (const char* part : {"bunny", "igea", "horse", "pizza", "boot", "rocker", "st-helens",
                           "teeth", "armadillo", "turbine"})
    if (r.mesh.find(part) != std::string::npos) return r.manifold;
  return false;
}

std::vector<Group> groups_of(const std::vector<Result>& results) {
  std::vector<Group> groups = {
      {"manifold", [](const Result& r) { return r.manifold; }},
      {"no plant", [](const Result& r) { return r.manifold && !is_plant(r); }},
      {"irregular", is_irregular},
  };
  std::set<std::string> families;
  for (const Result& r : results) families.insert(r.family);
  for (const std::string& family : families)
    groups.push_back({family, [family](const Result& r) { return r.family == family; }});
  return groups;
}

using Index = std::map<std::pair<std::string, std::string>, const Result*>;  // (mesh, codec)

void print_mean_table(std::ostream& out, const std::string& title, const std::string& reference,
                      const std::vector<std::string>& codecs, const std::vector<Group>& groups,
                      const Index& index, const std::function<double(const Result&)>& of) {
  out << "\n" << title << " " << reference << ": geometric means (meshes)\n";
  out << format("%-24s", "");
  for (const Group& g : groups) out << format(" %14s", g.name.c_str());
  out << "\n";
  for (const std::string& codec : codecs) {
    out << format("%-24s", codec.c_str());
    for (const Group& g : groups) {
      double sum = 0;
      int count = 0;
      for (const auto& [key, r] : index) {
        const auto base = index.find({key.first, reference});
        // Below 500 bytes headers decide, not coding.
        if (key.second != codec || !g.has(*r) || base == index.end() ||
            base->second->trial.bytes < 500)
          continue;
        sum += std::log(of(*r) / of(*base->second));
        ++count;
      }
      out << (count ? format(" %9.3f (%2d)", std::exp(sum / count), count) : format(" %14s", "-"));
    }
    out << "\n";
  }
}

}  // namespace

double Result::peak_bytes_per_triangle() const {
  return double(std::max(trial.encode_peak, trial.decode_peak)) / double(triangles);
}

void print_rows(std::ostream& out, const std::vector<Result>& rows) {
  if (rows.empty()) return;
  const Result& first = rows.front();
  const References names = references(first.mode);
  const Result* fast = find(rows, names.fast);
  const Result* small = find(rows, names.small);
  const auto size = [](const Result& r) { return double(r.trial.bytes); };
  const auto decode = [](const Result& r) { return r.decode_mtri_s(); };
  const auto encode = [](const Result& r) { return r.encode_mtri_s(); };

  out << "\n"
      << first.mesh << ", " << name(first.mode) << ": " << first.triangles << " triangles, "
      << first.vertices << " vertices" << (first.fanned ? ", polygons fanned" : "")
      << (first.manifold ? "" : ", not manifold") << "\n";
  out << format("%-24s %10s %8s %8s %8s %8s %7s |%7s |%7s %7s |%7s %7s  %s\n", "", "bytes",
                "bit/tri", "bit/vtx", "enc Mt/s", "dec Mt/s", "B/tri",
                "size:", "enc:", "enc:", "dec:", "dec:", "same mesh");
  const std::string fast_short = std::string(names.fast).substr(6),
                    small_short = std::string(names.small).substr(6);
  out << format("%-24s %10s %8s %8s %8s %8s %7s |%7s |%7.7s %7s |%7.7s %7s\n", "", "", "", "", "",
                "", "peak", small_short.c_str(), fast_short.c_str(), small_short.c_str(),
                fast_short.c_str(), small_short.c_str());
  for (const Result& r : rows) {
    if (r.failed()) {
      out << format("%-24s fails: ", r.codec.c_str()) << r.trial.failure << "\n";
      continue;
    }
    out << format("%-24s %10llu %8.3f %8.3f %8.2f %8.2f %7.1f |", r.codec.c_str(),
                  static_cast<unsigned long long>(r.trial.bytes), r.bits_per_triangle(),
                  r.bits_per_vertex(), r.encode_mtri_s(), r.decode_mtri_s(),
                  r.peak_bytes_per_triangle())
        << ratio(size(r), small, size) << " |" << ratio(encode(r), fast, encode) << " "
        << ratio(encode(r), small, encode) << " |" << ratio(decode(r), fast, decode) << " "
        << ratio(decode(r), small, decode) << "  " << describe(r.trial.fidelity) << "\n";
  }
  out.flush();
}

void print_means(std::ostream& out, const std::vector<Result>& results) {
  for (const Mode mode : all_modes) {
    Index index;
    std::vector<std::string> codecs;
    std::vector<Result> of_mode;
    for (const Result& r : results) {
      if (r.mode != mode) continue;
      if (std::find(codecs.begin(), codecs.end(), r.codec) == codecs.end())
        codecs.push_back(r.codec);
      of_mode.push_back(r);
    }
    for (const Result& r : of_mode)
      if (!r.failed()) index[{r.mesh, r.codec}] = &r;
    if (index.empty()) continue;
    const std::vector<Group> groups = groups_of(of_mode);
    const References names = references(mode);
    out << "\n==== " << name(mode) << " ====\n";
    for (const char* reference : {names.fast, names.small}) {
      print_mean_table(out, "bytes, of", reference, codecs, groups, index,
                       [](const Result& r) { return double(r.trial.bytes); });
      print_mean_table(out, "encode speed, over", reference, codecs, groups, index,
                       [](const Result& r) { return r.encode_mtri_s(); });
      print_mean_table(out, "decode speed, over", reference, codecs, groups, index,
                       [](const Result& r) { return r.decode_mtri_s(); });
    }
  }
  out.flush();
}

}  // namespace clers::bench
