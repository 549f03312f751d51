// The commands that write nothing but what they found.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>

#include "codec/cli/commands.h"
#include "codec/cli/each_input.h"
#include "codec/cli/precision.h"
#include "codec/cli/printable.h"
#include "codec/cli/report.h"
#include "codec/cli/scene_difference.h"
#include "codec/compare.h"
#include "codec/decoder.h"

namespace clers::cli {
namespace {

// Shares of the time, by measurement of scans and models of 0.1 to 2 million triangles.
constexpr Stage info_plan[] = {{"reading", 1}, {"measuring", 99}};
constexpr Stage check_plan[] = {{"reading", 5}, {"reading", 19}, {"measuring", 76}};
constexpr Stage verify_plan[] = {
    {"reading", 4}, {"reading", 16}, {"reading", 1}, {"decoding", 12}, {"comparing", 67}};

/// What a command found in its files, as it is printed: one file in detail, several as a line each
/// below a heading, or JSON.
class Reports {
 public:
  Reports(const Options& options, std::string heading)
      : json_(options.json), one_(options.inputs.size() == 1), heading_(std::move(heading)) {}

  bool json() const { return json_; }
  bool in_detail() const { return one_; }

  Outcome<Done> add(Job& job, std::string report) {
    job.progress().hide();
    if (!json_) return print((one_ ? "" : std::exchange(heading_, "")) + report);
    files_.push_back(std::move(report));
    return Done{};
  }
  /// Ends what is printed of a run that ends as `exit` so far.
  Exit end(Exit exit) {
    if (!json_ || (one_ && files_.empty())) return exit;
    const auto printed = print((one_ ? files_.front() : json_list(files_)) + "\n");
    if (printed) return exit;
    complain(printed.error().line);
    return exit == Exit::done ? printed.error().exit : exit;
  }

 private:
  bool json_, one_;
  std::string heading_;
  std::vector<std::string> files_;
};

/// Whether no vertex, face or first corner is another.
bool in_one_order(const Mesh& a, const Mesh& b, std::span<const Tolerance> tolerances) {
  if (a.corners != b.corners || a.face_sizes != b.face_sizes) return false;
  Permutation same;
  same.vertices.resize(a.vertex_count);
  same.faces.resize(a.face_count());
  std::iota(same.vertices.begin(), same.vertices.end(), 0u);
  std::iota(same.faces.begin(), same.faces.end(), 0u);
  same.first_corners.resize(a.face_count());
  const auto result = compare(a, b, tolerances, same);
  return result && result->verdict == Verdict::same;
}

/// What a file says of its values: those that are not bit for bit may be off by so much.
std::vector<Tolerance> tolerances_of(const MeshInfo& mesh) {
  std::vector<Tolerance> tolerances;
  for (const FoundError& stated : largest_errors({&mesh, 1}))
    tolerances.push_back({stated.attribute, stated.error, stated.domain, stated.measure});
  return tolerances;
}

std::string meshes_of(std::size_t count) {
  return fmt::format("{} mesh{}", count, count == 1 ? "" : "es");
}

/// What is said beside the first mesh of which something else is said; "" if there is none. It is
/// no part of the mesh, and of a file in another format it must differ.
std::string metadata_differences(const std::vector<Mesh>& expected,
                                 const std::vector<Mesh>& found) {
  for (std::size_t i = 0; i < found.size(); ++i)
    if (std::string what = metadata_difference(expected[i], found[i]); !what.empty()) return what;
  return "";
}

/// What is the same, once all meshes are.
struct Sameness {
  std::vector<FoundError> errors;  ///< the largest of any mesh
  bool ordered = true;             ///< the order of elements too
};

Outcome<Sameness> compare_all(Job& job, const std::vector<Mesh>& expected,
                              const std::vector<Mesh>& found, std::span<const MeshInfo> stated) {
  const std::string name = job.name();
  if (expected.size() != found.size())
    return stop(Exit::different, fmt::format("{}: differs: {}, the original has {}", name,
                                             meshes_of(found.size()), expected.size()));
  Sameness same;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::vector<Tolerance> tolerances = tolerances_of(stated[i]);
    const auto result = compare(expected[i], found[i], tolerances);
    if (!result) return stop(name, result.error());
    job.progress().show(static_cast<double>(i + 1) / static_cast<double>(found.size()));
    const std::string mesh = found.size() > 1 ? fmt::format("mesh {}: ", i) : "";
    if (result->verdict == Verdict::different)
      return stop(Exit::different, fmt::format("{}: differs: {}{}", name, mesh, result->what));
    if (result->verdict == Verdict::undecided)
      return stop(Exit::undecided,
                  fmt::format("{}: neither equal nor different could be shown: {}{}", name, mesh,
                              result->what));
    for (const FoundError& error : result->errors) add(same.errors, error);
    same.ordered = same.ordered && in_one_order(expected[i], found[i], tolerances);
  }
  return same;
}

/// How exact values are: "every value bit for bit", and what is not.
std::string exactness(std::span<const FoundError> found, std::span<const MeshInfo> stated,
                      std::span<const ArrayInfo> arrays) {
  std::string out = "every value bit for bit";
  const std::vector<FoundError> all = largest_errors(stated);
  for (const FoundError& error : found) {
    out += fmt::format(", but {}", off_by(error));
    for (const FoundError& other : all)
      if (other.attribute == error.attribute && other.domain == error.domain)
        out += other.error == error.error
                   ? ", as stated"
                   : fmt::format(", {} stated", in_words(other.error, other.measure));
  }
  for (const ArrayInfo& a : arrays)
    if (a.error > 0) out += fmt::format(", but '{}' is off by {:.4g} at most", a.name, a.error);
  return out;
}

}  // namespace

