// Systems and streams -> what a component's integers mean.
#include "codec/attributes/number_decoder.h"

#include <algorithm>
#include <utility>

#include "codec/attributes/refinements.h"
#include "codec/base/portable.h"

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

/// The word of each entry of a palette that has its refinements.
template <class T, class Map>
Expected<std::vector<WordOf<T>>> refine_palette(const NumberSystem& s, const Map& map,
                                                const std::vector<std::uint64_t>& palette,
                                                RefinementCoding coding, const Stream& stream) {
  std::vector<WordOf<T>> words(palette.size());
  const auto done = decode_refinements(stream, coding, [&](auto& coder) {
    RefinementCoder<Map> refinements(s, map, coding, palette.size());
    for (std::size_t i = 0; i < palette.size(); ++i) {
      const Refinement r = refinements.code(coder, palette[i], {});
      words[i] = refined_word<T>(s, map, integer_of(s, palette[i], r.low), r.choice);
    }
    return std::string();
  });
  if (!done) return Failure{done.error()};
  return words;
}

}  // namespace

Expected<NumberReader> NumberReader::read(ByteReader& in, Scalar scalar, std::size_t components,
                                          std::uint64_t count) {
  NumberReader reader;
  reader.numbers_.scalar = scalar;
  for (std::size_t c = 0; c < components; ++c) {
    auto column = read_column(in, scalar, count);
    if (!column) return Failure{column.error()};
    Part part = {column->coding, column->refined_palette, {}, 0, {}};
    if (!column->axis.palette.empty()) {
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

std::uint64_t NumberReader::memory(std::size_t components, std::uint64_t count) {
  constexpr std::uint64_t of_component = sizeof(NumberSystem) + sizeof(Axis) + sizeof(Part);
  // Entries of palettes, while one has its words too; vectors that grow.
  return components * (2 * of_component + count / 2 * 8) + count / 2 * 8 +
         RefinementCoder<PrintedMap<double>>::memory();
}

template <class Int>
Expected<Done> NumberReader::make_values(std::span<const Int> rows,
                                         std::span<std::byte> values) const {
  const std::size_t components = parts_.size(), count = rows.size() / components;
  const DoublePrecision doubles;
  for (std::size_t c = 0; c < components; ++c) {
    const NumberSystem& s = numbers_.systems[c];
    const Part& part = parts_[c];
    const auto& palette = numbers_.axes[c].palette;
    const auto k_of = [&](std::size_t i) {
      return static_cast<std::uint64_t>(rows[i * components + c]);
    };
    const auto done = with_type(numbers_.scalar, [&](auto type) {
      using T = decltype(type);
      using U = WordOf<T>;
      const auto set = [&](std::size_t i, U word) {
        set_word(values.data(), i * components + c, word);
      };
      const auto mapped = with_map<T>(s, [&](const auto& map) -> Expected<Done> {
        using Map = std::decay_t<decltype(map)>;
        if (!has_refinements(s)) {
          for (std::size_t i = 0; i < count; ++i) set(i, map.word(integer_of(s, k_of(i), 0), 0));
          return Done{};
        }
        if (part.refined_palette) {
          const auto words = refine_palette<T>(s, map, palette, part.coding, part.refinements);
          if (!words) return Failure{words.error()};
          for (std::size_t i = 0; i < count; ++i) {
            const auto entry = std::lower_bound(palette.begin(), palette.end() - 1, k_of(i));
            set(i, (*words)[static_cast<std::size_t>(entry - palette.begin())]);
          }
          return Done{};
        }
        return decode_refinements(part.refinements, part.coding, [&](auto& coder) {
          RefinementCoder<Map> refinements(s, map, part.coding, count);
          for (std::size_t i = 0; i < count; ++i) {
            const Refinement r = refinements.code(coder, k_of(i), {});
            set(i, refined_word<T>(s, map, integer_of(s, k_of(i), r.low), r.choice));
          }
          return std::string();
        });
      });
      if (!mapped || part.strays == 0) return mapped;
      return decode_stream(part.stray_numbers, "the strays", [&](auto& coder) {
        StrayCoder<U> strays;
        for (std::uint64_t i = 0; i < part.strays; ++i) {
          std::uint64_t index = 0;
          U word = 0;
          strays.code(coder, index, word);
          if (index >= count) return std::string("a stray beyond the last value");
          set(static_cast<std::size_t>(index), word);
        }
        return std::string();
      });
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
