/// \file
/// Expected outcomes under each policy from tests/support/exact.hpp, and the edge operands. Of
/// fixed/ this header takes only the names of the rules and of the errors.
#pragma once

#include <cstdint>
#include <limits>
#include <ostream>
#include <random>
#include <vector>

#include "fixed/number.hpp"
#include "fixed/text.hpp"
#include "tests/support/exact.hpp"

namespace exact {

/// x modulo 2^64. Boost's own conversion saturates on machines without 128-bit integers.
inline std::int64_t low_word(integer x) { return static_cast<std::int64_t>(wrapped(x, 64)); }

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
  constexpr int bits = std::numeric_limits<raw>::digits + 1;
  if (Number::rules.range == fixproof::overflow::trap && wrapped(value, bits) != value) {
    return {true, 0};
  }
  return {false, static_cast<raw>(narrowed(value, bits, Number::rules.range))};
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
  const fixproof::policy rules = Number::rules;
  integer divisor = d.raw();
  if (rules.divisor == fixproof::divisor_width::whole_part) divisor = divisor / one<Number>;
  return divisor == 0 || (rules.fault == fixproof::divide_fault::unsigned_quotient &&
                          (n.raw() < 0 ? -integer{n.raw()} : integer{n.raw()}) / one<Number> >=
                              (divisor < 0 ? -divisor : divisor));
}

/// n / d by the definition of the policy. A zero divisor that is no error gives the end of the
/// range.
template <class Number>
outcome<Number> quotient(Number n, Number d) {
  using raw = typename Number::raw_type;
  const fixproof::policy rules = Number::rules;
  integer numerator = integer{n.raw()} * one<Number>;
  integer divisor = d.raw();
  if (rules.divisor == fixproof::divisor_width::whole_part) {
    numerator = n.raw();
    divisor = divisor / one<Number>;
  }
  if (divisor == 0 && rules.fault == fixproof::divide_fault::none &&
      rules.range != fixproof::overflow::trap) {
    if (n.raw() == 0) return {false, 0};
    return {false, n.raw() > 0 ? std::numeric_limits<raw>::max() : std::numeric_limits<raw>::min()};
  }
  if (no_quotient(n, d)) return {true, 0};
  const integer value = round(ratio(numerator, divisor), rules.divide);
  if (rules.fault == fixproof::divide_fault::signed_quotient &&
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
  } catch (const fixproof::overflow_error&) {
  } catch (const fixproof::divide_error&) {
  } catch (const fixproof::domain_error&) {
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
