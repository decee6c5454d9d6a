#include "judge/check/operands.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "support/hex.hpp"
#include "verify/cases/exact_value.hpp"
#include "verify/cases/words.hpp"

namespace fixproof::check {

namespace {

using cases::Operation;

ValuedCase converted_double(std::uint64_t bits) {
  const auto number = std::bit_cast<double>(bits);
  ValuedCase operand{.text = {}, .value = oracle::double_value(number)};
  if (std::isinf(number)) operand.sign = number < 0 ? -1 : 1;
  return operand;
}

/// The words of the operands.
std::vector<std::uint64_t> words_in(std::string_view line, const cases::Variant& variant) {
  std::vector<std::uint32_t> parts(cases::words_in(variant));
  cases::parse_words(line, variant, parts);
  std::vector<std::uint64_t> words(cases::operands_of(variant));
  join_words(parts, cases::operand_format(variant), words);
  return words;
}

}  // namespace

ValuedCase parse_valued(std::string_view line, const cases::Variant& variant) {
  ValuedCase operand;
  switch (variant.operation) {
    case Operation::from_binary64:
      operand = converted_double(support::parse_long_hex(line, 16));
      break;
    case Operation::from_decimal:
      operand.value = parse_decimal(line);
      break;
    default: {
      operand.words = words_in(line, variant);
      const cases::ExactValue exact = cases::exact_value(variant, operand.words);
      operand.value = exact.value;
      operand.mirrored = exact.mirrored;
      operand.sign = exact.sign;
    }
  }
  operand.text = line;
  return operand;
}

std::string text_of(const ValuedCase& operand, const cases::Variant& variant) {
  switch (variant.operation) {
    case Operation::from_decimal:
      return operand.text;
    case Operation::from_binary64:
      return fmt::format("{} ({})", operand.text,
                         std::bit_cast<double>(support::parse_long_hex(operand.text, 16)));
    default: {
      const cases::Format format = cases::operand_format(variant);
      std::string values;
      for (const std::uint64_t word : operand.words) {
        values += (values.empty() ? "" : " ") + decimal_text(word, format);
      }
      return fmt::format("{} ({})", operand.text, values);
    }
  }
}

}  // namespace fixproof::check
