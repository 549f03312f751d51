// What static entropy coders are made of: bits that are written last first, shares of symbols,
// classes of residuals.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "codec/attributes/residual_classes.h"
#include "codec/entropy/reversed_bits.h"
#include "codec/entropy/shares.h"

namespace clers::internal {
namespace {

TEST(ResidualClasses, MeetWithoutGaps) {
  for (unsigned c = 0; c < residual_classes; ++c) {
    const std::int64_t least = least_of(c), most = least + ((std::int64_t(1) << raw_bits(c)) - 1);
    EXPECT_EQ(class_of(least), c);
    EXPECT_EQ(class_of(most), c);
    if (c + 2 >= residual_classes) continue;
    if (c % 2 != 0) {
      EXPECT_EQ(least_of(c + 2), most + 1);
    } else if (c > 0) {
      EXPECT_EQ(least_of(c + 2) + (std::int64_t(1) << raw_bits(c + 2)), least);
    }
  }
}

TEST(ResidualClasses, ManyAtOnceAsOneByOne) {
  std::vector<std::int32_t> residuals;
  for (unsigned bit = 0; bit < 31; ++bit)
    for (const std::uint32_t half : {0u, 1u, 2u, 3u})
      for (std::int32_t near = -2; near <= 2; ++near) {
        const std::int32_t r =
            static_cast<std::int32_t>((std::uint32_t(1) << bit) + (half << bit >> 1)) + near;
        if (r == std::numeric_limits<std::int32_t>::min()) continue;
        residuals.push_back(r);
        residuals.push_back(-r);
      }
  std::vector<std::uint8_t> classes(residuals.size());
  classes_of(std::span<const std::int32_t>(residuals), classes.data());
  for (std::size_t i = 0; i < residuals.size(); ++i)
    ASSERT_EQ(classes[i], class_of(residuals[i])) << residuals[i];
}

RC_GTEST_PROP(ReversedBits, ComeBack, (const std::vector<std::uint64_t>& values)) {
  Bytes memory(ReversedBitWriter::room(57 * values.size()));
  ReversedBitWriter out(memory);
  for (std::size_t i = values.size(); i-- > 0;) {
    const unsigned n = static_cast<unsigned>(values[i] % 57);
    out.put(low_bits(values[i], n), n);
  }
  const std::span<const std::byte> bytes = out.finish();
  ReversedBitReader in(bytes);
  for (const std::uint64_t v : values) {
    const unsigned n = static_cast<unsigned>(v % 57);
    RC_ASSERT(!in.finished() || n == 0);
    if (in.within() > 0) RC_ASSERT(low_bits(in.window_within(), 57) == low_bits(in.window(), 57));
    RC_ASSERT(low_bits(in.window(), n) == low_bits(v, n));
    in.take(n);
  }
  RC_ASSERT(in.finished());
  in.take(1);
  RC_ASSERT(!in.finished());
  RC_ASSERT(in.window() == 0u);
}

RC_GTEST_PROP(Shares, AddUp, (std::vector<std::uint16_t> some)) {
  some.resize(std::min<std::size_t>(some.size(), most_symbols - 1));
  some.push_back(1);
  const std::vector<std::uint64_t> counts(some.begin(), some.end());
  for (const unsigned significant : {1u, 4u}) {
    const Weights weights = weights_of(counts, significant);
    if (!can_share(weights, 9)) continue;
    const Shares shares = shares_of(weights, 9);
    unsigned sum = 0;
    for (std::size_t s = 0; s < weights.size(); ++s) {
      RC_ASSERT((shares.of[s] != 0) == (counts[s] != 0));
      sum += shares.of[s];
    }
    RC_ASSERT(sum == 512u);
  }
}

}  // namespace
}  // namespace clers::internal
