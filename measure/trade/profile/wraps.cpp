#include "measure/trade/profile/wraps.hpp"

#include <cstddef>
#include <utility>

#include "oracle/fast.hpp"

namespace fixproof::trade {

namespace {

std::int64_t value_of(std::uint32_t word) { return static_cast<std::int32_t>(word); }

bool fits(std::int64_t value) { return std::in_range<std::int32_t>(value); }

std::int64_t exact_product(const cases::Variant& variant, std::uint32_t a, std::uint32_t b) {
  using enum oracle::Rounding;
  const bool rounds = variant.build.mul_round;
  const auto rounding = variant.build.target == cases::Target::i386
                            ? (rounds ? half_up : floor)
                            : (rounds ? half_away : truncate);
  return oracle::fast::exact_product(a, b, rounding, 16).value();
}

/// Truncates, because rounding never moves a quotient of two words across the ends of the range.
bool quotient_wraps(const cases::Variant& variant, std::uint32_t n, std::uint32_t d) {
  // The 8088 listing divides by the whole part of the divisor's magnitude.
  const bool by_whole = variant.build.target == cases::Target::i8088;
  const auto divisor = by_whole ? static_cast<std::uint32_t>(value_of(d) / 65536 * 65536) : d;
  return !fits(oracle::fast::exact_quotient(n, divisor, oracle::Rounding::truncate, 16)->value());
}

std::int64_t row_times(const cases::Variant& variant, std::span<const std::uint32_t> row,
                       std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return exact_product(variant, row[0], x) + exact_product(variant, row[1], y) +
         exact_product(variant, row[2], z);
}

/// The carry that the printed 8088 ConcatXforms loses in sum + moved: 1.0 or 0.
std::int64_t lost_carry(const cases::Variant& variant, std::int64_t sum, std::int64_t moved) {
  constexpr std::int64_t one = 0x10000;
  const auto fraction = [](std::int64_t value) { return value & (one - 1); };
  return cases::loses_carry(variant) && fraction(sum) + fraction(moved) >= one ? one : 0;
}

}  // namespace

bool wraps(const cases::Variant& variant, std::span<const std::uint32_t> in) {
  switch (variant.operation) {
    case cases::Operation::mul:
      return !fits(exact_product(variant, in[0], in[1]));
    case cases::Operation::div:
      return quotient_wraps(variant, in[0], in[1]);
    case cases::Operation::xformvec:
      for (std::size_t i = 0; i < 3; ++i) {
        const auto row = in.subspan(4 * i, 4);
        if (!fits(row_times(variant, row, in[12], in[13], in[14]) + value_of(row[3]))) return true;
      }
      return false;
    case cases::Operation::concat:
      for (std::size_t i = 0; i < 3; ++i) {
        const auto row = in.subspan(4 * i, 4);
        for (std::size_t j = 0; j < 4; ++j) {
          const std::int64_t sum = row_times(variant, row, in[12 + j], in[16 + j], in[20 + j]);
          const std::int64_t moved = j == 3 ? value_of(row[3]) : 0;
          const std::int64_t lost = j == 3 ? lost_carry(variant, sum, moved) : 0;
          if (!fits(sum + moved - lost)) return true;
        }
      }
      return false;
    default:
      return false;
  }
}

}  // namespace fixproof::trade
