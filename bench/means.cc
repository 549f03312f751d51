// Means over meshes, wins and losses, and a line for each mesh.
#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <ostream>
#include <set>

#include "bench/result.h"
#include "bench/text.h"

namespace clers::bench {
namespace {

using Index = std::map<std::pair<std::string, std::string>, const Result*>;  // (mesh, codec)

// What ratios are taken of.
struct Measure {
  const char* name;
  double (*of)(const Result&);
};
// Beside the best of the rivals, which is another on each mesh, it is sizes alone.
std::vector<Measure> measures_beside(const std::string& reference) {
  if (reference == least_rival) return {{"size", size_of_file}};
  return {{"size", size_of_file}, {"encode", encode_speed}, {"decode", decode_speed}};
}

struct Mean {
  double value = 0;
  int meshes = 0;
};

// Of the ratios of `codec` to `reference`, over the meshes of `has` of which both have the figure.
Mean mean_ratio(const Index& index, const std::string& codec, const std::string& reference,
                const Measure& measure, const std::function<bool(const Result&)>& has) {
  double sum = 0;
  Mean mean;
  for (const auto& [key, r] : index) {
    const auto base = index.find({key.first, reference});
    if (key.second != codec || base == index.end() || !has(*r)) continue;
    const double a = measure.of(*r), b = measure.of(*base->second);
    if (!(a > 0 && b > 0)) continue;
    sum += std::log(a / b);
    ++mean.meshes;
  }
  if (mean.meshes) mean.value = std::exp(sum / mean.meshes);
  return mean;
}

std::string mean_text(const Mean& mean) {
  return mean.meshes ? format(" %7.3f", mean.value) : format(" %7s", "-");
}

// Every codec, all measures of the groups beside each other.
void print_groups(std::ostream& out, Mode mode, const std::vector<std::string>& codecs,
                  const std::string& reference, const Index& index) {
  const std::vector<Measure> measures = measures_beside(reference);
  const std::size_t width = 8 * measures.size() + 6;
  const std::vector<std::string> groups = group_names(mode);
  out << format("\n%-27s", "");
  for (const std::string& group : groups)
    out << format(" %*.*s", int(width), int(width), group.c_str());
  out << format("\n%-27s", "");
  for (std::size_t g = 0; g < groups.size(); ++g) {
    out << "  meshes";
    for (const Measure& m : measures) out << format(" %7s", m.name);
    out << " ";
  }
  out << "\n";
  for (const std::string& codec : codecs) {
    out << format("%-27s", codec.c_str());
    for (const std::string& group : groups) {
      const auto has = [&](const Result& r) { return in_group(r, group); };
      out << format("  %6d", mean_ratio(index, codec, reference, measures[0], has).meshes);
      for (const Measure& m : measures)
        out << mean_text(mean_ratio(index, codec, reference, m, has));
      out << " ";
    }
    out << "\n";
  }
}

std::vector<std::string> ours_of(const std::vector<std::string>& codecs) {
  std::vector<std::string> ours;
  std::copy_if(codecs.begin(), codecs.end(), std::back_inserter(ours),
               [](const std::string& codec) { return codec.rfind("clers", 0) == 0; });
  return ours;
}

// The meshes of a group, one a line: clers beside the reference on each.
void print_meshes(std::ostream& out, const std::string& group,
                  const std::vector<std::string>& codecs, const std::string& reference,
                  const Index& index) {
  const std::vector<Measure> measures = measures_beside(reference);
  const std::vector<std::string> ours = ours_of(codecs);
  std::vector<const Result*> meshes;
  for (const auto& [key, r] : index)
    if (key.second == reference && in_group(*r, group)) meshes.push_back(r);
  if (ours.empty() || meshes.empty()) return;
  out << format("\n%-40s %10s", group.c_str(), "triangles");
  for (const std::string& codec : ours)
    out << format("  %-*s", int(8 * measures.size() - 1), codec.c_str());
  out << format("\n%-40s %10s", "", "");
  for (std::size_t i = 0; i < ours.size(); ++i) {
    out << " ";
    for (const Measure& m : measures) out << format(" %7s", m.name);
  }
  out << "\n";
  for (const Result* base : meshes) {
    out << format("%-40.40s %10llu", base->mesh.c_str(),
                  static_cast<unsigned long long>(base->triangles));
    for (const std::string& codec : ours) {
      out << " ";
      const auto at = index.find({base->mesh, codec});
      for (const Measure& m : measures) {
        const double a = at == index.end() ? 0 : m.of(*at->second), b = m.of(*base);
        out << (at == index.end() ? format(" %7s", "fails")
                : a > 0 && b > 0  ? format(" %7.3f", a / b)
                                  : format(" %7s", "-"));
      }
    }
    out << "\n";
  }
  out << format("%-40s %10s", "geometric mean", "");
  for (const std::string& codec : ours) {
    out << " ";
    for (const Measure& m : measures) {
      const auto has = [&](const Result& r) { return in_group(r, group); };
      out << mean_text(mean_ratio(index, codec, reference, m, has));
    }
  }
  out << "\n";
}

// On how many meshes of a group clers takes less than each reference, and where most and least.
void print_wins(std::ostream& out, const std::string& group, const std::vector<std::string>& codecs,
                const std::vector<std::string>& rivals, const Measure& measure,
                const Index& index) {
  bool begun = false;
  for (const std::string& codec : ours_of(codecs))
    for (const std::string& rival : rivals) {
      int count = 0, wins = 0;
      std::pair<double, std::string> least{HUGE_VAL, ""}, most{0, ""};
      for (const auto& [key, r] : index) {
        const auto base = index.find({key.first, rival});
        if (key.second != codec || base == index.end() || !in_group(*r, group)) continue;
        const double a = measure.of(*r), b = measure.of(*base->second);
        if (!(a > 0 && b > 0)) continue;
        ++count;
        wins += a < b;
        least = std::min(least, {a / b, key.first});
        most = std::max(most, {a / b, key.first});
      }
      if (count == 0) continue;
      if (!begun)
        out << "\n"
            << measure.name << ", " << group
            << ": on how many meshes less, and the least and most\n";
      begun = true;
      out << format("%-10s / %-14s  %2d of %2d  %6.3f %-35.35s  %6.3f %s\n", codec.c_str(),
                    rival.c_str(), wins, count, least.first, least.second.c_str(), most.first,
                    most.second.c_str());
    }
}

// What the codecs give back of meshes that are not manifold, all together.
void print_losses(std::ostream& out, const std::vector<std::string>& codecs, const Index& index) {
  out << format("\n%-27s  %6s  %6s  %10s %10s  %10s %10s\n", "not manifold: comes back", "meshes",
                "same", "triangles", "triangles", "vertices", "vertices");
  out << format("%-27s  %6s  %6s  %10s %10s  %10s %10s\n", "", "", "", "lost", "added", "lost",
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
    out << format("%-27s  %6llu  %6llu  %10llu %10llu  %10llu %10llu\n", codec.c_str(), meshes,
                  same, number(sum.triangles_lost), number(sum.triangles_added),
                  number(sum.vertices_lost), number(sum.vertices_added));
  }
}

// One measure, the classes of meshes beside each other.
void print_classes(std::ostream& out, const std::vector<std::string>& codecs,
                   const std::string& reference, const Index& index, const Measure& measure) {
  std::map<std::string, std::set<std::string>> meshes;  // by class
  for (const auto& [key, r] : index)
    if (!groups_of(*r).empty() && index.count({key.first, reference}))
      meshes[r->family].insert(r->mesh);
  out << format("\n%-27s", measure.name);
  for (const auto& [family, names] : meshes) out << format(" %11.11s", family.c_str());
  out << format("\n%-27s", "meshes");
  for (const auto& [family, names] : meshes) out << format(" %11zu", names.size());
  out << "\n";
  for (const std::string& codec : codecs) {
    out << format("%-27s", codec.c_str());
    for (const auto& [family, names] : meshes) {
      const auto has = [&, &family = family](const Result& r) {
        return r.family == family && !groups_of(r).empty();
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

void print_means(std::ostream& out, const Setting& setting, const std::vector<Result>& results) {
  for (const Mode mode : all_modes) {
    Index index;
    std::vector<std::string> codecs;
    for (const Result& r : results) {
      if (r.mode != mode) continue;
      if (std::find(codecs.begin(), codecs.end(), r.codec) == codecs.end())
        codecs.push_back(r.codec);
      if (!r.failed()) index[{r.mesh, r.codec}] = &r;
    }
    if (index.empty()) continue;
    for (const std::string& reference : references(mode)) {
      const bool weighty = std::any_of(index.begin(), index.end(), [&](const auto& entry) {
        return entry.first.second == reference && !groups_of(*entry.second).empty();
      });
      if (!weighty) continue;
      out << "\n==== " << name(mode) << ": ratios to " << reference
          << ", geometric means over meshes that are not tiny ====\n"
          << "==== size: smaller is better; speed: larger is; " << setting.rivals() << " ====\n";
      print_groups(out, mode, codecs, reference, index);
      for (const std::string& group : group_names(mode))
        if (group == group_names(mode)[0] || group == not_manifold)
          print_meshes(out, group, codecs, reference, index);
      for (const Measure& m : measures_beside(reference))
        print_classes(out, codecs, reference, index, m);
    }
    const std::string group = group_names(mode)[0];
    print_wins(out, group, codecs, references(mode), {"bytes", size_of_file}, index);
    print_wins(out, group, codecs, {"zstd19", "xz9e", "fpzip-zstd19"},
               {"positions", size_of_positions}, index);
    if (std::any_of(index.begin(), index.end(),
                    [](const auto& entry) { return in_group(*entry.second, not_manifold); }))
      print_losses(out, codecs, index);
  }
  out.flush();
}

}  // namespace clers::bench
