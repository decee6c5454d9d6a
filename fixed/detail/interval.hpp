/// @file
/// Real numbers with a bound of their error, for the functions in formats of 64 bits.
///
/// Every operation adds the bound of its own error to those of its operands, so the exact result is
/// in the interval whatever the formula.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fixed/detail/assert.hpp"
#include "fixed/detail/bits.hpp"
#include "fixed/detail/interval_constants.hpp"
#include "fixed/detail/limb_integer.hpp"
#include "fixed/detail/square_root.hpp"
#include "fixed/detail/wide_integer.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// An integer of ulps, or none if an interval allows two.
struct interval_ulps {
  bool is_decided;
  int128 ulps;
};

/// The numbers (M +- radius) 2^(exponent - 32 n) with a sign, where M is an integer of n digits.
///
/// A number that loses its first bits to a difference loses as many of its last digits, so that the
/// first bit of M is 1 and the radius is small. If the first bit is 0, the number is 0, or fewer
/// than fewest_digits of its digits are known.
class interval {
 public:
  static constexpr std::size_t most_digits = limb_integer::most;
  static constexpr std::size_t fewest_digits = 3;

  /// magnitude * 2^-places, exactly, with n digits. @pre fewest_digits <= n <= most_digits
  constexpr interval(std::size_t n, bool is_negative, std::uint64_t magnitude, int places) noexcept
      : limbs_{n}, exponent_(64 - places), is_negative_(is_negative) {
    limbs_.digits[n - 1] = static_cast<std::uint32_t>(magnitude >> 32);
    limbs_.digits[n - 2] = static_cast<std::uint32_t>(magnitude);
    normalize();
  }

  /// A constant with n digits.
  constexpr interval(std::size_t n, const real_constant& from) noexcept
      : limbs_{n}, radius_(1), exponent_(from.exponent), is_negative_(from.is_negative) {
    for (std::size_t i = 0; i < n; ++i) limbs_.digits[i] = from.limbs[most_digits - n + i];
  }

  /// Whether the number is exactly 0.
  [[nodiscard]] constexpr bool is_zero() const noexcept { return radius_ == 0 && !is_normal(); }
  [[nodiscard]] constexpr bool is_negative() const noexcept { return is_negative_; }
  [[nodiscard]] constexpr std::size_t size() const noexcept { return limbs_.size; }
  /// The magnitude of every number in the interval is below 2^(exponent + 1).
  [[nodiscard]] constexpr int exponent() const noexcept { return exponent_; }
  /// The magnitude of every number in the interval is at least 2^(exponent - 2).
  [[nodiscard]] constexpr bool is_normal() const noexcept { return limbs_.has_first_bit(); }
  /// The first 32 bits of the magnitude, in units of 2^(exponent - 32).
  [[nodiscard]] constexpr std::uint32_t first_digit() const noexcept {
    return limbs_.digits[size() - 1];
  }

  [[nodiscard]] constexpr interval magnitude() const noexcept {
    interval result = *this;
    result.is_negative_ = false;
    return result;
  }

  [[nodiscard]] constexpr interval operator-() const noexcept {
    interval result = *this;
    result.is_negative_ = !is_negative_;
    return result;
  }

  /// The number times 2^places, exactly.
  [[nodiscard]] constexpr interval scaled(int places) const noexcept {
    interval result = *this;
    result.exponent_ += places;
    return result;
  }

  /// The number, or one that differs by less than 2^(exponent() - 32 n).
  [[nodiscard]] constexpr interval widened() const noexcept {
    interval result = *this;
    ++result.radius_;
    return result;
  }

  friend constexpr interval operator+(const interval& a, const interval& b) noexcept {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    return a.exponent_ < b.exponent_ ? sum_of(b, a) : sum_of(a, b);
  }

  friend constexpr interval operator-(const interval& a, const interval& b) noexcept {
    return a + -b;
  }

  friend constexpr interval operator*(const interval& a, const interval& b) noexcept {
    if (a.is_zero()) return a;
    if (b.is_zero()) return b;
    if (a.size() > b.size()) return a.without_last(a.size() - b.size()) * b;
    if (a.size() < b.size()) return a * b.without_last(b.size() - a.size());
    interval result(upper_product(a.limbs_, b.limbs_), a.exponent_ + b.exponent_,
                    a.is_negative_ != b.is_negative_);
    // Both errors of the product of the integers are below 2 units, the radii not counted.
    // M and M' are below 2^(32 n), so M radius' and M' radius are below that many units; the
    // product of the radii is below one.
    result.radius_ = a.radius_ + b.radius_ + 3;
    result.normalize();
    return result;
  }

  /// @pre n > 0
  friend constexpr interval operator/(const interval& a, std::uint32_t n) noexcept {
    interval result = a;
    const std::uint32_t rest = result.limbs_.divide(n);
    if (rest != 0 || a.radius_ != 0) result.radius_ = a.radius_ / n + 2;
    result.normalize();
    return result;
  }

