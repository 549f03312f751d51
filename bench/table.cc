#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iterator>
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

constexpr char no_grid[] = "clers: no rows, since it does not code positions on a grid yet\n";

bool is_ours(const Result& r) {
  return r.codec.rfind("clers", 0) == 0;
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

using Index = std::map<std::pair<std::string, std::string>, const Result*>;  // (mesh, codec)

// What ratios are taken of.
struct Measure {
  const char* name;
  double (*of)(const Result&);
};
constexpr Measure measures[] = {
    {"size", [](const Result& r) { return double(r.trial.bytes); }},
    {"encode", [](const Result& r) { return r.encode_mtri_s(); }},
    {"decode", [](const Result& r) { return r.decode_mtri_s(); }},
};

struct Mean {
  double value = 0;
  int meshes = 0;
};

// Of the ratios of `codec` to `reference`, over the meshes of `has` that both managed.
Mean mean_ratio(const Index& index, const std::string& codec, const std::string& reference,
                const Measure& measure, const std::function<bool(const Result&)>& has) {
  double sum = 0;
  Mean mean;
  for (const auto& [key, r] : index) {
    const auto base = index.find({key.first, reference});
    if (key.second != codec || base == index.end() || !has(*r)) continue;
    sum += std::log(measure.of(*r) / measure.of(*base->second));
    ++mean.meshes;
  }
  if (mean.meshes) mean.value = std::exp(sum / mean.meshes);
  return mean;
}

// Every codec, all measures of the groups beside each other.
void print_groups(std::ostream& out, const std::vector<std::string>& codecs,
                  const std::string& reference, const Index& index) {
  const std::size_t width = 8 * std::size(measures);
  out << format("\n%-24s", "");
  for (const char* group : group_names) out << format("  %*s", int(width + 5), group);
  out << format("\n%-24s", "");
  for (std::size_t g = 0; g < std::size(group_names); ++g) {
    out << "  meshes";
    for (const Measure& m : measures) out << format(" %7s", m.name);
    out << " ";
  }
  out << "\n";
  for (const std::string& codec : codecs) {
    out << format("%-24s", codec.c_str());
    for (const char* group : group_names) {
      const auto has = [&](const Result& r) { return in_group(r, group); };
      const int meshes = mean_ratio(index, codec, reference, measures[0], has).meshes;
      out << format("  %6d", meshes);
      for (const Measure& m : measures)
        out << (meshes ? format(" %7.3f", mean_ratio(index, codec, reference, m, has).value)
                       : format(" %7s", "-"));
      out << " ";
    }
    out << "\n";
  }
}

// Meshes that are not manifold, one a line: how fast clers is beside the reference on each.
void print_not_manifold(std::ostream& out, const std::vector<std::string>& codecs,
                        const std::string& reference, const Index& index) {
  std::vector<std::string> ours;
  std::copy_if(codecs.begin(), codecs.end(), std::back_inserter(ours),
               [](const std::string& codec) { return codec.rfind("clers", 0) == 0; });
  std::vector<const Result*> meshes;
  for (const auto& [key, r] : index)
    if (key.second == reference && in_group(*r, not_manifold)) meshes.push_back(r);
  if (ours.empty() || meshes.empty()) return;
  out << format("\n%-40s %10s", not_manifold, "triangles");
  for (const std::string& codec : ours) out << format(" %8s %7s %7s", codec.c_str(), "", "");
  out << format("\n%-40s %10s", "", "");
  for (std::size_t i = 0; i < ours.size(); ++i)
    out << format(" %8s %7s %7s", "size", "encode", "decode");
  out << "\n";
  for (const Result* base : meshes) {
    out << format("%-40.40s %10llu", base->mesh.c_str(),
                  static_cast<unsigned long long>(base->triangles));
    for (const std::string& codec : ours) {
      const auto at = index.find({base->mesh, codec});
      for (const Measure& m : measures)
        out << (at == index.end() ? format(" %7s", "fails")
                                  : format(" %7.3f", m.of(*at->second) / m.of(*base)))
            << (&m == &measures[0] ? " " : "");
    }
    out << "\n";
  }
  out << format("%-40s %10s", "geometric mean", "");
  for (const std::string& codec : ours)
    for (const Measure& m : measures) {
      const auto has = [](const Result& r) { return in_group(r, not_manifold); };
      out << format(" %7.3f", mean_ratio(index, codec, reference, m, has).value)
          << (&m == &measures[0] ? " " : "");
    }
  out << "\n";
}

// What the codecs give back of meshes that are not manifold, all together.
void print_losses(std::ostream& out, const std::vector<std::string>& codecs, const Index& index) {
  out << format("\n%-24s  %6s  %6s  %10s %10s  %10s %10s\n", "not manifold: comes back", "meshes",
                "same", "triangles", "triangles", "vertices", "vertices");
  out << format("%-24s  %6s  %6s  %10s %10s  %10s %10s\n", "", "", "", "lost", "added", "lost",
                "doubled");
  for (const std::string& codec : codecs) {
    unsigned long long meshes = 0, same = 0;
    Fidelity sum;
    for (const auto& [key, r] : index) {
      if (key.second != codec || !in_group(*r, not_manifold)) continue;
      const Fidelity& f = r->trial.fidelity;
      ++meshes;
      same += f.same();
      sum.triangles_lost += f.triangles_lost, sum.triangles_added += f.triangles_added;
      sum.vertices_lost += f.vertices_lost, sum.vertices_added += f.vertices_added;
    }
    if (meshes == 0) continue;
    const auto number = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    out << format("%-24s  %6llu  %6llu  %10llu %10llu  %10llu %10llu\n", codec.c_str(), meshes,
                  same, number(sum.triangles_lost), number(sum.triangles_added),
                  number(sum.vertices_lost), number(sum.vertices_added));
  }
}

// One measure, the classes of meshes beside each other.
void print_classes(std::ostream& out, const std::vector<std::string>& codecs,
                   const std::string& reference, const Index& index, const Measure& measure) {
  std::map<std::string, std::set<std::string>> meshes;  // by class
  for (const auto& [key, r] : index)
    if (r->draco_connectivity >= 500 && index.count({key.first, reference}))
      meshes[r->family].insert(r->mesh);
  out << format("\n%-24s", measure.name);
  for (const auto& [family, names] : meshes) out << format(" %11.11s", family.c_str());
  out << format("\n%-24s", "meshes");
  for (const auto& [family, names] : meshes) out << format(" %11zu", names.size());
  out << "\n";
  for (const std::string& codec : codecs) {
    out << format("%-24s", codec.c_str());
    for (const auto& [family, names] : meshes) {
      const auto has = [&, &family = family](const Result& r) {
        return r.family == family && r.draco_connectivity >= 500;
      };
      const Mean mean = mean_ratio(index, codec, reference, measure, has);
      // Fewer meshes than the others: the codec failed on some.
      const char* mark = mean.meshes < int(names.size()) ? "*" : " ";
      out << (mean.meshes ? format(" %10.3f%s", mean.value, mark) : format(" %10s ", "fails"));
    }
    out << "\n";
  }
}

}  // namespace

