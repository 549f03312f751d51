// Vertices coded by where a copy or a symmetry says that they are: what encoder and decoder share.
// It knows no parallelograms, and no bytes of a file.
#ifndef CLERS_CODEC_ATTRIBUTES_SIZED_GUIDES_H
#define CLERS_CODEC_ATTRIBUTES_SIZED_GUIDES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "codec/attributes/axis_steps.h"
#include "codec/attributes/copies.h"
#include "codec/attributes/mirror.h"
#include "codec/attributes/repetition.h"
#include "codec/attributes/residual_sizes.h"
#include "codec/attributes/symmetry.h"
#include "codec/base/portable.h"
#include "codec/connectivity/coded_surface.h"
#include "codec/entropy/distribution.h"
#include "codec/numbers/lattice.h"

namespace clers::internal {

/// What is known of a shape beforehand.
struct Guides {
  std::optional<Symmetry> symmetry;
  bool copies = false;
  Originals originals;  ///< if there are copies
  Repetition repeats = Repetition::none;
};

/// Codes vertices that are like others. Whoever codes asks first by connectivity alone, which is
/// fast, and then, if that found nobody, by places. `one(i, from, context, n)` codes component i of
/// the vertex, which is expected at `from`.
template <class Int, class Triple>
class GuidedCoding {
 public:
  static constexpr std::uint32_t nobody = Mirror<Int>::nobody;

  GuidedCoding(const Guides& guides, const CodedSurface& surface, Lattice<Int> positions,
               const AxisSteps<Triple>& steps)
      : rows_(positions.rows.data()), steps_(&steps) {
    if (guides.copies) copies_.emplace(guides.originals, rows_, positions.axes);
    if (!guides.symmetry) return;
    mirror_.emplace(*guides.symmetry, rows_, positions.count(), surface);
    axis_ = guides.symmetry->axis;
  }

  bool any() const { return copies_ || mirror_; }

  /// Codes v, across a-b from c, by its original or by connectivity. Returns whom it is like; or
  /// nobody, if it is not coded. Precondition: a, b and c are known.
  template <class Coder, class One>
  std::uint32_t code(Coder& coder, std::uint32_t v, std::uint32_t a, std::uint32_t b,
                     std::uint32_t c, bool strictly, One one) {
    if (Int place[3]; copies_ && copies_->guess(v, a, b, c, place)) {
      const unsigned size = std::max(copies_->expected() / 4, 4u) - 4;
      for (unsigned i = 0; i < 3; ++i) one(i, place[i], ResidualContext(4, size), 1u);
      return copies_->original(v);
    }
    if (!mirror_) return nobody;
    guessed_ = mirror_->guess(a, b, c, strictly);
    return guessed_ != nobody && code_image(coder, v, one) ? guessed_ : nobody;
  }

  /// Whether nobody was found yet by whom there may be.
  bool asks() const { return mirror_ && guessed_ == nobody; }

  /// The same by whose image is nearest to a place, in quarters of a step. Precondition: it asks.
  template <class Coder, class One>
  std::uint32_t code_nearest(Coder& coder, std::uint32_t v, std::uint32_t a, std::uint32_t b,
                             const std::int64_t* quarters, One one) {
    Int place[3];
    for (unsigned i = 0; i < 3; ++i)
      place[i] = static_cast<Int>(steps_->within(i, quarters[i] >> 2));
    guessed_ = mirror_->guess(a, b, place);
    return guessed_ != nobody && code_image(coder, v, one) ? guessed_ : nobody;
  }

  /// Whether what was decoded is what an encoder may have coded.
  bool valid() const { return valid_; }

  /// Says that v is in its row from now on.
  CLERS_NEVER_INLINE void known(std::uint32_t v) {
    if (copies_) copies_->known(v);
    if (mirror_) mirror_->known(v, guessed_);
    guessed_ = nobody;
  }

 private:
  /// Instead of a set of components that differ: the image is not where v is.
  static constexpr unsigned far = 8;

  /// v by the image of the one that was guessed: which components differ, then those.
  template <class Coder, class One>
  bool code_image(Coder& coder, std::uint32_t v, One one) {
    Int* const row = rows_ + 3 * std::size_t(v);
    std::array<std::int64_t, 3> place;
    unsigned differ = 0;
    for (unsigned i = 0; i < 3; ++i) {
      place[i] = steps_->nearest(i, steps_->within(i, mirror_->image(guessed_, i)));
      if constexpr (Coder::encodes) {
        const std::uint64_t off = magnitude(steps_->difference(i, row[i], place[i]));
        differ |= off > 3 ? far : off > 0 ? 1u << i : 0u;
      }
    }
    differ = coder.symbol(0, differing_[last_far_], std::min(differ, far));
    last_far_ = (2 * last_far_ + (differ >= far)) % differing_.size();
    if (differ >= far) {
      valid_ &= differ == far;
      return false;
    }
    for (unsigned i = 0; i < 3; ++i) {
      if ((differ >> i & 1) == 0) {
        row[i] = static_cast<Int>(place[i]);
        continue;
      }
      one(i, place[i], ResidualContext(3, 0), i == axis_ ? 2u : 1u);
      valid_ &= row[i] != place[i];
    }
    return true;
  }

  static Distribution prior() {
    std::array<std::uint16_t, 16> share{};
    share.fill(64);
    share[0] = share[far] = 6000;
    share[1] = share[2] = share[4] = 1200;
    share[15] = 144;
    return Distribution(share);
  }

  Int* const rows_;
  const AxisSteps<Triple>* steps_;
  std::optional<Copies<Int>> copies_;
  std::optional<Mirror<Int>> mirror_;
  std::uint32_t guessed_ = nobody, axis_ = 3;
  std::vector<Distribution> differing_ = std::vector<Distribution>(8, prior());
  std::size_t last_far_ = 0;  ///< whether the last three were, a bit each
  bool valid_ = true;
};

}  // namespace clers::internal

#endif