  /// The quotient; any number if the first bit of b is not known.
  friend constexpr interval operator/(const interval& a, const interval& b) noexcept {
    if (!b.is_normal()) return unknown(a.size());
    if (a.is_zero()) return a;
    if (a.size() > b.size()) return a.without_last(a.size() - b.size()) / b;
    if (a.size() < b.size()) return a / b.without_last(b.size() - a.size());
    interval result(upper_quotient(a.limbs_, b.limbs_), a.exponent_ - b.exponent_ + 1,
                    a.is_negative_ != b.is_negative_);
    // Let N = 2^(32 n - 1). The quotient is M N / M' with M < 2 N <= 2 M'. So an error of M shifts
    // it by at most that, and one of M' by at most twice that.
    result.radius_ = a.radius_ + 2 * b.radius_ + 3;
    result.normalize();
    return result;
  }

  /// The square root of a magnitude; any number if the first bit is not known.
  [[nodiscard]] friend constexpr interval sqrt(const interval& x) noexcept {
    if (x.is_zero()) return x;
    if (!x.is_normal()) return unknown(x.size());
    // The number is m 4^half with 1/4 <= m < 1.
    const bool is_odd = (x.exponent_ & 1) != 0;
    const int half = (x.exponent_ + (is_odd ? 1 : 0)) / 2;
    interval m = x.scaled(-2 * half);
    m.is_negative_ = false;
    m.radius_ = 0;
    const std::uint64_t top = m.limbs_.top() >> (is_odd ? 1 : 0);
    interval root(m.size(), false, static_cast<std::uint64_t>(nearest_sqrt_of_word(top)), 32);
    // Of relative errors, that of the first root is below 2^-30, and each step squares and halves
    // the one before. The errors of the last step are 3 units for the quotient, 1 for the sum, and
    // 1 for normalizing each.
    for (std::size_t bits = 30; bits < 32 * x.size(); bits = 2 * bits + 1) {
      root = (root + m / root).scaled(-1);
      root.radius_ = 0;
    }
    // A relative error of x is halved, and M of the root is at least half of the M of x.
    root.radius_ = x.radius_ + 16;
    root.exponent_ += half;
    return root;
  }

  /// The integer nearest to the magnitude. @pre that is below 2^64 - 1
  [[nodiscard]] constexpr std::uint64_t nearest_integer() const noexcept {
    FIXED_ASSERT(exponent_ <= 64);
    if (exponent_ < 0) return 0;
    if (exponent_ == 64) return limbs_.top() + (limbs_.digits[size() - 3] >> 31);
    const std::uint64_t halves = limbs_.top() >> (63 - exponent_);
    return (halves >> 1) + (halves & 1);
  }

  /// The nearest integer of units of 2^-fraction_bits, if all numbers of the interval have the same
  /// one; from 2^65 on, 2^66. @pre 0 <= fraction_bits <= 64
  [[nodiscard]] constexpr interval_ulps nearest_ulps(int fraction_bits) const noexcept {
    const int whole = exponent_ + fraction_bits;
    // Then a magnitude with a known first bit is above 2^64, out of range in every format.
    constexpr int beyond = 66;
    if (whole >= beyond) return {is_normal(), signed_ulps(int128{1} << beyond)};
    // M counts 2^-dropped half ulps.
    const int dropped = 32 * static_cast<int>(size()) - 1 - whole;
    const int128 low = halves_above(dropped, true);
    const int128 high = halves_above(dropped, false);
    const int128 ulps = (high + int128{1}) >> 1;
    return {((low + int128{1}) >> 1) == ulps, signed_ulps(ulps)};
  }

  /// The integer of units of 2^-fraction_bits below or above, by a rule that is not to nearest, if
  /// every number of the interval has the same one and none is an integer; from 2^65 on, 2^66.
  template <rounding Rounding>
  [[nodiscard]] constexpr interval_ulps directed_ulps(int fraction_bits) const noexcept {
    const int whole = exponent_ + fraction_bits;
    if (whole >= 66) return nearest_ulps(fraction_bits);
    const int dropped = 32 * static_cast<int>(size()) - whole;
    // No end of the wider interval is an end of this one, which so has no integer at its ends.
    const interval wider = widened();
    const int128 low = wider.halves_above(dropped, true);
    const int128 high = wider.halves_above(dropped, false);
    const bool grows = Rounding == (is_negative_ ? rounding::floor : rounding::ceiling);
    return {is_normal() && low == high, signed_ulps(grows ? low + int128{1} : low)};
  }

 private:
  constexpr interval(const limb_integer& limbs, int exponent, bool is_negative) noexcept
      : limbs_(limbs), exponent_(exponent), is_negative_(is_negative) {}

  [[nodiscard]] constexpr int128 signed_ulps(const int128& magnitude) const noexcept {
    return is_negative_ ? -magnitude : magnitude;
  }

  /// Any number: the results of functions are far below the radius.
  static constexpr interval unknown(std::size_t n) noexcept {
    interval result(n, false, 0, 0);
    result.exponent_ = 1 << 20;
    result.radius_ = 1;
    return result;
  }

