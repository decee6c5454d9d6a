#include "app/web/operand.hpp"

#include <charconv>
#include <optional>

namespace fixproof::web {

namespace {

/// Returns the word after the prefix, or nothing if a digit is wrong or the word is too wide.
std::optional<std::uint64_t> word_after_prefix(std::string_view text, int bits) {
  const int base = text[1] == 'x' || text[1] == 'X' ? 16 : 2;
  std::string digits;
  for (const char c : text.substr(2)) {
    if (c != ' ' && c != '_') digits += c;
  }
  std::uint64_t word = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, word, base);
  if (error != std::errc() || stop != end || word > cases::all_ones({bits, 0, false}))
    return std::nullopt;
  return word;
}

}  // namespace

std::string range_of(const NumberFormat& format) {
  const auto f = format.format.as<oracle::Format>();
  return format.write(oracle::wrap(oracle::lowest(f), f)) + " to " +
         format.write(oracle::wrap(oracle::highest(f), f));
}

Operand operand_of(std::string_view text, const NumberFormat& format) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  if (text.empty()) return {.error = "Type a number: 1.5, 0x18000 or 0b11."};
  if (text.size() > longest_operand) {
    return {.error = "The number is longer than " + std::to_string(longest_operand) +
                     " characters. Shorten it."};
  }
  const int bits = format.format.word_bits;
  if (text.size() > 1 && text[0] == '0' &&
      std::string_view("xXbB").find(text[1]) != std::string_view::npos) {
    const auto word = word_after_prefix(text, bits);
    if (!word) {
      return {.error = "Not a word of " + format_name(format.format) + ". After 0x write up to " +
                       std::to_string((bits + 3) / 4) + " hexadecimal digits, after 0b up to " +
                       std::to_string(bits) + " bits."};
    }
    return {.exact = {oracle::ulps(*word, format.format.as<oracle::Format>()),
                      oracle::Integer(1) << format.format.fraction_bits},
            .decimal = format.write(*word)};
  }
  const auto exact = oracle::decimal_value(text);
  if (!exact) {
    return {.error =
                "Not a number. Write digits with at most one point, 0x and hexadecimal digits, or "
                "0b and bits."};
  }
  return {.exact = *exact, .decimal = std::string(text)};
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
