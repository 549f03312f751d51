// Finds numbers, tries the coders that a level affords, and keeps what takes least.
#include "codec/attributes/attribute_encoder.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "codec/attributes/attribute_format.h"
#include "codec/attributes/charts.h"
#include "codec/attributes/integer_planes.h"
#include "codec/attributes/joints.h"
#include "codec/attributes/mixed_coder.h"
#include "codec/attributes/named_values_encoder.h"
#include "codec/attributes/normal_values_decoder.h"
#include "codec/attributes/normal_values_encoder.h"
#include "codec/attributes/ordered_integers.h"
#include "codec/attributes/planes.h"
#include "codec/attributes/sized_positions.h"
#include "codec/attributes/weights.h"
#include "codec/numbers/float_directions.h"
#include "codec/numbers/number_encoder.h"
#include "codec/numbers/number_format.h"
#include "codec/numbers/ranks.h"

namespace clers::internal {
namespace {

int zstd_level(int level) {
  static constexpr std::array<int, 9> levels = {1, 1, 3, 3, 6, 9, 12, 15, 19};
  return levels[static_cast<std::size_t>(level - 1)];
}

/// Values as words that sort like them.
Bytes words_of(const Attribute& attribute) {
  Bytes words = attribute.data;
  if (is_float(attribute.scalar))
    with_word(attribute.scalar, [&](auto word) {
      using U = decltype(word);
      for (std::size_t i = 0; i < words.size() / sizeof(U); ++i)
        set_word(words.data(), i, to_ordered(word_at<U>(words.data(), i)));
    });
  return words;
}

class AttributeEncoder {
 public:
  AttributeEncoder(const Attribute& attribute, const StructureHeader& structure,
                   const ValueSurface& along, int level)
      : attribute_(attribute), along_(along), surface_(along.surface), level_(level) {
    header_.attribute = {
        attribute.name, attribute.domain, attribute.scalar, attribute.components, {}};
    header_.structure = structure;
    is_position_ = attribute.domain == Domain::vertex && attribute.name == position_name;
    predictors_ = {Predictor::none, Predictor::previous};
    if (of_vertices() && !surface_.corners.empty()) {
      predictors_.push_back(Predictor::parallelogram);
      if (is_position_) predictors_ = {Predictor::parallelogram};
    }
  }

  Expected<EncodedAttribute> run(const AttributePlan& plan) {
    header_.error = plan.error;
    header_.measure = plan.measure;
    if (plan.integers_of) header_.attribute.scalar = *plan.integers_of;
    if (plan.systems.empty())
      if (auto done = float_directions(); !done) return Failure{done.error()};
    NumberedValues numbered =
        plan.systems.empty()
            ? number_values(attribute_.data, attribute_.scalar, attribute_.components, level_)
        : plan.integers_of
            ? put_integers(attribute_.data, *plan.integers_of, plan.systems)
            : put_into_systems(attribute_.data, attribute_.scalar, plan.systems, level_);
    header_.narrow = numbered.numbers.narrow();
    if (level_ >= 5 && attribute_.components == 3) normals(plan, numbered);
    if (level_ >= 5 && plan.systems.empty()) joints();
    header_.narrow = numbered.numbers.narrow();
    const auto ok =
        header_.narrow ? integers(numbered, numbered.narrow) : integers(numbered, numbered.wide);
    if (!ok) return Failure{ok.error()};
    if (plan.systems.empty() && level_ >= 5)
      if (auto done = words(); !done) return Failure{done.error()};
    best_.info.bytes = best_.bytes.size();
    return std::move(best_);
  }

 private:
  /// Takes what follows the header, if it is the least up to now.
  void consider(Coder coder, Predictor predictor, std::span<const std::byte> numbers,
                std::span<const std::byte> coded, std::string words) {
    AttributeHeader header = header_;
    header.coder = coder;
    header.predictor = predictor;
    header.numbers_size = numbers.size();
    if (coder == Coder::words) header.narrow = true;
    Bytes bytes;
    put_attribute_header(bytes, header);
    put_bytes(bytes, numbers);
    put_bytes(bytes, coded);
    if (!best_.bytes.empty() && bytes.size() >= best_.bytes.size()) return;
    best_ = {std::move(bytes), info_of(header)};
    best_.info.numbers = std::move(words);
  }

