/// @file
/// The two transforms of a vertex: one rounds each product, the other rounds each sum. row(i, v) is
/// coordinate i of vertex v.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "fixed/batch/detail/element.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/detail/quotient.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// The rows of a transform; the fourth column is the translation.
template <class Number>
using transform_rows = std::array<std::array<Number, 4>, 3>;

/// A vertex, as stored integers.
template <class Number>
using raw_vertex = std::array<typename Number::raw_type, 3>;

/// Rounds each product, then sums from the left.
template <class Number>
struct rounded_products {
  static constexpr const char* name = "transform";
  static constexpr overflow products = Number::rules.product_range();
  /// That of the sums, or of the products if sums wrap.
  static constexpr overflow range =
      Number::rules.range == overflow::wrap ? products : Number::rules.range;
  static constexpr bool never_throws = Number::never_throws && Number::multiply_never_throws;
  // A report counts all overflows of a transform together.
  static_assert(never_throws ||
                    (Number::rules.range != overflow::saturate && products != overflow::saturate),
                "fixproof::batch::transform cannot saturate sums and throw for products, or "
                "saturate products and throw for sums: give both one rule, policy::range");

  const transform_rows<Number>& rows;

  static constexpr bool sums_fit_lanes(const transform_rows<Number>& /*rows*/) noexcept {
    return true;
  }

  [[nodiscard]] FIXED_ALWAYS_INLINE constexpr outcome_of<Number> row(
      std::size_t i, const raw_vertex<Number>& v) const noexcept {
    outcome_of<Number> sum = multiplied(rows[i][0], Number::from_raw(v[0]));
    sum = added(sum, multiplied(rows[i][1], Number::from_raw(v[1])));
    sum = added(sum, multiplied(rows[i][2], Number::from_raw(v[2])));
    return added(sum, {rows[i][3].raw()});
  }

 private:
  FIXED_ALWAYS_INLINE static constexpr outcome_of<Number> added(
      const outcome_of<Number>& sum, const outcome_of<Number>& term) noexcept {
    const outcome_of<Number> next =
        narrowed_element<typename Number::raw_type, Number::rules.range>(
            exact_sum(sum.raw, term.raw));
    return {next.raw, first_of(sum.what, first_of(term.what, next.what))};
  }
};

/// Rounds each sum of products once.
template <class Number>
struct rounded_sums {
  using raw = typename Number::raw_type;
  static constexpr int bits = bits_of<raw>;
  static constexpr int fraction = Number::fraction_bits;
  static constexpr const char* name = "fused_transform";
  static constexpr overflow range = Number::rules.product_range();
  static constexpr bool never_throws = Number::multiply_never_throws;
  /// Whether results depend only on the lower half of a sum that is twice as wide as a number.
  static constexpr bool modulo = range == overflow::wrap && rounds_by_floor<Number::rules.multiply>;

  const transform_rows<Number>& rows;
  bool fit = sums_fit_lanes(rows);

  /// Whether sums of twice the width of a number give the results.
  static constexpr bool sums_fit_lanes(const transform_rows<Number>& rows) noexcept {
    if constexpr (modulo) {
      return true;
    } else {
      return sums_fit(rows[0]) && sums_fit(rows[1]) && sums_fit(rows[2]);
    }
  }

  [[nodiscard]] FIXED_ALWAYS_INLINE constexpr outcome_of<Number> row(
      std::size_t i, const raw_vertex<Number>& v) const noexcept {
    constexpr rounding Rounding = Number::rules.multiply;
    if constexpr (modulo && bits <= 32) {
      const std::uint64_t half = bias<Rounding>(false, false, std::uint64_t{1} << fraction);
      return {static_cast<raw>((sum<std::uint64_t>(rows[i], v) + half) >> fraction)};
    }
    if constexpr (std::is_signed_v<raw> && bits == 32) {
      if (fit) {
        const auto exact = sum<std::int64_t>(rows[i], v);
        return narrowed_element<raw, range>(shift_right<Rounding>(exact, fraction));
      }
    }
    const auto exact = sum<signed_t<2 * signed_bits<raw> + 2>>(rows[i], v);
    return narrowed_element<raw, range>(shift_right<Rounding>(exact, fraction));
  }

 private:
  using row_type = std::array<Number, 4>;

  /// Whether every sum of a row, and that plus 2^fraction, is below 2^(2 bits - 1) in magnitude.
  ///
  /// Let s be the sum of the magnitudes of the factors, and c that of the translation plus 1. Then
  /// the sum is at most 2^(bits - 1) s + 2^fraction c, and that is below
  /// 2^(bits - 1) (s + floor(2^fraction c / 2^(bits - 1)) + 1).
  static constexpr bool sums_fit(const row_type& by) noexcept {
    if constexpr (std::is_unsigned_v<raw> || bits > 32) {
      return false;
    } else {
      const auto magnitude = [&by](std::size_t k) {
        const std::int64_t x{by[k].raw()};
        return static_cast<std::uint64_t>(x < 0 ? -x : x);
      };
      const std::uint64_t factors = magnitude(0) + magnitude(1) + magnitude(2);
      const std::uint64_t rest = ((magnitude(3) + 1) << fraction) >> (bits - 1);
      return factors + rest < std::uint64_t{1} << bits;
    }
  }

  template <class Wide>
  static constexpr Wide sum(const row_type& by, const raw_vertex<Number>& v) noexcept {
    Wide all = static_cast<Wide>(by[3].raw()) << fraction;
    for (std::size_t k = 0; k < 3; ++k) {
      all = all + static_cast<Wide>(by[k].raw()) * static_cast<Wide>(v[k]);
    }
    return all;
  }
};

/// Returns a transformed vertex and the first fault of its coordinates.
template <class Number, template <class> class Transform>
FIXED_ALWAYS_INLINE constexpr outcome<raw_vertex<Number>> transformed(
    const Transform<Number>& by, const raw_vertex<Number>& v) noexcept {
  const auto x = by.row(0, v);
  const auto y = by.row(1, v);
  const auto z = by.row(2, v);
  return {{x.raw, y.raw, z.raw}, first_of(x.what, first_of(y.what, z.what))};
}

}  // namespace fixproof::detail
