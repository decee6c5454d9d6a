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
#include <cstddef>
#include <cstdint>
#include <optional>
#include <ostream>
#include <type_traits>
#include <vector>

#include "fixed/error.hpp"
#include "fixed/policy.hpp"

namespace reference {

using integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<1024, 1024, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked, void>,
    boost::multiprecision::et_off>;

inline integer power(int base, int exponent) {
  if (base == 2) return integer(1) << exponent;
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

/// A number type at run time, so that what is expected of it is compiled once for all types.
struct Type {
  std::size_t size;
  bool is_signed;
  int fraction_bits;
  fixproof::policy rules;

  template <class N>
  static constexpr Type of() {
    return {sizeof(N), std::is_signed_v<typename N::raw_type>, N::fraction_bits, N::rules};
  }
  [[nodiscard]] int bits() const { return static_cast<int>(8 * size); }
  [[nodiscard]] integer one() const { return power(2, fraction_bits); }
  [[nodiscard]] integer count() const { return power(2, bits()); }
  [[nodiscard]] integer lowest() const { return is_signed ? -power(2, bits() - 1) : integer(0); }
  [[nodiscard]] integer highest() const { return power(2, is_signed ? bits() - 1 : bits()) - 1; }
  [[nodiscard]] bool fits(const integer& x) const { return x >= lowest() && x <= highest(); }
  [[nodiscard]] integer wrapped(const integer& x) const {
    return x - count() * below(x - lowest(), count());
  }
  /// The low bits of a word, extended to 64 bits.
  [[nodiscard]] std::uint64_t extended(std::uint64_t word) const {
    const int above = 64 - bits();
    return is_signed ? static_cast<std::uint64_t>(static_cast<std::int64_t>(word << above) >> above)
                     : word << above >> above;
  }
  /// The stored integer of a word that was extended to 64 bits.
  [[nodiscard]] integer raw(std::uint64_t word) const {
    return is_signed ? integer(static_cast<std::int64_t>(word)) : integer(word);
  }
};
std::ostream& operator<<(std::ostream& out, const Type& type);

/// A stored integer, or nothing for an error.
using result = std::optional<integer>;

/// The value of a stored integer by the overflow rule.
result in_range(const Type& type, const integer& value, fixproof::overflow rule);
/// n / d, by the definition of every rule in fixed/policy.hpp.
result quotient(const Type& type, const integer& n, const integer& whole_divisor);
/// The stored integer as a word.
template <class N>
std::uint64_t word(N x) {
  return static_cast<std::uint64_t>(x.raw());
}
template <class N>
N number(std::uint64_t word) {
  return N::from_raw(static_cast<typename N::raw_type>(word));
}

/// \name The same for a type at compile time
/// \{
template <class N>
result in_range(const integer& value, fixproof::overflow rule) {
  return in_range(Type::of<N>(), value, rule);
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
result quotient(const integer& n, const integer& whole_divisor) {
  return quotient(Type::of<N>(), n, whole_divisor);
}
/// \}

/// The nearest integer to sqrt(n). \pre n >= 0
inline integer root(const integer& n) {
  const integer r = boost::multiprecision::sqrt(n);
  return n - r * r > r ? r + 1 : r;
}

/// The outcome of a call that returns a stored integer and may throw one of fixed's errors.
template <class Call>
result outcome_of(const Call& call) {
  try {
    return call();
  } catch (const fixproof::overflow_error&) {
  } catch (const fixproof::divide_error&) {
  } catch (const fixproof::domain_error&) {
  }
  return std::nullopt;
}
template <class Call>
result outcome(const Call& call) {
  return outcome_of([&] { return integer(call().raw()); });
}

/// Stored integers at the edges: 0, the ends, powers of two with their neighbours, both signs; then
/// random ones of every length. As words, of which a type takes its low bits.
std::vector<std::uint64_t> words(int bits, int random_count);

template <class N>
std::vector<N> operands(int random_count) {
  std::vector<N> values;
  for (const std::uint64_t value : words(8 * sizeof(N), random_count)) {
    values.push_back(number<N>(value));
  }
  return values;
}

}  // namespace reference
