#include "judge/check/rules.hpp"

#include <fmt/format.h>

#include <array>

#include "judge/check/exact_ulps.hpp"
#include "judge/check/ports.hpp"
#include "oracle/fast.hpp"
#include "oracle/format.hpp"
#include "verify/cases/exact_value.hpp"

namespace fixproof::check {

namespace {

using oracle::Rounding;

constexpr std::array<Rounding, 6> all_roundings{Rounding::half_up,   Rounding::half_away,
                                                Rounding::half_even, Rounding::floor,
                                                Rounding::truncate,  Rounding::ceiling};
constexpr std::array<Overflow, 6> all_overflow_rules{Overflow::wrap,      Overflow::saturate,
                                                     Overflow::symmetric, Overflow::maximum,
                                                     Overflow::minimum,   Overflow::error};
constexpr std::array<NoResult, 6> zero_divisor_rules{NoResult::error,     NoResult::saturate,
                                                     NoResult::symmetric, NoResult::maximum,
                                                     NoResult::minimum,   NoResult::zero};
constexpr std::array<Overflow, 5> unsigned_overflow_rules{
    Overflow::wrap, Overflow::saturate, Overflow::maximum, Overflow::minimum, Overflow::error};
constexpr std::array<NoResult, 3> unsigned_divisor_rules{NoResult::error, NoResult::saturate,
                                                         NoResult::zero};
constexpr std::array<NoResult, 4> rules_of_unsigned_results{NoResult::error, NoResult::saturate,
                                                            NoResult::maximum, NoResult::zero};
constexpr std::array<NoResult, 3> domain_rules_of_unsigned_results{
    NoResult::error, NoResult::maximum, NoResult::zero};
constexpr std::array<NoResult, 4> root_rules_of_unsigned_results{NoResult::error, NoResult::maximum,
                                                                 NoResult::zero, NoResult::mirror};
constexpr std::array<NoResult, 5> negative_root_rules{
    NoResult::error, NoResult::maximum, NoResult::minimum, NoResult::zero, NoResult::mirror};

constexpr std::array<NoResult, 4> outside_domain_rules{NoResult::error, NoResult::maximum,
                                                       NoResult::minimum, NoResult::zero};

Said limit_of(NoResult rule, const cases::Format& format, bool negative) {
  switch (rule) {
    case NoResult::saturate:
      return negative ? lowest(format) : highest(format);
    case NoResult::symmetric:
      return negative ? minus_highest(format) : highest(format);
    case NoResult::maximum:
      return highest(format);
    case NoResult::minimum:
      return lowest(format);
    case NoResult::zero:
      return 0;
    default:
      return std::nullopt;
  }
}

/// The rounding of a root whose negative has the other rounding.
constexpr Rounding mirrored(Rounding rounding) {
  if (rounding == Rounding::floor) return Rounding::ceiling;
  return rounding == Rounding::ceiling ? Rounding::floor : rounding;
}

Said mirrored_root(std::uint64_t radicand, const cases::Format& format, Rounding rounding) {
  const std::uint64_t size = magnitude(radicand, format);
  if (format == cases::q16_16 && radicand != lowest(format)) {
    const auto root = oracle::fast::exact_root(size, mirrored(rounding), 16);
    return static_cast<std::uint32_t>(0 - *root);
  }
  // The magnitude of the lowest word fits only an unsigned word.
  oracle::Format wide = format.as<oracle::Format>();
  wide.is_signed = false;
  return oracle::wrap(-*oracle::exact_root(size, mirrored(rounding), wide), wide);
}

Said no_result_of(NoResult rule, const cases::Format& format, const Operands& operands,
                  Rounding rounding) {
  if (rule != NoResult::mirror) return limit_of(rule, format, operands.sign(format) < 0);
  if (operands.valued() == nullptr) {
    return mirrored_root(operands.words()[0], format, rounding);
  }
  return oracle::wrap(to_ulps(*operands.valued()->mirrored, rounding, format),
                      format.as<oracle::Format>());
}

Said overflowed(Overflow rule, const cases::Format& format, const Rounded& rounded) {
  switch (rule) {
    case Overflow::wrap:
      return rounded.word;
    case Overflow::saturate:
      return rounded.negative ? lowest(format) : highest(format);
    case Overflow::symmetric:
      return rounded.negative ? minus_highest(format) : highest(format);
    case Overflow::maximum:
      return highest(format);
    case Overflow::minimum:
      return lowest(format);
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
    case Rounding::ceiling:
      return "ceiling";
    case Rounding::truncate:
      break;
  }
  return "toward-zero";
}

std::string_view name_of(Overflow rule) {
  constexpr std::array<std::string_view, 8> names{"any",     "wrap",    "saturate", "symmetric",
                                                  "maximum", "minimum", "de",       "a word"};
  return names.at(static_cast<std::size_t>(rule));
}

std::string_view name_of(NoResult rule) {
  constexpr std::array<std::string_view, 9> names{
      "any", "de", "saturate", "symmetric", "maximum", "minimum", "zero", "mirror", "a word"};
  return names.at(static_cast<std::size_t>(rule));
}

std::string text_of_rounding(const Rules& rules) {
  if (rules.within) {
    return fmt::format("within {}{}", rules.within->text,
                       rules.within->is_relative ? " of the exact result" : " ulp");
  }
  if (rules.faithful) return std::string(faithful);
  return is_rounded(rules.variant) ? std::string(name_of(rules.rounding)) : "exact";
}

std::string text_of_overflow(const Rules& rules) {
  return rules.overflow == Overflow::word ? hex_text(rules.overflow_word, rules.variant.format)
                                          : std::string(name_of(rules.overflow));
}

std::string text_of_no_result(const Rules& rules) {
  return rules.no_result == NoResult::word ? hex_text(rules.no_result_word, rules.variant.format)
                                           : std::string(name_of(rules.no_result));
}

bool is_rounded(const cases::Variant& v) {
  using enum cases::Operation;
  const bool is_product = v.operation == mul || cases::is_sum(v.operation);
  const bool is_sum = v.operation == add || v.operation == sub || is_remainder(v.operation);
  if (v.operation == to_decimal) return false;
  if (!is_product && !is_sum && v.operation != convert) return true;
  if (!v.from && !is_product) return false;
  if (!v.from && !v.format.is_decimal && v.format.fraction_bits >= 0) {
    return v.format.fraction_bits > 0;
  }
  const oracle::Ratio from = unit_of(cases::operand_format(v));
  const oracle::Ratio to = unit_of(v.format);
  const auto is_multiple = [&to](const oracle::Integer& numerator,
                                 const oracle::Integer& denominator) {
    return numerator * to.denominator % (denominator * to.numerator) == 0;
  };
  if (is_product &&
      !is_multiple(from.numerator * from.numerator, from.denominator * from.denominator)) {
    return true;
  }
  return v.operation != mul && v.operation != dot && !is_multiple(from.numerator, from.denominator);
}

std::span<const Rounding> roundings() { return all_roundings; }
std::span<const Overflow> overflow_rules() { return all_overflow_rules; }
std::span<const NoResult> no_result_rules(cases::Operation operation) {
  if (cases::divides(operation) || operation == cases::Operation::from_binary64) {
    return zero_divisor_rules;
  }
  if (operation == cases::Operation::sqrt) return negative_root_rules;
  if (cases::is_function(operation)) return outside_domain_rules;
  return {};
}

std::span<const Overflow> overflow_rules(const cases::Format& format) {
  if (!format.is_signed) return unsigned_overflow_rules;
  return all_overflow_rules;
}
std::span<const NoResult> no_result_rules(const cases::Variant& variant) {
  if (!can_lack_result(variant)) return {};
  if (variant.operation == cases::Operation::sqrt && !variant.format.is_signed) {
    return root_rules_of_unsigned_results;
  }
  if (cases::is_function(variant.operation)) {
    if (variant.format.is_signed) return outside_domain_rules;
    return domain_rules_of_unsigned_results;
  }
  if (variant.format.is_signed) return no_result_rules(variant.operation);
  if (has_sign_without_result(variant)) return rules_of_unsigned_results;
  return unsigned_divisor_rules;
}

std::optional<Rounded> rounded_result(const cases::Variant& variant, const Operands& operands,
                                      Rounding rule) {
  if (variant.format == cases::q16_16 && operands.valued() == nullptr) {
    const auto ulps = narrow_ulps(variant.operation, operands.words(), rule);
    if (!ulps) return std::nullopt;
    return narrow_word(*ulps);
  }
  const auto ulps = exact_ulps(variant, operands, rule);
  if (!ulps) return std::nullopt;
  const auto wide = variant.format.as<oracle::Format>();
  return Rounded{oracle::wrap(*ulps, wide), oracle::fits(*ulps, wide), *ulps < 0};
}

bool keeps(Overflow rule, const cases::Format& format, const Rounded& rounded, Said said) {
  return rule == Overflow::any || said == overflowed(rule, format, rounded);
}

bool keeps(NoResult rule, const cases::Format& format, const Operands& operands, Rounding rounding,
           Said said) {
  const bool by_sign = rule == NoResult::saturate || rule == NoResult::symmetric;
  if (rule == NoResult::any || (by_sign && operands.sign(format) == 0 && said == 0U)) return true;
  return said == no_result_of(rule, format, operands, rounding);
}

bool is_within(const Within& within, const cases::Variant& variant, const Operands& operands,
               std::uint64_t said) {
  const oracle::Ratio exact = operands.valued() != nullptr
                                  ? *operands.valued()->value
                                  : *cases::exact_value(variant, operands.words()).value;
  const oracle::Ratio result = value_of(said, variant.format);
  // |result - exact|, in parts of the product of the denominators.
  const oracle::Integer off =
      abs(result.numerator * exact.denominator - exact.numerator * result.denominator);
  const oracle::Ratio scale = within.is_relative
                                  ? oracle::Ratio{abs(exact.numerator), exact.denominator}
                                  : unit_of(variant.format);
  return off * scale.denominator * within.bound.denominator <=
         scale.numerator * within.bound.numerator * result.denominator * exact.denominator;
}

Expected expected_of(const Rules& rules, const Operands& operands) {
  return expected_of(rules, operands, rounded_result(rules.variant, operands, rules.rounding));
}

bool keeps(const Rules& rules, const Operands& operands, Said said) {
  return keeps(rules, operands, rounded_result(rules.variant, operands, rules.rounding), said);
}

Expected expected_of(const Rules& rules, const Operands& operands,
                     const std::optional<Rounded>& rounded) {
  const cases::Format& format = rules.variant.format;
  if (rules.port != nullptr) return {true, result_of(*rules.port, format, operands)};
  if (!rounded) {
    if (rules.no_result == NoResult::word) return {true, rules.no_result_word};
    return {rules.no_result != NoResult::any,
            no_result_of(rules.no_result, format, operands, rules.rounding)};
  }
  if (rounded->fits) return {true, rounded->word};
  if (rules.overflow == Overflow::word) return {true, rules.overflow_word};
  return {rules.overflow != Overflow::any, overflowed(rules.overflow, format, *rounded)};
}

bool keeps(const Rules& rules, const Operands& operands, const std::optional<Rounded>& rounded,
           Said said) {
  const cases::Format& format = rules.variant.format;
  if (rules.port != nullptr) return said == result_of(*rules.port, format, operands);
  if (!rounded) {
    return rules.no_result == NoResult::word
               ? said == rules.no_result_word
               : keeps(rules.no_result, format, operands, rules.rounding, said);
  }
  if (rules.within && said && is_word(*said, format) &&
      is_within(*rules.within, rules.variant, operands, *said)) {
    return true;
  }
  if (rules.faithful) {
    Rules one_way = rules;
    one_way.faithful = false;
    return keeps(one_way, operands, rounded_result(rules.variant, operands, Rounding::floor),
                 said) ||
           keeps(one_way, operands, rounded_result(rules.variant, operands, Rounding::ceiling),
                 said);
  }
  if (rounded->fits) return !rules.within && said == rounded->word;
  return rules.overflow == Overflow::word ? said == rules.overflow_word
                                          : keeps(rules.overflow, format, *rounded, said);
}

}  // namespace fixproof::check
