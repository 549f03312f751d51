// Wedges by comparing along edges; which values are equal by sorting.
#include "codec/attributes/structure_encoder.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

#include "codec/attributes/distinct_values.h"
#include "codec/base/no_index.h"
#include "codec/entropy/stream.h"

namespace clers::internal {
namespace {

/// Numbers in the order of first use, for numbers below `most`.
std::vector<std::uint32_t> by_first_use(std::span<const std::uint32_t> numbers, std::size_t most) {
  std::vector<std::uint32_t> result, of(most, no_index);
  result.reserve(numbers.size());
  std::uint32_t count = 0;
  for (const std::uint32_t n : numbers) {
    if (of[n] == no_index) of[n] = count++;
    result.push_back(of[n]);
  }
  return result;
}

std::uint32_t count_of(const std::vector<std::uint32_t>& numbers) {
  return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end()) + 1;
}

/// What code_structure asks.
class Elements {
 public:
  /// `by_value`: elements are compared by their values even if these have indices.
  Elements(const Attribute& attribute, bool by_value)
      : attribute_(attribute), stride_(attribute.stride()), by_value_(by_value) {}

  bool same(std::uint32_t e, std::uint32_t f) const {
    if (!by_value_) return attribute_.indices[e] == attribute_.indices[f];
    return std::memcmp(value(e), value(f), stride_) == 0;
  }
  std::vector<std::uint32_t> share(std::uint32_t, std::vector<std::uint32_t> elements) {
    list = std::move(elements);
    return numbers;
  }

  const std::byte* value(std::uint32_t e) const {
    const std::uint32_t i = attribute_.indices.empty() ? e : attribute_.indices[e];
    return attribute_.data.data() + i * stride_;
  }
  /// Those of the list, packed.
  Bytes values(std::span<const std::uint32_t> elements) const {
    Bytes result(elements.size() * stride_);
    std::byte* to = result.data();
    for (const std::uint32_t e : elements) {
      std::memcpy(to, value(e), stride_);
      to += stride_;
    }
    return result;
  }

  std::vector<std::uint32_t> list;     ///< elements, one for each value
  std::vector<std::uint32_t> numbers;  ///< of values that are listed

 private:
  const Attribute& attribute_;
  const std::size_t stride_;
  const bool by_value_;
};

/// Whether no two elements have one value by index.
bool are_apart(const Attribute& attribute) {
  std::vector<bool> used(attribute.value_count());
  for (const std::uint32_t i : attribute.indices) {
    if (i == no_value) continue;
    if (used[i]) return false;
    used[i] = true;
  }
  return true;
}

class StructureEncoder {
 public:
  StructureEncoder(const Attribute& attribute, const CodedFaces& faces, const Seams* beside,
                   int level)
      : attribute_(attribute),
        faces_(faces),
        beside_(beside),
        level_(level),
        apart_(attribute.domain == Domain::corner && !attribute.indices.empty() &&
               are_apart(attribute)),
        elements_(attribute, attribute.indices.empty() || apart_) {
    header_.any = true;
    header_.indexed = !attribute.indices.empty();
    header_.apart = apart_;
    header_.beside = attribute.domain == Domain::corner && beside != nullptr;
    header_.missing = std::find(attribute.indices.begin(), attribute.indices.end(), no_value) !=
                      attribute.indices.end();
  }

