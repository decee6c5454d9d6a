/// @file
/// The text of a number in every notation; formatters and streams share it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/bits.hpp"
#include "fixed/detail/decimal.hpp"

namespace fixproof::detail {

/// How a number is written.
struct text_style {
  /// `f`: `precision` digits after the point; `e`, `E`: scientific, with `precision` digits after
  /// the point; `x`, `X`, `b`: hexadecimal and binary; `a`, `A`: hexadecimal with a power of two,
  /// as in C; 0: the exact decimal. Only f and e round.
  char type = 0;
  /// What stands before a number that is not negative: `+`, a space, or `-` for nothing.
  char plus = '-';
  /// Adds 0x, 0X or 0b to `x`, `X` and `b`, and a point to all others that have none.
  bool alternate = false;
  std::size_t precision = 6;
};

/// The text of one number, without padding and grouping.
class number_text {
 public:
  template <int FractionBits, class Raw>
  static constexpr number_text of(Raw raw, const text_style& style) noexcept {
    number_text text;
    if (raw < 0) {
      text.add_to_head('-');
    } else if (style.plus != '-') {
      text.add_to_head(style.plus);
    }
    if (style.type == 'x' || style.type == 'X' || style.type == 'b') {
      const auto word = static_cast<std::uint64_t>(raw);
      text.set_binary(raw < 0 ? 0 - word : word, FractionBits, style);
      return text;
    }
    if (style.type == 'a' || style.type == 'A') {
      const auto word = static_cast<std::uint64_t>(raw);
      text.set_hex_float(raw < 0 ? 0 - word : word, FractionBits, style);
      return text;
    }
    std::array<char, max_decimal_chars<Raw, FractionBits>> exact{};
    const char* first = exact.data();
    const char* last = write_decimal<FractionBits>(exact.data(), raw);
    text.set_decimal(first + (raw < 0 ? 1 : 0), last);
    if (style.type == 'f') text.set_fixed(style.precision);
    if (style.type == 'e' || style.type == 'E') text.set_scientific(style);
    text.has_point_ = text.has_point_ || style.alternate;
    return text;
  }

  /// The number of characters.
  [[nodiscard]] constexpr std::size_t size() const noexcept {
    return head_size_ + (end_ - first_) + (has_point_ ? 1 : 0) + zeros_ + tail_size_;
  }

  /// Writes the sign and 0x; zeros that pad the number follow it.
  template <class Out>
  // NOLINTNEXTLINE(modernize-use-nodiscard): an output iterator, as of std::copy
  constexpr Out write_head(Out out) const {
    return copy(head_.data(), head_.data() + head_size_, out);
  }

  /// The digits before the point, at least one.
  [[nodiscard]] constexpr const char* whole_begin() const noexcept {
    return digits_.data() + first_;
  }
  [[nodiscard]] constexpr const char* whole_end() const noexcept { return digits_.data() + whole_; }

  /// Writes the point and what follows it.
  template <class Out>
  // NOLINTNEXTLINE(modernize-use-nodiscard)
  constexpr Out write_rest(Out out, char point = '.') const {
    if (has_point_) *out++ = point;
    out = copy(whole_end(), digits_.data() + end_, out);
    out = fill(out, zeros_, '0');
    return copy(tail_.data(), tail_.data() + tail_size_, out);
  }

  template <class Out>
  static constexpr Out copy(const char* first, const char* last, Out out) {
    for (; first != last; ++first) *out++ = *first;
    return out;
  }

  template <class Out>
  static constexpr Out fill(Out out, std::size_t count, char c) {
    for (; count != 0; --count) *out++ = c;
    return out;
  }

 private:
  constexpr void add_to_head(char c) noexcept { head_[head_size_++] = c; }

  constexpr void set_decimal(const char* first, const char* last) noexcept {
    for (; first != last && *first != '.'; ++first) digits_[end_++] = *first;
    whole_ = end_;
    has_point_ = first != last;
    for (; first != last; ++first) {
      if (*first != '.') digits_[end_++] = *first;
    }
  }

  /// Keeps `precision` digits after the point.
  constexpr void set_fixed(std::size_t precision) noexcept {
    const std::size_t exact = end_ - whole_;
    zeros_ = precision > exact ? precision - exact : 0;
    if (precision < exact) round_at(whole_ + precision);
    has_point_ = precision != 0;
  }

