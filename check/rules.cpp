#include "check/rules.hpp"

#include <array>
#include <stdexcept>

#include "oracle/fast.hpp"

namespace fixproof::check {

namespace {

using oracle::Rounding;

constexpr std::uint32_t highest = 0x7fffffff;
constexpr std::uint32_t lowest = 0x80000000;
constexpr std::uint32_t minus_highest = 0x80000001;

constexpr std::array<Rounding, 5> all_roundings{Rounding::half_up, Rounding::half_away,
                                                Rounding::half_even, Rounding::floor,
                                                Rounding::truncate};
constexpr std::array<Overflow, 6> all_overflow_rules{Overflow::wrap,      Overflow::saturate,
                                                     Overflow::symmetric, Overflow::maximum,
                                                     Overflow::minimum,   Overflow::error};
constexpr std::array<NoResult, 6> zero_divisor_rules{NoResult::error,     NoResult::saturate,
                                                     NoResult::symmetric, NoResult::maximum,
                                                     NoResult::minimum,   NoResult::zero};
constexpr std::array<NoResult, 5> negative_root_rules{
    NoResult::error, NoResult::maximum, NoResult::minimum, NoResult::zero, NoResult::mirror};

Said limit_of(NoResult rule, bool negative) {
  switch (rule) {
    case NoResult::saturate:
      return negative ? lowest : highest;
    case NoResult::symmetric:
      return negative ? minus_highest : highest;
    case NoResult::maximum:
      return highest;
    case NoResult::minimum:
      return lowest;
    case NoResult::zero:
      return 0;
    default:
      return std::nullopt;
  }
}

Said mirrored_root(std::uint32_t radicand, Rounding rounding) {
  // The magnitude of 80000000 does not fit a word; its root is 2^23.5 = 11863283.2 ulps.
  constexpr std::int64_t of_lowest = 11'863'283;
  const auto root = radicand == lowest ? std::optional(of_lowest)
                                       : oracle::fast::exact_root(0U - radicand, rounding, 16);
  // The mirrored root is negative, so floor rounds it away from zero.
  const bool down = rounding == Rounding::floor;
  if (!down) return static_cast<std::uint32_t>(-*root);
  const bool exact = radicand != lowest && *root * *root == std::int64_t{0U - radicand} << 16;
  return static_cast<std::uint32_t>(-*root - (exact ? 0 : 1));
}

Said no_result_of(NoResult rule, std::span<const std::uint32_t> words, Rounding rounding) {
  return rule == NoResult::mirror ? mirrored_root(words[0], rounding)
                                  : limit_of(rule, is_negative(words[0]));
}

Said overflowed(Overflow rule, std::int64_t ulps) {
  switch (rule) {
    case Overflow::wrap:
      return static_cast<std::uint32_t>(ulps);
    case Overflow::saturate:
      return ulps < 0 ? lowest : highest;
    case Overflow::symmetric:
      return ulps < 0 ? minus_highest : highest;
    case Overflow::maximum:
      return highest;
    case Overflow::minimum:
      return lowest;
    default:
      return std::nullopt;
  }
}

}  // namespace

std::string_view name_of(Rounding rule) {
  switch (rule) {
    case Rounding::half_up:
      return "half-up";
    case Rounding::half_away:
      return "half-away";
    case Rounding::half_even:
      return "half-even";
    case Rounding::floor:
      return "floor";
    case Rounding::truncate:
      break;
  }
  return "toward-zero";
}

std::string_view name_of(Overflow rule) {
  constexpr std::array<std::string_view, 7> names{"any",     "wrap",    "saturate", "symmetric",
                                                  "maximum", "minimum", "de"};
  return names.at(static_cast<std::size_t>(rule));
}

std::string_view name_of(NoResult rule) {
  constexpr std::array<std::string_view, 8> names{"any",     "de",      "saturate", "symmetric",
                                                  "maximum", "minimum", "zero",     "mirror"};
  return names.at(static_cast<std::size_t>(rule));
}

std::span<const Rounding> roundings() { return all_roundings; }
std::span<const Overflow> overflow_rules() { return all_overflow_rules; }
std::span<const NoResult> no_result_rules(cases::Operation operation) {
  if (operation == cases::Operation::div) return zero_divisor_rules;
  if (operation == cases::Operation::sqrt) return negative_root_rules;
  return {};
}

std::optional<std::int64_t> rounded_result(cases::Operation operation,
                                           std::span<const std::uint32_t> words, Rounding rule) {
  switch (operation) {
    case cases::Operation::mul:
      return oracle::fast::exact_product(words[0], words[1], rule, 16);
    case cases::Operation::div:
      return oracle::fast::exact_quotient(words[0], words[1], rule, 16);
    case cases::Operation::sqrt:
      return oracle::fast::exact_root(words[0], rule, 16);
    case cases::Operation::add:
      return oracle::fast::exact_sum(words[0], words[1], 16);
    case cases::Operation::sub:
      return oracle::fast::exact_difference(words[0], words[1], 16);
    default:
      throw std::invalid_argument("only mul, div, sqrt, add and sub are judged");
  }
}

bool keeps(Overflow rule, std::int64_t ulps, Said said) {
  return rule == Overflow::any || said == overflowed(rule, ulps);
}

bool keeps(NoResult rule, std::span<const std::uint32_t> words, Rounding rounding, Said said) {
  const bool by_sign = rule == NoResult::saturate || rule == NoResult::symmetric;
  if (rule == NoResult::any || (by_sign && words[0] == 0 && said == 0U)) return true;
  return said == no_result_of(rule, words, rounding);
}

Expected expected_of(const Rules& rules, std::span<const std::uint32_t> words) {
  const auto ulps = rounded_result(rules.operation, words, rules.rounding);
  if (!ulps) {
    return {rules.no_result != NoResult::any, no_result_of(rules.no_result, words, rules.rounding)};
  }
  if (fits_word(*ulps)) return {true, static_cast<std::uint32_t>(*ulps)};
  return {rules.overflow != Overflow::any, overflowed(rules.overflow, *ulps)};
}

bool keeps(const Rules& rules, std::span<const std::uint32_t> words, Said said) {
  const auto ulps = rounded_result(rules.operation, words, rules.rounding);
  if (!ulps) return keeps(rules.no_result, words, rules.rounding, said);
  if (fits_word(*ulps)) return said == static_cast<std::uint32_t>(*ulps);
  return keeps(rules.overflow, *ulps, said);
}

}  // namespace fixproof::check
