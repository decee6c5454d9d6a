/// \file
/// The exact result of every operation in every format, by definition, from integers of 1,024 bits.
/// Of fixed/ this header takes only the names of the rules.
#pragma once

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/multiprecision/cpp_int.hpp>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "fixed/error.hpp"
#include "fixed/policy.hpp"

namespace reference {

using integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<1024, 1024, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

inline integer power(int base, int exponent) {
  return boost::multiprecision::pow(integer(base), static_cast<unsigned>(exponent));
}

inline integer below(const integer& n, const integer& d) {
  const integer quotient = n / d;
  return quotient * d > n ? quotient - 1 : quotient;
}

/// n / d rounded by the rule. \pre d > 0
inline integer round(const integer& n, const integer& d, fixproof::rounding rule) {
  using fixproof::rounding;
  const integer low = below(n, d);
  const integer twice = 2 * (n - low * d);
  if (twice == 0) return low;
  if (rule == rounding::floor) return low;
  if (rule == rounding::truncate) return n < 0 ? low + 1 : low;
  if (twice != d) return twice < d ? low : low + 1;
  const bool up = rule == rounding::half_up || (rule == rounding::half_away && n > 0) ||
                  (rule == rounding::half_even && low % 2 != 0);
  return up ? low + 1 : low;
}

/// A stored integer, or nothing for an error.
template <class N>
using result = std::optional<integer>;

/// The value of a stored integer by the overflow rule.
template <class N>
result<N> in_range(const integer& value, fixproof::overflow rule) {
  using limits = std::numeric_limits<typename N::raw_type>;
  const integer lowest = limits::min();
  const integer highest = limits::max();
  if (value >= lowest && value <= highest) return value;
  if (rule == fixproof::overflow::trap) return std::nullopt;
  if (rule == fixproof::overflow::saturate) return value < lowest ? lowest : highest;
  const integer count = highest - lowest + 1;
  return value - count * below(value - lowest, count);
}

template <class N>
integer raw(N x) {
  return integer(x.raw());
}

template <class N>
integer one() {
  return power(2, N::fraction_bits);
}

template <class N>
result<N> quotient(const integer& n, const integer& whole_divisor) {
  using fixproof::divide_fault;
  const integer zero = 0;
  constexpr fixproof::overflow rule = N::rules.quotient_range();
  constexpr divide_fault fault = N::rules.fault;
  integer d = whole_divisor;
  if (N::rules.divisor == fixproof::divisor_width::whole_part) d = d / one<N>() * one<N>();
  if (d == 0) {
    if (fault != divide_fault::none) return std::nullopt;
    if (rule == fixproof::overflow::trap) return std::nullopt;
    if (n == 0) return zero;
    return in_range<N>(n < 0 ? -power(2, 100) : power(2, 100), fixproof::overflow::saturate);
  }
  const integer scaled = n * one<N>();
  const integer magnitude = abs(scaled / d);
  if (fault == divide_fault::unsigned_quotient && magnitude >= power(2, 8 * sizeof(N))) {
    return std::nullopt;
  }
  const integer rounded =
      d < 0 ? round(-scaled, -d, N::rules.divide) : round(scaled, d, N::rules.divide);
  return in_range<N>(rounded,
                     fault == divide_fault::signed_quotient ? fixproof::overflow::trap : rule);
}

/// The nearest integer to sqrt(n). \pre n >= 0
inline integer root(const integer& n) {
  const integer r = boost::multiprecision::sqrt(n);
  return n - r * r > r ? r + 1 : r;
}

/// The outcome of a call that may throw one of fixed's errors.
template <class Call>
std::optional<integer> outcome(const Call& call) {
  try {
    return integer(call().raw());
  } catch (const fixproof::overflow_error&) {
  } catch (const fixproof::divide_error&) {
  } catch (const fixproof::domain_error&) {
  }
  return std::nullopt;
}

/// Stored integers at the edges: 0, the ends, powers of two with their neighbours, both signs; then
/// random ones of every length.
template <class N>
std::vector<N> operands(int random_count) {
  using raw = typename N::raw_type;
  std::vector<N> values;
  const auto add = [&values](std::uint64_t value) {
    values.push_back(N::from_raw(static_cast<raw>(value)));
  };
  for (int bit = 0; bit < std::numeric_limits<std::make_unsigned_t<raw>>::digits;
       bit += bit % 8 == 7 || bit % 8 == 6 ? 1 : 3) {
    const std::uint64_t power = std::uint64_t{1} << bit;
    for (const std::uint64_t value : {power - 1, power, power + 1}) {
      add(value);
      add(0 - value);
    }
  }
  std::mt19937_64 random(19);
  for (int i = 0; i < random_count; ++i) {
    const std::uint64_t value = random() >> (random() % 64);
    add(random() % 2 == 0 ? value : 0 - value);
  }
  return values;
}

}  // namespace reference
