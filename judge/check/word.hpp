/// @file
/// Words of any format, in at most 64 bits, and the words that rules and traits name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "oracle/decimal.hpp"
#include "oracle/format.hpp"
#include "verify/cases/format.hpp"
#include "verify/cases/value.hpp"

namespace fixproof::check {

/// A subject's result: a word, or empty for a divide error. What the integer stores that holds a
/// word may be none; such a result has bits above the word.
using Said = std::optional<std::uint64_t>;

/// Returns minus highest(); lowest() if the format is unsigned.
constexpr std::uint64_t minus_highest(const cases::Format& format) {
  return format.is_signed ? sign_bit(format) + 1 : 0;
}

/// Tells whether a result is a word of the format.
constexpr bool is_word(std::uint64_t said, const cases::Format& format) {
  return (said & ~cases::all_ones(format)) == 0;
}

/// Returns the word of 1.0; empty if the format does not have it.
constexpr std::optional<std::uint64_t> whole_one(const cases::Format& format) {
  if (format.is_decimal) {
    std::uint64_t power = 1;
    for (int i = 0; i < format.fraction_bits; ++i) {
      if (power > highest(format) / 10) return std::nullopt;
      power *= 10;
    }
    return power;
  }
  const int exponent = format.fraction_bits;
  if (exponent < 0 || exponent >= cases::magnitude_bits(format)) return std::nullopt;
  return std::uint64_t{1} << exponent;
}
/// Returns the bits of a word that have a place after the point. In a decimal scale none has.
constexpr std::uint64_t fraction_of(const cases::Format& format) {
  if (format.is_decimal || format.fraction_bits <= 0) return 0;
  return format.fraction_bits >= format.word_bits
             ? cases::all_ones(format)
             : ~std::uint64_t{0} >> (64 - format.fraction_bits);
}

/// Returns minus a word, modulo 2^word_bits.
constexpr std::uint64_t minus(std::uint64_t word, const cases::Format& format) {
  return (0 - word) & cases::all_ones(format);
}
constexpr bool is_negative(std::uint64_t word, const cases::Format& format) {
  return format.is_signed && (word & sign_bit(format)) != 0;
}
constexpr std::uint64_t magnitude(std::uint64_t word, const cases::Format& format) {
  return is_negative(word, format) ? minus(word, format) : word;
}

/// Joins the 32-bit parts of words, low half first, as cases have them. A word of at most 32 bits
/// is one part.
void join_words(std::span<const std::uint32_t> parts, const cases::Format& format,
                std::span<std::uint64_t> words);

/// Returns the integer that stores a word in hex digits: 8 for 32 bits and for 18.
std::string hex_text(std::uint64_t word, const cases::Format& format);
/// Returns the value of a word in decimal, with enough places to distinguish all words; exact if
/// that takes at most 8 places, and in a decimal scale.
std::string decimal_text(std::uint64_t word, const cases::Format& format);

/// Returns what a result of the format looks like, for errors.
std::string result_format(const cases::Format& format, bool decimal = false);

/// Parses lower-case hex digits, as many as the integer that stores a word has, or DE for a divide
/// error.
/// @throws UsageError describing the defect
Said parse_result(std::string_view line, const cases::Format& format);

/// Parses a decimal number. Returns the nearest word; empty if that is out of range.
/// @throws UsageError for any other text
Said parse_decimal_result(std::string_view line, const cases::Format& format);

/// Parses a number of oracle::decimal_value(), which may have an exponent of -1000 ... 1000 after
/// an e, of at most 1,000 characters.
/// @throws UsageError for any other text
oracle::Ratio parse_decimal(std::string_view text);

}  // namespace fixproof::check
