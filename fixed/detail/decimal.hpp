/// \file
/// Conversion between stored integers and decimal text, exact in both directions.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include "fixed/detail/overflow.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/detail/wide_integer.hpp"

namespace fixproof::detail {

/// floor(bits * log10(2)), for 0 <= bits <= 64.
constexpr int decimal_digits(int bits) noexcept { return bits * 30103 / 100000; }

/// The longest decimal text: sign, whole part, point, and one fraction digit per fraction bit.
template <class Raw, int FractionBits>
inline constexpr std::size_t max_decimal_chars =
    1 + decimal_digits(larger(bits_of<Raw> - FractionBits, 0)) + 1 + 1 + FractionBits;

/// Writes the exact value in its shortest form: "-0.5", "3", "0.0000152587890625".
/// \param out a buffer of max_decimal_chars
/// \return the end of the text
template <int FractionBits, class Raw>
constexpr char* write_decimal(char* out, Raw raw) noexcept {
  using word =
      std::conditional_t<(bits_of<Raw> <= 32 && FractionBits <= 28), std::uint32_t, std::uint64_t>;
  auto magnitude = static_cast<word>(raw);
  if (raw < 0) {
    *out++ = '-';
    magnitude = 0 - magnitude;
  }
  const auto digit = [&out](word value) { *out++ = static_cast<char>('0' + value); };
  constexpr bool has_whole = FractionBits < std::numeric_limits<word>::digits;
  const word whole = has_whole ? magnitude >> (has_whole ? FractionBits : 0) : word{0};
  word power = 1;
  while (whole / power >= 10) power *= 10;
  for (; power != 0; power /= 10) digit(whole / power % 10);
  word fraction = magnitude - (has_whole ? whole << (has_whole ? FractionBits : 0) : word{0});
  if (fraction != 0) *out++ = '.';
  if constexpr (FractionBits + 4 <= std::numeric_limits<word>::digits) {
    constexpr word one = word{1} << FractionBits;
    for (; fraction != 0; fraction = fraction * 10 % one) digit(fraction * 10 / one);
  } else {
    for (fraction <<= 64 - FractionBits; fraction != 0; fraction *= 10) {
      digit(multiply_words(fraction, 10).high);
    }
  }
  return out;
}

/// Reads `[sign]digits[.digits]` one character at a time, in constant memory, and rounds it once.
///
/// A tie is an odd multiple of 2^-(FractionBits + 1) at the finest and has at most FractionBits + 1
/// fraction digits. Keeping those digits exactly, and whether any later digit is nonzero, therefore
/// decides every rounding.
template <class Raw, int FractionBits>
class decimal_reader {
 public:
  /// Consumes the next character if it can continue the text.
  constexpr bool take(char c) noexcept {
    const bool is_digit = c >= '0' && c <= '9';
    switch (state_) {
      case state::start:
        if (c == '-' || c == '+') {
          negative_ = c == '-';
          state_ = state::sign;
          return true;
        }
        [[fallthrough]];
      case state::sign:
        state_ = is_digit ? state::whole : state_;
        break;
      case state::whole:
        if (c == '.') {
          state_ = state::point;
          return true;
        }
        break;
      case state::point:
        state_ = is_digit ? state::fraction : state_;
        break;
      case state::fraction:
        break;
    }
    if (is_digit) add(static_cast<unsigned>(c - '0'));
    return is_digit;
  }

  /// Whether the characters consumed are a number. "1." is not.
  [[nodiscard]] constexpr bool complete() const noexcept {
    return state_ == state::whole || state_ == state::fraction;
  }

  /// Whether the characters consumed are a number and a point.
  [[nodiscard]] constexpr bool ends_in_point() const noexcept { return state_ == state::point; }

  /// The number rounded by rule R, or nothing if the rounded value is out of range.
  template <rounding R>
  constexpr std::optional<Raw> value() const noexcept {
    // The fraction in units of 10^-kept, doubled to make room for the sticky bit of later digits.
    digits_t parts = fraction_;
    for (int digits = kept_; digits < kept; ++digits) parts = parts * digits_t{10};
    parts = (parts << 1) + digits_t{more_};
    const wide whole = wide{whole_} << FractionBits;
    if constexpr (is_built_in<digits_t> && sizeof(digits_t) == sizeof(std::int64_t)) {
      constexpr digits_t unit = 2 * (power_of_ten(kept) >> FractionBits);
      const std::int64_t fraction = negative_ ? -parts : parts;
      return in_range((negative_ ? -whole : whole) + wide{rounded_ratio<R>(fraction, unit)});
    } else {
      // One bit of the quotient at a time, toward zero.
      constexpr digits_t one = power_of_ten(kept) << 1;
      wide magnitude = whole >> FractionBits;
      for (int bit = 0; bit < FractionBits; ++bit) {
        parts = parts << 1;
        const bool set = !(parts < one);
        if (set) parts = parts - one;
        magnitude = (magnitude << 1) + wide{set};
      }
      const bool exact = parts == digits_t{0};
      const digits_t rest = one - parts;
      const auto order = parts < rest   ? std::strong_ordering::less
                         : rest < parts ? std::strong_ordering::greater
                                        : std::strong_ordering::equal;
      // The magnitude grows where the number itself would not be rounded up.
      bool grows = rounds_up<R>(order, exact, false, is_odd(magnitude));
      if (negative_ && !exact) {
        const auto from_below = 0 <=> order;
        grows = !rounds_up<R>(from_below, false, true, !is_odd(magnitude));
      }
      if (grows) magnitude = magnitude + wide{1};
      return in_range(negative_ ? -magnitude : magnitude);
    }
  }

 private:
  enum class state { start, sign, whole, point, fraction };

  /// The fraction digits that are kept. 10^17 is a multiple of the power of two of every format
  /// whose reader calculates in 64 bits.
  static constexpr int kept = larger(FractionBits + 1, 17);

  /// Holds 4 * 10^kept.
  using digits_t = signed_t<larger(64, (kept * 33220 + 9999) / 10000 + 3)>;
  /// The whole part is limited to 2^whole_bits, which is beyond the range.
  static constexpr int whole_bits = bits_of<Raw> == 64 ? 65 : 33;
  using whole_t = signed_t<whole_bits + 5>;
  /// Holds a whole part times 2^FractionBits.
  using wide = signed_t<larger(64, whole_bits + FractionBits + 2)>;

  static constexpr digits_t power_of_ten(int exponent) noexcept {
    digits_t power{1};
    while (exponent-- > 0) power = power * digits_t{10};
    return power;
  }

  static constexpr std::optional<Raw> in_range(const wide& value) noexcept {
    if (!fits<Raw>(value)) return std::nullopt;
    return static_cast<Raw>(value);
  }

  constexpr void add(unsigned digit) noexcept {
    if (state_ == state::whole) {
      // Clamps: beyond every range, the exact whole part does not matter.
      constexpr whole_t beyond = whole_t{1} << whole_bits;
      whole_ = whole_ * whole_t{10} + whole_t{digit};
      if (beyond < whole_) whole_ = beyond;
    } else if (kept_ < kept) {
      fraction_ = fraction_ * digits_t{10} + digits_t{digit};
      ++kept_;
    } else {
      more_ = more_ || digit != 0;
    }
  }

  state state_ = state::start;
  bool negative_ = false;
  bool more_ = false;
  int kept_ = 0;
  whole_t whole_{0};
  digits_t fraction_{0};
};

}  // namespace fixproof::detail
