/// @file
/// Reads decimal text of any length and exponent with one rounding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fixed/detail/decimal.hpp"
#include "fixed/detail/decimal_words.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/detail/wide_integer.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// Reads `[sign]digits[e[sign]digits]` one character at a time, in constant memory, and rounds it
/// once. A point may stand before, between or after the first digits.
///
/// The reader keeps digits from the first that is not zero, and whether any later digit is not
/// zero. A number in range has at most whole_digits digits before the point. A tie is a multiple of
/// 2^-(FractionBits + 1), so it has at most fraction_digits digits after the point. As many digits
/// as both together decide every rounding, wherever the exponent moves the point.
template <class Raw, int FractionBits>
class decimal_reader {
 public:
  /// @param point the decimal point of the text
  explicit constexpr decimal_reader(char point = '.') noexcept : point_(point) {}

  /// Consumes the next character if it can continue the text. @pre fewer than 10^17 characters
  constexpr bool take(char c) noexcept {
    if (!is_digit(c)) return take_mark(c);
    if (state_ <= state::whole) {
      state_ = state::whole;
      if (count_ == 0 && c == '0') return true;
      ++whole_;
      keep(c);
    } else if (state_ <= state::fraction) {
      state_ = state::fraction;
      if (count_ == 0 && c == '0') {
        --whole_;
      } else {
        keep(c);
      }
    } else {
      state_ = state::exponent;
      if (exponent_ < exponent_limit) exponent_ = exponent_ * 10 + digit_of(c);
    }
    return true;
  }

  /// Whether all characters consumed are a number. ".", "1e" and "1e+" are not.
  [[nodiscard]] constexpr bool complete() const noexcept {
    return state_ == state::whole || state_ == state::point || state_ == state::fraction ||
           state_ == state::exponent;
  }

  /// How many of the characters consumed follow the longest number at their beginning: 1 for "1e",
  /// 2 for "1e+". @pre they begin with a number
  [[nodiscard]] constexpr int excess() const noexcept {
    if (complete()) return 0;
    return state_ == state::exponent_sign ? 2 : 1;
  }

  /// That number rounded by rule Rounding, or nothing if the rounded value is out of range.
  /// @pre the characters consumed begin with a number
  template <rounding Rounding>
  [[nodiscard]] constexpr std::optional<Raw> value() const noexcept {
    if (count_ == 0) return Raw{0};
    // The number is 0.ddd * 10^position, with the digits ddd kept; the first is not zero.
    const std::int64_t position = whole_ + (exponent_is_negative_ ? -exponent_ : exponent_);
    if (position > whole_digits) return std::nullopt;
    // Holds 10^whole_digits * 2^FractionBits. The fraction has nine digits in each limb.
    using wide = signed_t<larger(64, bits_of<Raw> + 6)>;
    constexpr std::uint64_t one = power_of_ten(9);
    wide magnitude{0};
    std::array<std::uint64_t, index(fraction_digits / 9 + 1)> limbs{};
    bool more = more_;
    for (std::int64_t i = 0; i < position || i < count_; ++i) {
      const unsigned digit = i < count_ ? digit_of(digits_[index(i)]) : 0;
      const std::int64_t place = i - position;
      if (place < 0) {
        magnitude = magnitude * wide{10} + wide{digit};
      } else if (place < fraction_digits) {
        limbs[index(place / 9)] += digit * power_of_ten(8 - place % 9);
      } else {
        more = more || digit != 0;
      }
    }
    // Moves up to 32 bits of the fraction to the magnitude at a time.
    for (int bits = FractionBits; bits > 0; bits -= 32) {
      const int step = bits < 32 ? bits : 32;
      std::uint64_t carry = 0;
      for (std::size_t i = limbs.size(); i-- > 0;) {
        const std::uint64_t shifted = (limbs[i] << step) + carry;
        limbs[i] = shifted % one;
        carry = shifted / one;
      }
      magnitude = (magnitude << step) + static_cast<wide>(carry);
    }
    for (std::size_t i = 1; i < limbs.size(); ++i) more = more || limbs[i] != 0;
    return rounded_text<Rounding, Raw>(magnitude, limbs[0], one, more, negative_);
  }

 private:
  /// A first_point has no digit before it.
  enum class state {
    start,
    sign,
    whole,
    first_point,
    point,
    fraction,
    exponent_mark,
    exponent_sign,
    exponent
  };

  static constexpr std::size_t index(std::int64_t i) noexcept {
    return static_cast<std::size_t>(i);
  }

  constexpr void keep(char digit) noexcept {
    if (count_ < kept_digits) {
      digits_[index(count_++)] = digit;
    } else {
      more_ = more_ || digit != '0';
    }
  }

  /// Consumes what is not a digit.
  constexpr bool take_mark(char c) noexcept {
    const bool is_sign = c == '-' || c == '+';
    if (state_ == state::start && is_sign) {
      negative_ = c == '-';
      state_ = state::sign;
    } else if (state_ <= state::whole && c == point_) {
      state_ = state_ == state::whole ? state::point : state::first_point;
    } else if (complete() && state_ != state::exponent && (c == 'e' || c == 'E')) {
      state_ = state::exponent_mark;
    } else if (state_ == state::exponent_mark && is_sign) {
      exponent_is_negative_ = c == '-';
      state_ = state::exponent_sign;
    } else {
      return false;
    }
    return true;
  }

  static constexpr int whole_digits = decimal_digits(larger(bits_of<Raw> - FractionBits, 0)) + 1;
  static constexpr int fraction_digits = FractionBits + 1;
  static constexpr int kept_digits = whole_digits + fraction_digits;
  /// A larger exponent moves the point beyond the length of every text.
  static constexpr std::int64_t exponent_limit = 100'000'000'000'000'000;

  state state_ = state::start;
  char point_;
  bool negative_ = false;
  bool exponent_is_negative_ = false;
  /// Whether a digit that is not kept is not zero.
  bool more_ = false;
  int count_ = 0;
  std::array<char, std::size_t{kept_digits}> digits_{};
  /// The digits before the point from the first that is not zero, or minus the zeros between the
  /// point and that digit.
  std::int64_t whole_ = 0;
  std::int64_t exponent_ = 0;
};

/// Reads the longest number at the beginning of a text, rounded by rule Rounding.
/// @pre the text begins with a number
/// @param value what decimal_reader::value() returns
/// @return the end of the number
template <rounding Rounding, int FractionBits, class Raw>
FIXED_NOINLINE constexpr const char* read_any(const char* first, const char* last,
                                              std::optional<Raw>& value) noexcept {
  decimal_reader<Raw, FractionBits> reader;
  const char* at = first;
  while (at != last && reader.take(*at)) ++at;
  value = reader.template value<Rounding>();
  return at - reader.excess();
}

/// Reads the longest number at the beginning of a text. Tries read_words() first, which is faster.
/// @return the end of the number, or `first` if the text begins with no number
template <rounding Rounding, int FractionBits, class Raw>
constexpr const char* read_decimal(const char* first, const char* last,
                                   std::optional<Raw>& value) noexcept {
  // A null pointer is a text, too: an empty one.
  if (first == nullptr) return first;
  const char* const end = read_words<Rounding, FractionBits>(first, last, value);
  return end != nullptr ? end : read_any<Rounding, FractionBits>(first, last, value);
}

}  // namespace fixproof::detail
