/// @file
/// Expected outcomes under each policy from tests/support/exact.hpp, and the edge operands. Of
/// fixed/ this header takes only the names of the rules and of the errors.
#pragma once

#include <cmath>
#include <cstdint>
#include <iomanip>
#include <limits>
#include <optional>
#include <ostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "fixed/number.hpp"
#include "fixed/text.hpp"
#include "tests/support/exact.hpp"

namespace exact {

/// x modulo 2^64. Boost's own conversion saturates on machines without 128-bit integers.
inline std::int64_t low_word(integer x) { return static_cast<std::int64_t>(wrapped(x, 64)); }

using Type = NumberType<integer>;

/// A stored integer or an exception.
struct Outcome {
  bool throws = false;
  std::int64_t raw = 0;

  static Outcome of(const std::optional<integer>& x) {
    return {!x, x ? static_cast<std::int64_t>(*x) : 0};
  }
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// The outcome of an exact result under a policy.
inline Outcome in_range(const Type& type, const integer& value) {
  const fixproof::overflow rule = type.rules.range;
  return Outcome::of(returned(type, narrowed(type, value, rule), rule));
}

/// x, in ulps, rounded by the policy's rule for products.
inline Outcome result(const Type& type, const fraction& x) {
  return in_range(type, round(x, type.rules.multiply));
}

/// The outcome of operator/ that has this result.
inline Outcome outcome_of_quotient(const Type& type, const Result<integer>& result) {
  return Outcome::of(returned(type, result, type.rules.quotient_range()));
}
inline Outcome quotient(const Type& type, const integer& n, const integer& d) {
  return outcome_of_quotient(type, policy_quotient(type, n, d));
}

/// The outcome of a call that returns a stored integer and may throw one of fixed's errors.
template <class Call>
Outcome outcome_of(const Call& call) {
  try {
    return {false, call()};
  } catch (const fixproof::overflow_error&) {
  } catch (const fixproof::divide_error&) {
  } catch (const fixproof::domain_error&) {
  }
  return {true, 0};
}

/// A number for messages, in all its digits.
inline std::string text(const Type& type, std::int64_t raw) {
  std::ostringstream out;
  out << std::setprecision(40) << std::ldexp(static_cast<double>(raw), -type.fraction_bits)
      << " (raw " << raw << ')';
  return out.str();
}
inline std::string text(const Type& type, const Outcome& x) {
  return x.throws ? "throws" : text(type, x.raw);
}

/// @name The same for a number type at compile time
/// \{
template <class Number>
struct outcome {
  bool throws = false;
  typename Number::raw_type raw = 0;

  static outcome of(const Outcome& x) {
    return {x.throws, static_cast<typename Number::raw_type>(x.raw)};
  }
  friend bool operator==(const outcome&, const outcome&) = default;
  friend std::ostream& operator<<(std::ostream& out, const outcome& x) {
    return out << text(Type::of<Number>(), Outcome{x.throws, x.raw});
  }
};

template <class Number>
outcome<Number> in_range(integer value) {
  return outcome<Number>::of(in_range(Type::of<Number>(), value));
}

template <class Number>
outcome<Number> result(fraction x) {
  return outcome<Number>::of(result(Type::of<Number>(), x));
}

template <class Number>
inline constexpr std::int64_t one = std::int64_t{1} << Number::fraction_bits;

template <class Number>
outcome<Number> quotient(Number n, Number d) {
  return outcome<Number>::of(quotient(Type::of<Number>(), n.raw(), d.raw()));
}

template <class Number, class Call>
outcome<Number> run(const Call& call) {
  try {
    return {false, call().raw()};
  } catch (const fixproof::overflow_error&) {
  } catch (const fixproof::divide_error&) {
  } catch (const fixproof::domain_error&) {
  }
  return {true, 0};
}
/// \}

/// Stored integers at the edges: 0, the range ends, the halves, and every power of two with its
/// neighbours, each with both signs.
inline std::vector<std::int64_t> edges(const Type& type) {
  std::vector<std::int64_t> values;
  const auto add = [&](std::int64_t value) {
    values.push_back(static_cast<std::int64_t>(type.wrapped(value)));
  };
  for (int bit = 0; bit < type.bits(); ++bit) {
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

template <class Number>
std::vector<Number> edges() {
  std::vector<Number> numbers;
  for (const std::int64_t raw : edges(Type::of<Number>())) {
    numbers.push_back(Number::from_raw(static_cast<typename Number::raw_type>(raw)));
  }
  return numbers;
}

template <class Number>
struct Quotient {
  Number n, d;
};

/// Pairs whose quotient lies within 1 / (2 d) ulp of an integer or a half, in every combination of
/// signs, and random pairs. The divisors are edges, below 1, or random.
template <class Number>
std::vector<Quotient<Number>> near_misses() {
  using limits = std::numeric_limits<typename Number::raw_type>;
  std::mt19937_64 random(20);
  std::vector<Quotient<Number>> pairs;
  const auto number = [](integer raw) {
    return Number::from_raw(static_cast<typename Number::raw_type>(raw));
  };
  const auto add = [&](integer n, integer d) {
    if (wrapped(n, limits::digits + 1) != n || wrapped(d, limits::digits + 1) != d) return;
    pairs.push_back({number(n), number(d)});
  };
  const auto around = [&](integer d) {
    for (int bits = 1; bits <= limits::digits; bits += 2) {
      const auto half_units = static_cast<integer>(random() >> (63 - bits));
      for (const integer k : {half_units, half_units | 1}) {
        const integer n = k * d / (2 * one<Number>);
        for (const int step : {-1, 0, 1}) {
          add(n + step, d);
          add(-n + step, d);
        }
      }
    }
  };
  const auto drawn = [&] { return static_cast<std::int64_t>(random()) >> (63 - limits::digits); };
  for (const auto edge : edges<Number>()) around(edge.raw());
  for (int i = 0; i < 200; ++i) around(drawn());
  for (int i = 0; i < 60; ++i) {
    around(static_cast<std::int64_t>(random() % (2 * one<Number>)));
    around(static_cast<std::int64_t>(random()) >> (random() % 32 + 32));
  }
  for (int i = 0; i < 4000; ++i) {
    add(drawn(), drawn());
    add(drawn() >> (random() % 24), drawn() >> (random() % 24));
  }
  return pairs;
}

}  // namespace exact
