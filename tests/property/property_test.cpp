// A user's test file: functions registered with their rules.
#include <cstdint>
#include <optional>

#include "property/rapidcheck.hpp"

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

}  // namespace
