#include "check/operands.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>

#include "cases/words.hpp"
#include "oracle/format.hpp"
#include "oracle/function.hpp"
#include "support/hex.hpp"

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
  return {oracle::ulps(word, oracle_format(format)), oracle::Integer(1) << format.fraction_bits};
}

/// The words of a function's operands.
std::array<std::uint64_t, 2> words_in(std::string_view line, const cases::Variant& variant) {
  std::array<std::uint32_t, 2> words{};
  cases::parse_words(line, variant, std::span(words).first(cases::words_in(variant)));
  return {words[0], words[1]};
}

std::optional<oracle::Ratio> function_of(const std::array<std::uint64_t, 2>& words,
                                         const cases::Variant& variant) {
  const auto& [x, y] = words;
  const oracle::Format format = oracle_format(variant.format);
  return oracle::function_value(oracle::function_named(cases::name_of(variant.operation)).value(),
                                oracle::ulps(x, format), oracle::ulps(y, format),
                                format.fraction_bits);
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
      if (cases::is_function(variant.operation)) {
        operand.words = words_in(line, variant);
        operand.value = function_of(operand.words, variant);
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
      if (cases::is_function(variant.operation)) {
        const auto& [x, y] = operand.words;
        return fmt::format(
            "{} ({}{})", operand.text, decimal_text(x, format),
            cases::words_in(variant.operation) == 1 ? "" : " " + decimal_text(y, format));
      }
      return fmt::format("{} ({})", operand.text,
                         decimal_text(word_in(operand.text, format), format));
    }
  }
}

}  // namespace fixproof::check
