// Chunks, JSON and files that it names; then runs of values, by the plan.
#include <algorithm>
#include <cstring>
#include <set>
#include <utility>

#include "codec/base/guarded.h"
#include "codec/gltf/bounds.h"
#include "codec/gltf/extension.h"
#include "codec/gltf/foreign.h"
#include "codec/gltf/glb.h"
#include "codec/gltf/gltf.h"
#include "codec/gltf/json.h"
#include "codec/gltf/marks.h"
#include "codec/gltf/places.h"
#include "codec/gltf/plan.h"
#include "codec/gltf/rest.h"
#include "codec/gltf/uri.h"
#include "codec/gltf/values.h"

namespace clers::gltf {
namespace {

using Bytes = std::vector<std::byte>;

class Reader {
 public:
  Reader(const Fetch& fetch, const Decoders& decoders) : fetch_(fetch), decoders_(decoders) {}

  Expected<ReadResult> run(std::span<const std::byte> bytes) {
    if (auto ok = open(bytes); !ok) return Failure{ok.error()};
    if (auto ok = check_version(); !ok) return Failure{ok.error()};
    if (auto ok = read_buffers(); !ok) return Failure{ok.error()};
    if (auto ok = decode_foreign(); !ok) return Failure{ok.error()};
    std::vector<bool> empty = as_set(marks_.empty, buffers_.size());
    if (auto ok = expand(document_, buffers_, empty); !ok) return Failure{ok.error()};
    empty.resize(buffers_.size());
    auto layout = read_layout(document_, empty);
    if (!layout) return Failure{layout.error()};
    layout_ = std::move(*layout);
    const std::vector<bool> odd = find_odd();
    marks_.odd = as_list(odd);
    auto plan = make_plan(layout_, document_, odd);
    if (!plan) return Failure{plan.error()};
    plan_ = std::move(*plan);
    for (const MeshPlan& mesh : plan_.meshes) add_mesh(mesh);
    for (const ArrayPlan& array : plan_.arrays) add_array(array);
    add_remains(empty);
    add_pictures();
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
      marks_.chunks.push_back(chunks_[i].type);
      add_blob(blob_name("chunk", i), Bytes(chunks_[i].bytes.begin(), chunks_[i].bytes.end()));
    }
    shorten_bounds(layout_, plan_, buffers_, document_, marks_);
    shorten_places(document_);
    put_marks(marks_, document_);
    result_.scene.document = print(document_);
    return std::move(result_);
  }

 private:
  Expected<Done> open(std::span<const std::byte> bytes) {
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (is_glb(bytes)) {
      auto glb = split(bytes);
      if (!glb) return Failure{glb.error()};
      text = glb->json;
      chunks_ = std::move(glb->others);
      if (!chunks_.empty() && chunks_[0].type == chunk_bin) {
        binary_ = chunks_[0].bytes;
        chunks_.erase(chunks_.begin());
      }
    } else {
      marks_.form = Form::gltf;
    }
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    while (text.ends_with('\0')) text.remove_suffix(1);
    auto document = parse(text);
    if (!document) return Failure{document.error()};
    if (!document->is(Json::Kind::object))
      return fail(ErrorCode::malformed, "glTF: the JSON is no object");
    document_ = std::move(*document);
    return Done{};
  }

  Expected<Done> check_version() const {
    const Json* asset = document_.find("asset");
    const Json* version = asset == nullptr ? nullptr : asset->find("version");
    if (version == nullptr || !version->is(Json::Kind::string))
      return fail(ErrorCode::malformed, "glTF: asset.version is missing");
    if (version->text != "2" && !version->text.starts_with("2."))
      return fail(ErrorCode::unsupported, "glTF of version " + version->text + ", expected 2.0");
    return Done{};
  }

  /// Bytes that a URI names, if a file is what it names.
  Expected<Bytes> fetch(const std::string& uri) const {
    const auto path = relative_path(uri);
    if (!path) return fail(ErrorCode::unsupported, "'" + uri + "' is no file beside the glTF");
    if (!fetch_) return fail(ErrorCode::io_failed, "'" + *path + "' is another file");
    return fetch_(*path);
  }

