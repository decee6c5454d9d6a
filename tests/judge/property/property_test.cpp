// A user's test file: functions registered with their rules.
#include <cstdint>
#include <optional>

#include "judge/property/rapidcheck.hpp"

namespace {

std::int32_t wide_mul(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((std::int64_t{a} * b + 0x8000) >> 16);
}

std::optional<std::int32_t> wide_div(std::int32_t a, std::int32_t b) {
  if (b == 0) return std::nullopt;
  return static_cast<std::int32_t>(std::int64_t{a} * 65536 / b);
}

/// Undefined for divisions that its rules exclude.
std::int32_t careless_div(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(std::int64_t{a} * 65536 / b);
}

std::int32_t root(std::int32_t x) {
  std::int64_t result = 0;
  for (std::int64_t bit = 1 << 23; x > 0 && bit != 0; bit /= 2) {
    if ((result + bit) * (result + bit) <= std::int64_t{x} * 65536) result += bit;
  }
  return static_cast<std::int32_t>(result);
}

FIXPROOF_CHECK_MUL(wide_mul, half_up, wrap)
FIXPROOF_PROPERTY_MUL(wide_mul, half_up, wrap)
FIXPROOF_CHECK_DIV(wide_div, truncate, wrap, error)
FIXPROOF_PROPERTY_DIV(wide_div, truncate, wrap, error)
FIXPROOF_CHECK_DIV(careless_div, truncate, any, any)
FIXPROOF_CHECK_SQRT(root, floor, zero)
FIXPROOF_PROPERTY_SQRT(root, floor, zero)

std::int32_t mul_of_q2_30(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((std::int64_t{a} * b + (1 << 29)) >> 30);
}

std::int16_t mul_of_q1_15(std::int16_t a, std::int16_t b) {
  const std::int32_t product = (std::int32_t{a} * b + 0x4000) >> 15;
  return static_cast<std::int16_t>(product > 0x7fff ? 0x7fff : product);
}

std::uint16_t mul_of_u8_8(std::uint16_t a, std::uint16_t b) {
  return static_cast<std::uint16_t>((std::uint32_t{a} * b + 128) >> 8U);
}

std::optional<std::uint16_t> div_of_u8_8(std::uint16_t a, std::uint16_t b) {
  if (b == 0) return std::nullopt;
  return static_cast<std::uint16_t>((std::uint32_t{a} << 8U) / b);
}

/// Multiplies in halves of 32 bits, because the product has 128.
std::int64_t mul_of_q32_32(std::int64_t a, std::int64_t b) {
  const auto x = static_cast<std::uint64_t>(a);
  const auto y = static_cast<std::uint64_t>(b);
  const std::uint64_t low = (x & 0xffffffffU) * (y & 0xffffffffU);
  // The upper halves have the sign.
  const std::uint64_t high = static_cast<std::uint64_t>(a >> 32) * y +
                             (x & 0xffffffffU) * static_cast<std::uint64_t>(b >> 32);
  const std::uint64_t carry = (low + (std::uint64_t{1} << 31U)) >> 32U;
  return static_cast<std::int64_t>(high + carry);
}

FIXPROOF_CHECK_MUL_IN(fixproof::q2_30, mul_of_q2_30, half_up, wrap)
FIXPROOF_PROPERTY_MUL_IN(fixproof::q2_30, mul_of_q2_30, half_up, wrap)
FIXPROOF_CHECK_MUL_IN(fixproof::q1_15, mul_of_q1_15, half_up, saturate)
FIXPROOF_PROPERTY_MUL_IN(fixproof::q1_15, mul_of_q1_15, half_up, saturate)
FIXPROOF_CHECK_MUL_IN(fixproof::u8_8, mul_of_u8_8, half_up, wrap)
FIXPROOF_PROPERTY_MUL_IN(fixproof::u8_8, mul_of_u8_8, half_up, wrap)
FIXPROOF_CHECK_DIV_IN(fixproof::u8_8, div_of_u8_8, floor, wrap, error)
FIXPROOF_CHECK_MUL_IN(fixproof::q32_32, mul_of_q32_32, half_up, wrap)
FIXPROOF_PROPERTY_MUL_IN(fixproof::q32_32, mul_of_q32_32, half_up, wrap)

}  // namespace