  std::vector<EncodedStructure> run(const std::vector<std::uint32_t>& numbering) {
    std::vector<EncodedStructure> all;
    const bool of_corners = attribute_.domain == Domain::corner;
    if (!header_.indexed && !of_corners) {
      all.push_back(none());
      return all;
    }
    if (!numbering.empty()) {
      header_.numbered = true;
      numbering_ = encode_stream([&](EncodeTo& coder) {
        std::vector<std::uint32_t> numbers = numbering;
        NumberingCoder().code(coder, numbers);
      });
    }
    EncodedStructure own = coded(Sharing::none);
    const std::vector<std::uint32_t> list = elements_.list;
    const std::size_t count = list.size(), most = attribute_.value_count();
    // Corners that have little in common.
    const bool poor = !header_.indexed && 4 * count > 3 * attribute_.value_count();
    if (poor) all.push_back(none());
    if (poor && level_ < 5) return all;
    const Bytes values = elements_.values(list);
    std::vector<std::uint32_t> equal;
    const bool by_index = header_.indexed && !apart_;
    if (by_index || level_ >= 5) equal = distinct_values(values, attribute_.stride());
    std::vector<std::uint32_t> indices;
    if (by_index) {
      for (const std::uint32_t e : list) indices.push_back(attribute_.indices[e]);
      indices = by_first_use(indices, most);
    }
    const std::size_t listed = count_of(by_index ? indices : equal);
    if (!by_index || listed == count) {
      all.push_back(finished(std::move(own), values));
    } else if (indices == equal) {
      own.header.sharing = Sharing::equal;
      all.push_back(finished(std::move(own), values));
      all.back().header.distinct = listed + all.back().header.unused;
    }
    const bool must = by_index && listed < count && indices != equal;
    if (must || (level_ >= 5 && listed < count - count / 8)) {
      elements_.numbers = by_index ? std::move(indices) : std::move(equal);
      EncodedStructure structure = coded(Sharing::listed);
      std::vector<std::uint32_t> first(listed);
      for (std::size_t i = count; i-- > 0;) first[elements_.numbers[i]] = list[i];
      all.push_back(finished(std::move(structure), elements_.values(first)));
    }
    return all;
  }

 private:
  EncodedStructure none() const {
    EncodedStructure result;
    result.values = attribute_.data;
    return result;
  }

  EncodedStructure coded(Sharing sharing) {
    EncodedStructure result;
    result.header = header_;
    result.header.sharing = sharing;
    result.header.values = no_value;
    result.structure.value_of.assign(faces_.count(attribute_.domain), unassigned);
    if (header_.missing)
      for (std::size_t e = 0; e < attribute_.indices.size(); ++e)
        if (attribute_.indices[e] == no_value) result.structure.value_of[e] = no_value;
    result.stream = encode_stream([&](EncodeTo& coder) {
      code_structure(coder, result.header, faces_, attribute_.domain, beside_, elements_,
                     result.structure);
    });
    return result;
  }

  /// With the values that are used, and those that are not.
  EncodedStructure finished(EncodedStructure result, Bytes values) const {
    const std::size_t stride = attribute_.stride(), used = values.size() / stride;
    if (header_.indexed) {
      std::vector<bool> is_used(attribute_.value_count());
      for (const std::uint32_t i : attribute_.indices)
        if (i != no_value) is_used[i] = true;
      for (std::size_t i = 0; i < is_used.size(); ++i)
        if (!is_used[i])
          values.insert(values.end(),
                        attribute_.data.begin() + static_cast<std::ptrdiff_t>(i * stride),
                        attribute_.data.begin() + static_cast<std::ptrdiff_t>((i + 1) * stride));
    }
    result.header.values = result.header.distinct = values.size() / stride;
    result.header.unused = result.header.values - used;
    if (apart_) result.header.distinct = attribute_.value_count();
    result.values = std::move(values);
    result.numbering = numbering_;
    return result;
  }

  const Attribute& attribute_;
  const CodedFaces& faces_;
  const Seams* const beside_;
  const int level_;
  const bool apart_;
  StructureHeader header_;
  Elements elements_;
  Bytes numbering_;
};

}  // namespace

std::vector<EncodedStructure> encode_structures(const Attribute& attribute, const CodedFaces& faces,
                                                const std::vector<std::uint32_t>& numbering,
                                                const Seams* beside, int level) {
  return StructureEncoder(attribute, faces, beside, level).run(numbering);
}

std::vector<std::uint32_t> kept_numbering(std::span<const std::uint32_t> indices,
                                          std::size_t values) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(values);
  std::vector<bool> used(values);
  const auto add = [&](std::uint32_t i) {
    if (used[i]) return;
    used[i] = true;
    numbers.push_back(i);
  };
  for (const std::uint32_t i : indices)
    if (i != no_value) add(i);
  for (std::uint32_t i = 0; i < values; ++i) add(i);
  return std::is_sorted(numbers.begin(), numbers.end()) ? std::vector<std::uint32_t>() : numbers;
}

}  // namespace clers::internal
