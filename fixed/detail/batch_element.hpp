/// \file
/// One element of a batch: its result and its fault.
///
/// The portable path uses only this. Every other path uses it for the last few elements.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "fixed/detail/divide.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/rounding.hpp"
#include "fixed/detail/square_root.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// The faults that a batch report counts. An element with several faults counts for the first.
enum class fault : std::uint8_t { none, divide_error, overflow, domain_error };

/// The rows of a transform as stored integers; the fourth column is the translation.
template <int FractionBits>
using raw_transform = std::array<std::array<raw_t<FractionBits>, 4>, 3>;

/// A stored integer, or those of a vertex, and the fault.
template <class Raw>
struct outcome {
  Raw raw;
  fault what = fault::none;
};

/// The first of two faults.
constexpr fault first_of(fault a, fault b) noexcept { return a != fault::none ? a : b; }

/// The overflow rule inside a batch: wrap instead of throwing, because the report records the
/// overflow.
template <policy P>
inline constexpr overflow range_in_batch =
    P.range == overflow::saturate ? overflow::saturate : overflow::wrap;

/// Narrows a result that may be out of range. Under overflow::wrap it reports no fault.
template <int F, policy P, class Wide>
constexpr outcome<raw_t<F>> narrowed_element(Wide value) noexcept {
  using raw = raw_t<F>;
  fault what = fault::none;
  if constexpr (P.range != overflow::wrap) {
    if (!fits<raw>(value)) what = fault::overflow;
  }
  return {narrow<range_in_batch<P>, raw>(value, [] {}), what};
}

template <int F, policy P>
constexpr outcome<raw_t<F>> multiplied(raw_t<F> a, raw_t<F> b) noexcept {
  using wide = product_t<raw_t<F>>;
  return narrowed_element<F, P>(shift_right<P.multiply>(wide{a} * wide{b}, F));
}

template <int F, policy P>
constexpr outcome<raw_t<F>> multiplied_and_added(raw_t<F> a, raw_t<F> b, raw_t<F> c) noexcept {
  using wide = product_t<raw_t<F>>;
  const wide sum = wide{a} * wide{b} + wide{c} * (wide{1} << F);
  return narrowed_element<F, P>(shift_right<P.multiply>(sum, F));
}

/// The result of the scalar divide, or the wrapped result if the scalar divide throws.
template <int F, policy P>
constexpr outcome<raw_t<F>> divided(raw_t<F> n, raw_t<F> d) noexcept {
  const std::int32_t divisor = effective_divisor<raw_t<F>, F, P>(d);
  if (divisor == 0) return {total_divide<raw_t<F>, F, P>(n, d), fault::divide_error};
  const std::int64_t quotient = rounded_quotient<P.divide, numerator_shift<F, P>>(n, divisor);
  outcome<raw_t<F>> result = narrowed_element<F, P>(quotient);
  const division end = ending_of<raw_t<F>, F, P>(n, divisor, quotient);
  if (end == division::divide_error) result.what = fault::divide_error;
  return result;
}

/// Whether divided() may report a fault under a policy that never throws: the divisor is zero or
/// the result is an end of the range. Has no branch.
template <int F, policy P>
constexpr bool may_be_fault(raw_t<F> d, raw_t<F> result) noexcept {
  using limits = std::numeric_limits<raw_t<F>>;
  bool may = effective_divisor<raw_t<F>, F, P>(d) == 0;
  if constexpr (P.range == overflow::saturate) {
    may |= result == (limits::min)();
    may |= result == (limits::max)();
  }
  return may;
}

template <int F>
constexpr outcome<raw_t<F>> rooted(raw_t<F> x) noexcept {
  if (x < 0) return {0, fault::domain_error};
  return {static_cast<raw_t<F>>(nearest_sqrt(std::int64_t{x} * (std::int64_t{1} << F)))};
}

/// One row of a transform applied to a vertex: each product rounded, then summed from the left.
template <int F, policy P>
constexpr outcome<raw_t<F>> transformed(const std::array<raw_t<F>, 4>& row,
                                        const std::array<raw_t<F>, 3>& v) noexcept {
  using wide = product_t<raw_t<F>>;
  outcome<raw_t<F>> sum = multiplied<F, P>(row[0], v[0]);
  const auto add = [&sum](const outcome<raw_t<F>>& term) {
    const outcome<raw_t<F>> next = narrowed_element<F, P>(wide{sum.raw} + wide{term.raw});
    sum = {next.raw, first_of(sum.what, first_of(term.what, next.what))};
  };
  add(multiplied<F, P>(row[1], v[1]));
  add(multiplied<F, P>(row[2], v[2]));
  add({row[3]});
  return sum;
}

/// coordinate / depth * constant.
template <int F, policy P>
constexpr outcome<raw_t<F>> projected(raw_t<F> coordinate, raw_t<F> depth,
                                      raw_t<F> constant) noexcept {
  const outcome<raw_t<F>> quotient = divided<F, P>(coordinate, depth);
  const outcome<raw_t<F>> product = multiplied<F, P>(quotient.raw, constant);
  return {product.raw, first_of(quotient.what, product.what)};
}

/// A transformed vertex and the first fault of its coordinates.
template <int F, policy P>
constexpr outcome<std::array<raw_t<F>, 3>> transformed_vertex(
    const raw_transform<F>& by, const std::array<raw_t<F>, 3>& v) noexcept {
  const auto x = transformed<F, P>(by[0], v);
  const auto y = transformed<F, P>(by[1], v);
  const auto z = transformed<F, P>(by[2], v);
  return {{x.raw, y.raw, z.raw}, first_of(x.what, first_of(y.what, z.what))};
}

/// A projected point. A divide error in either coordinate takes precedence over an overflow in the
/// other.
template <int F, policy P>
constexpr outcome<std::array<raw_t<F>, 2>> projected_point(
    raw_t<F> constant, const std::array<raw_t<F>, 3>& v) noexcept {
  const auto x = projected<F, P>(v[0], v[2], constant);
  const auto y = projected<F, P>(v[1], v[2], constant);
  const bool error = x.what == fault::divide_error || y.what == fault::divide_error;
  return {{x.raw, y.raw}, error ? fault::divide_error : first_of(x.what, y.what)};
}

}  // namespace fixproof::detail
