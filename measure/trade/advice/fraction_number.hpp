/// @file
/// A number for the pipeline whose fraction bits are chosen at run time.
#pragma once

#include <boost/noncopyable.hpp>
#include <cmath>
#include <compare>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include "measure/trade/profile/value_range.hpp"
#include "xsharp/arithmetic.hpp"

namespace fixproof::trade {

/// The fraction bits of a run, and the range of the results that it had so far, in ulps.
struct FractionRun {
  int fraction_bits = 16;  ///< 0 ... 24
  ValueRange range;
};

/// An integer of 64 bits in ulps of 2^-fraction_bits. Products and quotients are rounded half up,
/// as in q16_16, but the range is large enough for every scene. Within the range of q16_16, results
/// with 16 fraction bits are those of q16_16.
class FractionNumber {
 public:
  /// Makes a run the current one of this thread until the scope ends. Numbers exist in a scope
  /// only.
  class Scope : private boost::noncopyable {
   public:
    explicit Scope(FractionRun& run) : before_(std::exchange(current, &run)) {}
    ~Scope() { current = before_; }

   private:
    FractionRun* before_;
  };

  constexpr FractionNumber() = default;

  static FractionNumber from_ulps(std::int64_t ulps) {
    FractionNumber result;
    result.ulps_ = ulps;
    return result;
  }
  /// A result, which counts for the range.
  static FractionNumber result(std::int64_t ulps) {
    current->range.add(ulps);
    return from_ulps(ulps);
  }
  [[nodiscard]] std::int64_t ulps() const { return ulps_; }
  static int fraction_bits() { return current->fraction_bits; }

  friend FractionNumber operator+(FractionNumber a, FractionNumber b) {
    return result(a.ulps_ + b.ulps_);
  }
  friend FractionNumber operator-(FractionNumber a, FractionNumber b) {
    return result(a.ulps_ - b.ulps_);
  }
  FractionNumber operator-() const { return from_ulps(-ulps_); }
  friend FractionNumber operator*(FractionNumber a, FractionNumber b) {
    const Wide product = Wide{a.ulps_} * b.ulps_;
    return result(static_cast<std::int64_t>((product + half()) >> fraction_bits()));
  }
  /// Nothing for a divisor of 0.
  static std::optional<FractionNumber> divide(FractionNumber n, FractionNumber d) {
    if (d.ulps_ == 0) return std::nullopt;
    // floor((2 n + d) / 2 d), with d > 0
    const Wide sign = d.ulps_ < 0 ? -1 : 1;
    const Wide twice = 2 * sign * d.ulps_;
    const Wide sum = 2 * sign * (Wide{n.ulps_} << fraction_bits()) + twice / 2;
    const Wide quotient = sum / twice - (sum % twice < 0 ? 1 : 0);
    return result(static_cast<std::int64_t>(quotient));
  }
  friend constexpr bool operator==(FractionNumber, FractionNumber) = default;
  // NOLINTNEXTLINE(modernize-use-nullptr): the 0 is clang's own
  friend constexpr auto operator<=>(FractionNumber, FractionNumber) = default;
  explicit operator double() const {
    return std::ldexp(static_cast<double>(ulps_), -fraction_bits());
  }

  /// The root of the sum of squares, to nearest; there are no ties.
  static FractionNumber length(FractionNumber x, FractionNumber y, FractionNumber z) {
    const Wide sum = Wide{x.ulps_} * x.ulps_ + Wide{y.ulps_} * y.ulps_ + Wide{z.ulps_} * z.ulps_;
    auto root = static_cast<Wide>(std::sqrt(static_cast<double>(sum)));
    while (root * root > sum) --root;
    while ((root + 1) * (root + 1) <= sum) ++root;
    if (sum - root * root > root) ++root;
    return result(static_cast<std::int64_t>(root));
  }

 private:
  __extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): __extension__ needs typedef

  static Wide half() { return Wide{1} << fraction_bits() >> 1; }

  // NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): set by Scope alone
  static inline thread_local FractionRun* current = nullptr;

  std::int64_t ulps_ = 0;
};

}  // namespace fixproof::trade

namespace xsharp {

template <>
struct Arithmetic<fixproof::trade::FractionNumber> {
  using N = fixproof::trade::FractionNumber;

  /// Whole numbers of the pipeline are exact. They count for the range once a result has them.
  static N from_raw(std::int32_t raw) {
    const int bits = N::fraction_bits();
    if (bits >= 16) return N::from_ulps(std::int64_t{raw} << (bits - 16));
    return N::from_ulps((std::int64_t{raw} + (std::int64_t{1} << (15 - bits))) >> (16 - bits));
  }
  static N constant(double value, Conversion conversion) {
    const double ulps = std::ldexp(value, N::fraction_bits()) + 0.5;
    const double whole = conversion == Conversion::published ? std::trunc(ulps) : std::floor(ulps);
    return N::result(static_cast<std::int64_t>(whole));
  }
  static std::optional<N> divide(N n, N d) { return N::divide(n, d); }
  static constexpr bool divides_by_whole_part() { return false; }
  static Turn<N> turn(std::int32_t tenths) {
    const double angle = radians(tenths);
    return {constant(std::cos(angle), Conversion::nearest),
            constant(std::sin(angle), Conversion::nearest)};
  }
  static N midpoint(N a, N b) { return N::result(std::midpoint(a.ulps(), b.ulps())); }
  static Vec3<N> apply(const Transform<N>& t, const Vec3<N>& v) { return apply_products(t, v); }
  static Transform<N> concatenate(const Transform<N>& first, const Transform<N>& second,
                                  Concatenation /*how*/) {
    return concatenate_products(first, second);
  }
  static N length(const Vec3<N>& v) { return N::length(v.x, v.y, v.z); }
};

}  // namespace xsharp
