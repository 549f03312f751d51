// Places values in systems, and writes what their integers do not say.
#include "codec/numbers/number_encoder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <utility>

#include "codec/base/portable.h"
#include "codec/entropy/stream.h"
#include "codec/numbers/choose_palette.h"
#include "codec/numbers/component_words.h"
#include "codec/numbers/find_system.h"
#include "codec/numbers/place_numbers.h"

namespace clers::internal {
namespace {

/// How many low bits of K are better not predicted: those that make integers too wide, or wide
/// where nothing is near enough to predict them from.
unsigned choose_low_bits(const PlacedColumn& column) {
  const auto width = static_cast<unsigned>(std::bit_width(column.top));
  const unsigned needed = width > 60 ? width - 60 : 0;
  if (column.top <= most_narrow) return 0;
  const unsigned narrow = width - static_cast<unsigned>(std::bit_width(most_narrow));
  std::size_t near = 0;
  std::uint64_t before = 0;
  for (const std::uint64_t k : column.ks) {
    near += zigzag(k - before) >> narrow < 256;
    before = k;
  }
  return near > column.ks.size() / 8 ? needed : narrow;
}

/// A component, ready to be written.
struct EncodedColumn {
  NumberColumn header;
  std::vector<std::uint64_t> ks;
  Bytes palette, refinements;
  EncodedStream strays;