  /// What a quick zstd may make of planes so that a slower one may be better than the best, where
  /// `besides` bytes are needed: a sixteenth more. Higher levels try all.
  std::size_t most_quick(std::size_t besides) const {
    if (level_ >= 7) return no_bound;
    const std::size_t most = best_.bytes.size() + best_.bytes.size() / 16;
    return most - std::min(most, besides);
  }

  template <class Int>
  Expected<Done> integers(const NumberedValues& numbered, std::vector<Int>& rows) {
    const std::vector<Axis>& axes = numbered.numbers.axes;
    const std::string words = in_words(numbered.numbers);
    const auto take = [&](Coder coder, const Bytes& coded) {
      consider(coder, Predictor::none, numbered.bytes, coded, words);
    };
    const bool is_position = is_position_ && axes.size() == 3;
    const Lattice<Int> lattice{rows, axes};
    if (!is_position_ && level_ >= 5 && of_vertices() && may_be_charts(axes))
      take(Coder::charts, encode_charts(lattice, along_, level_));
    if (!is_position && level_ >= 5) {
      std::optional<std::size_t> beside;
      if (level_ < 7 && !best_.bytes.empty()) beside = best_.bytes.size();
      const Bytes named = encode_named_values(lattice, surface_of(header_, lattice.count(), along_),
                                              header_.coded_domain(), beside);
      if (!named.empty() || rows.empty()) take(Coder::named, named);
    }
    if (!is_position_ && level_ >= 5 && of_vertices() && may_be_weights(numbered.numbers) &&
        look_like_weights<Int>(rows, numbered.numbers)) {
      ValueSurface along = along_;
      along.joints = nullptr;
      take(Coder::weights, encode_weights<Int>(rows, numbered.numbers, along));
      if (along_.joints != nullptr && fit_as_joints(*along_.joints, lattice.count(), axes.size()))
        take(Coder::skin, encode_weights<Int>(rows, numbered.numbers, along_));
    }
    if (is_position && level_ == 9) take(Coder::mixed, encode_mixed(surface_, lattice));
    if (is_position && level_ >= 7)
      take(Coder::sized, encode_sized_positions(surface_, lattice, VisitOrder::parallelograms));
    if (is_position && level_ >= 5)
      take(Coder::sized, encode_sized_positions(surface_, lattice, VisitOrder::introduction));
    integers_to_ranks(Lattice<Int>{rows, axes});
    const std::vector<Axis> ranked = with_ranks(axes);
    const Lattice<const Int> ranks{rows, ranked};
    take(Coder::ordered, encode_ordered(ranks, of_vertices() ? surface_ : CodedSurface{}, level_));
    if (level_ < 5) return Done{};
    auto packed = pack_integers(ranks, predictors_, surface_, zstd_level(level_),
                                most_quick(numbered.bytes.size()));
    if (!packed) return Failure{packed.error()};
    if (!packed->frame.empty())
      consider(Coder::planes, packed->predictor, numbered.bytes, packed->frame, words);
    // Positions that repeat themselves may do so in single components, which that coder looks for.
    if (is_position && best_.info.coder == name(Coder::planes)) {
      ranks_to_integers(lattice);
      take(Coder::named, encode_named_values(lattice, along_, Domain::vertex));
    }
    return Done{};
  }

  /// Tries values as directions that a decoder of others computed, if all are such.
  Expected<Done> float_directions() {
    if (is_position_ || attribute_.components != 3 || attribute_.scalar != Scalar::float32)
      return Done{};
    const auto bits = bits_of_float_directions(attribute_.data);
    if (!bits) return Done{};
    AttributePlan plan;
    plan.systems = octahedral_systems(*bits, true);
    NumberedValues numbered =
        put_into_systems(attribute_.data, attribute_.scalar, plan.systems, level_);
    header_.narrow = numbered.numbers.narrow();
    if (level_ >= 5) normals(plan, numbered);
    return integers(numbered, numbered.narrow);
  }