Exit info(const Options& options) {
  Reports reports(options, info_heading());
  return reports.end(for_each_input(options, info_plan, [&](Job& job) -> Outcome<Done> {
    const Outcome<Bytes> bytes = job.read();
    if (!bytes) return Failure{bytes.error()};
    job.progress().next();
    const auto found = inspect(*bytes, options.decode.limits);
    if (!found) return job.not_accepted(found.error());
    return reports.add(job, reports.json()        ? info_json(job.name(), *found)
                            : reports.in_detail() ? info_text(job.name(), *found)
                                                  : info_line(job.name(), *found));
  }));
}

Exit check(const Options& options) {
  Reports reports(options, check_heading());
  return reports.end(for_each_input(options, check_plan, [&](Job& job) -> Outcome<Done> {
    const Outcome<SceneFile> file = job.read_scene();
    if (!file) return Failure{file.error()};
    job.note(job.name(), file->notes);
    job.progress().next();
    std::vector<Measured> measured;
    for (const Mesh& mesh : file->scene.meshes) {
      const auto shape = measure(mesh);
      if (!shape) return stop(job.name(), shape.error());
      measured.push_back({mesh.name, *shape});
    }
    return reports.add(job, reports.json()        ? check_json(job.name(), measured)
                            : reports.in_detail() ? check_text(job.name(), measured)
                                                  : check_line(job.name(), measured));
  }));
}

Exit verify(const Options& options) {
  const std::string &original = options.inputs[0], &file = options.inputs[1];
  return attempt(file, [&]() -> Outcome<Exit> {
    if (original == "-" && file == "-")
      return stop(Exit::usage, "only one of the two files can be standard input");
    Job job(options, file, input_name(file), verify_plan);
    const Outcome<SceneFile> expected = job.read_scene(original);
    if (!expected) return Failure{expected.error()};
    const Outcome<Bytes> bytes = job.read();
    if (!bytes) return Failure{bytes.error()};
    const Outcome<Scene> found = job.decode(*bytes);
    if (!found) return Failure{found.error()};
    job.progress().next();
    const Expected<Decoder> decoder = Decoder::open(*bytes, options.decode);
    const Expected<FileInfo> stated = decoder ? decoder->info() : Failure{decoder.error()};
    if (!stated) return job.not_accepted(stated.error());
    const std::string other = scene_difference(expected->scene, *found, stated->scene.arrays);
    if (!other.empty())
      return stop(Exit::different, fmt::format("{}: differs: {}", job.name(), other));
    const auto same =
        compare_all(job, with_uses(expected->scene), with_uses(*found), stated->meshes);
    if (!same) return Failure{same.error()};

    const std::string metadata = metadata_differences(expected->scene.meshes, found->meshes);
    if (options.strict && !metadata.empty())
      return stop(Exit::different, fmt::format("{}: differs: {}", job.name(), metadata));
    const Losses lost = losses(expected->notes);
    if (options.strict && !lost.what.empty())
      return stop(Exit::different, fmt::format("{}: differs: {} of {} {} not carried", job.name(),
                                               lost.what, input_name(original), lost.are));
    job.progress().hide();
    if (options.quiet) return Exit::done;
    std::size_t faces = 0;
    for (const Mesh& mesh : found->meshes) faces += mesh.face_count();
    const std::string verdict = fmt::format(
        "{}: same as {}{}{}: {}, {} face{}, {}{}", job.name(), input_name(original),
        metadata.empty() ? "" : fmt::format(", but for {}", metadata),
        lost.what.empty() ? ""
                          : fmt::format(", but for {} that {} not carried", lost.what, lost.are),
        meshes_of(found->meshes.size()), grouped(faces), faces == 1 ? "" : "s",
        exactness(same->errors, stated->meshes, stated->scene.arrays),
        same->ordered ? ", in the same order" : "");
    const auto printed = print(printable(verdict) + "\n");
    if (!printed) return Failure{printed.error()};
    return Exit::done;
  });
}

}  // namespace clers::cli
