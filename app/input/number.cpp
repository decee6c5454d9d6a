#include "app/input/number.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "verify/cases/value.hpp"

namespace fixproof::input {

namespace {

constexpr std::string_view minus_sign = "\u2212";

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hex(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }

/// Removes each `_` between two digits.
std::string without_underscores(std::string_view text) {
  std::string kept;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool between =
        i > 0 && i + 1 < text.size() && is_digit(text[i - 1]) && is_digit(text[i + 1]);
    if (text[i] != '_' || !between) kept += text[i];
  }
  return kept;
}

std::optional<std::uint64_t> units_of(std::string_view text, int base) {
  std::uint64_t units = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, units, base);
  if (error != std::errc() || stop != end) return std::nullopt;
  return units;
}

/// Reads the integer that stores a word, or the word's own bits if that is `allowed`.
Number word_of(std::uint64_t bits, const cases::Format& format, bool allowed) {
  std::uint64_t word = cases::word_in(bits, format);
  if (allowed && (word & ~cases::all_ones(format)) != 0) word = bits;
  if ((word & ~cases::all_ones(format)) != 0) {
    return {.error = "not a word of " + std::to_string(format.word_bits) + " bits"};
  }
  return {.exact = cases::value_of(word, format), .is_word = true};
}

std::size_t digits_of(const cases::Format& format) {
  return static_cast<std::size_t>(cases::storage_bits(format) / 4);
}

/// Reads what follows the sign and the prefix `0x` or `0b`.
Number units_after_prefix(std::string_view text, char prefix, std::string_view sign,
                          const cases::Format& format) {
  std::string digits;
  for (const char c : text) {
    if (c != ' ' && c != '_') digits += c;
  }
  const auto units = units_of(digits, prefix == 'x' || prefix == 'X' ? 16 : 2);
  const int bits = cases::storage_bits(format);
  if (!units || *units > ~std::uint64_t{0} >> (64 - bits)) {
    return {.error = "not a word of " + std::to_string(bits) + " bits; after 0x write up to " +
                     std::to_string(bits / 4) + " hexadecimal digits, after 0b up to " +
                     std::to_string(bits) + " bits"};
  }
  if (sign.empty()) return word_of(*units, format, true);
  oracle::Integer value = *units;
  if (sign == "-") value = -value;
  return {.exact = cases::value_of(value, format), .is_word = true};
}

Number decimal_of(const std::string& text) {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const auto digits = oracle::decimal_value(std::string_view(text).substr(0, e));
  int exponent = 0;
  if (e < text.size()) {
    std::string_view power = std::string_view(text).substr(e + 1);
    if (power.starts_with('+') && power.size() > 1 && is_digit(power[1])) power.remove_prefix(1);
    const char* const end = power.data() + power.size();
    const auto [stop, error] = std::from_chars(power.data(), end, exponent);
    const bool is_number = stop == end && error != std::errc::invalid_argument;
    if (digits && is_number &&
        (error != std::errc() || exponent > largest_exponent || exponent < -largest_exponent)) {
      return {.error = "the exponent is not from -" + std::to_string(largest_exponent) + " to " +
                       std::to_string(largest_exponent)};
    }
    if (!is_number) exponent = largest_exponent + 1;
  }
  if (!digits || exponent > largest_exponent) {
    return {.error = "not a number; write it as 1.5, -2e3, 0x18000 or 0b11"};
  }
  Number number{.exact = *digits, .decimal = text, .is_word = false};
  for (; exponent > 0; --exponent) number.exact.numerator *= 10;
  for (; exponent < 0; ++exponent) number.exact.denominator *= 10;
  return number;
}

/// Reads digits without a prefix as the command does. Returns nothing for a decimal number.
std::optional<Number> bare_word_of(std::string_view text, const cases::Format& format) {
  const std::size_t digits = digits_of(format);
  const bool all_hex = std::all_of(text.begin(), text.end(), is_hex);
  if (all_hex && text.size() == digits) return word_of(*units_of(text, 16), format, false);
  const bool all_decimal =
      std::all_of(text.begin(), text.end(), [](char c) { return is_digit(c) || c == '_'; });
  const bool leading_zero = all_decimal && text.size() > 1 && text[0] == '0';
  const bool letters = all_hex && text.find_first_of("abcdfABCDF") != std::string_view::npos;
  if (!leading_zero && !letters) return std::nullopt;
  return Number{.error = "a word has " + std::to_string(digits) +
                         " hexadecimal digits, or fewer after 0x" +
                         (leading_zero ? ", and a decimal number has no 0 in front" : "")};
}

}  // namespace

Number number_of(std::string_view text, const cases::Format& format, Bare bare) {
  constexpr std::string_view space = " \t";
  text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
  text.remove_suffix(text.size() - (text.find_last_not_of(space) + 1));
  if (text.empty()) return {.error = "no number; write it as 1.5, -2e3, 0x18000 or 0b11"};
  if (text.size() > longest) {
    return {.error = "the number is longer than " + std::to_string(longest) + " characters"};
  }
  std::string_view sign;
  std::string_view rest = text;
  if (text[0] == '-' || text[0] == '+') {
    sign = text.substr(0, 1);
    rest.remove_prefix(1);
  } else if (text.starts_with(minus_sign)) {
    sign = "-";
    rest.remove_prefix(minus_sign.size());
  }
  if (rest.size() > 1 && rest[0] == '0' && std::string_view("xXbB").find(rest[1]) < 4) {
    const bool word = bare == Bare::word && sign.empty() && rest.size() == digits_of(format) &&
                      std::all_of(rest.begin(), rest.end(), is_hex);
    // Where a word needs no prefix, 0b and as many digits as it has are a word.
    if (!word) return units_after_prefix(rest.substr(2), rest[1], sign, format);
  }
  if (bare == Bare::word && sign.empty()) {
    if (auto word = bare_word_of(rest, format)) return std::move(*word);
  }
  if (rest.starts_with('-') || rest.starts_with('+')) rest = "x";  // a second sign
  return decimal_of(std::string(sign == "-" ? "-" : "") + without_underscores(rest));
}

std::vector<std::string_view> parts_of(std::string_view line) {
  constexpr std::string_view separators = " ,;\t";
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t start = line.find_first_not_of(separators);
    if (start == std::string_view::npos) return parts;
    line.remove_prefix(start);
    parts.push_back(line.substr(0, line.find_first_of(separators)));
    line.remove_prefix(parts.back().size());
  }
}

}  // namespace fixproof::input
