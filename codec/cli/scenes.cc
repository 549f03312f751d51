// What is in files that others name lies beside these.
#include "codec/cli/scenes.h"

#include <fmt/format.h>

#include <filesystem>

#include "codec/cli/foreign.h"
#include "codec/cli/words.h"

namespace clers::cli {

namespace fs = std::filesystem;

std::string beside(const std::string& path, const std::string& name) {
  return path == "-" ? name : (fs::path(path).parent_path() / name).string();
}

Outcome<SceneFile> parse_scene(const std::string& path, std::span<const std::byte> bytes,
                               Format format) {
  SceneFile file;
  if (is_read_only(format)) return parse_drc(path, bytes);
  if (const auto* of_meshes = std::get_if<io::Format>(&format)) {
    Expected<io::ReadResult> read = io::read(bytes, *of_meshes);
    if (!read) return stop(input_name(path), read.error());
    file.scene.meshes = std::move(read->meshes);
    file.notes = std::move(read->notes);
    return file;
  }
  const auto fetch = [&](const std::string& name) -> Expected<Bytes> {
    auto read = read_file(beside(path, name));
    if (!read) return fail(ErrorCode::io_failed, read.error().line);
    return std::move(*read);
  };
  auto read = gltf::read(bytes, fetch, foreign_decoders());
  if (!read && read.error().code == ErrorCode::io_failed)
    return stop(Exit::input, fmt::format("{}: {}", input_name(path), read.error().what));
  if (!read) return stop(input_name(path), read.error());
  file.scene = std::move(read->scene);
  file.orders = std::move(read->orders);
  for (const std::string& note : read->notes)
    file.notes.push_back({io::Note::Kind::loss, 1, "a picture", note});
  for (const std::string& remark : read->remarks)
    file.notes.push_back({io::Note::Kind::remark, 1, "an extension", remark});
  return file;
}

std::string besides_meshes(const Scene& scene) {
  std::vector<std::string> parts;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) parts.push_back(fmt::format("{} {}{}", count, what, count == 1 ? "" : "s"));
  };
  add(scene.arrays.size(), "array");
  add(scene.blobs.size(), "blob");
  add(scene.document.empty() ? 0 : 1, "document");
  return list(parts, "and");
}

gltf::WriteOptions options_for(gltf::Form form, const std::string& path) {
  gltf::WriteOptions how;
  how.form = form;
  how.embed = path == "-";
  if (form == gltf::Form::gltf && path != "-")
    how.buffer_name = fs::path(path).stem().string() + ".bin";
  return how;
}

Outcome<gltf::Written> write_scene(const Scene& scene, gltf::Form form, const std::string& path) {
  Expected<gltf::Written> written = gltf::write(scene, options_for(form, path));
  if (!written && written.error().code == ErrorCode::unsupported)
    return stop(Exit::usage, output_name(path) +
                                 ": what was encoded is no glTF scene; --to ply, obj, off or stl "
                                 "takes its meshes");
  if (!written) return stop(output_name(path), written.error());
  return std::move(*written);
}

}  // namespace clers::cli
