/// @file
/// The exact results of judged operations in ulps, by the oracle.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>

#include "judge/check/rules.hpp"
#include "oracle/fast.hpp"
#include "oracle/integer.hpp"
#include "oracle/rule.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::check {

[[noreturn]] inline void refuse_operation() {
  throw std::invalid_argument(
      "only mul, div, sqrt, add, sub, fmod, remainder, conversions and what has an exact value are "
      "judged");
}

/// The rounded result in ulps of the results' format; empty for x / 0, negative radicands, NaN and
/// the infinities.
/// @throws std::invalid_argument for an operation that is not judged
std::optional<oracle::Integer> exact_ulps(const cases::Variant& variant, const Operands& operands,
                                          oracle::Rounding rule);

/// The same in 16.16, about ten times as fast: a result has less than 49 bits.
inline std::optional<std::int64_t> narrow_ulps(cases::Operation operation,
                                               std::span<const std::uint64_t> words,
                                               oracle::Rounding rule) {
  const auto a = static_cast<std::uint32_t>(words[0]);
  const auto b = static_cast<std::uint32_t>(words.back());
  constexpr oracle::Format format;
  const auto signed_word = [](std::optional<oracle::LongWord> word) -> std::optional<std::int64_t> {
    if (!word) return std::nullopt;
    return static_cast<std::int32_t>(*word);
  };
  const auto value_of = [](std::optional<oracle::fast::Signed> ulps) {
    return ulps ? std::optional(ulps->value()) : std::nullopt;
  };
  switch (operation) {
    case cases::Operation::mul:
      return oracle::fast::exact_product(a, b, rule, format).value();
    case cases::Operation::div:
      return value_of(oracle::fast::exact_quotient(a, b, rule, format));
    case cases::Operation::sqrt:
      return oracle::fast::exact_root(a, rule, format);
    case cases::Operation::add:
      return oracle::fast::exact_sum(a, b, format);
    case cases::Operation::sub:
      return oracle::fast::exact_difference(a, b, format);
    case cases::Operation::fmod:
      return signed_word(oracle::fast::truncated_remainder(a, b, format));
    case cases::Operation::remainder:
      return signed_word(oracle::fast::nearest_remainder(a, b, format));
    default:
      refuse_operation();
  }
}

/// Returns the word of a result of narrow_ulps().
constexpr Rounded narrow_word(std::int64_t ulps) {
  const auto word = static_cast<std::uint32_t>(ulps);
  return {word, static_cast<std::int32_t>(word) == ulps, ulps < 0};
}

}  // namespace fixproof::check
