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

/// The exact value of a word of 64 bits.
std::string decimal_of_64(const Format& format, std::uint64_t word) {
  const bool negative = format.is_signed && word >> 63U != 0;
  return fmt::format("{}{}", negative ? "-" : "",
                     exact_decimal(negative ? 0 - word : word, format.fraction_bits));
}

std::string decimal(const Variant& v, std::uint32_t word) {
  if (v.operation == Operation::cossin) {
    return fmt::format("{:.1f} degrees", signed_word(word, operand_bits(v)) / 10.0);
  }
  // A decimal place has 3.3 bits.
  const int places = std::max(5, v.format.fraction_bits * 3 / 10 + 1);
  // The conversion is exact: a word of 32 bits has fewer bits than a double.
  const double units =
      v.format.is_signed ? signed_word(word, operand_bits(v)) : static_cast<double>(word);
  std::string text = fmt::format("{:.{}f}", std::ldexp(units, -v.format.fraction_bits), places);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::uint64_t joined(std::span<const std::uint32_t> halves) {
  return std::uint64_t{halves[1]} << 32U | halves[0];
}

}  // namespace

std::string exact_decimal(std::uint64_t magnitude, int fraction_bits, bool and_half) {
  const int f = fraction_bits;
  std::string text = fmt::format("{}.", f == 64 ? 0 : magnitude >> f);
  // The fraction fills three words, the highest last. The digit is what exceeds ten times it.
  std::uint64_t top = f == 0 ? 0 : magnitude << (64 - f);
  std::uint32_t below = 0;
  if (and_half && f == 64) below = 0x80000000U;
  if (and_half && f < 64) top |= std::uint64_t{1} << (63 - f);
  std::array<std::uint32_t, 3> rest{below, static_cast<std::uint32_t>(top),
                                    static_cast<std::uint32_t>(top >> 32U)};
  while (rest != std::array<std::uint32_t, 3>{}) {
    std::uint64_t carry = 0;
    for (std::uint32_t& word : rest) {
      const std::uint64_t product = std::uint64_t{word} * 10 + carry;
      word = static_cast<std::uint32_t>(product);
      carry = product >> 32U;
    }
    text += static_cast<char>('0' + carry);
  }
  if (text.back() == '.') text.pop_back();
  return text;
}

void parse_words(std::string_view line, const Variant& v, std::span<std::uint32_t> words) {
  const auto digits = static_cast<std::size_t>(operand_bits(v) / 4);
  const std::size_t each = digits > 8 ? 2 : 1;
  const std::size_t numbers = words.size() / each;
  for (std::size_t i = 0; i < numbers; ++i) {
    const auto space = line.find(' ');
    const bool last = i + 1 == numbers;
    if (last != (space == std::string_view::npos)) {
      throw support::UsageError(fmt::format("{} takes {} word{}, separated by single spaces",
                                            name_of(v.operation), numbers, numbers > 1 ? "s" : ""));
    }
    const std::uint64_t number = support::parse_long_hex(line.substr(0, space), digits);
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
  append_words(to, words, operand_bits(v));
}

std::string hex_words(std::span<const std::uint32_t> words, int bits) {
  std::string text;
  append_words(text, words, bits);
  return text;
}

std::string decimal_words(const Variant& v, std::span<const std::uint32_t> words) {
  const std::size_t each = words_per_number(v.format);
  std::string text;
  for (std::size_t i = 0; i < words.size(); i += each) {
    if (i > 0) text += ' ';
    text += each == 2 ? decimal_of_64(v.format, joined(words.subspan(i, 2))) : decimal(v, words[i]);
  }
  return text;
}

}  // namespace fixproof::cases
