/// @file
/// What each operation takes and what it should return. Exact results are long doubles, computed
/// from the words without any code that is timed.
///
/// An operation has
///
///     inputs, outputs                    the columns that it reads and writes
///     results                            the results of an element
///     draw(Draw&) -> three words         random operands
///     exact(words, i, k) -> Ulp          result k of element i, not rounded
///     clamps                             whether operands out of range have a result
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "measure/bench/fair/columns.hpp"

namespace fair {

using Drawn = std::array<std::int32_t, 3>;

/// Operations on one or two words. `of(a, b)` is the exact result.
template <class Derived, std::size_t inputs_ = 2>
struct Elementwise {
  static constexpr std::size_t inputs = inputs_, outputs = 1, results = 1;
  static constexpr bool clamps = false;
  template <class In>
  static In input(const Words& words, std::size_t k, std::size_t i) {
    return of_word<In>(k == 0 ? words.a[i] : words.b[i]);
  }
  static Ulp exact(const Words& words, std::size_t i, std::size_t /*k*/) {
    return Derived::of(words.a[i], words.b[i]);
  }
};

struct Multiply : Elementwise<Multiply> {
  static Drawn draw(Draw& from) { return {from.word(24), from.word(23), 0}; }
  static Ulp of(Ulp a, Ulp b) { return a * b / 65536; }
  /// In chains factors and their reciprocals take turns, so numbers stay near 3/2.
  static constexpr std::array<std::int32_t, 3> chain{98304, 81920, 52429};
  template <class T>
  static std::array<T, 2> link(T last, T other) {
    return {last, other};
  }
};

struct MultiplySaturating : Multiply {
  static constexpr bool clamps = true;
  static Ulp exact(const Words& words, std::size_t i, std::size_t /*k*/) {
    using limits = std::numeric_limits<std::int32_t>;
    return std::clamp(of(words.a[i], words.b[i]), Ulp{limits::min()}, Ulp{limits::max()});
  }
};

struct Divide : Elementwise<Divide> {
  static Drawn draw(Draw& from) {
    const std::int32_t d = from.word(24);
    return {from.word(24), d < 0 ? std::min(d, -65536) : std::max(d, 65536), 0};
  }
  static Ulp of(Ulp a, Ulp b) { return b == 0 ? no_result : a * 65536 / b; }
  static constexpr std::array<std::int32_t, 3> chain{98304, 220000, 220000};
  template <class T>
  static std::array<T, 2> link(T last, T other) {
    return {other, last};
  }
};

struct Root : Elementwise<Root, 1> {
  static Drawn draw(Draw& from) { return {from.word(31) & 0x7fffffff, 0, 0}; }
  static Ulp of(Ulp a, Ulp /*b*/) { return a < 0 ? no_result : std::sqrt(a * 65536); }
  static constexpr std::array<std::int32_t, 3> chain{98304, 1234567, 23456};
  template <class T>
  static std::array<T, 2> link(T last, T other) {
    return {last + other, other};
  }
};

template <int bits>
struct Sine : Elementwise<Sine<bits>, 1> {
  static Drawn draw(Draw& from) { return {from.word(bits), 0, 0}; }
  static Ulp of(Ulp a, Ulp /*b*/) { return std::sin(a / 65536) * 65536; }
  static constexpr std::array<std::int32_t, 3> chain{98304, 123456, -200000};
  template <class T>
  static std::array<T, 2> link(T last, T other) {
    return {last + other, other};
  }
};

/// Cosine and sine within +-8.
struct SineCosine : Sine<20> {
  static constexpr std::size_t outputs = 2, results = 2;
  static Ulp exact(const Words& words, std::size_t i, std::size_t k) {
    const Ulp angle = Ulp{1} * words.a[i] / 65536;
    return (k == 0 ? std::cos(angle) : std::sin(angle)) * 65536;
  }
};

/// A double that the words a and b make: a, and a fraction of a unit from b.
struct FromDouble : Elementwise<FromDouble, 1> {
  static Drawn draw(Draw& from) { return {from.word(26), from.word(32), 0}; }
  static double value(const Words& words, std::size_t i) {
    return (words.a[i] + static_cast<double>(words.b[i] >> 12) / (1 << 20)) / 65536;
  }
  template <class In>
  static In input(const Words& words, std::size_t /*k*/, std::size_t i) {
    return value(words, i);
  }
  static Ulp exact(const Words& words, std::size_t i, std::size_t /*k*/) {
    return static_cast<Ulp>(value(words, i)) * 65536;
  }
};

struct ToDouble : Elementwise<ToDouble, 1> {
  static Drawn draw(Draw& from) { return {from.word(32), 0, 0}; }
  static Ulp of(Ulp a, Ulp /*b*/) { return a; }
  static constexpr std::array<std::int32_t, 3> chain{98304, 70001, -70001};
  template <class T>
  static std::array<T, 2> link(T last, T other) {
    return {last + other, other};
  }
};

/// The sum of the products of two columns, in element 0.
struct Dot {
  static constexpr std::size_t inputs = 2, outputs = 1, results = 1;
  static constexpr bool clamps = false;
  static Drawn draw(Draw& from) { return {from.word(18), from.word(14), 0}; }
  template <class In>
  static In input(const Words& words, std::size_t k, std::size_t i) {
    return of_word<In>(k == 0 ? words.a[i] : words.b[i]);
  }
  template <class Arrays>
  static Ulp error(const Words& words, const Arrays& arrays, std::size_t count) {
    return std::abs(arrays.result(0, 0) - exact_sum(words, count));
  }
  /// The sum of the first `count` products, in halves that cannot overflow.
  static Ulp exact_sum(const Words& words, std::size_t count) {
    std::int64_t high = 0;
    std::int64_t low = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::int64_t product = std::int64_t{words.a[i]} * words.b[i];
      high += product >> 32;
      low += product & 0xffffffff;
    }
    return Ulp{1} * high * 65536 + static_cast<Ulp>(low) / 65536;
  }
  /// Sums of three products. Two products cancel each other, so the sum is in range. The lowest
  /// word is not among them, because the sum of two of its squares exceeds 64 bits.
  static std::vector<Words> edge_words();
};

