// Marks what is known, byte by byte, and collects what is not.
#include "codec/gltf/rest.h"

#include "codec/gltf/values.h"

namespace clers::gltf {

std::size_t Remains::size() const {
  std::size_t sum = 0;
  for (const auto& [from, to] : parts) sum += to - from;
  return sum;
}

std::string blob_name(const char* what, std::size_t index) {
  return std::string(what) + " " + std::to_string(index);
}

std::vector<Remains> find_remains(const Layout& layout, const Plan& plan, const Json& document,
                                  const std::vector<bool>& empty) {
  std::vector<std::vector<bool>> known(layout.buffers.size());
  for (std::size_t b = 0; b < known.size(); ++b)
    if (!empty[b]) known[b].resize(static_cast<std::size_t>(layout.buffers[b]));
  for (std::size_t i = 0; i < layout.runs.size(); ++i)
    if (plan.taken[i] && plan.first[i] == i)
      for_each_column(layout.runs[i], [&](std::size_t place, std::size_t bytes) {
        for (std::size_t k = 0; k < bytes; ++k) known[layout.runs[i].buffer][place + k] = true;
      });
  std::vector<Remains> pictures;
  if (const Json* images = document.find("images"))
    for (std::size_t i = 0; i < images->items.size(); ++i) {
      const Json* index = images->items[i].find("bufferView");
      const auto view = index == nullptr ? std::nullopt : integer(*index);
      if (!view || *view >= layout.views.size()) continue;
      const View& v = layout.views[static_cast<std::size_t>(*view)];
      if (empty[v.buffer] || v.length == 0) continue;
      const auto from = static_cast<std::size_t>(v.offset),
                 to = static_cast<std::size_t>(v.offset + v.length);
      bool alone = true;
      for (std::size_t k = from; k < to && alone; ++k) alone = !known[v.buffer][k];
      if (!alone) continue;
      for (std::size_t k = from; k < to; ++k) known[v.buffer][k] = true;
      pictures.push_back({blob_name("image", i), v.buffer, {{from, to}}});
    }
  std::vector<Remains> all;
  for (std::size_t b = 0; b < known.size(); ++b) {
    Remains rest{blob_name("buffer", b), b, {}};
    for (std::size_t k = 0; k < known[b].size(); ++k) {
      if (known[b][k]) continue;
      if (rest.parts.empty() || rest.parts.back().second != k) rest.parts.emplace_back(k, k);
      ++rest.parts.back().second;
    }
    if (!rest.parts.empty()) all.push_back(std::move(rest));
  }
  for (Remains& picture : pictures) all.push_back(std::move(picture));
  return all;
}

}  // namespace clers::gltf
