#include "judge/check/operands.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>

#include "oracle/format.hpp"
#include "oracle/function.hpp"
#include "oracle/whole_function.hpp"
#include "support/hex.hpp"
#include "verify/cases/words.hpp"

namespace fixproof::check {

namespace {

using cases::Operation;

Converted converted_double(std::uint64_t bits) {
  const auto number = std::bit_cast<double>(bits);
  Converted operand{.text = {}, .value = oracle::double_value(number)};
  if (std::isinf(number)) operand.sign = number < 0 ? -1 : 1;
  return operand;
}

std::uint64_t word_in(std::string_view line, const cases::Format& format) {
  return support::parse_long_hex(line, static_cast<std::size_t>(format.word_bits / 4));
}

oracle::Ratio value_of(std::uint64_t word, const cases::Format& format) {
  const auto wide = format.as<oracle::Format>();
  return {oracle::ulps(word, wide), oracle::one(wide)};
}

/// The words of a function's operands.
std::array<std::uint64_t, 3> words_in(std::string_view line, const cases::Variant& variant) {
  std::array<std::uint32_t, 6> parts{};
  const auto used = std::span(parts).first(cases::words_in(variant));
  cases::parse_words(line, variant, used);
  std::array<std::uint64_t, 3> words{};
  join_words(used, variant.format, std::span(words).first(cases::words_in(variant.operation)));
  return words;
}

/// Sets the exact result of a function, or the sign without one.
void set_value(Converted& operand, const cases::Variant& variant) {
  const auto format = variant.format.as<oracle::Format>();
  const auto ulps = [&](std::size_t i) { return oracle::ulps(operand.words.at(i), format); };
  const oracle::Integer x = ulps(0);
  const oracle::Integer y = ulps(1);
  const oracle::Integer one = oracle::Integer(1) << format.fraction_bits;
  const auto set_whole = [&](const std::optional<oracle::Integer>& result, int sign) {
    if (result) {
      operand.value = {*result, one};
    } else {
      operand.sign = sign;
    }
  };
  switch (variant.operation) {
    case Operation::fmod:
      return set_whole(oracle::truncated_remainder(x, y), x.sign());
    case Operation::remainder:
      return set_whole(oracle::nearest_remainder(x, y), x.sign());
    case Operation::mul_div: {
      const oracle::Integer z = ulps(2);
      const oracle::Integer product = x * y;
      if (z == 0) {
        operand.sign = product.sign();
      } else {
        operand.value = {z < 0 ? -product : product, abs(z) * one};
      }
      return;
    }
    case Operation::hypot3: {
      const oracle::Ratio length = oracle::length_of(x, y, ulps(2));
      operand.value = {length.numerator, length.denominator * one};
      return;
    }
    default:
      operand.value =
          oracle::function_value(oracle::function_named(cases::name_of(variant.operation)).value(),
                                 x, y, format.fraction_bits);
  }
}

}  // namespace

Converted parse_converted(std::string_view line, const cases::Variant& variant) {
  Converted operand;
  switch (variant.operation) {
    case Operation::from_binary64:
      operand = converted_double(support::parse_long_hex(line, 16));
      break;
    case Operation::from_decimal:
      operand.value = parse_decimal(line);
      break;
    default: {
      if (!cases::is_conversion(variant.operation)) {
        operand.words = words_in(line, variant);
        set_value(operand, variant);
        break;
      }
      const cases::Format& format = cases::operand_format(variant);
      operand.value = value_of(word_in(line, format), format);
    }
  }
  operand.text = line;
  return operand;
}

std::string text_of(const Converted& operand, const cases::Variant& variant) {
  switch (variant.operation) {
    case Operation::from_decimal:
      return operand.text;
    case Operation::from_binary64:
      return fmt::format("{} ({})", operand.text,
                         std::bit_cast<double>(support::parse_long_hex(operand.text, 16)));
    default: {
      const cases::Format& format = cases::operand_format(variant);
      if (!cases::is_conversion(variant.operation)) {
        std::string values;
        for (std::size_t i = 0; i < cases::words_in(variant.operation); ++i) {
          values += (i == 0 ? "" : " ") + decimal_text(operand.words.at(i), format);
        }
        return fmt::format("{} ({})", operand.text, values);
      }
      return fmt::format("{} ({})", operand.text,
                         decimal_text(word_in(operand.text, format), format));
    }
  }
}

}  // namespace fixproof::check
