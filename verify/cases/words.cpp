#include "verify/cases/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "support/hex.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/conversion_makers.hpp"

namespace fixproof::cases {

namespace {

std::int32_t signed_word(std::uint32_t word, int bits) {
  const int unused = 32 - bits;
  return static_cast<std::int32_t>(word << unused) >> unused;
}

/// The exact value of a word of more than 32 bits.
std::string decimal_of_long(const Format& format, std::uint64_t word) {
  const bool negative = format.is_signed && word >> (format.word_bits - 1) != 0;
  const std::uint64_t magnitude = negative ? (0 - word) & all_ones(format) : word;
  return fmt::format("{}{}", negative ? "-" : "", decimal_of(magnitude, format));
}

/// Multiplies a number in decimal digits.
void multiply(std::string& digits, int factor) {
  int carry = 0;
  for (std::size_t i = digits.size(); i-- > 0;) {
    const int product = (digits[i] - '0') * factor + carry;
    digits[i] = static_cast<char>('0' + product % 10);
    carry = product / 10;
  }
  if (carry != 0) digits.insert(0, 1, static_cast<char>('0' + carry));
}

std::string decimal(const Variant& v, std::uint32_t word) {
  if (v.operation == Operation::cossin) {
    return fmt::format("{:.1f} degrees", signed_word(word, operand_bits(v)) / 10.0);
  }
  const Format format = operand_format(v);
  // A decimal place has 3.3 bits.
  const int places = std::max(5, format.fraction_bits * 3 / 10 + 1);
  // The conversion is exact: a word of 32 bits has fewer bits than a double.
  const double units =
      format.is_signed ? signed_word(word, operand_bits(v)) : static_cast<double>(word);
  std::string text = fmt::format("{:.{}f}", std::ldexp(units, -format.fraction_bits), places);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::uint64_t joined(std::span<const std::uint32_t> halves) {
  return std::uint64_t{halves[1]} << 32U | halves[0];
}

}  // namespace

std::string decimal_of(std::uint64_t magnitude, const Format& format, bool and_half) {
  std::string digits = std::to_string(magnitude);
  int places = format.fraction_bits;
  if (and_half) {
    multiply(digits, format.is_decimal ? 10 : 2);
    // The last digit of what has been multiplied is even.
    digits.back() = static_cast<char>(digits.back() + (format.is_decimal ? 5 : 1));
    ++places;
  }
  if (!format.is_decimal) {
    for (int i = 0; i < places; ++i) multiply(digits, 5);  // n / 2^F = n 5^F / 10^F
    for (int i = places; i < 0; ++i) multiply(digits, 2);
  }
  if (places <= 0) return digits;
  const auto after = static_cast<std::size_t>(places);
  if (digits.size() <= after) digits.insert(0, after + 1 - digits.size(), '0');
  digits.insert(digits.size() - after, 1, '.');
  if (format.is_decimal && !and_half) return digits;
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

void parse_words(std::string_view line, const Variant& v, std::span<std::uint32_t> words) {
  Format format = operand_format(v);
  format.word_bits = operand_bits(v);
  const auto digits_of_word = static_cast<std::size_t>(storage_bits(format) / 4);
  const std::size_t each = words_per_number(format);
  const std::size_t numbers = words.size() / each;
  for (std::size_t i = 0; i < numbers; ++i) {
    const auto space = line.find(' ');
    const bool last = i + 1 == numbers;
    if (last != (space == std::string_view::npos)) {
      throw support::UsageError(fmt::format("{} takes {} word{}, separated by single spaces",
                                            name_of(v.operation), numbers, numbers > 1 ? "s" : ""));
    }
    const std::string_view digits = line.substr(0, space);
    const std::uint64_t number = word_in(support::parse_long_hex(digits, digits_of_word), format);
    if ((number & ~all_ones(format)) != 0) {
      throw support::UsageError(fmt::format(
          "'{}' is not a word of {}: the bits above its {} are not "
          "{}",
          digits, name_of(format), format.word_bits, format.is_signed ? "its sign" : "0"));
    }
    words[i * each] = static_cast<std::uint32_t>(number);
    if (each == 2) words[2 * i + 1] = static_cast<std::uint32_t>(number >> 32U);
    if (!last) line.remove_prefix(space + 1);
  }
}

void append_words(std::string& to, std::span<const std::uint32_t> words, int bits) {
  const std::size_t each = bits > 32 ? 2 : 1;
  const auto digits = static_cast<std::size_t>(bits) / (4 * each);
  for (std::size_t i = 0; i < words.size(); i += each) {
    if (i > 0) to += ' ';
    if (each == 2) support::append_hex(to, words[i + 1], digits);
    support::append_hex(to, words[i], digits);
  }
}

void append_operands(std::string& to, const Variant& v, std::span<const std::uint32_t> words) {
  if (v.operation == Operation::from_decimal) return append_decimal_operand(to, words, v.format);
  Format format = operand_format(v);
  format.word_bits = operand_bits(v);
  const int bits = storage_bits(format);
  if (bits == format.word_bits) return append_words(to, words, bits);
  const int digits = bits / 4;
  const std::size_t each = words_per_number(format);
  for (std::size_t i = 0; i < words.size(); i += each) {
    const std::uint64_t word = each == 2 ? joined(words.subspan(i, 2)) : words[i];
    if (i > 0) to += ' ';
    to += fmt::format("{:0{}x}", stored(word, format), digits);
  }
}

std::string hex_words(std::span<const std::uint32_t> words, int bits) {
  std::string text;
  append_words(text, words, bits);
  return text;
}

std::string decimal_words(const Variant& v, std::span<const std::uint32_t> words) {
  const Format format = operand_format(v);
  const std::size_t each = words_per_number(format);
  std::string text;
  for (std::size_t i = 0; i < words.size(); i += each) {
    if (i > 0) text += ' ';
    text += each == 2 ? decimal_of_long(format, joined(words.subspan(i, 2))) : decimal(v, words[i]);
  }
  return text;
}

}  // namespace fixproof::cases
