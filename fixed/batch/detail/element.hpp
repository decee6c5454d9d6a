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

#include "fixed/batch/vectorizable.hpp"
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

/// The outcome of an operation on numbers Number.
template <class Number>
using outcome_of = outcome<typename Number::raw_type>;

/// The first of two faults.
constexpr fault first_of(fault a, fault b) noexcept { return a != fault::none ? a : b; }

/// The overflow rule inside a batch: wrap instead of throwing, because the report records the
/// overflow.
template <overflow Overflow>
inline constexpr overflow range_in_batch =
    Overflow == overflow::saturate ? overflow::saturate : overflow::wrap;

/// Narrows a result that may be out of range. Under overflow::wrap it reports no fault.
template <class Raw, overflow Overflow, class Wide>
constexpr outcome<Raw> narrowed_element(const Wide& value) noexcept {
  fault what = fault::none;
  if constexpr (Overflow != overflow::wrap) {
    if (!fits<Raw>(value)) what = fault::overflow;
  }
  return {narrow<range_in_batch<Overflow>, Raw>(value, [] {}), what};
}

template <class Number>
constexpr outcome_of<Number> multiplied(Number a, Number b) noexcept {
  return narrowed_element<typename Number::raw_type, Number::rules.product_range()>(
      rounded_product<Number::fraction_bits, Number::rules.multiply>(a.raw(), b.raw()));
}

template <class Number>
constexpr outcome_of<Number> multiplied_and_added(Number a, Number b, Number c) noexcept {
  return narrowed_element<typename Number::raw_type, Number::rules.product_range()>(
      rounded_mul_add<Number::fraction_bits, Number::rules.multiply>(a.raw(), b.raw(), c.raw()));
}

/// The result of the scalar divide, or the wrapped result if the scalar divide throws.
template <class Raw, int Point, policy Rules>
constexpr outcome<Raw> divided(number<Raw, Point, Rules> n, number<Raw, Point, Rules> d) noexcept {
  const divisor_t<Raw> divisor = effective_divisor<Raw, Point, Rules>(d.raw());
  if (divisor == divisor_t<Raw>{0}) {
    return {total_divide<Raw, Point, Rules>(n.raw(), d.raw()), fault::divide_error};
  }
  const auto quotient = quotient_of<Raw, Point, Rules>(n.raw(), divisor);
  outcome<Raw> result = narrowed_element<Raw, Rules.quotient_range()>(quotient);
  const division end = ending_of<Raw, Point, Rules>(n.raw(), divisor, quotient);
  if (end == division::divide_error) result.what = fault::divide_error;
  return result;
}

/// Tells whether divided() may report a fault under a policy that never throws: if the divisor is
/// zero, or if the policy saturates and the result is an end of the range. Has no branch.
template <class Raw, int Point, policy Rules>
constexpr bool may_be_fault(number<Raw, Point, Rules> d, Raw result) noexcept {
  using limits = std::numeric_limits<Raw>;
  bool may = effective_divisor<Raw, Point, Rules>(d.raw()) == divisor_t<Raw>{0};
  if constexpr (Rules.quotient_range() == overflow::saturate) {
    may |= result == (limits::min)();
    may |= result == (limits::max)();
  }
  return may;
}

/// Converts a floating-point number to a number. Infinities wrap to the ends of the range.
template <class Number, binary_float Float>
constexpr outcome_of<Number> from_float(Float value) noexcept {
  using raw = typename Number::raw_type;
  using wide = signed_t<larger(64, 2 * bits_of<raw>)>;
  using kind = typename scaled_float<wide>::kind;
  constexpr overflow Overflow = Number::rules.range;
  const auto x = scale<Number::rules.multiply, wide>(value, Number::fraction_bits);
  if (x.what == kind::nan) return {0, fault::domain_error};
  if (x.what == kind::finite) return narrowed_element<raw, Overflow>(x.integer);
  using limits = std::numeric_limits<raw>;
  const raw end = x.negative ? (limits::min)() : (limits::max)();
  return {
      x.what == kind::beyond && Overflow != overflow::saturate ? static_cast<raw>(x.integer) : end,
      Overflow == overflow::wrap ? fault::none : fault::overflow};
}

/// The conversion as an element.
template <class Number>
struct from_float_element {
  template <class Float>
  constexpr outcome_of<Number> operator()(std::size_t i, const Float* from) const noexcept {
    return from_float<Number>(from[i]);
  }

  /// See few_elements().
  template <class Float>
  requires(has_vector_conversion<Number>) std::int64_t quick(std::size_t i, const Float* from)
  const noexcept { return rounded_ulps<Number>(from[i]); }
};

/// Computes element i + k for every bit k that is set in `missing`, and records its fault.
template <class Number, class Float, class Recorder>
void missing_from_floats(const void* from, void* to, std::size_t i, std::uint32_t missing,
                         Recorder& found) noexcept {
  for (; missing != 0; missing &= missing - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(missing));
    const auto one = from_float<Number>(static_cast<const Float*>(from)[i + k]);
    static_cast<Number*>(to)[i + k] = Number::from_raw(one.raw);
    found.note(one.what, i + k);
  }
}

/// Returns a stored integer as a number Type, or a floating-point number as it is.
template <class Type, class Raw>
constexpr Type stored(Raw raw) noexcept {
  if constexpr (std::is_floating_point_v<Type>) {
    return raw;
  } else {
    return Type::from_raw(raw);
  }
}

template <class Number>
constexpr outcome_of<Number> rooted(Number x) noexcept {
  using raw = typename Number::raw_type;
  if (x.raw() < 0) return {0, fault::domain_error};
  constexpr int Point = Number::fraction_bits;
  constexpr overflow range =
      has_every_root<raw, Point> ? overflow::wrap : function_range<Number::rules.range>;
  return narrowed_element<raw, range>(stored_root<Number::rules.functions, Point>(x.raw()));
}

/// Returns coordinate / depth * constant.
template <class Number>
constexpr outcome_of<Number> projected(Number coordinate, Number depth, Number constant) noexcept {
  const outcome_of<Number> quotient = divided(coordinate, depth);
  const outcome_of<Number> product = multiplied(Number::from_raw(quotient.raw), constant);
  return {product.raw, first_of(quotient.what, product.what)};
}

/// Returns a projected point. A divide error in either coordinate takes precedence over an overflow
/// in the other.
template <class Number>
constexpr outcome<std::array<typename Number::raw_type, 2>> projected_point(
    Number constant, const std::array<typename Number::raw_type, 3>& v) noexcept {
  const auto x = projected(Number::from_raw(v[0]), Number::from_raw(v[2]), constant);
  const auto y = projected(Number::from_raw(v[1]), Number::from_raw(v[2]), constant);
  const bool error = x.what == fault::divide_error || y.what == fault::divide_error;
  return {{x.raw, y.raw}, error ? fault::divide_error : first_of(x.what, y.what)};
}

}  // namespace fixproof::detail
