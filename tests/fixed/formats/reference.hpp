/// @file
/// The exact result of every operation in every format, by definition, from integers of 1,024 bits.
/// Of fixed/ this header takes only the names of the rules and errors.
///
/// What is expected of a number type is computed from a description of the type at run time, so
/// that it is compiled once and not for each of dozens of types.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "fixed/error.hpp"
#include "tests/fixed/formats/integer.hpp"
#include "tests/support/number_rules.hpp"

namespace reference {

using exact::below;
using exact::Fault;
using exact::narrowed;
using exact::returned;
using exact::round;

/// The nearest integer to sqrt(n). @pre n >= 0
integer root(const integer& n);

/// The stored integer of a number of any type, extended to 64 bits by its sign.
using Word = std::uint64_t;
template <class N>
Word word_of(N x) {
  return static_cast<Word>(x.raw());
}
template <class N>
N number_of(Word word) {
  return N::from_raw(static_cast<typename N::raw_type>(word));
}

/// A number type at run time.
struct Type : exact::NumberType<integer> {
  template <class N>
  static Type of() {
    return {NumberType::of<N>()};
  }

  /// A stored integer from the low bits of `value`.
  [[nodiscard]] Word word(std::uint64_t value) const;
  /// @pre fits(x)
  [[nodiscard]] Word stored(const integer& x) const;
  [[nodiscard]] integer value(Word stored) const;
};
std::ostream& operator<<(std::ostream& out, const Type& type);

using Result = exact::Result<integer>;

/// A sum of products of stored integers.
Result product(const Type& type, const integer& sum);
/// n / d, by the definition of every rule in fixed/policy.hpp.
Result quotient(const Type& type, const integer& n, const integer& d);

/// A stored integer, or nothing for an error.
using Returned = std::optional<integer>;

/// An exact result in units of the type, under the rule.
Returned in_range(const Type& type, const integer& value, fixproof::overflow rule);
/// The same for products and quotients, under the rules of the type.
Returned returned_product(const Type& type, const integer& sum);
Returned returned_quotient(const Type& type, const integer& n, const integer& d);

/// Nothing if the outcome of a call on numbers of the type is as expected, or else both.
std::string difference(const Type& type, const std::optional<Word>& got, const Returned& expected);

/// The digits with a point before the last `places` of them.
std::string with_point(std::string digits, int places);

/// Stored integers and their type, for the message of a failure.
std::string listed(const Type& type, const std::vector<Word>& words);

/// The outcome of a call that may throw one of fixed's errors.
template <class Call>
std::optional<std::invoke_result_t<Call>> outcome(const Call& call) {
  try {
    return call();
  } catch (const fixproof::overflow_error&) {
  } catch (const fixproof::divide_error&) {
  } catch (const fixproof::domain_error&) {
  }
  return std::nullopt;
}

/// Stored integers at the edges: 0, the ends, powers of two with their neighbours, both signs; then
/// random ones of every length.
std::vector<Word> operands(const Type& type, int random_count);
/// The same without repetitions, for tests of all pairs.
std::vector<Word> distinct_operands(const Type& type, int random_count);

}  // namespace reference
