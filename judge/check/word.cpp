#include "judge/check/word.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <system_error>

#include "oracle/format.hpp"
#include "support/hex.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::check {

namespace {

constexpr std::size_t digits_of(const cases::Format& format) {
  return static_cast<std::size_t>(cases::storage_bits(format) / 4);
}

/// The fewest places that distinguish all words: the smallest p with 10^p >= 2^fraction_bits.
int places_of(const oracle::Integer& one) {
  int places = 0;
  for (oracle::Integer power = 1; power < one; power *= 10) ++places;
  return places;
}

/// The time to read a number grows with the square of its length.
constexpr std::size_t longest_decimal = 1000;
constexpr int largest_exponent = 1000;

/// Returns the number after the e of `text`, 0 if it is empty.
std::optional<int> exponent_of(std::string_view text) {
  if (text.empty()) return 0;
  text.remove_prefix(1);
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  int exponent = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, exponent);
  const bool valid = error == std::errc() && stop == end && std::abs(exponent) <= largest_exponent;
  return valid ? std::optional(exponent) : std::nullopt;
}

}  // namespace

void join_words(std::span<const std::uint32_t> parts, const cases::Format& format,
                std::span<std::uint64_t> words) {
  const std::size_t count = cases::words_per_number(format);
  for (std::size_t i = 0; i < words.size(); ++i) {
    words[i] = parts[count * i];
    if (count == 2) words[i] |= std::uint64_t{parts[2 * i + 1]} << 32U;
  }
}

std::string hex_text(std::uint64_t word, const cases::Format& format) {
  return fmt::format("{:0{}x}", cases::stored(word, format), digits_of(format));
}

std::string decimal_text(std::uint64_t word, const cases::Format& format) {
  const auto [numerator, denominator] = value_of(word, format);
  // A short fraction is exact.
  constexpr int most_exact = 8;
  const int places = format.fraction_bits <= 0 ? 0
                     : format.is_decimal || format.fraction_bits <= most_exact
                         ? format.fraction_bits
                         : places_of(denominator);
  const oracle::Integer scale = pow(oracle::Integer(10), static_cast<unsigned>(places));
  const oracle::Integer value =
      oracle::rounded(abs(numerator) * scale, denominator, oracle::Rounding::half_even);
  const oracle::Integer whole = value / scale;
  std::string fraction = (scale + value % scale).str().substr(1);
  fraction.erase(fraction.find_last_not_of('0') + 1);
  return fmt::format("{}{}{}{}", numerator < 0 ? "-" : "", whole.str(), fraction.empty() ? "" : ".",
                     fraction);
}

std::string result_format(const cases::Format& format, bool decimal) {
  if (decimal) return "a result is a decimal number, such as -1.5 or 2e-3";
  return fmt::format("a result is {} lower-case hex digits, or DE for a divide error",
                     digits_of(format));
}

Said parse_result(std::string_view line, const cases::Format& format) {
  if (line == "DE") return std::nullopt;
  try {
    return cases::word_in(support::parse_long_hex(line, digits_of(format)), format);
  } catch (const support::UsageError& error) {
    throw support::UsageError(fmt::format("{}; {}", error.what(), result_format(format)));
  }
}

oracle::Ratio parse_decimal(std::string_view text) {
  const std::size_t at = text.find_first_of("eE");
  const auto exponent = exponent_of(text.substr(std::min(at, text.size())));
  const auto value =
      text.size() <= longest_decimal ? oracle::decimal_value(text.substr(0, at)) : std::nullopt;
  if (!value || !exponent) {
    throw support::UsageError(fmt::format(
        "{} is not a decimal number, such as -1.5 or 2e-3, of at most {} characters and with "
        "an exponent of at most {}",
        support::quoted(text), longest_decimal, largest_exponent));
  }
  const oracle::Integer power =
      pow(oracle::Integer(10), static_cast<unsigned>(std::abs(*exponent)));
  return *exponent < 0 ? oracle::Ratio{value->numerator, value->denominator * power}
                       : oracle::Ratio{value->numerator * power, value->denominator};
}

Said parse_decimal_result(std::string_view line, const cases::Format& format) {
  const oracle::Integer ulps = to_ulps(parse_decimal(line), oracle::Rounding::half_even, format);
  const auto wide = format.as<oracle::Format>();
  return oracle::fits(ulps, wide) ? Said(oracle::wrap(ulps, wide)) : std::nullopt;
}

}  // namespace fixproof::check
