/// @file
/// One element of a batch: its result and its fault.
///
/// The portable path uses only this. Every other path uses it for the last few elements.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "fixed/detail/divide.hpp"
#include "fixed/detail/exact.hpp"
#include "fixed/detail/floating.hpp"
#include "fixed/detail/integer.hpp"
#include "fixed/detail/overflow.hpp"
#include "fixed/detail/square_root.hpp"
#include "fixed/number.hpp"
#include "fixed/policy.hpp"

namespace fixproof::detail {

/// The faults that a batch report counts. An element with several faults counts for the first.
enum class fault : std::uint8_t { none, divide_error, overflow, domain_error };

/// A stored integer, or the stored integers of a vertex, and the fault.
template <class Raw>
struct outcome {
  Raw raw;
  fault what = fault::none;
};

/// The outcome of an operation on numbers N.
template <class N>
using outcome_of = outcome<typename N::raw_type>;

/// The first of two faults.
constexpr fault first_of(fault a, fault b) noexcept { return a != fault::none ? a : b; }

/// The overflow rule inside a batch: wrap instead of throwing, because the report records the
/// overflow.
template <overflow O>
inline constexpr overflow range_in_batch =
    O == overflow::saturate ? overflow::saturate : overflow::wrap;

/// Narrows a result that may be out of range. Under overflow::wrap it reports no fault.
template <class Raw, overflow O, class Wide>
constexpr outcome<Raw> narrowed_element(const Wide& value) noexcept {
  fault what = fault::none;
  if constexpr (O != overflow::wrap) {
    if (!fits<Raw>(value)) what = fault::overflow;
  }
  return {narrow<range_in_batch<O>, Raw>(value, [] {}), what};
}

template <class N>
constexpr outcome_of<N> multiplied(N a, N b) noexcept {
  return narrowed_element<typename N::raw_type, N::rules.product_range()>(
      rounded_product<N::fraction_bits, N::rules.multiply>(a.raw(), b.raw()));
}

template <class N>
constexpr outcome_of<N> multiplied_and_added(N a, N b, N c) noexcept {
  return narrowed_element<typename N::raw_type, N::rules.product_range()>(
      rounded_mul_add<N::fraction_bits, N::rules.multiply>(a.raw(), b.raw(), c.raw()));
}

/// The result of the scalar divide, or the wrapped result if the scalar divide throws.
template <class Raw, int F, policy P>
constexpr outcome<Raw> divided(number<Raw, F, P> n, number<Raw, F, P> d) noexcept {
  const divisor_t<Raw> divisor = effective_divisor<Raw, F, P>(d.raw());
  if (divisor == divisor_t<Raw>{0}) {
    return {total_divide<Raw, F, P>(n.raw(), d.raw()), fault::divide_error};
  }
  const auto quotient = quotient_of<Raw, F, P>(n.raw(), divisor);
  outcome<Raw> result = narrowed_element<Raw, P.quotient_range()>(quotient);
  const division end = ending_of<Raw, F, P>(n.raw(), divisor, quotient);
  if (end == division::divide_error) result.what = fault::divide_error;
  return result;
}

/// Tells whether divided() may report a fault under a policy that never throws: if the divisor is
/// zero, or if the policy saturates and the result is an end of the range. Has no branch.
template <class Raw, int F, policy P>
constexpr bool may_be_fault(number<Raw, F, P> d, Raw result) noexcept {
  using limits = std::numeric_limits<Raw>;
  bool may = effective_divisor<Raw, F, P>(d.raw()) == divisor_t<Raw>{0};
  if constexpr (P.quotient_range() == overflow::saturate) {
    may |= result == (limits::min)();
    may |= result == (limits::max)();
  }
  return may;
}

/// Converts a floating-point number to a number. Infinities wrap to the ends of the range.
template <class N, binary_float Float>
constexpr outcome_of<N> from_float(Float value) noexcept {
  using raw = typename N::raw_type;
  using wide = signed_t<larger(64, 2 * bits_of<raw>)>;
  using kind = typename scaled_float<wide>::kind;
  constexpr overflow O = N::rules.range;
  const auto x = scale<N::rules.multiply, wide>(value, N::fraction_bits);
  if (x.what == kind::nan) return {0, fault::domain_error};
  if (x.what == kind::finite) return narrowed_element<raw, O>(x.integer);
  using limits = std::numeric_limits<raw>;
  const raw end = x.negative ? (limits::min)() : (limits::max)();
  return {x.what == kind::beyond && O != overflow::saturate ? static_cast<raw>(x.integer) : end,
          O == overflow::wrap ? fault::none : fault::overflow};
}

/// Computes element i + k for every bit k that is set in `missing`, and records its fault.
template <class N, class Float, class Recorder>
void missing_from_floats(const void* from, void* to, std::size_t i, std::uint32_t missing,
                         Recorder& found) noexcept {
  for (; missing != 0; missing &= missing - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(missing));
    const auto one = from_float<N>(static_cast<const Float*>(from)[i + k]);
    static_cast<N*>(to)[i + k] = N::from_raw(one.raw);
    found.note(one.what, i + k);
  }
}

/// Returns a stored integer as a number T, or a floating-point number as it is.
template <class T, class Raw>
constexpr T stored(Raw raw) noexcept {
  if constexpr (std::is_floating_point_v<T>) {
    return raw;
  } else {
    return T::from_raw(raw);
  }
}

template <class N>
constexpr outcome_of<N> rooted(N x) noexcept {
  using raw = typename N::raw_type;
  if (x.raw() < 0) return {0, fault::domain_error};
  constexpr int F = N::fraction_bits;
  constexpr overflow range =
      has_every_root<raw, F> ? overflow::wrap : function_range<N::rules.range>;
  return narrowed_element<raw, range>(nearest_root<F>(x.raw()));
}

/// Returns coordinate / depth * constant.
template <class N>
constexpr outcome_of<N> projected(N coordinate, N depth, N constant) noexcept {
  const outcome_of<N> quotient = divided(coordinate, depth);
  const outcome_of<N> product = multiplied(N::from_raw(quotient.raw), constant);
  return {product.raw, first_of(quotient.what, product.what)};
}

/// Returns a projected point. A divide error in either coordinate takes precedence over an overflow
/// in the other.
template <class N>
constexpr outcome<std::array<typename N::raw_type, 2>> projected_point(
    N constant, const std::array<typename N::raw_type, 3>& v) noexcept {
  const auto x = projected(N::from_raw(v[0]), N::from_raw(v[2]), constant);
  const auto y = projected(N::from_raw(v[1]), N::from_raw(v[2]), constant);
  const bool error = x.what == fault::divide_error || y.what == fault::divide_error;
  return {{x.raw, y.raw}, error ? fault::divide_error : first_of(x.what, y.what)};
}

}  // namespace fixproof::detail