  constexpr void set_scientific(const text_style& style) noexcept {
    // The first digit that is not zero stands before the point; zero has the exponent 0.
    std::size_t leading = first_;
    while (leading + 1 < end_ && digits_[leading] == '0') ++leading;
    int exponent = static_cast<int>(whole_) - static_cast<int>(leading) - 1;
    if (digits_[leading] == '0') exponent = 0;
    first_ = leading;
    whole_ = leading + 1;
    set_fixed(style.precision);
    if (whole_ - first_ == 2) {  // 9.9 became 10
      --whole_;
      --end_;
      ++exponent;
    }
    set_exponent(style.type, exponent, 2);
  }

  /// @pre |exponent| < 100
  constexpr void set_exponent(char mark, int exponent, int digits) noexcept {
    const int magnitude = exponent < 0 ? -exponent : exponent;
    const auto add = [this](char c) { tail_[tail_size_++] = c; };
    add(mark);
    add(exponent < 0 ? '-' : '+');
    if (digits > 1 || magnitude > 9) add(static_cast<char>('0' + magnitude / 10));
    add(static_cast<char>('0' + magnitude % 10));
  }

  /// Removes the digits from `at` on and rounds those before it to nearest, ties to even.
  /// @pre first_ < at < end_
  constexpr void round_at(std::size_t at) noexcept {
    bool above_half = false;
    for (std::size_t i = at + 1; i < end_; ++i) above_half = above_half || digits_[i] != '0';
    const bool odd = (digits_[at - 1] - '0') % 2 != 0;
    bool carry = digits_[at] > '5' || (digits_[at] == '5' && (above_half || odd));
    end_ = at;
    for (std::size_t i = at; carry && i > first_;) {
      --i;
      carry = digits_[i] == '9';
      digits_[i] = carry ? '0' : static_cast<char>(digits_[i] + 1);
    }
    if (carry) digits_[--first_] = '1';
  }

  constexpr void set_binary(std::uint64_t magnitude, int fraction_bits,
                            const text_style& style) noexcept {
    const int bits = style.type == 'b' ? 1 : 4;
    if (style.alternate) {
      add_to_head('0');
      add_to_head(style.type);
    }
    const std::uint64_t whole = fraction_bits < 64 ? magnitude >> fraction_bits : 0;
    int shift = 0;
    while (shift + bits < 64 && whole >> (shift + bits) != 0) shift += bits;
    for (; shift >= 0; shift -= bits) {
      add_digit(whole >> shift & ((std::uint64_t{1} << bits) - 1), style.type);
    }
    set_fraction(fraction_bits > 0 ? magnitude << (64 - fraction_bits) : 0, bits, style.type);
  }

  /// Writes 1.8p+0 for 1.5: one bit before the point. Zero is 0p+0.
  constexpr void set_hex_float(std::uint64_t magnitude, int fraction_bits,
                               const text_style& style) noexcept {
    const bool upper = style.type == 'A';
    add_to_head('0');
    add_to_head(upper ? 'X' : 'x');
    const int top = magnitude == 0 ? 0 : width_of(magnitude) - 1;
    add_digit(magnitude >> top, style.type);
    set_fraction(top > 0 ? magnitude << (64 - top) : 0, 4, style.type);
    has_point_ = has_point_ || style.alternate;
    set_exponent(upper ? 'P' : 'p', magnitude == 0 ? 0 : top - fraction_bits, 1);
  }

  /// @param type of a text_style; if it is upper-case, so are the digits from ten
  constexpr void add_digit(std::uint64_t digit, char type) noexcept {
    const char ten = type < 'a' ? 'A' : 'a';
    digits_[end_++] = static_cast<char>(digit < 10 ? '0' + static_cast<int>(digit)
                                                   : ten + static_cast<int>(digit - 10));
  }

  /// Ends the whole part and adds the digits of a fraction of 64 bits.
  constexpr void set_fraction(std::uint64_t fraction, int bits_per_digit, char type) noexcept {
    whole_ = end_;
    has_point_ = fraction != 0;
    for (; fraction != 0; fraction <<= bits_per_digit) {
      add_digit(fraction >> (64 - bits_per_digit), type);
    }
  }

  /// The digits are digits_[first_, end_), with the point before digits_[whole_], and then zeros_
  /// zeros. One free place before them takes a carry. No format has more than 65 digits.
  std::array<char, 68> digits_{};
  std::size_t first_ = 1;
  std::size_t whole_ = 1;
  std::size_t end_ = 1;
  std::size_t zeros_ = 0;
  bool has_point_ = false;
  std::array<char, 3> head_{};
  std::size_t head_size_ = 0;
  std::array<char, 4> tail_{};
  std::size_t tail_size_ = 0;
};

}  // namespace fixproof::detail
