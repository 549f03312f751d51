// The commands that write files.
#include "codec/cli/commands.h"

#include <fmt/format.h>

#include "codec/cli/each_input.h"

namespace clers::cli {
namespace {

/// Writes meshes in a format and saves them, which are two stages.
Outcome<Done> save_meshes(const Options& options, Job& job, const std::vector<Mesh>& meshes,
                          io::Format format, const std::string& output,
                          const std::string& result = "") {
  job.progress().next();
  const auto encoding = options.text ? std::optional(io::Encoding::text) : std::nullopt;
  const auto written = io::write(meshes, format, encoding);
  if (!written) return stop(job.name(), written.error());
  job.note(output_name(output), written->notes);
  return job.save(output, written->bytes, result);
}

/// The format of an output by --to or by its name; none if it gets its name by the format.
Outcome<std::optional<io::Format>> format_of_output(const Options& options,
                                                    const std::optional<std::string>& given) {
  if (options.to || !given || *given == "-") return options.to;
  const Outcome<io::Format> named = format_for(*given, {}, "--to");
  if (!named) return Failure{named.error()};
  return std::optional(*named);
}

}  // namespace

Exit encode(const Options& options) {
  constexpr char suffix[] = ".clers";
  return for_each_output(
      options, suffix, {{"reading", 1}, {"reading", 1}, {"encoding", 1}, {"writing", 1}},
      [&](Job& job, const Destination& to, const auto& check) -> Outcome<Done> {
        const Outcome<std::string> output = check(to.path(job.input(), suffix));
        if (!output) return Failure{output.error()};
        const Outcome<MeshFile> file = job.read_meshes();
        if (!file) return Failure{file.error()};
        const std::string lost = losses(file->notes);
        if (options.strict && !lost.empty())
          return stop(Exit::input,
                      fmt::format("{}: {} cannot be carried; without --strict the rest is encoded",
                                  job.name(), lost));
        job.note(job.name(), file->notes);
        job.progress().next();
        EncodeOptions how = options.encode;
        how.progress = job.progress().callback();
        const auto encoded = clers::encode(file->meshes, how);
        if (!encoded) return stop(job.name(), encoded.error());
        return job.save(*output, encoded->bytes);
      });
}

Exit decode(const Options& options) {
  return for_each_output(options, options.to ? extension(*options.to) : nullptr,
                         {{"reading", 1}, {"decoding", 1}, {"writing", 1}, {"writing", 1}},
                         [&](Job& job, const Destination& to, const auto& check) -> Outcome<Done> {
                           auto format = format_of_output(options, to.given(job.input()));
                           if (!format) return Failure{format.error()};
                           Outcome<std::string> output = std::string();
                           const auto settle = [&] {
                             output = check(to.path(job.input(), extension(**format)));
                           };
                           if (*format) settle();
                           if (!output) return Failure{output.error()};
                           const Outcome<Bytes> bytes = job.read();
                           if (!bytes) return Failure{bytes.error()};
                           const Outcome<std::vector<Mesh>> meshes = job.decode(*bytes);
                           if (!meshes) return Failure{meshes.error()};
                           if (!*format) {
                             *format = format_encoded(*meshes).value_or(io::Format::ply);
                             settle();
                             if (!output) return Failure{output.error()};
                           }
                           return save_meshes(options, job, *meshes, **format, *output);
                         });
}

Exit subdivide(const Options& options) {
  return for_each_output(
      options, options.to ? extension(*options.to) : nullptr,
      {{"reading", 1}, {"reading", 1}, {"subdividing", 1}, {"writing", 1}, {"writing", 1}},
      [&](Job& job, const Destination& to, const auto& check) -> Outcome<Done> {
        const auto named = format_of_output(options, to.given(job.input()));
        if (!named) return Failure{named.error()};
        const auto format = format_for(job.input(), *named ? *named : options.from, "--from");
        if (!format) return Failure{format.error()};
        const Outcome<std::string> output = check(to.path(job.input(), extension(*format)));
        if (!output) return Failure{output.error()};
        Outcome<MeshFile> file = job.read_meshes();
        if (!file) return Failure{file.error()};
        job.note(job.name(), file->notes);
        job.progress().next();
        std::string result;
        for (Mesh& mesh : file->meshes) {
          auto done = subdivide(mesh, options.subdivision,
                                [&](double share) { job.progress().show(share); });
          if (!done) return stop(job.name(), done.error());
          job.note(job.name(), done->notes);
          result += (result.empty() ? "" : "\n") +
                    fmt::format("{}: {}", mesh.name.empty() ? job.name() : mesh.name,
                                describe(options.subdivision, *done));
          mesh = std::move(done->mesh);
        }
        return save_meshes(options, job, file->meshes, *format, *output, result);
      });
}

}  // namespace clers::cli
