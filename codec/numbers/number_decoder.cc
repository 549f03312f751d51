// Systems and streams -> what a component's integers mean.
#include "codec/numbers/number_decoder.h"

#include <algorithm>
#include <array>
#include <utility>

#include "codec/base/portable.h"
#include "codec/numbers/component_words.h"
#include "codec/numbers/float_directions.h"
#include "codec/numbers/refinements.h"

namespace clers::internal {
namespace {

/// Calls code(coder) with the coder that refinements were coded with. It returns what is wrong.
template <class Code>
Expected<Done> decode_refinements(const Stream& stream, RefinementCoding coding, const Code& code) {
  if (coding != RefinementCoding::bits) return decode_stream(stream, "the refinements", code);
  BitsFrom coder(stream.bytes);
  code(coder);
  if (coder.finished()) return Done{};
  return fail(ErrorCode::invalid, Place::byte, stream.at,
              "the refinements do not end where their bytes end");
}

/// So many values are made at a time.
constexpr std::size_t batch = 512;

/// The integers of a component, some at a time.
class Integers {
 public:
  template <class Int>
  Integers(std::span<const Int> rows, std::size_t components, std::size_t component)
      : components_(components), component_(component), count_(rows.size() / components) {
    if constexpr (sizeof(Int) == 4)
      narrow_ = rows.data();
    else
      wide_ = rows.data();
  }
  std::size_t count() const { return count_; }
  void load(std::size_t begin, std::span<std::uint64_t> ks) const {
    narrow_ != nullptr ? load(narrow_, begin, ks) : load(wide_, begin, ks);
  }

 private:
  template <class Int>
  void load(const Int* rows, std::size_t begin, std::span<std::uint64_t> ks) const {
    const Int* k = rows + begin * components_ + component_;
    for (std::size_t i = 0; i < ks.size(); ++i, k += components_)
      ks[i] = static_cast<std::uint64_t>(*k);
  }

