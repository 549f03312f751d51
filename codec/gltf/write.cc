// Buffers of meshes, arrays and blobs, by the plan; then the JSON, and the files that it names.
#include <algorithm>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "codec/base/guarded.h"
#include "codec/gltf/bounds.h"
#include "codec/gltf/extension.h"
#include "codec/gltf/glb.h"
#include "codec/gltf/gltf.h"
#include "codec/gltf/json.h"
#include "codec/gltf/marks.h"
#include "codec/gltf/places.h"
#include "codec/gltf/plan.h"
#include "codec/gltf/rest.h"
#include "codec/gltf/triangles.h"
#include "codec/gltf/uri.h"
#include "codec/gltf/values.h"
#include "codec/gltf/write_files.h"

namespace clers::gltf {
namespace {

Failure<Error> inconsistent(std::string what) {
  return fail(ErrorCode::inconsistent_mesh, "glTF: " + std::move(what));
}

std::uint32_t word(const std::vector<std::byte>& data, std::size_t i) {
  std::uint32_t value = 0;
  std::memcpy(&value, data.data() + i * sizeof value, sizeof value);
  return value;
}

class Builder {
 public:
  /// `files`: of each mesh, if the extension is wanted.
  Builder(const Scene& scene, const WriteOptions& options,
          std::span<const std::vector<std::byte>> files)
      : scene_(scene), options_(options), files_(files) {}

  Expected<Written> run() {
    if (auto ok = open(); !ok) return Failure{ok.error()};
    if (auto ok = fill(); !ok) return Failure{ok.error()};
    restore_bounds(layout_, plan_, buffers_, marks_, document_);
    compress(layout_, plan_, files_, document_, buffers_);
    name_pictures();
    name_buffers();
    const std::string text = print(document_);
    if (options_.form == Form::gltf) {
      const auto bytes = std::as_bytes(std::span(text));
      result_.bytes.assign(bytes.begin(), bytes.end());
      return std::move(result_);
    }
    auto bytes = join(text, chunks());
    if (!bytes) return Failure{bytes.error()};
    result_.bytes = std::move(*bytes);
    return std::move(result_);
  }

 private:
  /// Reads the document, and makes its plan again.
  Expected<Done> open() {
    if (scene_.document.empty()) return fail(ErrorCode::unsupported, "this was not made of a glTF");
    auto document = parse(scene_.document);
    if (!document) return Failure{document.error()};
    document_ = std::move(*document);
    auto marks = take_marks(document_);
    if (!marks) return Failure{marks.error()};
    marks_ = std::move(*marks);
    restore_places(document_);
    const Json* buffers = document_.find("buffers");
    empty_ = as_set(marks_.empty, buffers == nullptr ? 0 : buffers->items.size());
    auto layout = read_layout(document_, empty_);
    if (!layout) return Failure{layout.error()};
    layout_ = std::move(*layout);
    if (auto ok = check_sizes(); !ok) return ok;
    auto plan = make_plan(layout_, document_, as_set(marks_.odd, layout_.runs.size()));
    if (!plan) return Failure{plan.error()};
    plan_ = std::move(*plan);
    for (const Blob& blob : scene_.blobs) blobs_.emplace(blob.name, &blob);
    return Done{};
  }

  /// Refuses buffers that are longer than what there is to fill them.
  Expected<Done> check_sizes() const {
    std::uint64_t there = most_zeros;
    for (const Mesh& mesh : scene_.meshes) {
      there += sizeof(std::uint32_t) * (mesh.corners.size() + std::uint64_t(mesh.vertex_count));
      for (const Attribute& a : mesh.attributes) there += a.data.size();
    }
    for (const Array& array : scene_.arrays) there += array.data.size();
    for (const Blob& blob : scene_.blobs) there += blob.bytes.size();
    std::uint64_t needed = 0;
    for (std::size_t i = 0; i < layout_.buffers.size(); ++i)
      if (!empty_[i]) needed = std::min(needed + layout_.buffers[i], ~std::uint64_t(0) >> 1);
    if (needed > there)
      return inconsistent("buffers of " + std::to_string(needed) +
                          " bytes, but there are at most " + std::to_string(there) +
                          " to fill them");
    return Done{};
  }