  /// Tries the coder of normals, with the numbers given, or with those that it predicts best.
  void normals(const AttributePlan& plan, const NumberedValues& given) {
    const bool of_faces = header_.attribute.domain == Domain::face && !header_.structure.any;
    if (is_position_ || !(of_vertices() || of_faces)) return;
    const auto take = [&](const NumberedValues& numbered) {
      if (!may_be_normals(numbered.numbers, along_)) return false;
      header_.narrow = numbered.numbers.narrow();
      const auto try_rows = [&](const auto& rows) {
        const std::span all(rows.data(), rows.size());
        if (!look_like_normals(all, numbered.numbers, along_)) return false;
        consider(Coder::normals, Predictor::none, numbered.bytes,
                 encode_normals(all, numbered.numbers, along_, level_), in_words(numbered.numbers));
        return true;
      };
      return header_.narrow ? try_rows(numbered.narrow) : try_rows(numbered.wide);
    };
    if (!plan.systems.empty()) {
      take(given);
    } else {
      for (const NumberedValues& numbered :
           number_for_lines(attribute_.data, attribute_.scalar, attribute_.components, level_))
        if (!take(numbered)) break;
    }
    header_.narrow = given.numbers.narrow();
  }

  /// Tries the coder of joints, which takes a joint to have one number in all components.
  void joints() {
    if (is_position_ || !of_vertices() || is_float(attribute_.scalar)) return;
    const NumberedValues numbered =
        put_into_systems(attribute_.data, attribute_.scalar,
                         std::vector<NumberSystem>(attribute_.components), level_, Integers::whole);
    const std::vector<Axis>& axes = numbered.numbers.axes;
    if (!may_be_joints(axes) || !look_like_joints(numbered.narrow, axes, along_)) return;
    header_.narrow = true;
    consider(Coder::joints, Predictor::none, numbered.bytes,
             encode_joints(numbered.narrow, axes, along_), in_words(numbered.numbers));
  }

  Expected<Done> words() {
    const WordShape shape{attribute_.scalar, attribute_.components};
    auto packed = pack_planes(words_of(attribute_), shape, predictors_, surface_,
                              zstd_level(level_), most_quick(0));
    if (!packed) return Failure{packed.error()};
    if (packed->frame.empty()) return Done{};
    consider(Coder::words, packed->predictor, {}, packed->frame, words_text);
    return Done{};
  }

  bool of_vertices() const { return header_.coded_domain() == Domain::vertex; }

  const Attribute& attribute_;
  const ValueSurface& along_;
  const CodedSurface& surface_;
  const int level_;
  bool is_position_ = false;
  AttributeHeader header_;
  std::vector<Predictor> predictors_;
  EncodedAttribute best_;
};

}  // namespace

Expected<EncodedAttribute> encode_attribute(const Attribute& attribute,
                                            const StructureHeader& structure,
                                            const ValueSurface& along, int level,
                                            const AttributePlan& plan) {
  auto coded = AttributeEncoder(attribute, structure, along, level).run(plan);
  if (coded) coded->info.count = attribute.value_count();
  return coded;
}

Expected<EncodedAttribute> encode_attribute(const Attribute& attribute,
                                            std::vector<EncodedStructure> ways,
                                            const CodedFaces& faces, const Attribute* position,
                                            int level, const AttributePlan& plan) {
  const Domain domain = attribute.domain;
  const std::size_t elements = faces.count(domain);
  std::optional<EncodedAttribute> best;
  for (EncodedStructure& way : ways) {
    StructureHeader& header = way.header;
    header.stream.bytes = way.stream;
    header.numbering.bytes = way.numbering;
    Attribute values{attribute.name, domain, attribute.scalar, attribute.components,
                     std::move(way.values)};
    ValueArrays arrays;
    if (header.any) arrays = make_value_surface(faces, domain, way.structure, values.value_count());
    const ValueSurface along =
        header.any ? arrays.view(position) : ValueSurface{faces.surface, {}, position};
    auto coded = encode_attribute(values, header, along, level, plan);
    if (!coded) return coded;
    coded->info.count = header.indexed ? header.distinct : elements;
    if (!best || coded->bytes.size() < best->bytes.size()) best = std::move(*coded);
  }
  return std::move(*best);
}

}  // namespace clers::internal
