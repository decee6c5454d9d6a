/// \file
/// What the benchmarks of batches work on, and the loops that they are set beside.
#pragma once

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <type_traits>
#include <vector>

#include "fixed/fixed.hpp"

namespace batch_bench {

__extension__ using Wide = __int128;

template <class T>
T of_raw(std::int32_t raw) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(raw) / 65536;
  } else if constexpr (std::is_integral_v<T>) {
    return raw;
  } else {
    return T::from_raw(raw);
  }
}

/// Operands within +-128, divisors from 1 and radicands from zero, so that nothing overflows or
/// faults under any preset; and room for results.
template <class T>
struct Operands {
  std::vector<T> a, b, c, out, out_y, out_z;
  std::vector<std::array<T, 3>> vertices, moved;
  std::vector<std::array<T, 2>> points;
  std::array<std::array<T, 4>, 3> rows{};
  T constant = of_raw<T>(-100 * 65536);

  explicit Operands(std::size_t count)
      : out(count), out_y(count), out_z(count), moved(count), points(count) {
    std::mt19937 random(54);
    const auto draw = [&random](int bits) {
      return static_cast<std::int32_t>(random()) >> (32 - bits);
    };
    for (std::size_t i = 0; i < count; ++i) {
      a.push_back(of_raw<T>(draw(24)));
      const std::int32_t magnitude = (draw(24) & 0x7fffff) | 0x10000;
      b.push_back(of_raw<T>(draw(1) < 0 ? -magnitude : magnitude));
      c.push_back(of_raw<T>(draw(24) & 0x7fffff));
      vertices.push_back({a[i], c[i], b[i]});
    }
    for (auto& row : rows) {
      for (T& x : row) x = of_raw<T>(draw(18));
    }
  }
};

/// One loop: what is timed, and whether the results of the last run are right.
struct Loop {
  std::function<void()> run;
  std::function<bool()> right;
};

inline void time_loop(benchmark::State& state, const std::function<Loop(std::size_t)>& make) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Loop loop = make(count);
  loop.run();
  if (!loop.right()) {
    state.SkipWithError("wrong result");
    return;
  }
  for ([[maybe_unused]] auto _ : state) {
    loop.run();
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// n / d to nearest, halves up.
inline std::int64_t nearest(Wide n, Wide d) {
  const Wide halves = d < 0 ? -2 * n - d : 2 * n + d;
  const Wide unit = d < 0 ? -2 * d : 2 * d;
  return static_cast<std::int64_t>(halves / unit - (halves % unit < 0 ? 1 : 0));
}

inline constexpr Wide one = 65536;

/// The operations, for one element, as each kind of number has them; and what is expected of stored
/// integers. `truncates` tells of quotients.
struct Multiply {
  template <class T>
  static T of(T a, T b, T /*c*/) {
    if constexpr (std::is_integral_v<T>) {
      return static_cast<T>((std::int64_t{a} * b + 0x8000) >> 16);
    } else {
      return a * b;
    }
  }
  static std::int64_t expected(Wide a, Wide b, Wide /*c*/, bool /*truncates*/) {
    return nearest(a * b, one);
  }
};
struct MulAdd {
  template <class T>
  static T of(T a, T b, T c) {
    if constexpr (std::is_integral_v<T>) {
      return static_cast<T>((std::int64_t{a} * b + std::int64_t{c} * 65536 + 0x8000) >> 16);
    } else if constexpr (std::is_floating_point_v<T>) {
      return a * b + c;
    } else {
      return fixed::mul_add(a, b, c);
    }
  }
  static std::int64_t expected(Wide a, Wide b, Wide c, bool /*truncates*/) {
    return nearest(a * b + c * one, one);
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
  static std::int64_t expected(Wide a, Wide b, Wide /*c*/, bool truncates) {
    return truncates ? static_cast<std::int64_t>(a * one / b) : nearest(a * one, b);
  }
};
struct Root {
  template <class T>
  static T of(T /*a*/, T /*b*/, T c) {
    if constexpr (std::is_floating_point_v<T>) {
      return std::sqrt(c);
    } else {
      return fixed::sqrt(c);
    }
  }
  /// The r with (r - 1/2)^2 < c 2^16 < (r + 1/2)^2, by halving.
  static std::int64_t expected(Wide /*a*/, Wide /*b*/, Wide c, bool /*truncates*/) {
    Wide low = 0;
    Wide high = Wide{1} << 24;
    while (low < high) {
      const Wide middle = (low + high) / 2;
      if ((2 * middle + 1) * (2 * middle + 1) > 4 * c * one) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    return static_cast<std::int64_t>(low);
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

}  // namespace batch_bench
