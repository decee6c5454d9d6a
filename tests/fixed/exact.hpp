/// \file
/// Expected results as exact fractions of 128-bit integers, rounded by the definition of each rule,
/// and the edge operands. This header shares only the names of the rules with fixed/.
#pragma once

#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "fixed/number.hpp"
#include "fixed/policy.hpp"
#include "fixed/text.hpp"
#ifndef __SIZEOF_INT128__
#include <boost/multiprecision/cpp_int.hpp>
#endif

namespace exact {

#ifdef __SIZEOF_INT128__
__extension__ using integer = __int128;
#else
using integer = boost::multiprecision::int128_t;
#endif

/// numerator / denominator, with a positive denominator.
struct fraction {
  integer numerator;
  integer denominator;
};

inline fraction ratio(integer n, integer d) { return d < 0 ? fraction{-n, -d} : fraction{n, d}; }

/// The greatest integer not above x.
inline integer below(fraction x) {
  integer k = x.numerator / x.denominator;
  if (k * x.denominator > x.numerator) --k;
  return k;
}

/// x rounded by the rule to one of the two integers around it.
inline integer round(fraction x, fixed::rounding rule) {
  const integer low = below(x);
  if (low * x.denominator == x.numerator) return low;
  const integer to_low = x.numerator - low * x.denominator;
  const integer to_high = x.denominator - to_low;
  const bool positive = x.numerator > 0;
  switch (rule) {
    case fixed::rounding::floor:
      return low;
    case fixed::rounding::truncate:
      return positive ? low : low + 1;
    case fixed::rounding::half_up:
      return to_low < to_high ? low : low + 1;
    case fixed::rounding::half_away:
      if (to_low == to_high) return positive ? low + 1 : low;
      return to_low < to_high ? low : low + 1;
  }
  return 0;
}

/// x modulo 2^64. Boost's own conversion saturates on machines without 128-bit integers.
inline std::int64_t low_word(integer x) {
  const integer count = integer{1} << 64;
  const integer rest = x % count;
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(rest < 0 ? rest + count : rest));
}

/// The outcome of an exact result under a policy: a stored integer or an exception.
template <class Number>
struct outcome {
  bool throws = false;
  typename Number::raw_type raw = 0;

  friend bool operator==(const outcome&, const outcome&) = default;
  friend std::ostream& operator<<(std::ostream& out, const outcome& x) {
    return x.throws ? out << "throws" : out << Number::from_raw(x.raw) << " (raw " << x.raw << ')';
  }
};

template <class Number>
outcome<Number> in_range(integer value) {
  using raw = typename Number::raw_type;
  const integer lowest = std::numeric_limits<raw>::min();
  const integer highest = std::numeric_limits<raw>::max();
  const integer count = highest - lowest + 1;
  if (value >= lowest && value <= highest) return {false, static_cast<raw>(value)};
  switch (Number::rules.range) {
    case fixed::overflow::trap:
      return {true, 0};
    case fixed::overflow::saturate:
      return {false, static_cast<raw>(value < lowest ? lowest : highest)};
    case fixed::overflow::wrap:
      break;
  }
  integer rest = (value - lowest) % count;
  if (rest < 0) rest += count;
  return {false, static_cast<raw>(lowest + rest)};
}

/// x, in ulps, rounded by the policy's rule for products.
template <class Number>
outcome<Number> result(fraction x) {
  return in_range<Number>(round(x, Number::rules.multiply));
}

template <class Number>
inline constexpr std::int64_t one = std::int64_t{1} << Number::fraction_bits;

/// Whether n / d is an error, by the definition of each divide_fault.
template <class Number>
bool no_quotient(Number n, Number d) {
  const fixed::policy rules = Number::rules;
  integer divisor = d.raw();
  if (rules.divisor == fixed::divisor_width::whole_part) divisor = divisor / one<Number>;
  return divisor == 0 || (rules.fault == fixed::divide_fault::unsigned_quotient &&
                          (n.raw() < 0 ? -integer{n.raw()} : integer{n.raw()}) / one<Number> >=
                              (divisor < 0 ? -divisor : divisor));
}

/// n / d by the definition of the policy. A zero divisor that is no error gives the end of the
/// range.
template <class Number>
outcome<Number> quotient(Number n, Number d) {
  using raw = typename Number::raw_type;
  const fixed::policy rules = Number::rules;
  integer numerator = integer{n.raw()} * one<Number>;
  integer divisor = d.raw();
  if (rules.divisor == fixed::divisor_width::whole_part) {
    numerator = n.raw();
    divisor = divisor / one<Number>;
  }
  if (divisor == 0 && rules.fault == fixed::divide_fault::none &&
      rules.range != fixed::overflow::trap) {
    if (n.raw() == 0) return {false, 0};
    return {false, n.raw() > 0 ? std::numeric_limits<raw>::max() : std::numeric_limits<raw>::min()};
  }
  if (no_quotient(n, d)) return {true, 0};
  const integer value = round(ratio(numerator, divisor), rules.divide);
  if (rules.fault == fixed::divide_fault::signed_quotient &&
      (value < std::numeric_limits<raw>::min() || value > std::numeric_limits<raw>::max())) {
    return {true, 0};
  }
  return in_range<Number>(value);
}

/// The outcome of a call that may throw one of fixed's errors.
template <class Number, class Call>
outcome<Number> run(const Call& call) {
  try {
    return {false, call().raw()};
  } catch (const fixed::overflow_error&) {
  } catch (const fixed::divide_error&) {
  } catch (const fixed::domain_error&) {
  }
  return {true, 0};
}

/// Stored integers at the edges: 0, the range ends, the halves, and every power of two with its
/// neighbours, each with both signs.
template <class Number>
std::vector<Number> edges() {
  using raw = typename Number::raw_type;
  std::vector<Number> values;
  const auto add = [&values](std::int64_t value) {
    values.push_back(Number::from_raw(static_cast<raw>(value)));
  };
  for (int bit = 0; bit <= std::numeric_limits<raw>::digits; ++bit) {
    for (const int step : {-1, 0, 1}) {
      add((std::int64_t{1} << bit) + step);
      add(-(std::int64_t{1} << bit) + step);
    }
  }
  for (const std::int64_t value : {3, 5, 7, 10, 100, 181, 46341, 0x8000 * 3, 0x5555, 0x12345678}) {
    add(value);
    add(-value);
  }
  return values;
}

}  // namespace exact
