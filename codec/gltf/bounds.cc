// Least and greatest components, once a run.
#include "codec/gltf/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace clers::gltf {
namespace {

struct Bounds {
  std::vector<double> least, greatest;
};

/// Zeros have an order too, so that bounds do not depend on that of the values.
bool before(double a, double b) {
  return a < b || (a == b && std::signbit(a) && !std::signbit(b));
}

/// Bounds of values; none if there are none, or a NaN or infinity.
class Finder {
 public:
  explicit Finder(unsigned components)
      : bounds_{std::vector<double>(components, std::numeric_limits<double>::infinity()),
                std::vector<double>(components, -std::numeric_limits<double>::infinity())} {}

  void add(const Run& run, std::span<const std::byte> values) {
    with_type(run.scalar, [&](auto type) {
      using T = decltype(type);
      const std::size_t n = bounds_.least.size();
      for (std::size_t i = 0; i < values.size() / sizeof(T); ++i) {
        T value;
        std::memcpy(&value, values.data() + i * sizeof(T), sizeof value);
        add(i % n, static_cast<double>(value));
      }
    });
  }
  void add_zero() {
    for (std::size_t c = 0; c < bounds_.least.size(); ++c) add(c, 0);
  }
  std::optional<Bounds> found() && {
    if (!finite_ || std::isinf(bounds_.least[0])) return std::nullopt;
    return std::move(bounds_);
  }

 private:
  void add(std::size_t c, double value) {
    finite_ = finite_ && std::isfinite(value);
    if (before(value, bounds_.least[c])) bounds_.least[c] = value;
    if (before(bounds_.greatest[c], value)) bounds_.greatest[c] = value;
  }

  Bounds bounds_;
  bool finite_ = true;
};

class AllBounds {
 public:
  AllBounds(const Layout& layout, const Plan& plan, const Buffers& buffers)
      : layout_(layout), plan_(plan), buffers_(buffers), of_run_(layout.runs.size()) {
    for (std::size_t i = 0; i < layout.runs.size(); ++i)
      if (plan.taken[i] && plan.first[i] == i) {
        std::vector<std::byte> values;
        gather(layout.runs[i], buffers, values);
        Finder finder(layout.runs[i].components());
        finder.add(layout.runs[i], values);
        of_run_[i] = std::move(finder).found();
      }
  }

  /// None where values are not known to this library.
  std::optional<Bounds> of(const Accessor& a) const {
    const Run& base = layout_.runs[a.base];
    if (a.count == 0 || (base.has_bytes() && !plan_.taken[a.base])) return std::nullopt;
    if (a.values == none || layout_.runs[a.values].count == 0)
      return base.has_bytes() ? of_run_[plan_.first[a.base]] : zeros(base);
    const Run &indices = layout_.runs[a.indices], &values = layout_.runs[a.values];
    // Once for each run of values: the time that it takes is linear whatever a document says.
    if (!plan_.taken[a.indices] || !plan_.taken[a.values] || plan_.first[a.values] != a.values ||
        (base.has_bytes() && plan_.first[a.base] != a.base))
      return std::nullopt;
    std::vector<std::byte> all, changed;
    gather(values, buffers_, changed);
    Finder finder(base.components());
    if (!base.has_bytes()) {
      if (values.count < a.count) finder.add_zero();
      finder.add(values, changed);
      return std::move(finder).found();
    }
    gather(base, buffers_, all);
    const std::size_t size = base.components() * size_of(base.scalar);
    std::size_t i = 0;
    for (const std::uint32_t at : gather_indices(indices, buffers_)) {
      if (at >= a.count) return std::nullopt;
      std::memcpy(all.data() + at * size, changed.data() + i++ * size, size);
    }
    finder.add(base, all);
    return std::move(finder).found();
  }

 private:
  static std::optional<Bounds> zeros(const Run& run) {
    const std::vector<double> all(run.components());
    return Bounds{all, all};
  }