  Expected<Done> fill() {
    for (std::size_t i = 0; i < layout_.buffers.size(); ++i)
      buffers_.emplace_back(empty_[i] ? 0 : static_cast<std::size_t>(layout_.buffers[i]));
    if (plan_.meshes.size() != scene_.meshes.size())
      return inconsistent("the document has " + std::to_string(plan_.meshes.size()) +
                          " meshes, the scene " + std::to_string(scene_.meshes.size()));
    if (plan_.arrays.size() != scene_.arrays.size())
      return inconsistent("the document has " + std::to_string(plan_.arrays.size()) +
                          " arrays, the scene " + std::to_string(scene_.arrays.size()));
    for (std::size_t i = 0; i < plan_.meshes.size(); ++i)
      if (auto ok = put_mesh(plan_.meshes[i], scene_.meshes[i]); !ok)
        return inconsistent("mesh " + std::to_string(i) + " has " + ok.error().what);
    for (std::size_t i = 0; i < plan_.arrays.size(); ++i)
      if (auto ok = put_array(plan_.arrays[i], scene_.arrays[i]); !ok)
        return inconsistent("array " + std::to_string(i) + " has " + ok.error().what);
    sort_sparse();
    return put_remains();
  }

  static Failure<Error> other(std::string what) {
    return fail(ErrorCode::inconsistent_mesh, std::move(what));
  }

  Expected<Done> put_mesh(const MeshPlan& plan, const Mesh& mesh) {
    const std::size_t lists = plan.list_count();
    if (mesh.vertex_count != plan.vertices)
      return other(std::to_string(mesh.vertex_count) + " vertices, expected " +
                   std::to_string(plan.vertices));
    if (mesh.attributes.size() != plan.attributes.size() + (lists > 1) ||
        (lists > 1) != (lists_of(mesh) != nullptr))
      return other(std::to_string(mesh.attributes.size()) + " attributes");
    for (std::size_t i = 0; i < plan.attributes.size(); ++i)
      if (mesh.attributes[i].name != plan.attributes[i].name ||
          !is_values_of(mesh.attributes[i], layout_.runs[plan.attributes[i].run]))
        return other("an attribute that is not '" + plan.attributes[i].name +
                     "' as the document says");
    auto corners = part_triangles(mesh);
    if (!corners) return Failure{corners.error()};
    if (corners->size() > lists) return other(std::to_string(corners->size()) + " lists of faces");
    corners->resize(lists);
    for (std::size_t k = 0; k < plan.lists.size(); ++k)
      if ((*corners)[k].size() != layout_.runs[plan.lists[k]].count)
        return other(std::to_string((*corners)[k].size()) + " corners in list " +
                     std::to_string(k) + ", expected " +
                     std::to_string(layout_.runs[plan.lists[k]].count));
    auto numbers = vertex_numbers(plan.vertices, *corners, plan.in_turn);
    if (!numbers) return Failure{numbers.error()};
    for (std::size_t i = 0; i < plan.attributes.size(); ++i)
      scatter(layout_.runs[plan.attributes[i].run], renumbered(mesh.attributes[i], *numbers),
              buffers_);
    for (std::size_t k = 0; k < plan.lists.size(); ++k) {
      for (std::uint32_t& v : (*corners)[k]) v = (*numbers)[v];
      scatter_indices(layout_.runs[plan.lists[k]], (*corners)[k], buffers_);
    }
    numbers_.push_back(std::move(*numbers));
    return Done{};
  }

