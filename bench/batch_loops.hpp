/// \file
/// Each operation on one element for each kind of number, the loops that batches are compared with,
/// and the expected results from tests/support/exact.hpp.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "bench/batch_operands.hpp"
#include "fixed/fixed.hpp"
#include "tests/support/exact.hpp"

namespace batch_bench {

using Wide = exact::integer;

struct Rules {
  fixproof::policy by;
  int bits = 16;  ///< number of integer bits and of fraction bits

  [[nodiscard]] constexpr Wide one() const { return Wide{1} << bits; }

  /// Applies the overflow rule. Under a trapping rule, x must be in range.
  [[nodiscard]] constexpr Wide narrowed(Wide x) const {
    return exact::narrowed(x, 2 * bits, by.range);
  }

  /// A sum of products, rounded once.
  [[nodiscard]] constexpr Wide product(Wide sum) const {
    return narrowed(exact::round({sum, one()}, by.multiply));
  }
};

/// The rules of the type, of the plain idiom, and of float and double. The idiom rounds products
/// half up and truncates quotients as the processor does.
template <class T>
inline constexpr Rules rules_of{
    {.divide = std::is_integral_v<T> ? fixproof::rounding::truncate : fixproof::rounding::half_up},
    16};
template <class Raw, int F, fixproof::policy P>
inline constexpr Rules rules_of<fixproof::number<Raw, F, P>>{P, F};

struct Multiply {
  template <class T>
  static T of(T a, T b, T /*c*/) {
    if constexpr (std::is_integral_v<T>) {
      return static_cast<T>((std::int64_t{a} * b + 0x8000) >> 16);
    } else {
      return a * b;
    }
  }
  static Wide right(const Rules& rules, Wide a, Wide b, Wide /*c*/) { return rules.product(a * b); }
};
struct MulAdd {
  template <class T>
  static T of(T a, T b, T c) {
    if constexpr (std::is_integral_v<T>) {
      return static_cast<T>((std::int64_t{a} * b + std::int64_t{c} * 65536 + 0x8000) >> 16);
    } else if constexpr (std::is_floating_point_v<T>) {
      return a * b + c;
    } else {
      return fixproof::mul_add(a, b, c);
    }
  }
  static Wide right(const Rules& rules, Wide a, Wide b, Wide c) {
    return rules.product(a * b + c * rules.one());
  }
};
struct Divide {
  template <class T>
  static T of(T a, T b, T /*c*/) {
    if constexpr (std::is_integral_v<T>) {
      return static_cast<T>(std::int64_t{a} * 65536 / b);
    } else {
      return a / b;
    }
  }
  static Wide right(const Rules& rules, Wide a, Wide b, Wide /*c*/) {
    const bool whole = rules.by.divisor == fixproof::divisor_width::whole_part;
    const Wide divisor = whole ? b / rules.one() * rules.one() : b;
    if (divisor == 0)
      return exact::narrowed(a << 64U, 2 * rules.bits, fixproof::overflow::saturate);
    return rules.narrowed(exact::round(exact::ratio(a * rules.one(), divisor), rules.by.divide));
  }
};
struct Root {
  template <class T>
  static T of(T /*a*/, T /*b*/, T c) {
    if constexpr (std::is_floating_point_v<T>) {
      return std::sqrt(c);
    } else {
      return fixproof::sqrt(c);
    }
  }
  /// The r with (r - 1/2)^2 < c 2^bits < (r + 1/2)^2, by bisection; 0 for negative c.
  static Wide right(const Rules& rules, Wide /*a*/, Wide /*b*/, Wide c) {
    Wide low = 0;
    Wide high = Wide{1} << 24;
    while (low < high) {
      const Wide middle = (low + high) / 2;
      if ((2 * middle + 1) * (2 * middle + 1) > 4 * c * rules.one()) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return low;
  }
};

template <class Operation, class T>
[[gnu::noinline]] void apply(const T* __restrict a, const T* __restrict b, const T* __restrict c,
                             T* __restrict out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) out[i] = Operation::of(a[i], b[i], c[i]);
}

template <class T>
[[gnu::noinline]] void apply_transform(const std::array<std::array<T, 4>, 3>& rows,
                                       const std::array<T, 3>* __restrict in,
                                       std::array<T, 3>* __restrict out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto product = [&](std::size_t j) { return Multiply::of(rows[k][j], in[i][j], T{}); };
      out[i][k] = static_cast<T>(product(0) + product(1) + product(2) + rows[k][3]);
    }
  }
}

template <class T>
[[gnu::noinline]] void apply_project(const std::array<T, 3>* __restrict in, T constant,
                                     std::array<T, 2>* __restrict out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      out[i][k] = Multiply::of(Divide::of(in[i][k], in[i][2], T{}), constant, T{});
    }
  }
}

/// Whether x has the stored integer `right`; for float, within its resolution.
template <class T>
bool same(T x, Wide right) {
  if constexpr (std::is_floating_point_v<T>) {
    const double exact = static_cast<double>(right) / 65536;
    return std::fabs(static_cast<double>(x) - exact) <= std::fabs(exact) * 0x1p-20 + 0x1p-9;
  } else if constexpr (std::is_integral_v<T>) {
    return x == right;
  } else {
    return x.raw() == right;
  }
}

template <class Operation, class T>
bool right_elements(const Words& words, const Array<T>& out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!same(out[i], Operation::right(rules_of<T>, words.a[i], words.b[i], words.c[i]))) {
      return false;
    }
  }
  return true;
}

/// Rounds each product, then sums from the left with the overflow rule at each step.
template <class T>
bool right_vertices(const Words& words, const Array<std::array<T, 3>>& out) {
  constexpr const Rules& rules = rules_of<T>;
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& row = words.rows[k];
      const auto v = words.vertex(i);
      Wide sum = rules.product(Wide{row[0]} * v[0]);
      sum = rules.narrowed(sum + rules.product(Wide{row[1]} * v[1]));
      sum = rules.narrowed(sum + rules.product(Wide{row[2]} * v[2]));
      if (!same(out[i][k], rules.narrowed(sum + row[3]))) return false;
    }
  }
  return true;
}

template <class T>
bool right_points(const Words& words, const Array<std::array<T, 2>>& out) {
  constexpr const Rules& rules = rules_of<T>;
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto v = words.vertex(i);
      const Wide quotient = Divide::right(rules, v[k], v[2], 0);
      if (!same(out[i][k], rules.product(quotient * words.constant))) return false;
    }
  }
  return true;
}

template <class T>
bool right_dot(const Words& words, T x) {
  Wide sum = 0;
  for (std::size_t i = 0; i < words.a.size(); ++i) sum += Wide{words.a[i]} * words.small[i];
  return same(x, rules_of<T>.product(sum));
}

}  // namespace batch_bench