  void put(Bytes& out, const NumberSystem* before) const {
    put_column(out, header, before);
    if (!header.axis.palette.empty()) EncodedStream{{}, palette}.put(out);
    if (has_refinements(header.system)) EncodedStream{{}, refinements}.put(out);
    if (header.has_strays) strays.put(out);
  }
};

template <class Map>
Bytes encode_refinements(const NumberSystem& s, const Map& map, RefinementCoding coding,
                         const std::vector<std::uint64_t>& ks,
                         const std::vector<Refinement>& known) {
  RefinementCoder<Map> refinements(s, map, coding, ks.size());
  if (coding != RefinementCoding::bits)
    return encode_stream([&](auto& coder) {
      for (std::size_t i = 0; i < ks.size(); ++i) refinements.code(coder, ks[i], known[i]);
    });
  Bytes bytes;
  BitsTo coder(bytes);
  for (std::size_t i = 0; i < ks.size(); ++i) refinements.code(coder, ks[i], known[i]);
  coder.finish();
  return bytes;
}

/// The way to code them that takes the fewest bytes; below level 5 plain bits, unless they take
/// more than two bits a value more.
template <class Map>
void choose_refinements(EncodedColumn& out, const Map& map, const std::vector<std::uint64_t>& ks,
                        const std::vector<Refinement>& known, int level) {
  std::size_t least = 0;
  for (const RefinementCoding coding :
       {RefinementCoding::bits, RefinementCoding::adaptive, RefinementCoding::repeating}) {
    if (Map::has_choices && coding == RefinementCoding::adaptive) continue;  // gains nothing
    Bytes bytes = encode_refinements(out.header.system, map, coding, ks, known);
    const bool first = coding == RefinementCoding::bits;
    if (first || bytes.size() < least) {
      least = bytes.size();
      if (first && level < 5) least -= std::min(least, ks.size() / 4);
      out.header.coding = coding;
      out.refinements = std::move(bytes);
    }
  }
}

/// Whether integers that are equal have equal refinements: then those of a palette's entries.
std::optional<std::vector<Refinement>> refinements_of(const std::vector<std::uint64_t>& palette,
                                                      const std::vector<std::uint64_t>& ks,
                                                      const std::vector<Refinement>& known) {
  std::vector<std::optional<Refinement>> of(palette.size());
  for (std::size_t i = 0; i < ks.size(); ++i) {
    auto& r = of[static_cast<std::size_t>(std::lower_bound(palette.begin(), palette.end(), ks[i]) -
                                          palette.begin())];
    if (r && (r->low != known[i].low || r->choice != known[i].choice)) return std::nullopt;
    r = known[i];
  }
  std::vector<Refinement> all;
  for (const auto& r : of) all.push_back(*r);
  return all;
}

template <class T, class Map>
EncodedColumn encode_column(PlacedColumn column, const Map& map, int level, Integers integers) {
  EncodedColumn out;
  NumberColumn& header = out.header;
  header.system = column.system;
  // Low bits that are all ones may be beyond what there are numbers of.
  const auto width = static_cast<unsigned>(std::bit_width(column.top));
  const unsigned most_low =
      integers == Integers::as_coded ? choose_low_bits(column) : width - std::min(width, 60u);
  for (unsigned low = most_low;; --low) {
    header.system.low_bits = static_cast<std::uint8_t>(low);
    header.axis.top = column.top >> low;
    if (low == 0 || fault_of<T>(header).empty()) break;
  }
  const NumberSystem& s = header.system;
  std::vector<Refinement> known;
  if (has_refinements(s)) {
    known.resize(column.ks.size());
    for (std::size_t i = 0; i < known.size(); ++i)
      known[i] = {column.ks[i] & ((std::uint64_t(1) << s.low_bits) - 1),
                  column.choices.empty() ? 0 : column.choices[i]};
    for (std::uint64_t& k : column.ks) k >>= s.low_bits;
    for (const Stray& stray : column.strays) known[stray.index] = {};
  }
  if (integers == Integers::as_coded)
    header.axis.palette =
        choose_palette(std::span<const std::uint64_t>(column.ks), 1, header.axis.top);
  if (!header.axis.palette.empty())
    out.palette = encode_stream(
        [&](auto& coder) { code_palette(coder, header.axis.palette, header.axis.top); });
  if (has_refinements(s)) {
    std::optional<std::vector<Refinement>> of_palette;
    if (!header.axis.palette.empty())
      of_palette = refinements_of(header.axis.palette, column.ks, known);
    header.refined_palette = of_palette.has_value();
    if (of_palette)
      choose_refinements(out, map, header.axis.palette, *of_palette, level);
    else
      choose_refinements(out, map, column.ks, known, level);
  }
  if (!column.strays.empty()) {
    header.has_strays = true;
    out.strays.numbers = {column.strays.size()};
    out.strays.bytes = encode_stream([&](auto& coder) {
      StrayCoder<WordOf<T>> strays;
      for (const Stray& stray : column.strays) {
        std::uint64_t index = stray.index;
        auto word = static_cast<WordOf<T>>(stray.word);
        strays.code(coder, index, word);
      }
    });
  }
  out.ks = std::move(column.ks);
  return out;
}

/// The system of the fewest decimals that all numbers have, but a few; none if they have many.
template <class T>
std::optional<NumberSystem> in_decimals(const std::vector<WordOf<T>>& numbers) {
  if constexpr (std::is_floating_point_v<T>) {
    for (unsigned decimals = 1; decimals <= (sizeof(T) == 4 ? 7u : 14u); ++decimals) {
      NumberSystem system;
      system.map = NumberMap::quotient;
      system.divisor = integer_tens[decimals];
      const QuotientMap<T> map(system, scalar_of<T>());
      std::size_t strays = 0;
      for (const auto word : numbers) {
        const auto made = map.word(map.locate(word).n, 0);
        if (made != word && magnitude(word) != 0 && ++strays > numbers.size() / 256) break;
        system.signed_zero |= made != word && magnitude(word) == 0;
      }
      if (strays <= numbers.size() / 256) return system;
    }
  }
  return std::nullopt;
}

/// Directions as points of a grid that they are on.
NumberedValues put_into_octahedral(std::span<const std::byte> values, Scalar scalar,
                                   const NumberSystem& system) {
  NumberedValues out;
  out.numbers = octahedral_numbers(scalar, system.precision, system.single);
  put_octahedral(out.bytes, system);
  const OctahedralGrid grid(system.precision);
  for (std::size_t at = 0; at < values.size(); at += 3 * size_of(scalar)) {
    const Vector3 direction = vector_at(scalar, values.data() + at);
    for (const std::int32_t k : grid.integers(grid.nearest(grid.project(direction))))
      out.narrow.push_back(k);
  }
  return out;
}

/// The numbers of a component in a system.
template <class T>
EncodedColumn column_in(const NumberSystem& system, std::span<const WordOf<T>> numbers,
                        Scalar scalar, int level, Integers integers = Integers::as_coded) {
  return with_map<T>(system, scalar, [&](const auto& map) {
    return encode_column<T>(place_column<T>(numbers, system, map), map, level, integers);
  });
}

/// About how many bits a column takes, its integers, or their ranks, by their differences.
std::uint64_t about_bits(const EncodedColumn& column) {
  const auto& palette = column.header.axis.palette;
  StepBits steps;
  for (const std::uint64_t k : column.ks)
    steps.add(palette.empty()
                  ? k
                  : static_cast<std::uint64_t>(std::lower_bound(palette.begin(), palette.end(), k) -
                                               palette.begin()));
  return steps.bits +
         8 * (column.palette.size() + column.refinements.size() + column.strays.bytes.size());
}

template <class Int>
void set_rows(const std::vector<EncodedColumn>& columns, std::vector<Int>& rows) {
  const std::size_t count = columns.front().ks.size(), components = columns.size();
  rows.resize(count * components);
  for (std::size_t c = 0; c < components; ++c)
    for (std::size_t i = 0; i < count; ++i)
      rows[i * components + c] = static_cast<Int>(columns[c].ks[i]);
}

/// All but the integers.
NumberedValues with_headers(std::vector<EncodedColumn>& columns, Scalar scalar) {
  NumberedValues out;
  out.numbers.scalar = scalar;
  for (const EncodedColumn& column : columns) {
    out.numbers.systems.push_back(column.header.system);
    out.numbers.axes.push_back(column.header.axis);
  }
  set_scales(out.numbers);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    columns[c].header.axis.scale = out.numbers.axes[c].scale;
    columns[c].put(out.bytes, c == 0 ? nullptr : &columns[c - 1].header.system);
  }
  return out;
}

NumberedValues numbered(std::vector<EncodedColumn>& columns, Scalar scalar) {
  NumberedValues out = with_headers(columns, scalar);
  out.numbers.narrow() ? set_rows(columns, out.narrow) : set_rows(columns, out.wide);
  return out;
}

}  // namespace

