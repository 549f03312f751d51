// Distributions of sixteen symbols, and what is coded with them.
#include "codec/entropy/lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <vector>

#include "corpus/random.h"

namespace clers::internal {
namespace {

Distribution even() {
  std::array<std::uint16_t, 16> share;
  share.fill(shares / 16);
  return Distribution(share);
}

/// What every form must do, by the words of the format.
struct Plain {
  std::array<int, 17> start;
  int seen = 0;

  Plain() {
    for (int s = 0; s <= 16; ++s) start[static_cast<std::size_t>(s)] = s * 1024;
  }
  void update(int symbol) {
    const int rate = seen < 6 ? 3 : seen < 18 ? 4 : seen < 50 ? 5 : seen < 159 ? 6 : 7;
    seen += seen < 159;
    for (int s = 0; s < 16; ++s) {
      int& x = start[static_cast<std::size_t>(s)];
      const int target = s <= symbol ? 4 * s : 16384 - 4 * (16 - s) + (1 << rate) - 1;
      const int step = target - x;
      x += step >= 0 ? step >> rate : -((-step + (1 << rate) - 1) >> rate);
    }
  }
};

TEST(Distribution, MovesTowardsWhatItSees) {
  corpus::Random random(1);
  for (unsigned kind = 0; kind < 4; ++kind) {
    Distribution x = even(), y = even();
    Plain plain, other;
    for (unsigned i = 0; i < 3000; ++i) {
      const unsigned s = kind == 0   ? random.below(16)
                         : kind == 1 ? 15
                         : kind == 2 ? 0
                                     : random.below(1 + random.below(16));
      Starts mean;
      Distribution::mean(x, y, mean);
      for (std::size_t k = 0; k <= 16; ++k) {
        ASSERT_EQ(x.starts().at[k], plain.start[k]);
        ASSERT_EQ(mean.at[k], (plain.start[k] + other.start[k] + 1) / 2);
      }
      for (std::size_t k = 0; k < 16; ++k) ASSERT_GE(mean.at[k + 1] - mean.at[k], 4);
      for (const std::uint32_t place : {std::uint32_t(0), shares - 1, random.below(shares)}) {
        const unsigned found = mean.find(place);
        ASSERT_TRUE(mean.at[found] <= place && place < mean.at[found + 1]);
      }
      x.update(s);
      plain.update(static_cast<int>(s));
      if (i % 3 == 0) {
        y.update(15 - s);
        other.update(15 - static_cast<int>(s));
      }
    }
  }
}

/// What of any of the ways to code something comes back; a random sequence, twice the same.
template <class Coder>
std::vector<std::uint64_t> code(Coder& coder, std::vector<std::uint64_t> values) {
  corpus::Random random(2);
  std::vector<Distribution> models(4, even());
  BitModel flags;
  for (std::uint64_t& value : values) {
    const unsigned lane = random.below(lane_count), way = random.below(5), n = random.below(59);
    const auto low = [&](unsigned bits) { return value & ((std::uint64_t(1) << bits) - 1); };
    switch (way) {
      case 0: value = coder.symbol(lane, models[0], static_cast<unsigned>(low(4))); break;
      case 1:
        value = coder.symbol(lane, models[1], models[2], static_cast<unsigned>(low(3)));
        break;
      case 2: value = coder.flag(lane, flags, low(1)); break;
      case 3: value = coder.even(lane, n, low(n)); break;
      default:
        if constexpr (Coder::encodes)
          coder.bits(n, value = low(n));
        else
          value = coder.bits(n, 0, 0)[0];
    }
  }
  return values;
}

TEST(Lanes, GiveBackWhatWasCoded) {
  corpus::Random random(3);
  for (const std::size_t count : {0u, 1u, 2u, 10u, 3000u}) {
    std::vector<std::uint64_t> values(count);
    for (std::uint64_t& v : values)
      v = std::uint64_t(random.below(1u << 31)) << 31 | random.below(1u << 31);
    LaneEncoder encoder;
    const auto coded = code(encoder, values);
    Bytes bytes;
    encoder.finish(bytes);
    const auto decode = [&](const Bytes& from, std::vector<std::uint64_t>& out) {
      ByteReader in(from, 0);
      LaneDecoder decoder(in);
      out = code(decoder, std::vector<std::uint64_t>(count));
      return decoder.finished();
    };
    std::vector<std::uint64_t> out;
    ASSERT_TRUE(decode(bytes, out));
    ASSERT_EQ(out, coded);
    Bytes longer = bytes;
    for (unsigned i = 0; i < 3; ++i) {
      longer.push_back(std::byte(0));
      ASSERT_FALSE(decode(longer, out));
    }
    for (unsigned i = 0; i < 20; ++i) {
      Bytes shorter = bytes;
      shorter.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
      ASSERT_FALSE(decode(shorter, out));
    }
  }
}

}  // namespace
}  // namespace clers::internal
