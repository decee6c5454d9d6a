#include "judge/check/rules.hpp"

#include <array>

#include "judge/check/exact_ulps.hpp"
#include "judge/check/ports.hpp"
#include "oracle/fast.hpp"
#include "oracle/format.hpp"

namespace fixproof::check {

namespace {

using oracle::Rounding;

constexpr std::array<Rounding, 5> all_roundings{Rounding::half_up, Rounding::half_away,
                                                Rounding::half_even, Rounding::floor,
                                                Rounding::truncate};
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

/// Minus a root that was rounded down or to nearest. It is negative, so floor rounds it away from
/// zero unless it is exact.
template <class Number>
Number mirrored(const Number& root, const Number& square, Rounding rounding) {
  const bool away = rounding == Rounding::floor && root * root != square;
  return away ? -root - 1 : -root;
}

Said mirrored_root(std::uint64_t radicand, const cases::Format& format, Rounding rounding) {
  const std::uint64_t size = magnitude(radicand, format);
  if (format == cases::q16_16 && radicand != lowest(format)) {
    const auto root = oracle::fast::exact_root(size, rounding, 16);
    return static_cast<std::uint32_t>(mirrored(*root, size << 16U, rounding));
  }
  // The magnitude of the lowest word fits only an unsigned word.
  oracle::Format wide = format.as<oracle::Format>();
  wide.is_signed = false;
  const auto root = oracle::exact_root(size, rounding, wide);
  const oracle::Integer square = oracle::Integer(size) << format.fraction_bits;
  return oracle::wrap(mirrored(*root, square, rounding), wide);
}

Said no_result_of(NoResult rule, const cases::Format& format, const Operands& operands,
                  Rounding rounding) {
  return rule == NoResult::mirror ? mirrored_root(operands.words()[0], format, rounding)
                                  : limit_of(rule, format, operands.sign(format) < 0);
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
std::span<const NoResult> no_result_rules(cases::Operation operation, const cases::Format& format) {
  if (!can_lack_result(operation, format)) return {};
  if (!format.is_signed) return unsigned_divisor_rules;
  return no_result_rules(operation);
}

std::optional<Rounded> rounded_result(cases::Operation operation, const cases::Format& format,
                                      const Operands& operands, Rounding rule) {
  if (format == cases::q16_16 && operands.converted() == nullptr) {
    const auto ulps = narrow_ulps(operation, operands.words(), rule);
    if (!ulps) return std::nullopt;
    return narrow_word(*ulps);
  }
  const auto ulps = exact_ulps(operation, format, operands, rule);
  if (!ulps) return std::nullopt;
  const auto wide = format.as<oracle::Format>();
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

Expected expected_of(const Rules& rules, const Operands& operands) {
  return expected_of(rules, operands,
                     rounded_result(rules.operation, rules.format, operands, rules.rounding));
}

bool keeps(const Rules& rules, const Operands& operands, Said said) {
  return keeps(rules, operands,
               rounded_result(rules.operation, rules.format, operands, rules.rounding), said);
}

Expected expected_of(const Rules& rules, const Operands& operands,
                     const std::optional<Rounded>& rounded) {
  if (rules.port != nullptr) return {true, result_of(*rules.port, rules.format, operands)};
  if (!rounded) {
    return {rules.no_result != NoResult::any,
            no_result_of(rules.no_result, rules.format, operands, rules.rounding)};
  }
  if (rounded->fits) return {true, rounded->word};
  return {rules.overflow != Overflow::any, overflowed(rules.overflow, rules.format, *rounded)};
}

bool keeps(const Rules& rules, const Operands& operands, const std::optional<Rounded>& rounded,
           Said said) {
  if (rules.port != nullptr) return said == result_of(*rules.port, rules.format, operands);
  if (!rounded) return keeps(rules.no_result, rules.format, operands, rules.rounding, said);
  if (rounded->fits) return said == rounded->word;
  return keeps(rules.overflow, rules.format, *rounded, said);
}

}  // namespace fixproof::check