  const Layout& layout_;
  const Plan& plan_;
  const Buffers& buffers_;
  std::vector<std::optional<Bounds>> of_run_;
};

Json written(const std::vector<double>& values, Scalar scalar, Style style) {
  Json json{Json::Kind::array};
  for (const double value : values)
    json.items.push_back(Json::number(is_float(scalar)
                                          ? text_of(value, style)
                                          : std::to_string(static_cast<std::int64_t>(value))));
  return json;
}

bool same(const Json& a, const Json& b) {
  if (!a.is(Json::Kind::array) || a.items.size() != b.items.size()) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    if (!a.items[i].is(Json::Kind::number) || a.items[i].text != b.items[i].text) return false;
  return true;
}

/// Whether bounds that a document says hold: no value is `before` them, less or greater.
template <class Before>
bool hold(const Json& said, const std::vector<double>& found, Scalar scalar, Before is_before) {
  if (!said.is(Json::Kind::array) || said.items.size() != found.size()) return false;
  for (std::size_t i = 0; i < found.size(); ++i) {
    auto value = real(said.items[i]);
    if (!value) return false;
    if (scalar == Scalar::float32) value = static_cast<double>(static_cast<float>(*value));
    if (is_before(found[i], *value)) return false;
  }
  return true;
}
bool less(double a, double b) {
  return a < b;
}
bool greater(double a, double b) {
  return a > b;
}

struct Said {
  std::size_t accessor;
  Json *least, *greatest;
  Bounds found;
  Scalar scalar;

  bool true_of_all() const {
    return (least == nullptr || hold(*least, found.least, scalar, less)) &&
           (greatest == nullptr || hold(*greatest, found.greatest, scalar, greater));
  }
};

/// What the document says of bounds that are known.
std::vector<Said> said_in(Json& document, const Layout& layout, const Plan& plan,
                          const Buffers& buffers) {
  std::vector<Said> all;
  Json* accessors = document.find("accessors");
  if (accessors == nullptr) return all;
  const AllBounds bounds(layout, plan, buffers);
  for (std::size_t i = 0; i < accessors->items.size(); ++i) {
    Json *least = accessors->items[i].find("min"), *greatest = accessors->items[i].find("max");
    if (least == nullptr && greatest == nullptr) continue;
    const Accessor& a = layout.accessors[i];
    if (auto found = bounds.of(a))
      all.push_back({i, least, greatest, std::move(*found), layout.runs[a.base].scalar});
  }
  return all;
}

}  // namespace

void shorten_bounds(const Layout& layout, const Plan& plan, const Buffers& buffers, Json& document,
                    Marks& marks) {
  const std::vector<Said> all = said_in(document, layout, plan, buffers);
  std::array<std::size_t, style_count> fitting{};
  const auto fits = [](const Said& said, Style style) {
    return (said.least != nullptr &&
            same(*said.least, written(said.found.least, said.scalar, style))) +
           (said.greatest != nullptr &&
            same(*said.greatest, written(said.found.greatest, said.scalar, style)));
  };
  for (const Said& said : all)
    for (std::size_t s = 0; s < style_count; ++s)
      fitting[s] += static_cast<std::size_t>(fits(said, static_cast<Style>(s)));
  const auto best = std::max_element(fitting.begin(), fitting.end()) - fitting.begin();
  marks.style = static_cast<std::uint64_t>(best);
  const auto style = static_cast<Style>(best);
  for (const Said& said : all) {
    if (!said.true_of_all()) marks.loose.push_back(said.accessor);
    if (said.least != nullptr && same(*said.least, written(said.found.least, said.scalar, style)))
      *said.least = {};
    if (said.greatest != nullptr &&
        same(*said.greatest, written(said.found.greatest, said.scalar, style)))
      *said.greatest = {};
  }
}

void restore_bounds(const Layout& layout, const Plan& plan, const Buffers& buffers,
                    const Marks& marks, Json& document) {
  const std::vector<bool> loose = as_set(marks.loose, layout.accessors.size());
  const auto style = static_cast<Style>(marks.style);
  for (const Said& said : said_in(document, layout, plan, buffers)) {
    const bool leave = loose[said.accessor];
    if (said.least != nullptr &&
        (said.least->is(Json::Kind::null) ||
         (!leave && !hold(*said.least, said.found.least, said.scalar, less))))
      *said.least = written(said.found.least, said.scalar, style);
    if (said.greatest != nullptr &&
        (said.greatest->is(Json::Kind::null) ||
         (!leave && !hold(*said.greatest, said.found.greatest, said.scalar, greater))))
      *said.greatest = written(said.found.greatest, said.scalar, style);
  }
}

}  // namespace clers::gltf