void print_rows(std::ostream& out, const Setting& setting, const std::vector<Result>& rows) {
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
      << (first.manifold ? "" : ", not manifold") << "; class " << first.family << "; "
      << setting.rivals() << "\n";
  if (bits(first.mode) && std::none_of(rows.begin(), rows.end(), is_ours)) out << no_grid;
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

void print_means(std::ostream& out, const Setting& setting, const std::vector<Result>& results) {
  for (const Mode mode : all_modes) {
    Index index;
    std::vector<std::string> codecs;
    bool ours = false;
    for (const Result& r : results) {
      if (r.mode != mode) continue;
      if (std::find(codecs.begin(), codecs.end(), r.codec) == codecs.end())
        codecs.push_back(r.codec);
      if (!r.failed()) index[{r.mesh, r.codec}] = &r;
      ours = ours || is_ours(r);
    }
    if (index.empty()) continue;
    for (const char* reference : {references(mode).fast, references(mode).small}) {
      const bool weighty = std::any_of(index.begin(), index.end(), [&](const auto& entry) {
        return entry.first.second == reference && entry.second->draco_connectivity >= 500;
      });
      if (!weighty) continue;
      out << "\n==== " << name(mode) << ": ratios to " << reference
          << ", geometric means over meshes whose connectivity takes Draco 500 bytes or more ====\n"
          << "==== size: smaller is better; speed: larger is; " << setting.rivals() << " ====\n";
      if (bits(mode) && !ours) out << no_grid;
      print_groups(out, codecs, reference, index);
      print_not_manifold(out, codecs, reference, index);
      for (const Measure& m : measures) print_classes(out, codecs, reference, index, m);
    }
    if (std::any_of(index.begin(), index.end(),
                    [](const auto& entry) { return in_group(*entry.second, not_manifold); }))
      print_losses(out, codecs, index);
  }
  out.flush();
}

}  // namespace clers::bench