  Expected<Done> put_array(const ArrayPlan& plan, const Array& array) {
    const bool vertices = plan.mesh != none;
    std::uint64_t expected = 0;
    for (const std::size_t i : plan.runs)
      expected +=
          vertices ? sizeof(std::uint32_t) * layout_.runs[i].count : packed_size(layout_.runs[i]);
    if (array.data.size() != expected ||
        array.scalar != (vertices ? Scalar::uint32 : plan.scalar) ||
        array.components != (vertices ? 1 : plan.components) ||
        array.vertices_of != (vertices ? std::optional(plan.mesh) : std::nullopt))
      return other("not what the document says of '" + plan.name + "'");
    std::size_t at = 0;
    for (const std::size_t i : plan.runs) {
      const Run& run = layout_.runs[i];
      if (!vertices) {
        scatter(run, std::span(array.data).subspan(at, packed_size(run)), buffers_);
        at += packed_size(run);
        continue;
      }
      std::vector<std::uint32_t> indices;
      const std::vector<std::uint32_t>& numbers = numbers_[plan.mesh];
      for (std::uint64_t k = 0; k < run.count; ++k, ++at) {
        const std::uint32_t v = word(array.data, at);
        if (v >= numbers.size()) return other("vertex " + std::to_string(v));
        indices.push_back(numbers[v]);
      }
      scatter_indices(run, indices, buffers_);
    }
    return Done{};
  }

  /// Indices of sparse values ascend: these follow them where vertices were renumbered.
  void sort_sparse() {
    std::set<std::size_t> renumbered;
    for (const ArrayPlan& array : plan_.arrays)
      if (array.mesh != none) renumbered.insert(array.runs.begin(), array.runs.end());
    std::map<std::size_t, std::set<std::size_t>> values_of;
    for (const Accessor& a : layout_.accessors)
      if (a.indices != none && renumbered.contains(plan_.first[a.indices]))
        values_of[plan_.first[a.indices]].insert(plan_.first[a.values]);
    for (const auto& [at, all_values] : values_of) {
      std::vector<std::uint32_t> indices = gather_indices(layout_.runs[at], buffers_);
      std::vector<std::uint32_t> order(indices.size());
      std::iota(order.begin(), order.end(), 0u);
      std::sort(order.begin(), order.end(),
                [&](std::uint32_t a, std::uint32_t b) { return indices[a] < indices[b]; });
      for (const std::size_t i : all_values) {
        const Run& run = layout_.runs[i];
        if (!plan_.taken[i]) continue;
        std::vector<std::byte> values, sorted;
        gather(run, buffers_, values);
        const std::size_t size = run.components() * size_of(run.scalar);
        for (const std::uint32_t k : order)
          sorted.insert(sorted.end(), values.begin() + static_cast<std::ptrdiff_t>(k * size),
                        values.begin() + static_cast<std::ptrdiff_t>((k + 1) * size));
        scatter(run, sorted, buffers_);
      }
      std::sort(indices.begin(), indices.end());
      scatter_indices(layout_.runs[at], indices, buffers_);
    }
  }

  Expected<Done> put_remains() {
    for (const Remains& remains : find_remains(layout_, plan_, document_, empty_)) {
      const auto found = blobs_.find(remains.name);
      if (found == blobs_.end()) continue;  // zeros
      const std::vector<std::byte>& bytes = found->second->bytes;
      if (bytes.size() != remains.size())
        return inconsistent("blob '" + remains.name + "' has " + std::to_string(bytes.size()) +
                            " bytes, expected " + std::to_string(remains.size()));
      auto from = bytes.begin();
      for (const auto& [begin, end] : remains.parts) {
        const auto next = from + static_cast<std::ptrdiff_t>(end - begin);
        std::copy(from, next,
                  buffers_[remains.buffer].begin() + static_cast<std::ptrdiff_t>(begin));
        from = next;
      }
    }
    return Done{};
  }

