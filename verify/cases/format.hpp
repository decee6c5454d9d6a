/// @file
/// Formats of fixed-point words.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace fixproof::cases {

/// The format of a word. A word with raw integer n has the value n / 2^fraction_bits, or
/// n / 10^fraction_bits if the scale is decimal. The type and the routines have formats that
/// are is_of_type(); only words that are judged have others.
struct Format {
  int word_bits = 32;       ///< 2 ... 64
  int fraction_bits = 16;   ///< -64 ... 128; digits after the point if the scale is decimal
  bool is_signed = true;    ///< two's complement; otherwise unsigned
  bool is_decimal = false;  ///< a unit is a power of ten

  /// Returns `value` units as a word of at most 32 bits, modulo 2^word_bits.
  [[nodiscard]] constexpr std::uint32_t word(std::int64_t value) const {
    return static_cast<std::uint32_t>(value) & (~std::uint32_t{0} >> (32 - word_bits));
  }
  /// 1.0 in units.
  [[nodiscard]] constexpr std::int64_t one() const { return std::int64_t{1} << fraction_bits; }
  /// The smallest positive magnitude that overflows a signed word.
  [[nodiscard]] constexpr std::int64_t limit() const { return std::int64_t{1} << (word_bits - 1); }

  /// Returns the same format as another library describes it, such as the oracle. Its members have
  /// this order.
  template <class Theirs>
  [[nodiscard]] constexpr Theirs as() const {
    return {word_bits, fraction_bits, is_signed};
  }

  friend constexpr bool operator==(const Format&, const Format&) = default;
};

inline constexpr Format q16_16{};
inline constexpr Format q8_8{.word_bits = 16, .fraction_bits = 8};

/// Returns the bits of a word that are set in its largest raw integer and in -1.
constexpr std::uint64_t all_ones(const Format& format) {
  return ~std::uint64_t{0} >> (64 - format.word_bits);
}

/// The bits of the integer that stores a word: the next of 8, 16, 32 and 64.
constexpr int storage_bits(const Format& format) {
  int bits = 8;
  while (bits < format.word_bits && bits < 64) bits *= 2;
  return bits;
}

/// Tells whether the format is one of the type's: words that fill 8, 16, 32 or 64 bits, in a unit
/// of 2^-F with 0 <= F <= word_bits.
constexpr bool is_of_type(const Format& format) {
  return storage_bits(format) == format.word_bits && !format.is_decimal &&
         format.fraction_bits >= 0 && format.fraction_bits <= format.word_bits;
}

constexpr std::uint64_t sign_bit(const Format& format) {
  return std::uint64_t{1} << (format.word_bits - 1);
}
/// The words of the largest and of the least number.
constexpr std::uint64_t highest(const Format& format) {
  return format.is_signed ? sign_bit(format) - 1 : all_ones(format);
}
constexpr std::uint64_t lowest(const Format& format) {
  return format.is_signed ? sign_bit(format) : 0;
}

/// Returns the integer that stores a word, with copies of its sign above it.
constexpr std::uint64_t stored(std::uint64_t word, const Format& format) {
  const bool is_negative = format.is_signed && (word & sign_bit(format)) != 0;
  const std::uint64_t above =
      (~std::uint64_t{0} >> (64 - storage_bits(format))) & ~all_ones(format);
  return is_negative ? word ^ above : word;
}
/// Returns the word that an integer stores; one that stores none keeps bits above the word. Copies
/// of the sign are dropped as they are added.
constexpr std::uint64_t word_in(std::uint64_t integer, const Format& format) {
  return stored(integer, format);
}

/// The bits of the largest word.
constexpr int magnitude_bits(const Format& format) {
  return format.word_bits - (format.is_signed ? 1 : 0);
}

/// Returns qW_F for a signed format, uW_F for an unsigned one: W bits before the point, the sign
/// included, and F after it. With a decimal scale dB_F or udB_F: B bits in all, in units of 10^-F.
std::string name_of(const Format& format);

/// Returns the format with this name, such as q16_16, u8_8 or q1_31. W + F is 8, 16, 32 or 64.
/// @throws UsageError for any other name
Format format_named(std::string_view name);

/// The same for words that are judged: W + F is 2 ... 64, and each of them may be negative, as in
/// q20_-2; d64_8 and ud32_2 have units of 10^-8 and 10^-2.
/// @throws UsageError for any other name
Format judged_format_named(std::string_view name);

/// Returns the formats that fixed/formats.hpp names, q8_8 and q16_16 among them, narrow words
/// first.
std::span<const Format> named_formats();

}  // namespace fixproof::cases
