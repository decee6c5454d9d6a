#include "verify/profile/wraps.hpp"

#include <cstddef>
#include <limits>

namespace fixproof {

namespace {

std::int64_t value_of(std::uint32_t word) { return static_cast<std::int32_t>(word); }

bool fits(std::int64_t value) {
  return value >= std::numeric_limits<std::int32_t>::min() &&
         value <= std::numeric_limits<std::int32_t>::max();
}

/// Rounded as the listings round it. |a b| <= 2^62, so that nothing wraps here.
std::int64_t exact_product(const Variant& variant, std::uint32_t a, std::uint32_t b) {
  const std::int64_t exact = value_of(a) * value_of(b);
  const std::int64_t half = variant.mul_round ? 0x8000 : 0;
  if (variant.target == Target::i386) return (exact + half) >> 16;
  return exact < 0 ? -((half - exact) >> 16) : (exact + half) >> 16;
}

/// The magnitude of the quotient, rounded; its divisor has what the listing looks at.
bool quotient_wraps(const Variant& variant, std::uint32_t n, std::uint32_t d) {
  const std::int64_t dividend = value_of(n) < 0 ? -value_of(n) : value_of(n);
  const std::int64_t divisor = value_of(d) < 0 ? -value_of(d) : value_of(d);
  const bool i8088 = variant.target == Target::i8088;
  const std::int64_t over = i8088 ? dividend : dividend << 16;
  const std::int64_t under = i8088 ? divisor >> 16 : divisor;
  const std::int64_t magnitude = (over + (variant.div_round ? under / 2 : 0)) / under;
  const bool negative = (value_of(n) < 0) != (value_of(d) < 0);
  return !fits(negative ? -magnitude : magnitude);
}

/// Row `i` of a transform times a column.
std::int64_t row_times(const Variant& variant, std::span<const std::uint32_t> row, std::uint32_t x,
                       std::uint32_t y, std::uint32_t z) {
  return exact_product(variant, row[0], x) + exact_product(variant, row[1], y) +
         exact_product(variant, row[2], z);
}

}  // namespace

bool wraps(const Variant& variant, std::span<const std::uint32_t> in) {
  switch (variant.operation) {
    case Operation::mul:
      return !fits(exact_product(variant, in[0], in[1]));
    case Operation::div:
      return quotient_wraps(variant, in[0], in[1]);
    case Operation::xformvec:
      for (std::size_t i = 0; i < 3; ++i) {
        const auto row = in.subspan(4 * i, 4);
        if (!fits(row_times(variant, row, in[12], in[13], in[14]) + value_of(row[3]))) return true;
      }
      return false;
    case Operation::concat:
      for (std::size_t i = 0; i < 3; ++i) {
        const auto row = in.subspan(4 * i, 4);
        for (std::size_t j = 0; j < 4; ++j) {
          const std::int64_t moved = j == 3 ? value_of(row[3]) : 0;
          if (!fits(row_times(variant, row, in[12 + j], in[16 + j], in[20 + j]) + moved)) {
            return true;
          }
        }
      }
      return false;
    default:
      return false;
  }
}

}  // namespace fixproof