  Expected<Done> read_buffers() {
    if (auto list = list_of(document_, "buffers"); !list) return Failure{list.error()};
    Json* buffers = document_.find("buffers");
    if (buffers == nullptr) return Done{};
    for (std::size_t i = 0; i < buffers->items.size(); ++i) {
      auto bytes = read_buffer(buffers->items[i], i);
      if (!bytes) return Failure{bytes.error()};
      buffers_.push_back(std::move(*bytes));
    }
    return Done{};
  }

  /// The bytes of a buffer, as many as it says.
  Expected<Bytes> read_buffer(Json& json, std::size_t index) {
    std::string fault;
    const std::uint64_t size = member(json, "byteLength", 0, fault);
    Json* uri = json.find("uri");
    if (fault.empty() && uri != nullptr && !uri->is(Json::Kind::string)) fault = "uri is no text";
    if (!fault.empty()) return malformed("buffers", index, std::move(fault));
    Bytes bytes;
    if (uri != nullptr) {
      if (auto inside = data_bytes(uri->text)) {
        bytes = std::move(*inside);
        uri->text = *data_head(uri->text);
      } else if (data_head(uri->text)) {
        return malformed("buffers", index, "no base64 in its uri");
      } else {
        auto read = fetch(uri->text);
        if (!read) return read;
        bytes = std::move(*read);
      }
    } else if (index == 0 && binary_.data() != nullptr) {
      bytes.assign(binary_.begin(), binary_.end());
    } else {
      marks_.empty.push_back(index);
      return bytes;
    }
    if (bytes.size() < size)
      return malformed("buffers", index,
                       std::to_string(bytes.size()) + " bytes, expected " + std::to_string(size));
    const auto more = std::span(bytes).subspan(static_cast<std::size_t>(size));
    const bool filling = more.size() < 4 && std::all_of(more.begin(), more.end(), [](std::byte b) {
                           return b == std::byte{0};
                         });
    if (!filling) add_blob(blob_name("behind buffer", index), Bytes(more.begin(), more.end()));
    bytes.resize(static_cast<std::size_t>(size));
    return bytes;
  }

  /// What others compressed. Buffers without bytes may go with it.
  Expected<Done> decode_foreign() {
    if (auto ok =
            decode_meshopt(document_, buffers_, marks_.empty, decoders_.meshopt, result_.remarks);
        !ok)
      return ok;
    return decode_draco(document_, buffers_, as_set(marks_.empty, buffers_.size()), decoders_.draco,
                        result_.remarks);
  }

  /// Indices that lead beyond the vertices, and those of sparse values that do not ascend.
  std::vector<bool> find_odd() const {
    std::vector<bool> odd(layout_.runs.size());
    const auto look = [&](std::size_t i, std::uint64_t count, bool ascending) {
      if (!layout_.runs[i].has_bytes()) return;
      std::uint64_t least = 0;
      for (const std::uint32_t v : gather_indices(layout_.runs[i], buffers_)) {
        if (v >= count || (ascending && v < least)) odd[i] = true;
        least = std::uint64_t(v) + 1;
      }
    };
    for (const Accessor& a : layout_.accessors)
      if (a.indices != none) look(a.indices, a.count, true);
    std::vector<std::uint64_t> least(layout_.accessors.size(), ~std::uint64_t(0));
    for (const Primitive& p : layout_.primitives) {
      std::uint64_t count = p.vertices.empty() ? 0 : ~std::uint64_t(0);
      for (const Primitive::Vertices& v : p.vertices)
        count = std::min(count, layout_.accessors[v.accessor].count);
      if (p.indices != none) least[p.indices] = std::min(least[p.indices], count);
      for (const std::size_t i : p.other_indices) least[i] = std::min(least[i], count);
    }
    for (std::size_t i = 0; i < least.size(); ++i)
      if (least[i] != ~std::uint64_t(0)) look(layout_.accessors[i].base, least[i], false);
    // Runs that are the same are odd together.
    return odd;
  }