  /// A file beside the JSON, or part of it: sets what a URI says.
  void put_file(std::string& uri, const char* type, std::span<const std::byte> bytes) {
    const auto path = relative_path(uri);
    const auto is_it = [&](const File& file) { return file.path == *path; };
    std::vector<File>& files = result_.files;
    if (!options_.embed && path && leads_down(*path)) {
      const auto known = std::find_if(files.begin(), files.end(), is_it);
      if (known != files.end() && std::ranges::equal(known->bytes, bytes)) return;
      if (known == files.end()) {
        files.push_back({*path, {bytes.begin(), bytes.end()}});
        return;
      }
    }
    uri = "data:" + std::string(type) + ";base64," + base64(bytes);
  }

  void name_pictures() {
    Json* images = document_.find("images");
    if (images == nullptr) return;
    for (std::size_t i = 0; i < images->items.size(); ++i) {
      Json* uri = images->items[i].find("uri");
      const auto blob = blobs_.find(blob_name("image", i));
      if (uri == nullptr || !uri->is(Json::Kind::string) || blob == blobs_.end()) continue;
      const std::vector<std::byte>& bytes = blob->second->bytes;
      if (data_head(uri->text))
        uri->text += base64(bytes);
      else
        put_file(uri->text, uri->text.ends_with(".png") ? "image/png" : "image/jpeg", bytes);
    }
  }

  void name_buffers() {
    Json* buffers = document_.find("buffers");
    if (buffers == nullptr) return;
    for (std::size_t i = 0; i < buffers->items.size(); ++i) {
      if (i < empty_.size() && empty_[i]) continue;
      Json& json = buffers->items[i];
      std::vector<std::byte>& bytes = buffers_[i];
      const auto behind = blobs_.find(blob_name("behind buffer", i));
      if (behind != blobs_.end())
        bytes.insert(bytes.end(), behind->second->bytes.begin(), behind->second->bytes.end());
      Json* uri = json.find("uri");
      if (options_.form == Form::glb && i == 0) {
        json.remove("uri");
        has_binary_ = true;
      } else if (uri != nullptr && data_head(uri->text)) {
        uri->text += base64(bytes);
      } else {
        const bool named = uri != nullptr && uri->is(Json::Kind::string);
        std::string text = named ? uri->text : options_.buffer_name;
        put_file(text, "application/octet-stream", bytes);
        if (uri == nullptr)
          json.add("uri", Json::string(text));
        else
          *uri = Json::string(text);
      }
    }
  }

  std::vector<Chunk> chunks() const {
    std::vector<Chunk> all;
    if (has_binary_) all.push_back({chunk_bin, buffers_[0]});
    for (std::size_t i = 0; i < marks_.chunks.size(); ++i)
      if (const auto blob = blobs_.find(blob_name("chunk", i)); blob != blobs_.end())
        all.push_back({static_cast<std::uint32_t>(marks_.chunks[i]), blob->second->bytes});
    return all;
  }

  const Scene& scene_;
  const WriteOptions& options_;
  const std::span<const std::vector<std::byte>> files_;
  Json document_;
  Marks marks_;
  std::vector<bool> empty_;
  Layout layout_;
  Plan plan_;
  Buffers buffers_;
  std::map<std::string, const Blob*> blobs_;
  std::vector<std::vector<std::uint32_t>> numbers_;  ///< of vertices, for each mesh
  bool has_binary_ = false;
  Written result_;
};

}  // namespace

Expected<Written> write(const Scene& scene, const WriteOptions& options) {
  return internal::guarded("write a glTF", [&] { return Builder(scene, options, {}).run(); });
}

Expected<Written> write_files(const Scene& scene, std::span<const std::vector<std::byte>> files,
                              const WriteOptions& options) {
  return Builder(scene, options, files).run();
}

std::optional<Form> form_of(const Scene& scene) {
  auto document = parse(scene.document);
  if (!document) return std::nullopt;
  const auto marks = take_marks(*document);
  if (!marks) return std::nullopt;
  return marks->form;
}

}  // namespace clers::gltf
