#include "app/web/operand.hpp"

#include <utility>

#include "app/input/number.hpp"
#include "app/web/words.hpp"

namespace fixproof::web {

std::string range_of(const NumberFormat& format) {
  const auto f = format.format.as<oracle::Format>();
  return format.write(oracle::wrap(oracle::lowest(f), f)) + " to " +
         format.write(oracle::wrap(oracle::highest(f), f));
}

Operand operand_of(std::string_view text, const NumberFormat& format) {
  input::Number number = input::number_of(text, format.format, input::Bare::decimal);
  if (!number.error.empty()) {
    std::string error = std::move(number.error) + ".";
    error.front() = static_cast<char>(error.front() - 'a' + 'A');
    return {.error = std::move(error)};
  }
  if (number.is_word) {
    // All digits: a fraction of n bits has n.
    number.decimal = decimal_text(number.exact.numerator, number.exact.denominator, 64);
  }
  return {.exact = std::move(number.exact), .decimal = std::move(number.decimal)};
}

WordOperand word_operand_of(std::string_view text, const NumberFormat& format) {
  const Operand operand = operand_of(text, format);
  if (!operand.error.empty()) return {.error = operand.error};
  const auto word = format.read(operand.decimal).word;
  if (!word) {
    return {.error = "Out of the range of " + format_name(format.format) + ", " + range_of(format) +
                     "."};
  }
  return {.word = *word};
}

}  // namespace fixproof::web