  void add_mesh(const MeshPlan& plan) {
    Mesh mesh;
    mesh.name = plan.name;
    mesh.vertex_count = plan.vertices;
    for (const MeshPlan::Slot& slot : plan.attributes) {
      const Run& run = layout_.runs[slot.run];
      Attribute a{
          slot.name, Domain::vertex, run.scalar, static_cast<std::uint8_t>(run.components()), {}};
      gather(run, buffers_, a.data);
      mesh.attributes.push_back(std::move(a));
    }
    std::vector<std::uint32_t> list_of_face;
    const auto close_list = [&](std::size_t list) {
      list_of_face.resize(mesh.corners.size() / 3, static_cast<std::uint32_t>(list));
    };
    for (std::size_t i = 0; i < plan.lists.size(); ++i) {
      const std::vector<std::uint32_t> indices =
          gather_indices(layout_.runs[plan.lists[i]], buffers_);
      mesh.corners.insert(mesh.corners.end(), indices.begin(), indices.end());
      close_list(i);
    }
    if (plan.in_turn) {
      for (std::uint32_t v = 0; v < plan.vertices; ++v) mesh.corners.push_back(v);
      close_list(plan.lists.size());
    }
    if (plan.list_count() > 1) {
      Attribute a{list_name, Domain::face, Scalar::uint32, 1, {}};
      a.data.resize(list_of_face.size() * sizeof(std::uint32_t));
      std::memcpy(a.data.data(), list_of_face.data(), a.data.size());
      mesh.attributes.push_back(std::move(a));
    }
    result_.orders.push_back(plan.keep ? Order::keep : Order::free);
    result_.scene.meshes.push_back(std::move(mesh));
  }

  void add_array(const ArrayPlan& plan) {
    Array array{plan.name, plan.scalar, plan.components, {}};
    if (plan.mesh != none) {
      array.scalar = Scalar::uint32;
      array.components = 1;
      array.vertices_of = plan.mesh;
    }
    for (const std::size_t i : plan.runs) {
      if (plan.mesh == none) {
        gather(layout_.runs[i], buffers_, array.data);
        continue;
      }
      const auto indices = gather_indices(layout_.runs[i], buffers_);
      const auto bytes = std::as_bytes(std::span(indices));
      array.data.insert(array.data.end(), bytes.begin(), bytes.end());
    }
    result_.scene.arrays.push_back(std::move(array));
  }

  void add_blob(std::string name, Bytes bytes) {
    result_.scene.blobs.push_back({std::move(name), std::move(bytes)});
  }

  void add_remains(const std::vector<bool>& empty) {
    std::size_t zeros = most_zeros;
    for (const Remains& remains : find_remains(layout_, plan_, document_, empty)) {
      Bytes bytes;
      bytes.reserve(remains.size());
      const Bytes& from = buffers_[remains.buffer];
      for (const auto& [begin, end] : remains.parts)
        bytes.insert(bytes.end(), from.begin() + static_cast<std::ptrdiff_t>(begin),
                     from.begin() + static_cast<std::ptrdiff_t>(end));
      const bool all_zeros =
          std::all_of(bytes.begin(), bytes.end(), [](std::byte b) { return b == std::byte{0}; });
      if (all_zeros && bytes.size() <= zeros)
        zeros -= bytes.size();
      else
        add_blob(remains.name, std::move(bytes));
    }
  }

  /// Pictures that a URI names: each file once.
  void add_pictures() {
    Json* images = document_.find("images");
    if (images == nullptr) return;
    std::set<std::string> known;
    for (std::size_t i = 0; i < images->items.size(); ++i) {
      Json* uri = images->items[i].find("uri");
      if (uri == nullptr || !uri->is(Json::Kind::string)) continue;
      if (auto inside = data_bytes(uri->text)) {
        const std::string head(*data_head(uri->text));
        if (head + base64(*inside) != uri->text) continue;  // stays as it is
        uri->text = head;
        add_blob(blob_name("image", i), std::move(*inside));
      } else if (relative_path(uri->text) && known.insert(uri->text).second) {
        auto bytes = fetch(uri->text);
        if (bytes)
          add_blob(blob_name("image", i), std::move(*bytes));
        else
          result_.notes.push_back("image " + std::to_string(i) +
                                  " is named only: " + bytes.error().what);
      }
    }
  }

  const Fetch& fetch_;
  const Decoders& decoders_;
  Marks marks_;
  Json document_;
  std::span<const std::byte> binary_;
  std::vector<Chunk> chunks_;
  Buffers buffers_;
  Layout layout_;
  Plan plan_;
  ReadResult result_;
};

}  // namespace

Expected<ReadResult> read(std::span<const std::byte> bytes, const Fetch& fetch,
                          const Decoders& decoders) {
  return internal::guarded("read a glTF", [&] { return Reader(fetch, decoders).run(bytes); });
}

}  // namespace clers::gltf
