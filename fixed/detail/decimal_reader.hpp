/// \file
/// Reads decimal text of any length and exponent with one rounding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "fixed/detail/decimal_rounding.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

constexpr bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

constexpr unsigned digit_of(char c) noexcept { return static_cast<unsigned>(c - '0'); }

/// Reads `[sign]digits[e[sign]digits]` one character at a time, in constant memory, and rounds it
/// once. A point may stand before, between or after the first digits.
///
/// The reader keeps as many digits from the first that is not zero as decimal_parts can need, and
/// whether any later digit is not zero. They decide every rounding, wherever the exponent moves the
/// point.
template <class Raw, int FractionBits>
class decimal_reader {
 public:
  /// \param point the decimal point of the text
  explicit constexpr decimal_reader(char point = '.') noexcept : point_(point) {}

  /// Consumes the next character if it can continue the text. \pre fewer than 10^17 characters
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
  /// 2 for "1e+". \pre they begin with a number
  [[nodiscard]] constexpr int excess() const noexcept {
    if (complete()) return 0;
    return state_ == state::exponent_sign ? 2 : 1;
  }

  /// That number rounded by rule R, or nothing if the rounded value is out of range.
  /// \pre the characters consumed begin with a number
  template <rounding R>
  [[nodiscard]] constexpr std::optional<Raw> value() const noexcept {
    if (count_ == 0) return Raw{0};
    // The number is 0.ddd * 10^position, with the digits ddd kept; the first is not zero.
    const std::int64_t position = whole_ + (exponent_is_negative_ ? -exponent_ : exponent_);
    if (position > parts_t::whole_digits) return std::nullopt;
    // So many zeros leave only the sticky bit.
    constexpr std::int64_t lowest = -parts_t::fraction_digits;
    const auto places = static_cast<int>(position < lowest ? lowest : position);
    parts_t parts;
    parts.negative = negative_;
    parts.more = more_;
    parts.read = larger(-places, 0);
    for (int i = 0; i < places; ++i) parts.add_whole(i < count_ ? digit_of(digits_[index(i)]) : 0);
    for (int i = larger(places, 0); i < count_; ++i) {
      parts.add_fraction(digit_of(digits_[index(i)]));
    }
    return parts.template rounded<R>();
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
  using parts_t = decimal_parts<Raw, FractionBits>;

  static constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

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

  static constexpr int kept_digits = parts_t::whole_digits + parts_t::fraction_digits;
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

/// Reads the longest number at the beginning of a text, rounded by rule R.
/// \param value what decimal_reader::value() returns
/// \return the end of the number; `first` if there is none
template <rounding R, int FractionBits, class Raw>
constexpr const char* read_decimal(const char* first, const char* last,
                                   std::optional<Raw>& value) noexcept {
  // Without an exponent, no digit has to be kept.
  decimal_parts<Raw, FractionBits> parts;
  const char* at = first;
  if (at != last && (*at == '-' || *at == '+')) parts.negative = *at++ == '-';
  const char* const whole = at;
  for (; at != last && is_digit(*at); ++at) parts.add_whole(digit_of(*at));
  const bool has_whole = at != whole;
  if (at != last && *at == '.' && (has_whole || (last - at >= 2 && is_digit(at[1])))) {
    for (++at; at != last && is_digit(*at); ++at) parts.add_fraction(digit_of(*at));
  }
  if (at == whole) return first;
  if (at == last || (*at != 'e' && *at != 'E')) {
    value = parts.template rounded<R>();
    return at;
  }
  decimal_reader<Raw, FractionBits> reader;
  for (at = first; at != last && reader.take(*at);) ++at;
  value = reader.template value<R>();
  return at - reader.excess();
}

}  // namespace fixproof::detail