  /// The lower or the upper end of the magnitude, divided by 2^places and rounded down; an end
  /// below 0 counts as 0. @pre the result is below 2^68
  [[nodiscard]] constexpr int128 halves_above(int places, bool is_low) const noexcept {
    std::array<std::uint32_t, most_digits + 1> end{};
    std::int64_t carry = 0;
    std::uint64_t rest = radius_;
    for (std::size_t i = 0; i <= size(); ++i) {
      const std::int64_t digit = i < size() ? std::int64_t{limbs_.digits[i]} : 0;
      const auto part = static_cast<std::int64_t>(rest & 0xffffffff);
      rest >>= 32;
      carry += is_low ? digit - part : digit + part;
      end[i] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    if (carry < 0) return int128{0};
    const auto whole = static_cast<std::size_t>(places) / 32;
    int128 result{0};
    for (std::size_t i = size() + 1; i-- > whole;) result = (result << 32) + int128{end[i]};
    return result >> (places % 32);
  }

  /// The number without its last digits. @pre count < size()
  [[nodiscard]] constexpr interval without_last(std::size_t count) const noexcept {
    interval result = *this;
    result.drop_last(count);
    return result;
  }

  constexpr void drop_last(std::size_t count) noexcept {
    drop_from_radius(32 * static_cast<int>(count), limbs_.drop_last(count));
  }

  /// Drops `places` bits. @pre places > 0
  constexpr void shift_right(int places) noexcept {
    exponent_ += places;
    drop_from_radius(places, limbs_.shift_right(places));
  }

  /// Counts the radius in units that are 2^places times as large.
  constexpr void drop_from_radius(int places, bool has_rest) noexcept {
    if (radius_ != 0) radius_ = (places < 64 ? radius_ >> places : 0) + 1;
    if (has_rest) ++radius_;
  }

  /// Makes the first bit 1 if at least fewest_digits of the number are known.
  constexpr void normalize() noexcept {
    // So sums of a few radii fit.
    if (radius_ >> 56 != 0) {
      if (size() > fewest_digits) {
        drop_last(1);
      } else {
        shift_right(32);
      }
    }
    int places = limbs_.zero_bits();
    if (places == 0) return;
    if (radius_ == 0 && places == 32 * static_cast<int>(size())) {
      exponent_ = 0;
      return;
    }
    // The radius stays below 2^48.
    const int room = radius_ == 0 ? places : leading_zeros(radius_) - 16;
    int lost = places <= room ? 0 : (places - room + 31) / 32;
    if (static_cast<int>(size()) - lost < static_cast<int>(fewest_digits)) {
      // Too little is known: the first digits, which are 0, are left out.
      const std::size_t most = size() - fewest_digits;
      const std::size_t zeros = limbs_.zero_digits();
      const std::size_t left_out = zeros < most ? zeros : most;
      limbs_.size -= left_out;
      exponent_ -= 32 * static_cast<int>(left_out);
      places -= 32 * static_cast<int>(left_out);
      if (places > room) places = room;
      lost = 0;
      if (places <= 0) return;
    }
    limbs_.shift_left(places);
    exponent_ -= places;
    if (lost == 0) {
      radius_ <<= radius_ == 0 ? 0 : places;
      return;
    }
    limbs_.drop_last(static_cast<std::size_t>(lost));
    const int more = places - 32 * lost;
    radius_ = (more >= 0 ? radius_ << more : (radius_ >> -more) + 1) + 1;
  }

  /// @pre a.exponent_ >= b.exponent_
  static constexpr interval sum_of(const interval& a, const interval& b) noexcept {
    // In units of the last digit of a, the radius of b has `places` bits less, or more.
    const int more = 32 * (static_cast<int>(a.size()) - static_cast<int>(b.size()));
    const int places = a.exponent_ - b.exponent_ - more;
    if (places < 0 && b.radius_ != 0 && leading_zeros(b.radius_) - 8 < -places) {
      return sum_of(a.without_last(1), b);
    }
    interval addend = b;
    addend.radius_ = 0;
    addend.take_size(a.size());
    if (places != -more) addend.shift_right(places + more);
    interval result = a;
    result.radius_ += addend.radius_;
    if (b.radius_ != 0) {
      result.radius_ +=
          places < 0 ? b.radius_ << -places : (places < 64 ? b.radius_ >> places : 0) + 1;
    }
    const int carry = result.limbs_.add(addend.limbs_, a.is_negative_ == b.is_negative_);
    if (carry > 0) {
      result.shift_right(1);
      result.limbs_.digits[a.size() - 1] |= std::uint32_t{1} << 31;
    } else if (carry < 0) {
      result.limbs_.negate();
      result.is_negative_ = !result.is_negative_;
    }
    result.normalize();
    return result;
  }

  /// Appends zeros, or drops digits.
  constexpr void take_size(std::size_t n) noexcept {
    if (n < size()) {
      drop_last(size() - n);
    } else {
      limbs_.append_zeros(n - size());
    }
  }

  limb_integer limbs_;
  std::uint64_t radius_ = 0;
  int exponent_;
  bool is_negative_;
};

}  // namespace fixproof::detail
