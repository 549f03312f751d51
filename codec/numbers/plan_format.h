// Plans of attributes <-> bytes, to hand them to who encodes a piece elsewhere. Never in a file.
#ifndef CLERS_CODEC_NUMBERS_PLAN_FORMAT_H
#define CLERS_CODEC_NUMBERS_PLAN_FORMAT_H

#include <cstdint>
#include <span>
#include <vector>

#include "codec/entropy/bytes.h"
#include "codec/error.h"
#include "codec/numbers/number_format.h"
#include "codec/numbers/number_system.h"

namespace clers::internal {

inline void put_plan(Bytes& out, const AttributePlan& plan) {
  put_varint(out, plan.systems.size());
  for (const NumberSystem& s : plan.systems) {
    put_u8(out, static_cast<std::uint32_t>(s.map));
    put_u8(out, s.low_bits);
    put_u8(out, s.signed_zero);
    put_u8(out, s.ulps);
    put_signed_varint(out, s.first);
    put_varint(out, s.step);
    put_varint(out, s.divisor);
    put_double(out, s.origin);
    put_double(out, s.length);
    put_u8(out, s.single);
    put_u8(out, s.precision);
    put_u8(out, s.decimals);
    put_signed_varint(out, s.exponent);
  }
  put_double(out, plan.error);
  put_u8(out, static_cast<std::uint32_t>(plan.measure));
  put_u8(out, plan.integers_of ? static_cast<std::uint32_t>(*plan.integers_of) : scalar_count);
}

/// Looks at no more than where the bytes end: what they say was said by put_plan().
inline AttributePlan read_plan(ByteReader& in) {
  AttributePlan plan;
  for (std::uint64_t left = in.varint(); in.ok() && left > 0; --left) {
    NumberSystem& s = plan.systems.emplace_back();
    s.map = static_cast<NumberMap>(in.u8());
    s.low_bits = static_cast<std::uint8_t>(in.u8());
    s.signed_zero = in.u8() != 0;
    s.ulps = static_cast<std::uint8_t>(in.u8());
    s.first = in.signed_varint();
    s.step = in.varint();
    s.divisor = in.varint();
    s.origin = read_double(in);
    s.length = read_double(in);
    s.single = in.u8() != 0;
    s.precision = static_cast<std::uint8_t>(in.u8());
    s.decimals = in.u8() != 0;
    s.exponent = static_cast<std::int16_t>(in.signed_varint());
  }
  plan.error = read_double(in);
  plan.measure = static_cast<ErrorMeasure>(in.u8());
  if (const std::uint32_t scalar = in.u8(); scalar < scalar_count)
    plan.integers_of = static_cast<Scalar>(scalar);
  return plan;
}

}  // namespace clers::internal

#endif
