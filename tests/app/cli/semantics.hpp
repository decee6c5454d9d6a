/// @file
/// FixedMul and FixedDiv by docs/semantics.md.
#pragma once

#include <optional>

#include "tests/support/exact.hpp"

namespace semantics {

using fixproof::rounding;

inline constexpr exact::integer one = 65536;

constexpr exact::integer value_of(std::uint32_t word) { return static_cast<std::int32_t>(word); }
constexpr std::uint32_t word_of(exact::integer n) {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(exact::wrapped(n, 32)));
}

constexpr std::uint32_t mul(std::uint32_t a, std::uint32_t b, bool is_386, bool round) {
  const rounding rule = is_386  ? round ? rounding::half_up : rounding::floor
                        : round ? rounding::half_away
                                : rounding::truncate;
  return word_of(exact::round({value_of(a) * value_of(b), one}, rule));
}

/// Returns no value for a divide error.
constexpr std::optional<std::uint32_t> div(std::uint32_t n, std::uint32_t d, bool is_386,
                                           bool round) {
  // The 8088 divides by the whole part of the magnitude, so both operands lose 16 fraction bits.
  const exact::integer divisor = is_386 ? value_of(d) : value_of(d) / one;
  if (divisor == 0) return std::nullopt;
  const auto quotient = exact::ratio(value_of(n) * (is_386 ? one : 1), divisor);
  const exact::integer result =
      exact::round(quotient, round ? rounding::half_away : rounding::truncate);
  const exact::integer cut = exact::round(quotient, rounding::truncate);
  if (is_386 && round && (cut <= -one * one || cut >= one * one)) return std::nullopt;
  if (is_386 && !round && exact::wrapped(result, 32) != result) return std::nullopt;
  return word_of(result);
}

}  // namespace semantics