NumberedValues put_into_systems(std::span<const std::byte> values, Scalar scalar,
                                std::vector<NumberSystem> systems, int level, Integers integers) {
  const DoublePrecision doubles;
  if (!systems.empty() && systems[0].map == NumberMap::octahedral)
    return put_into_octahedral(values, scalar, systems[0]);
  std::vector<EncodedColumn> columns;
  for (std::size_t c = 0; c < systems.size(); ++c)
    with_number_type(scalar, [&](auto type) {
      using T = decltype(type);
      const auto words = words_of<T>(values, {scalar, systems.size(), c});
      columns.push_back(column_in<T>(systems[c], words, scalar, level, integers));
    });
  return numbered(columns, scalar);
}

NumberedValues number_values(std::span<const std::byte> values, Scalar scalar,
                             std::size_t components, int level) {
  const DoublePrecision doubles;
  std::vector<EncodedColumn> columns;
  for (std::size_t c = 0; c < components; ++c)
    with_number_type(scalar, [&](auto type) {
      using T = decltype(type);
      const auto words = words_of<T>(values, {scalar, components, c});
      if (level < 5) {
        columns.push_back(column_in<T>(find_system<T>(words, Search::quick), words, scalar, level));
        return;
      }
      const auto systems = find_systems<T>(words, Search::thorough);
      columns.push_back(column_in<T>(systems[0], words, scalar, level));
      if (systems.size() < 2) return;
      EncodedColumn other = column_in<T>(systems[1], words, scalar, level);
      if (about_bits(other) < about_bits(columns.back())) columns.back() = std::move(other);
    });
  return numbered(columns, scalar);
}

std::vector<NumberedValues> number_for_lines(std::span<const std::byte> values, Scalar scalar,
                                             std::size_t components, int level) {
  const DoublePrecision doubles;
  std::vector<NumberSystem> words(components), found;
  for (std::size_t c = 0; c < components; ++c)
    with_number_type(scalar, [&](auto type) {
      using T = decltype(type);
      const auto numbers = words_of<T>(values, {scalar, components, c});
      std::optional<NumberSystem> system = in_decimals<T>(numbers);
      if (!system) system = find_system<T>(numbers, Search::thorough);
      const bool whole = system->map != NumberMap::digits && system->map != NumberMap::binary;
      found.push_back(whole ? *system : NumberSystem{});
    });
  std::vector<NumberedValues> all;
  all.push_back(put_into_systems(values, scalar, words, level, Integers::whole));
  if (std::any_of(found.begin(), found.end(),
                  [](const NumberSystem& s) { return s.map != NumberMap::word; }))
    all.push_back(put_into_systems(values, scalar, found, level, Integers::whole));
  return all;
}

NumberedValues put_integers(std::span<const std::byte> integers, Scalar scalar,
                            std::vector<NumberSystem> systems) {
  const std::size_t components = systems.size();
  std::vector<std::int32_t> rows(integers.size() / sizeof(std::int32_t));
  if (!rows.empty()) std::memcpy(rows.data(), integers.data(), integers.size());
  std::vector<EncodedColumn> columns(components);
  for (std::size_t c = 0; c < components; ++c) {
    NumberColumn& header = columns[c].header;
    header.system = systems[c];
    if (rows.empty()) continue;
    std::int32_t least = rows[c], greatest = rows[c];
    for (std::size_t i = c; i < rows.size(); i += components) {
      least = std::min(least, rows[i]);
      greatest = std::max(greatest, rows[i]);
    }
    for (std::size_t i = c; i < rows.size(); i += components) rows[i] -= least;
    header.system.first += least * static_cast<std::int64_t>(header.system.step);
    header.axis.top = static_cast<std::uint64_t>(std::int64_t(greatest) - least);
    header.axis.palette =
        choose_palette(std::span<const std::int32_t>(rows).subspan(c), components, header.axis.top);
    if (!header.axis.palette.empty())
      columns[c].palette = encode_stream(
          [&](auto& coder) { code_palette(coder, header.axis.palette, header.axis.top); });
  }
  NumberedValues out = with_headers(columns, scalar);
  out.narrow = std::move(rows);
  return out;
}

void put_plain_numbers(Bytes& out, const Numbers& numbers) {
  for (std::size_t c = 0; c < numbers.systems.size(); ++c) {
    EncodedColumn column;
    column.header.system = numbers.systems[c];
    column.header.axis = numbers.axes[c];
    if (!column.header.axis.palette.empty())
      column.palette = encode_stream([&](auto& coder) {
        code_palette(coder, column.header.axis.palette, column.header.axis.top);
      });
    column.put(out, c == 0 ? nullptr : &numbers.systems[c - 1]);
  }
}

}  // namespace clers::internal
