// The commands that write files.
#include "codec/cli/commands.h"

#include <fmt/format.h>

#include "codec/cli/each_input.h"
#include "codec/cli/frames.h"
#include "codec/cli/precision.h"
#include "codec/cli/report.h"

namespace clers::cli {
namespace {

// Shares of the time, by measurement of scans and models of 0.1 to 2 million triangles.
constexpr Stage encode_plan[] = {{"reading", 4}, {"reading", 20}, {"encoding", 72}, {"writing", 4}};
constexpr Stage decode_plan[] = {
    {"reading", 2}, {"decoding", 46}, {"writing", 36}, {"writing", 16}};
constexpr Stage subdivide_plan[] = {
    {"reading", 1}, {"reading", 3}, {"subdividing", 78}, {"writing", 9}, {"writing", 9}};
constexpr Stage adapt_plan[] = {
    {"reading", 1}, {"reading", 3}, {"adapting", 94}, {"writing", 1}, {"writing", 1}};
constexpr Stage simplify_plan[] = {
    {"reading", 2}, {"reading", 8}, {"simplifying", 80}, {"writing", 5}, {"writing", 5}};
constexpr Stage reconstruct_plan[] = {
    {"reading", 1}, {"reading", 3}, {"reconstructing", 92}, {"writing", 2}, {"writing", 2}};

/// Writes meshes in a format and saves them, which are two stages.
Outcome<Done> save_meshes(Job& job, const std::vector<Mesh>& meshes, io::Format format,
                          std::optional<io::Encoding> encoding, const std::string& output,
                          const std::vector<std::string>& results = {}) {
  job.progress().next();
  const auto written = io::write(meshes, format, encoding);
  if (!written) return stop(job.name(), written.error());
  job.note(output_name(output), written->notes);
  return job.save(output, written->bytes, results);
}

/// Binary where a format has it, unless text is asked for.
io::Encoding encoding_of(Format format, const Options& options) {
  if (is_scene(format))
    return std::get<gltf::Form>(format) == gltf::Form::glb ? io::Encoding::binary
                                                           : io::Encoding::text;
  const auto of_meshes = std::get<io::Format>(format);
  const bool has_binary = of_meshes == io::Format::ply || of_meshes == io::Format::stl;
  return has_binary && !options.text ? io::Encoding::binary : io::Encoding::text;
}

struct Source {
  Format format;
  io::Encoding encoding;
};

/// What a scene was read from before it was encoded; what holds its meshes, if that is not known.
Source source_of(const Scene& scene) {
  if (const auto form = gltf::form_of(scene))
    return {*form, *form == gltf::Form::glb ? io::Encoding::binary : io::Encoding::text};
  if (scene.meshes.size() != 1) return {io::Format::obj, io::Encoding::text};
  const io::Source source =
      io::source_of(scene.meshes[0]).value_or(io::Source{io::Format::ply, io::Encoding::binary});
  return {source.format, source.encoding};
}

/// The format of an output by --to or by its name; none if it gets its name by the format.
Outcome<std::optional<Format>> format_of_output(const Options& options,
                                                const std::optional<std::string>& given) {
  if (options.to || !given || *given == "-") return options.to;
  const Outcome<Format> named = format_for(*given, {}, "--to");
  if (!named) return Failure{named.error()};
  if (is_read_only(*named))
    return stop(Exit::usage, fmt::format("{}: Draco's files are read, not written; expected {}",
                                         *given, written_names));
  return std::optional(*named);
}

/// Writes the files that one at `output` names, but for those that are there already.
Outcome<Done> save_beside(const Options& options, const std::string& output,
                          std::span<const gltf::File> files) {
  const FileIds inputs = ids_of(options.inputs);
  std::vector<const gltf::File*> missing;
  for (const gltf::File& file : files) {
    const std::string path = beside(output, file.path);
    if (const auto there = read_file(path); there && *there == file.bytes) continue;
    if (auto ok = check_output(path, options.force, inputs); !ok) return ok;
    missing.push_back(&file);
  }
  for (const gltf::File* file : missing)
    if (auto ok = write_file(beside(output, file->path), file->bytes, options.force); !ok)
      return ok;
  return Done{};
}

/// Writes a scene in a format and saves it, which are two stages.
Outcome<Done> save_scene(const Options& options, Job& job, const Scene& scene, Format format,
                         io::Encoding encoding, const std::string& output) {
  if (!is_scene(format)) {
    const std::string lost = besides_meshes(scene);
    if (!lost.empty())
      job.note(output_name(output), "meshes alone are in it, without " + lost + " of the scene",
               true);
    return save_meshes(job, scene.meshes, std::get<io::Format>(format), encoding, output);
  }
  job.progress().next();
  const auto written = write_scene(scene, std::get<gltf::Form>(format), output);
  if (!written) return Failure{written.error()};
  if (auto ok = save_beside(options, output, written->files); !ok) return ok;
  return job.save(output, written->bytes);
}

constexpr char clers_suffix[] = ".clers";

const char* suffix_if_known(const Options& options) {
  return options.to ? extension(*options.to) : nullptr;
}

/// Notes of what comes back otherwise than it was.
void note_changes(Job& job, std::span<const Warning> warnings, std::span<const MeshInfo> report) {
  for (const Warning& warning : warnings)
    job.note(job.name(),
             (report.size() > 1 ? fmt::format("mesh {}: ", warning.mesh) : "") + warning.what,
             false);
  for (const FoundError& found : largest_errors(report)) job.note(job.name(), off_by(found), true);
}

/// The same of arrays.
void note_changes(Job& job, const SceneInfo& scene) {
  std::vector<FoundError> found;
  for (const ArrayInfo& a : scene.arrays)
    if (a.error > 0) add(found, {a.name, Domain::face, a.error, ErrorMeasure::difference});
  for (const FoundError& one : found) job.note(job.name(), off_by(one), true);
}

/// A scene whose meshes are .clers files, for an output that is called so.
Outcome<Done> encode_within(const Options& options, Job& job, const SceneFile& file,
                            gltf::Form form, const std::string& output) {
  EncodeOptions how = options.encode;
  how.progress = {};
  auto written = gltf::write_compressed(file.scene, file.orders, how, options_for(form, output));
  if (!written) return stop(job.name(), written.error());
  note_changes(job, written->warnings, written->report);
  if (auto ok = save_beside(options, output, written->written.files); !ok) return ok;
  return job.save(output, written->written.bytes);
}

Outcome<Done> encode_one(const Options& options, Job& job, const Destination& to) {
  if (const auto format = job.mesh_format(); !format) return Failure{format.error()};
  const Outcome<std::string> output = to.of(job.input(), clers_suffix, io::Encoding::binary);
  if (!output) return Failure{output.error()};
  const Outcome<SceneFile> file = job.read_scene();
  if (!file) return Failure{file.error()};
  const Losses lost = losses(file->notes);
  if (options.strict && !lost.what.empty())
    return stop(Exit::input,
                fmt::format("{}: {} cannot be carried; without --strict the rest is encoded",
                            job.name(), lost.what));
  job.note(job.name(), file->notes);
  job.progress().next();
  if (const auto format = format_of_path(*output); format && is_scene(*format)) {
    if (!gltf::form_of(file->scene))
      return stop(Exit::usage, *output + ": only a scene can become a glTF");
    return encode_within(options, job, *file, std::get<gltf::Form>(*format), *output);
  }
  EncodeOptions how = options.encode;
  how.progress = job.progress().callback();
  const auto encoded =
      clers::encode(file->scene, how,
                    how.order == Order::keep ? std::span<const Order>() : std::span(file->orders));
  if (!encoded) return stop(job.name(), encoded.error());
  note_changes(job, encoded->warnings, encoded->report);
  note_changes(job, encoded->scene);
  return job.save(*output, encoded->bytes);
}

Outcome<Done> decode_one(const Options& options, Job& job, const Destination& to) {
  auto format = format_of_output(options, to.given(job.input()));
  if (!format) return Failure{format.error()};
  Outcome<std::string> output = std::string();
  // Before the work if it is known by then.
  if (*format) output = to.of(job.input(), extension(**format), encoding_of(**format, options));
  if (!output) return Failure{output.error()};
  const Outcome<Bytes> bytes = job.read();
  if (!bytes) return Failure{bytes.error()};
  const Outcome<Scene> scene = job.decode(*bytes);
  if (!scene) return Failure{scene.error()};
  if (*format)
    return save_scene(options, job, *scene, **format, encoding_of(**format, options), *output);
  const Source source = source_of(*scene);
  const io::Encoding encoding =
      options.text && !is_scene(source.format) ? io::Encoding::text : source.encoding;
  output = to.of(job.input(), extension(source.format), encoding);
  if (!output) return Failure{output.error()};
  return save_scene(options, job, *scene, source.format, encoding, *output);
}

/// The meshes of a mesh file by others: `work(Mesh&, io::Format, io::Encoding)` makes the new one,
/// and returns what is said of it.
template <class Work>
Outcome<Done> remake_one(const Options& options, Job& job, const Destination& to,
                         const char* remade, Work work) {
  const auto from = job.mesh_format();
  if (!from) return Failure{from.error()};
  const auto named = format_of_output(options, to.given(job.input()));
  if (!named) return Failure{named.error()};
  const Format any = named->value_or(is_read_only(*from) ? io::Format::ply : *from);
  if (is_scene(*from) || is_scene(any))
    return stop(Exit::usage,
                fmt::format("{}: a scene cannot be {}, only mesh files can", job.name(), remade));
  const auto format = std::get<io::Format>(any);
  const io::Encoding encoding = encoding_of(format, options);
  const Outcome<std::string> output = to.of(job.input(), extension(format), encoding);
  if (!output) return Failure{output.error()};
  Outcome<SceneFile> file = job.read_scene();
  if (!file) return Failure{file.error()};
  if (options.frames && file->scene.meshes.size() != 1)
    return stop(Exit::usage, fmt::format("{}: has {} meshes, --frames needs one", job.name(),
                                         file->scene.meshes.size()));
  job.note(job.name(), file->notes);
  job.progress().next();
  std::vector<std::string> results;
  for (Mesh& mesh : file->scene.meshes) {
    const std::string name = mesh.name.empty() ? job.name() : mesh.name;
    Outcome<std::string> done = work(mesh, format, encoding);
    if (!done) return Failure{done.error()};
    results.push_back(fmt::format("{}: {}", name, *done));
  }
  return save_meshes(job, file->scene.meshes, format, encoding, *output, results);
}

Outcome<Done> subdivide_one(const Options& options, Job& job, const Destination& to) {
  const auto work = [&](Mesh& mesh, io::Format, io::Encoding) -> Outcome<std::string> {
    auto done =
        subdivide(mesh, options.subdivision, [&](double share) { job.progress().show(share); });
    if (!done) return stop(job.name(), done.error());
    for (const std::string& note : done->notes) job.note(job.name(), note, true);
    mesh = std::move(done->mesh);
    return describe(options.subdivision, *done);
  };
  return remake_one(options, job, to, "subdivided", work);
}

/// `reports`: JSON, one of each mesh.
Outcome<Done> adapt_one(const Options& options, Job& job, const Destination& to,
                        std::vector<std::string>& reports) {
  const auto work = [&](Mesh& mesh, io::Format format,
                        io::Encoding encoding) -> Outcome<std::string> {
    Frames frames(options, format, encoding);
    if (auto ok = frames.open(); !ok) return Failure{ok.error()};
    auto done = adapt(
        mesh, options.adaptation, [&](double share) { job.progress().show(share); },
        [&](const Mesh& frame) { return frames.add(frame); });
    if (frames.failure()) return Failure{*frames.failure()};
    if (!done) return stop(job.name(), done.error());
    for (const std::string& note : done->notes) job.note(job.name(), note, true);
    if (done->limited)
      job.note(job.name(),
               fmt::format("not all was refined: --max-faces {} allows no more",
                           options.adaptation.faces),
               false);
    if (done->turned != 0)
      job.note(job.name(),
               fmt::format("{} {} the other way than the surface there: a base of more faces may "
                           "follow it better",
                           grouped(done->turned), done->turned == 1 ? "face looks" : "faces look"),
               false);
    if (done->off_shape != 0)
      job.note(job.name(),
               fmt::format("{} {} not on the surface: the base has edges across gaps",
                           grouped(done->off_shape),
                           done->off_shape == 1 ? "vertex is" : "vertices are"),
               false);
    reports.push_back(adapted_json(job.name(), *done));
    mesh = std::move(done->mesh);
    return describe(*done);
  };
  return remake_one(options, job, to, "adapted", work);
}

/// `reports`: JSON, one of each mesh.
Outcome<Done> simplify_one(const Options& options, Job& job, const Destination& to,
                           std::vector<std::string>& reports) {
  const auto work = [&](Mesh& mesh, io::Format, io::Encoding) -> Outcome<std::string> {
    auto done = simplify(mesh, options.fewer, [&](double share) { job.progress().show(share); });
    if (!done) return stop(job.name(), done.error());
    for (const std::string& note : done->notes) job.note(job.name(), note, true);
    if (const std::string note = unreached(*done); !note.empty()) job.note(job.name(), note, false);
    reports.push_back(simplified_json(job.name(), *done));
    mesh = std::move(done->mesh);
    return describe(*done);
  };
  return remake_one(options, job, to, "simplified", work);
}

/// `reports`: as of adapt_one.
Outcome<Done> reconstruct_one(const Options& options, Job& job, const Destination& to,
                              std::vector<std::string>& reports) {
  const auto work = [&](Mesh& mesh, io::Format, io::Encoding) -> Outcome<std::string> {
    auto done = reconstruct(mesh, options.reconstruction,
                            [&](double share) { job.progress().show(share); });
    if (!done) return stop(job.name(), done.error());
    for (const std::string& note : done->notes) job.note(job.name(), note, true);
    reports.push_back(reconstructed_json(job.name(), *done));
    mesh = std::move(done->mesh);
    return describe(*done);
  };
  return remake_one(options, job, to, "reconstructed", work);
}

/// `one` of each input; then what it added to the reports, if JSON is asked for.
template <class One>
Exit for_each_report(const Options& options, std::span<const Stage> plan, One one) {
  std::vector<std::string> reports;
  const Exit exit = for_each_output(options, suffix_if_known(options), plan,
                                    [&](const Options& how, Job& job, const Destination& to) {
                                      return one(how, job, to, reports);
                                    });
  if (!options.json || reports.empty()) return exit;
  const auto printed = print((reports.size() == 1 ? reports.front() : json_list(reports)) + "\n");
  if (printed) return exit;
  complain(printed.error().line);
  return exit == Exit::done ? printed.error().exit : exit;
}

}  // namespace

Exit encode(const Options& options) {
  return for_each_output(options, clers_suffix, encode_plan, encode_one);
}

Exit decode(const Options& options) {
  return for_each_output(options, suffix_if_known(options), decode_plan, decode_one);
}

Exit subdivide(const Options& options) {
  return for_each_output(options, suffix_if_known(options), subdivide_plan, subdivide_one);
}

Exit adapt(const Options& options) {
  return for_each_report(options, adapt_plan, adapt_one);
}

Exit simplify(const Options& options) {
  return for_each_report(options, simplify_plan, simplify_one);
}

Exit reconstruct(const Options& options) {
  return for_each_report(options, reconstruct_plan, reconstruct_one);
}

}  // namespace clers::cli
