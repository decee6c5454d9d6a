/// \file
/// One element of a batch: what the number type makes of it, and what there is to report of it.
///
/// This is all of the portable path, and the last few elements of every other one.
#pragma once

#include <array>
#include <cstdint>

#include "fixed/detail/divide.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/square_root.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixed::detail {

/// What the report of a batch counts. Of several in one element the first counts.
enum class fault : std::uint8_t { none, divide_error, overflow, domain_error };

/// A stored integer and what was wrong with it.
template <int FractionBits>
struct outcome {
  raw_t<FractionBits> raw;
  fault what = fault::none;
};

/// The first of two faults.
constexpr fault first_of(fault a, fault b) noexcept { return a != fault::none ? a : b; }

/// What range rule takes the place of P's in a batch: one that throws wraps, and the report tells.
template <policy P>
inline constexpr overflow quiet_range =
    P.range == overflow::saturate ? overflow::saturate : overflow::wrap;

/// A result that may be out of range. Wrapping does not look.
template <int F, policy P, class Wide>
constexpr outcome<F> narrowed_element(Wide value) noexcept {
  using raw = raw_t<F>;
  fault what = fault::none;
  if constexpr (P.range != overflow::wrap) {
    if (!fits<raw>(value)) what = fault::overflow;
  }
  return {narrow<quiet_range<P>, raw>(value, [] {}), what};
}

template <int F, policy P>
constexpr outcome<F> multiplied(raw_t<F> a, raw_t<F> b) noexcept {
  using wide = wide_t<F>;
  return narrowed_element<F, P>(shift_right<P.multiply>(wide{a} * wide{b}, F));
}

template <int F, policy P>
constexpr outcome<F> multiplied_and_added(raw_t<F> a, raw_t<F> b, raw_t<F> c) noexcept {
  using wide = wide_t<F>;
  const wide sum = wide{a} * wide{b} + wide{c} * (wide{1} << F);
  return narrowed_element<F, P>(shift_right<P.multiply>(sum, F));
}

/// What the scalar divide returns; where it throws, what it would return if it wrapped instead.
template <int F, policy P>
constexpr outcome<F> divided(raw_t<F> n, raw_t<F> d) noexcept {
  const raw_t<F> quotient = total_divide<F, P>(n, d);
  const division end = try_division<F, P>(n, d);
  if (end == division::divide_error) return {quotient, fault::divide_error};
  if (end == division::out_of_range) return {quotient, fault::overflow};
  if constexpr (P.range == overflow::saturate) {
    const std::int32_t divisor = effective_divisor<F, P>(d);
    if (!fits<raw_t<F>>(rounded_quotient<P.divide, numerator_shift<F, P>>(n, divisor))) {
      return {quotient, fault::overflow};
    }
  }
  return {quotient};
}

template <int F>
constexpr outcome<F> rooted(raw_t<F> x) noexcept {
  if (x < 0) return {0, fault::domain_error};
  return {static_cast<raw_t<F>>(nearest_sqrt(std::int64_t{x} * (std::int64_t{1} << F)))};
}

/// One row of a transform applied to a vertex: each product rounded, then summed from the left.
template <int F, policy P>
constexpr outcome<F> transformed(const std::array<raw_t<F>, 4>& row,
                                 const std::array<raw_t<F>, 3>& v) noexcept {
  using wide = wide_t<F>;
  outcome<F> sum = multiplied<F, P>(row[0], v[0]);
  const auto add = [&sum](const outcome<F>& term) {
    const outcome<F> next = narrowed_element<F, P>(wide{sum.raw} + wide{term.raw});
    sum = {next.raw, first_of(sum.what, first_of(term.what, next.what))};
  };
  add(multiplied<F, P>(row[1], v[1]));
  add(multiplied<F, P>(row[2], v[2]));
  add({row[3]});
  return sum;
}

/// A coordinate over a depth, times a constant.
template <int F, policy P>
constexpr outcome<F> projected(raw_t<F> coordinate, raw_t<F> depth, raw_t<F> constant) noexcept {
  const outcome<F> quotient = divided<F, P>(coordinate, depth);
  const outcome<F> product = multiplied<F, P>(quotient.raw, constant);
  return {product.raw, first_of(quotient.what, product.what)};
}

}  // namespace fixed::detail
