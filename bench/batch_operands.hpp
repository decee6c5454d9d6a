/// \file
/// The operands and the timing of the batch benchmarks.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace batch_bench {

template <class T>
T of_raw(std::int32_t raw) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(raw) / 65536;
  } else if constexpr (std::is_integral_v<T>) {
    return raw;
  } else {
    return T::from_raw(static_cast<typename T::raw_type>(raw));
  }
}

/// Random stored integers of 16.16, the same in every object. Values are within +-128, divisors at
/// least 1 and radicands not negative, so no operation overflows or faults.
struct Words {
  std::vector<std::int32_t> a, b, c;
  /// Within +-1/2, so that a thousand products can be summed without overflow.
  std::vector<std::int32_t> small;
  std::array<std::array<std::int32_t, 4>, 3> rows{};
  std::int32_t constant;

  explicit Words(std::size_t count) : constant(-100 * one) {
    std::mt19937 random(54);
    const auto below = [&random](int n) {
      return static_cast<int>(random() % static_cast<unsigned>(n));
    };
    const auto word = [&](int width) {
      const std::int32_t x = static_cast<std::int32_t>(random()) >> (32 - width);
      // Half of the words end in zeros, so that products and quotients can be ties.
      return below(2) == 0 ? x : x & -(1 << below(16));
    };
    const auto wide = [&] { return word(24); };
    const auto divisor = [](std::int32_t x) {
      return x < 0 ? std::min(x, -one) : std::max(x, one);
    };
    const auto radicand = [](std::int32_t x) { return x >= 0 ? x : ~x; };
    a = filled(count, wide);
    b = filled(count, [&] { return divisor(wide()); });
    c = filled(count, [&] { return radicand(wide()); });
    small = filled(count, [&] { return word(16); });
    for (auto& row : rows) std::ranges::generate(row, [&] { return word(18); });
  }

  [[nodiscard]] std::array<std::int32_t, 3> vertex(std::size_t i) const {
    return {a[i], c[i], b[i]};
  }

 private:
  static constexpr std::int32_t one = 1 << 16;

  /// Draws only a hundred thousand values and repeats them, to save time.
  static std::vector<std::int32_t> filled(std::size_t count, const auto& draw) {
    constexpr std::size_t drawn = 100'000;
    std::vector<std::int32_t> words(count);
    std::generate_n(words.begin(), std::min(count, drawn), draw);
    for (std::size_t i = drawn; i < count; ++i) words[i] = words[i - drawn];
    return words;
  }
};

template <class T>
struct LineAllocator {
  using value_type = T;
  static constexpr std::align_val_t line{64};

  LineAllocator() = default;
  template <class U>
  explicit LineAllocator(const LineAllocator<U>& /*other*/) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), line));
  }
  void deallocate(T* at, std::size_t /*count*/) { ::operator delete(at, line); }
  friend bool operator==(const LineAllocator&, const LineAllocator&) = default;
};
template <class T>
using Array = std::vector<T, LineAllocator<T>>;

/// The words as numbers of type T, and space for results.
template <class T>
struct Operands {
  Array<T> a, b, c, small, out, out_y, out_z;
  Array<std::array<T, 3>> vertices, moved;
  Array<std::array<T, 2>> points;
  std::array<std::array<T, 4>, 3> rows{};
  T constant;

  explicit Operands(const Words& words)
      : a(numbers(words.a)),
        b(numbers(words.b)),
        c(numbers(words.c)),
        small(numbers(words.small)),
        out(a.size()),
        out_y(a.size()),
        out_z(a.size()),
        vertices(a.size()),
        moved(a.size()),
        points(a.size()),
        constant(of_raw<T>(words.constant)) {
    for (std::size_t i = 0; i < a.size(); ++i) vertices[i] = {a[i], c[i], b[i]};
    for (std::size_t k = 0; k < rows.size(); ++k) {
      std::ranges::transform(words.rows[k], rows[k].begin(), of_raw<T>);
    }
  }

 private:
  static Array<T> numbers(const std::vector<std::int32_t>& words) {
    Array<T> result(words.size());
    std::ranges::transform(words, result.begin(), of_raw<T>);
    return result;
  }
};

struct Loop {
  std::function<void()> run;
  std::function<bool()> right;
};

/// Times the loop from `make` for each size. Checks it once, not at every repetition.
inline void add_loop(const std::string& name, const std::vector<std::int64_t>& sizes,
                     const std::function<Loop(std::size_t)>& make) {
  const auto known_right = std::make_shared<std::set<std::int64_t>>();
  auto* const timed =
      benchmark::RegisterBenchmark(name.c_str(), [make, known_right](benchmark::State& state) {
        const Loop loop = make(static_cast<std::size_t>(state.range(0)));
        loop.run();
        if (!known_right->contains(state.range(0))) {
          if (!loop.right()) {
            state.SkipWithError("wrong result");
            return;
          }
          known_right->insert(state.range(0));
        }
        for ([[maybe_unused]] auto _ : state) {
          loop.run();
          benchmark::ClobberMemory();
        }
        state.SetItemsProcessed(state.iterations() * state.range(0));
      });
  for (const std::int64_t size : sizes) timed->Arg(size);
}

}  // namespace batch_bench
