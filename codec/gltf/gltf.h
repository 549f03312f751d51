// glTF 2.0 <-> scenes.
#ifndef CLERS_CODEC_GLTF_GLTF_H
#define CLERS_CODEC_GLTF_GLTF_H

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <clers/error.h>
#include <clers/info.h>
#include <clers/options.h>
#include <clers/order.h>
#include <clers/precision.h>
#include <clers/scene.h>
#include <clers/topology/export.h>

namespace clers {
namespace CLERS_VISIBLE gltf {

/// One file of all, or JSON that names others.
enum class Form : std::uint8_t { glb, gltf };

/// Another file that a glTF names, by its path from there: without escapes.
struct File {
  std::string path;
  std::vector<std::byte> bytes;
};
/// Reads such a file.
using Fetch = std::function<Expected<std::vector<std::byte>>(const std::string& path)>;

/// What others compressed is decoded by whoever can: <clers/draco.h>, <clers/meshopt.h>. Without
/// that it stays as it is, bytes that are carried along.
struct Decoders {
  /// Of KHR_draco_mesh_compression, given the bytes of its bufferView: a mesh of triangles with a
  /// value for each vertex, attributes that have Draco's unique ids, in decimal, for names, and
  /// metadata of the same keys that say how these were quantised ("14 bits").
  std::function<Expected<Mesh>(std::span<const std::byte> bytes)> draco;
  /// Of EXT_meshopt_compression: the bytes that a bufferView stands for, count * stride.
  std::function<Expected<std::vector<std::byte>>(std::span<const std::byte> bytes,
                                                 std::size_t count, std::size_t stride,
                                                 std::string_view mode, std::string_view filter)>
      meshopt;
};

/// What a glTF becomes. Nothing of it is lost but the white space between the tokens of its JSON:
///
///   meshes    Primitives that share accessors are one mesh: their vertices, and all their
///             triangles. POSITION becomes "position", other attributes keep their names, those of
///             morph targets too. A face attribute "list" says which accessor of indices a triangle
///             is from, where there are several.
///   arrays    All other accessors: keys of animations, matrices, instances; indices of points,
///             lines, strips and fans, which refer to vertices.
///   blobs     Pictures, and what of buffers no accessor names.
///   document  The JSON, in which what the rest says is null or left out, and at its end "CLERS":
///             what else write() needs.
struct ReadResult {
  Scene scene;
  /// One a mesh, for encode(): an order is kept where vertices may be named by what is not known.
  std::vector<Order> orders;
  std::vector<std::string> notes;    ///< for people: files that are named and not there
  std::vector<std::string> remarks;  ///< likewise: what others compressed, and is not any more
};

/// Reads a .glb or a .gltf, by its first bytes; `fetch` reads what it names. What vertices and
/// triangles it has may be in any order afterwards: encode() may renumber them, and all that names
/// vertices follows. What `decoders` decode becomes plain accessors, and their extensions go; where
/// the document has plain values beside what Draco compressed, these are taken.
///
/// Errors: malformed, with the place in the JSON, or the byte; unsupported, of another version;
/// what `fetch` and `decoders` return; out_of_memory. Memory: some 100 bytes a token of JSON, and a
/// small multiple of the rest. Cost: linear, n log n in the accessors.
Expected<ReadResult> read(std::span<const std::byte> bytes, const Fetch& fetch,
                          const Decoders& decoders = {});

/// The form that a scene was read from; none if it was not read from a glTF.
std::optional<Form> form_of(const Scene& scene);

struct WriteOptions {
  Form form = Form::glb;
  /// What a buffer that has no name yet is called in Form::gltf; "": it becomes part of the JSON.
  std::string buffer_name = "";
  bool embed = false;  ///< pictures and buffers become part of the JSON rather than other files
};

struct Written {
  std::vector<std::byte> bytes;
  std::vector<File> files;  ///< to be written beside it; their paths lead nowhere above it
};

/// Writes a scene that read() made, or that came of one by encode() and decode_scene(). The JSON is
/// as it was, but for what says where things are (buffers, byteOffset, byteLength), and `min` and
/// `max` of accessors whose values were quantised, which are those of what is written.
///
/// Errors: unsupported, a scene without a glTF; malformed and inconsistent_mesh, a document or
/// contents that do not fit each other, whatever they are; out_of_memory.
Expected<Written> write(const Scene& scene, const WriteOptions& options = {});

/// The same with each mesh as a .clers file in a bufferView, which the extension
/// CLERS_mesh_compression names (codec/gltf/CLERS_mesh_compression.md). `scene` is one that read()
/// made, with its orders, not yet encoded. read() reads what it makes; others refuse it, since the
/// extension is required. Errors besides: those of encode. Buffers have no bytes that no view
/// names.
struct Compressed {
  Written written;
  std::vector<MeshInfo> report;   ///< of meshes, as Encoded has them
  std::vector<Warning> warnings;  ///< likewise
};
Expected<Compressed> write_compressed(const Scene& scene, std::span<const Order> orders,
                                      const EncodeOptions& how, const WriteOptions& options = {});

}  // namespace gltf
}  // namespace clers

#endif
