// The type beside the plain idioms, over arrays that fit in the first-level cache. Every loop reads
// two operands and stores one result; operands are uniform, and no divisor is zero.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "fixed/fixed.hpp"
#include "oracle/fast.hpp"

namespace {

using fixed::q16_16;

constexpr std::size_t count = 2048;

struct Operands {
  std::vector<std::int32_t> a;
  std::vector<std::int32_t> b;
};

const Operands& operands() {
  static const Operands drawn = [] {
    Operands o;
    std::mt19937 random(54);
    for (std::size_t i = 0; i < count; ++i) {
      o.a.push_back(static_cast<std::int32_t>(random()));
      o.b.push_back(static_cast<std::int32_t>(random() | 1U));
    }
    return o;
  }();
  return drawn;
}

template <class Number>
std::vector<Number> numbers(const std::vector<std::int32_t>& raws) {
  std::vector<Number> all;
  for (const std::int32_t raw : raws) {
    if constexpr (std::is_arithmetic_v<Number>) {
      all.push_back(static_cast<Number>(raw));
    } else {
      all.push_back(Number::from_raw(raw));
    }
  }
  return all;
}

/// The loop that is timed. The pointers do not alias, so that no contender pays for the
/// possibility.
template <class Number, class Apply>
[[gnu::noinline]] void apply_all(const Number* __restrict a, const Number* __restrict b,
                                 Number* __restrict out, Apply apply) {
  for (std::size_t i = 0; i < count; ++i) out[i] = apply(a[i], b[i]);
}

/// Times `apply` over the operand arrays, once `right(a, b, result)` has held for every element.
template <class Number, class Apply, class Right>
void time_over_arrays(benchmark::State& state, Apply apply, Right right) {
  const auto a = numbers<Number>(operands().a);
  const auto b = numbers<Number>(operands().b);
  std::vector<Number> out(count);
  const auto loop = [&] { apply_all(a.data(), b.data(), out.data(), apply); };
  loop();
  for (std::size_t i = 0; i < count; ++i) {
    if (!right(operands().a[i], operands().b[i], out[i])) {
      state.SkipWithError("wrong result");
      return;
    }
  }
  for ([[maybe_unused]] auto _ : state) {
    loop();
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}

std::int32_t raw_multiply(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((std::int64_t{a} * b + 0x8000) >> 16);
}
std::int32_t raw_divide(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((std::int64_t{a} * 65536) / b);
}

std::uint32_t bits(std::int32_t v) { return static_cast<std::uint32_t>(v); }

bool is_product(std::int32_t a, std::int32_t b, std::int32_t result) {
  return bits(result) == oracle::fast::mul(bits(a), bits(b), oracle::Rounding::half_up, 16);
}
bool is_quotient(std::int32_t a, std::int32_t b, std::int32_t result, oracle::Rounding rounding) {
  return bits(result) == oracle::fast::quotient(bits(a), bits(b), rounding, 16);
}

/// What saturation makes of an exact result.
std::int32_t nearest_word(std::int64_t exact) {
  return static_cast<std::int32_t>(std::clamp<std::int64_t>(exact, INT32_MIN, INT32_MAX));
}

void multiply_raw_idiom(benchmark::State& state) {
  time_over_arrays<std::int32_t>(
      state, [](std::int32_t a, std::int32_t b) { return raw_multiply(a, b); }, is_product);
}
void multiply_q16_16(benchmark::State& state) {
  time_over_arrays<q16_16>(
      state, [](q16_16 a, q16_16 b) { return a * b; },
      [](auto a, auto b, q16_16 r) { return is_product(a, b, r.raw()); });
}
void multiply_saturating(benchmark::State& state) {
  using number = fixed::q16_16_saturating;
  time_over_arrays<number>(
      state, [](number a, number b) { return a * b; },
      [](auto a, auto b, number r) {
        return r.raw() == nearest_word(oracle::fast::exact_product(bits(a), bits(b),
                                                                   oracle::Rounding::half_up, 16));
      });
}
void multiply_double(benchmark::State& state) {
  time_over_arrays<double>(
      state, [](double a, double b) { return a * b; },
      // One rounding of the exact product.
      [](auto a, auto b, double r) { return r == static_cast<double>(std::int64_t{a} * b); });
}

void divide_raw_idiom(benchmark::State& state) {
  time_over_arrays<std::int32_t>(
      state, [](std::int32_t a, std::int32_t b) { return raw_divide(a, b); },
      [](auto a, auto b, auto r) { return is_quotient(a, b, r, oracle::Rounding::truncate); });
}
void divide_q16_16(benchmark::State& state) {
  time_over_arrays<q16_16>(
      state, [](q16_16 a, q16_16 b) { return a / b; },
      [](auto a, auto b, q16_16 r) {
        return is_quotient(a, b, r.raw(), oracle::Rounding::half_up);
      });
}
void divide_saturating(benchmark::State& state) {
  using number = fixed::q16_16_saturating;
  time_over_arrays<number>(
      state, [](number a, number b) { return a / b; },
      [](auto a, auto b, number r) {
        return r.raw() == nearest_word(*oracle::fast::exact_quotient(
                              bits(a), bits(b), oracle::Rounding::half_up, 16));
      });
}
void divide_double(benchmark::State& state) {
  time_over_arrays<double>(
      state, [](double a, double b) { return a / b; },
      [](auto a, auto b, double r) { return std::abs(r * b - a) <= std::abs(a) * 0x1p-52; });
}

BENCHMARK(multiply_raw_idiom);
BENCHMARK(multiply_q16_16);
BENCHMARK(multiply_saturating);
BENCHMARK(multiply_double);
BENCHMARK(divide_raw_idiom);
BENCHMARK(divide_q16_16);
BENCHMARK(divide_saturating);
BENCHMARK(divide_double);

}  // namespace