/// The columns a, b, c are the coordinates x, y, z.
struct Transform {
  static constexpr std::size_t inputs = 3, outputs = 3, results = 3;
  static constexpr bool clamps = false;
  static Drawn draw(Draw& from) { return {from.word(24), from.word(24), from.word(24)}; }
  template <class In>
  static In input(const Words& words, std::size_t k, std::size_t i) {
    return of_word<In>((k == 0 ? words.a : k == 1 ? words.b : words.c)[i]);
  }
  static Ulp exact(const Words& words, std::size_t i, std::size_t k) {
    const auto& row = matrix_words[k];
    const Ulp sum =
        Ulp{1} * row[0] * words.a[i] + Ulp{1} * row[1] * words.b[i] + Ulp{1} * row[2] * words.c[i];
    return sum / 65536 + row[3];
  }
};

/// The same of vertices x y z x y z in one column.
struct TransformInterleaved : Transform {
  static constexpr std::size_t inputs = 1, outputs = 1;
  template <class In>
  static In input(const Words& words, std::size_t /*k*/, std::size_t i) {
    using number = typename element_of<In>::number;
    return {of_word<number>(words.a[i]), of_word<number>(words.b[i]), of_word<number>(words.c[i])};
  }
};

/// Copies the coordinates: the limit of a transform of vertices in memory.
struct Copy : Transform {
  static Ulp exact(const Words& words, std::size_t i, std::size_t k) {
    return (k == 0 ? words.a : k == 1 ? words.b : words.c)[i];
  }
};

template <class Op>
Words drawn(std::size_t count) {
  // A hundred thousand operands, and then the same again, to save time.
  constexpr std::size_t different = 100'000;
  Draw from;
  Words words;
  for (std::size_t i = 0; i < count; ++i) {
    if (i < different) {
      const auto [a, b, c] = Op::draw(from);
      words.add(a, b, c);
    } else {
      words.add(words.a[i - different], words.b[i - different], words.c[i - different]);
    }
  }
  return words;
}

/// Words where carries, signs, roundings and ranges change.
inline std::vector<std::int32_t> edges() {
  std::vector<std::int32_t> all{0, std::numeric_limits<std::int32_t>::min()};
  for (const std::int32_t x :
       {1,        2,        3,         255,        0x7fff,     0x8000,     0x8001,    0xaaab,
        0xffff,   0x10000,  0x10001,   0x18000,    0x1ffff,    102943,     205887,    0x7fffff,
        0x800000, 0x800001, 0x1234567, 0x40000000, 0x7fff8000, 0x7ffffffe, 0x7fffffff}) {
    all.push_back(x);
    all.push_back(-x);
  }
  return all;
}

/// All pairs of edges, with a third one, whose exact results are in range of 16.16.
template <class Op>
Words lattice() {
  const std::vector<std::int32_t> all = edges();
  Words words;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < all.size(); ++j) {
      Words one;
      one.add(all[i], all[j], all[(7 * i + j) % all.size()]);
      bool in_range = true;
      for (std::size_t k = 0; k < Op::results; ++k) {
        // A sum of three rounded products is up to 3/2 away.
        constexpr Ulp margin = Op::results == 3 ? 2 : 0;
        const Ulp x = Op::exact(one, 0, k);
        in_range =
            in_range && (Op::clamps || (x >= -0x1p31L + margin && x <= 0x1p31L - 1 - margin));
      }
      if (in_range) words.add(one.a[0], one.b[0], one.c[0]);
    }
  }
  return words;
}

inline std::vector<Words> Dot::edge_words() {
  const std::vector<std::int32_t> all = edges();
  std::vector<Words> sums;
  for (std::size_t i = 2; i < all.size(); ++i) {
    for (std::size_t j = 2; j < all.size(); ++j) {
      Words sum;
      sum.add(all[i], all[j], 0);
      sum.add(all[(i + j) % all.size()], all[i * j % all.size()], 0);
      sum.add(-all[i], all[j], 0);
      if (std::abs(exact_sum(sum, sum.size())) <= 0x1p31L - 1) sums.push_back(sum);
    }
  }
  return sums;
}

}  // namespace fair
