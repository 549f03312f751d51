// Streams come back, and no other bytes give the same.
#include "codec/entropy/stream.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace clers::internal {
namespace {

template <class Coder>
void code(Coder& coder, std::vector<std::uint32_t>& numbers) {
  NumberModel model;
  for (std::uint32_t& n : numbers) n = model.code(coder, n);
}

/// What decoding finds wrong; empty: nothing.
std::string decoded(const Bytes& bytes, std::vector<std::uint32_t>& numbers) {
  const auto ok = decode_stream({bytes, 7}, "the numbers", [&](DecodeFrom& coder) -> std::string {
    code(coder, numbers);
    return {};
  });
  if (ok) return {};
  EXPECT_EQ(ok.error().code, ErrorCode::invalid);
  EXPECT_EQ(ok.error().at, 7u);
  return ok.error().what;
}

RC_GTEST_PROP(Stream, ComesBackAndIsTheOnlyOne, (std::vector<std::uint32_t> numbers)) {
  std::vector<std::uint32_t> again = numbers;
  const Bytes bytes = encode_stream([&](EncodeTo& coder) { code(coder, again); });
  RC_ASSERT(again == numbers);
  again.assign(numbers.size(), 0);
  RC_ASSERT(decoded(bytes, again).empty());
  RC_ASSERT(again == numbers);

  // Any other bytes are refused, or give other numbers.
  Bytes other = bytes;
  const auto at = *rc::gen::inRange<std::size_t>(0, bytes.size());
  switch (*rc::gen::inRange(0, 3)) {
    case 0: other.resize(at); break;
    case 1: other.push_back(std::byte(*rc::gen::arbitrary<std::uint8_t>())); break;
    default: other[at] ^= std::byte(*rc::gen::inRange(1, 256)); break;
  }
  std::vector<std::uint32_t> others(numbers.size());
  RC_ASSERT(!decoded(other, others).empty() || others != numbers);
}

TEST(Stream, SaysWhereItDoesNotEnd) {
  std::vector<std::uint32_t> numbers{1, 2, 3};
  Bytes bytes = encode_stream([&](EncodeTo& coder) { code(coder, numbers); });
  bytes.push_back({});
  bytes.push_back({});
  EXPECT_EQ(decoded(bytes, numbers), "the numbers do not end where their bytes end");
}

TEST(Stream, WhatCodeFindsWrongComesFirst) {
  const Bytes nothing;
  const auto ok = decode_stream({nothing, 3}, "the numbers",
                                [](DecodeFrom&) { return std::string("is wrong"); });
  ASSERT_FALSE(ok);
  EXPECT_EQ(ok.error().what, "is wrong");
}

TEST(Stream, IsReadWithTheNumbersBeforeIt) {
  const EncodedStream stream{{300, 5}, {std::byte{1}, std::byte{2}}};
  Bytes out(3);
  stream.put(out);
  ByteReader in(std::span<const std::byte>(out).subspan(3), 3);
  std::uint64_t a = 0, b = 0;
  const Stream read = read_stream(in, {&a, &b});
  EXPECT_TRUE(in.ok());
  EXPECT_EQ(in.left(), 0u);
  EXPECT_EQ(a, 300u);
  EXPECT_EQ(b, 5u);
  EXPECT_EQ(read.at, 3u + 2 + 1 + 1);
  EXPECT_EQ(Bytes(read.bytes.begin(), read.bytes.end()), stream.bytes);

  out.pop_back();
  ByteReader cut(std::span<const std::byte>(out).subspan(3), 3);
  read_stream(cut, {&a, &b});
  EXPECT_FALSE(cut.ok());
}

}  // namespace
}  // namespace clers::internal