  const std::int32_t* narrow_ = nullptr;
  const std::int64_t* wide_ = nullptr;
  std::size_t components_, component_, count_;
};

/// Makes numbers of the integers of a component: word(k) is called for each, in their order.
template <class U, class Word>
void make_numbers(const Integers& integers, const Component& of, std::span<std::byte> values,
                  const Word& word) {
  std::array<std::uint64_t, batch> ks;
  std::array<U, batch> words;
  for (std::size_t begin = 0; begin < integers.count(); begin += batch) {
    const std::size_t n = std::min(batch, integers.count() - begin);
    integers.load(begin, std::span(ks).first(n));
    for (std::size_t i = 0; i < n; ++i) words[i] = word(ks[i]);
    store_words(std::span<const U>(words).first(n), of, begin, values);
  }
}

/// Makes numbers of integers that leave something open.
template <class T, class Map>
Expected<Done> make_refined(const Integers& integers, const Component& of,
                            std::span<std::byte> values, const NumberSystem& s, const Map& map,
                            const std::vector<std::uint64_t>* palette, RefinementCoding coding,
                            const Stream& stream) {
  using U = WordOf<T>;
  std::vector<U> entries;  // of the palette, if they are what is refined
  const std::size_t refined = palette != nullptr ? palette->size() : integers.count();
  const auto done = decode_refinements(stream, coding, [&](auto& coder) {
    RefinementCoder<Map> refinements(s, map, coding, refined);
    const auto word = [&](std::uint64_t k) {
      const Refinement r = refinements.code(coder, k, {});
      return refined_word<T>(s, map, integer_of(s, k, r.low), r.choice);
    };
    if (palette == nullptr) {
      make_numbers<U>(integers, of, values, word);
    } else {
      entries.reserve(refined);
      for (const std::uint64_t k : *palette) entries.push_back(word(k));
    }
    return std::string();
  });
  if (!done || palette == nullptr) return done;
  make_numbers<U>(integers, of, values, [&](std::uint64_t k) {
    const auto entry = std::lower_bound(palette->begin(), palette->end() - 1, k);
    return entries[static_cast<std::size_t>(entry - palette->begin())];
  });
  return done;
}

/// Makes the directions of points of an octahedral grid.
template <class Int>
void make_directions(std::span<const Int> rows, const NumberSystem& system, Scalar scalar,
                     std::span<std::byte> values) {
  const OctahedralGrid grid(system.precision);
  const FloatDirections floats(system.precision);
  for (std::size_t i = 0; i < rows.size() / 2; ++i) {
    const OctahedralPoint point = grid.point(static_cast<std::int64_t>(rows[2 * i]),
                                             static_cast<std::int64_t>(rows[2 * i + 1]));
    put_vector(scalar, system.single ? floats.direction(point) : OctahedralGrid::direction(point),
               values.data() + i * 3 * size_of(scalar));
  }
}

/// Stores strays where they belong.
template <class U>
Expected<Done> put_strays(const Component& of, std::size_t count, std::span<std::byte> values,
                          std::uint64_t strays, const Stream& stream) {
  return decode_stream(stream, "the strays", [&](auto& coder) {
    StrayCoder<U> coded;
    for (std::uint64_t i = 0; i < strays; ++i) {
      std::uint64_t index = 0;
      U word = 0;
      coded.code(coder, index, word);
      if (index >= count) return std::string("a stray beyond the last value");
      store_words(std::span<const U>(&word, 1), of, static_cast<std::size_t>(index), values);
    }
    return std::string();
  });
}

}  // namespace

Expected<NumberReader> NumberReader::read(ByteReader& in, Scalar scalar, std::size_t components,
                                          std::uint64_t count) {
  NumberReader reader;
  if (is_octahedral(in)) {
    auto numbers = read_octahedral(in, scalar, components);
    if (!numbers) return Failure{numbers.error()};
    reader.numbers_ = std::move(*numbers);
    return reader;
  }
  reader.numbers_.scalar = scalar;
  reader.numbers_.systems.reserve(components);
  reader.numbers_.axes.reserve(components);
  reader.parts_.reserve(components);
  for (std::size_t c = 0; c < components; ++c) {
    const auto& systems = reader.numbers_.systems;
    auto column = read_column(in, scalar, count, systems.empty() ? nullptr : &systems.back());
    if (!column) return Failure{column.error()};
    Part part = {column->coding, column->refined_palette, {}, 0, {}};
    if (column->entries > 0) {
      column->axis.palette.resize(static_cast<std::size_t>(column->entries));
      const Stream stream = read_stream(in, {});
      if (!in.ok()) return Failure{in.error()};
      const auto done = decode_stream(stream, "the palette", [&](auto& coder) {
        return code_palette(coder, column->axis.palette, column->axis.top);
      });
      if (!done) return Failure{done.error()};
    }
    if (has_refinements(column->system)) part.refinements = read_stream(in, {});
    if (column->has_strays) {
      const std::uint64_t at = in.offset();
      part.stray_numbers = read_stream(in, {&part.strays});
      if (in.ok() && (part.strays == 0 || part.strays > count))
        return fail(
            ErrorCode::invalid, Place::byte, at,
            std::to_string(part.strays) + " strays of " + std::to_string(count) + " values");
    }
    if (!in.ok()) return Failure{in.error()};
    reader.numbers_.systems.push_back(column->system);
    reader.numbers_.axes.push_back(std::move(column->axis));
    reader.parts_.push_back(part);
  }
  return reader;
}

std::uint64_t NumberReader::memory(std::span<const std::byte> bytes, Scalar scalar,
                                   std::size_t components, std::uint64_t count) {
  constexpr std::uint64_t of_component = sizeof(NumberSystem) + sizeof(Axis) + sizeof(Part);
  std::uint64_t entries = 0, most = 0;
  bool refined = false;
  ByteReader in(bytes, 0);
  NumberSystem before;
  for (std::size_t c = 0; c < components && !is_octahedral(in); ++c) {
    const auto column = read_column(in, scalar, count, c == 0 ? nullptr : &before);
    if (!column) break;  // as read() will
    before = column->system;
    entries += column->entries;
    most = std::max(most, column->entries);
    refined |= has_refinements(column->system);
    if (column->entries > 0) read_stream(in, {});
    if (has_refinements(column->system)) read_stream(in, {});
    std::uint64_t strays = 0;
    if (column->has_strays) read_stream(in, {&strays});
  }
  // Entries of palettes, while one of them has its words too.
  return components * of_component + 8 * (entries + most) +
         (refined ? RefinementCoder<PrintedMap<double>>::memory() : 0);
}

template <class Int>
Expected<Done> NumberReader::make_values(std::span<const Int> rows,
                                         std::span<std::byte> values) const {
  const DoublePrecision doubles;
  if (numbers_.octahedral_bits() > 0) {
    make_directions(rows, numbers_.systems[0], numbers_.scalar, values);
    return Done{};
  }
  for (std::size_t c = 0; c < parts_.size(); ++c) {
    const Component of = {numbers_.scalar, parts_.size(), c};
    const Integers integers(rows, of.components, c);
    const NumberSystem& s = numbers_.systems[c];
    const Part& part = parts_[c];
    const auto done = with_number_type(of.scalar, [&](auto type) {
      using T = decltype(type);
      using U = WordOf<T>;
      const auto made = with_map<T>(s, of.scalar, [&](const auto& map) {
        if (has_refinements(s))
          return make_refined<T>(integers, of, values, s, map,
                                 part.refined_palette ? &numbers_.axes[c].palette : nullptr,
                                 part.coding, part.refinements);
        make_numbers<U>(integers, of, values,
                        [&](std::uint64_t k) { return map.word(integer_of(s, k, 0), 0); });
        return Expected<Done>(Done{});
      });
      if (!made || part.strays == 0) return made;
      return put_strays<U>(of, integers.count(), values, part.strays, part.stray_numbers);
    });
    if (!done) return done;
  }
  return Done{};
}

Expected<Done> NumberReader::to_values(std::span<const std::int32_t> rows,
                                       std::span<std::byte> values) const {
  return make_values(rows, values);
}
Expected<Done> NumberReader::to_values(std::span<const std::int64_t> rows,
                                       std::span<std::byte> values) const {
  return make_values(rows, values);
}

}  // namespace clers::internal
