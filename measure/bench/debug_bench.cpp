// Times single operations as a program without optimisation runs them: the type, the plain idiom,
// and fpm if the compiler finds it. Checks every result of the type against the idiom's. Needs no
// library:
//
//     g++ -std=c++20 -O0 -I. -I FPM/include measure/bench/debug_bench.cpp -o debug_bench &&
//     ./debug_bench
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

#include "fixed/fixed.hpp"
#include "measure/bench/least_time.hpp"
#if __has_include(<fpm/fixed.hpp>)
#include <fpm/fixed.hpp>
#define FPM_IS_HERE
#endif

namespace {

constexpr std::size_t count = 4096;

/// The arithmetic of q16_16 in plain integers.
struct Plain {
  std::int32_t raw;
  static Plain from_raw(std::int32_t raw) { return {raw}; }
};
using Wide = std::int64_t;

enum class Operation { multiply, divide, add, subtract, add_to };

template <Operation operation, class Number>
void run(const std::vector<Number>& xs, const std::vector<Number>& ys, std::vector<Number>& zs) {
  // Pointers, because operator[] of a vector is a call.
  const Number* const x = xs.data();
  const Number* const y = ys.data();
  Number* const z = zs.data();
  for (std::size_t i = 0; i < count; ++i) {
    if constexpr (operation == Operation::multiply) {
      z[i] = x[i] * y[i];
    } else if constexpr (operation == Operation::divide) {
      z[i] = x[i] / y[i];
    } else if constexpr (operation == Operation::add) {
      z[i] = x[i] + y[i];
    } else if constexpr (operation == Operation::subtract) {
      z[i] = x[i] - y[i];
    } else {
      z[i] = x[i];
      z[i] += y[i];
    }
  }
}

template <Operation operation>
void run(const std::vector<Plain>& xs, const std::vector<Plain>& ys, std::vector<Plain>& zs) {
  const Plain* const x = xs.data();
  const Plain* const y = ys.data();
  Plain* const z = zs.data();
  for (std::size_t i = 0; i < count; ++i) {
    if constexpr (operation == Operation::multiply) {
      z[i].raw = static_cast<std::int32_t>((Wide{x[i].raw} * y[i].raw + 0x8000) >> 16);
    } else if constexpr (operation == Operation::divide) {
      // (floor(2^17 x / y) + 1) / 2, rounded down: the quotient to nearest, ties up
      const Wide twice = Wide{x[i].raw} * 0x20000;
      const bool between = twice % y[i].raw != 0 && (x[i].raw < 0) != (y[i].raw < 0);
      z[i].raw = static_cast<std::int32_t>((twice / y[i].raw - (between ? 1 : 0) + 1) >> 1);
    } else if constexpr (operation == Operation::subtract) {
      z[i].raw = x[i].raw - y[i].raw;
    } else {
      z[i].raw = x[i].raw + y[i].raw;
    }
  }
}

/// Random words of 24 bits; none is 0.
template <class Number>
std::vector<Number> words(unsigned seed, Number (*from_raw)(std::int32_t)) {
  std::mt19937 random(seed);
  std::vector<Number> made;
  for (std::size_t i = 0; i < count; ++i) {
    made.push_back(from_raw((static_cast<std::int32_t>(random()) >> 8) | 1));
  }
  return made;
}

/// The least time of one operation.
template <Operation operation, class Number>
double time_of(Number (*from_raw)(std::int32_t), std::vector<Number>& results) {
  const auto x = words(1, from_raw);
  const auto y = words(2, from_raw);
  results = x;
  return bench::least_times<300>(count, [&] {
    run<operation>(x, y, results);
    bench::keep(results);
  })[0];
}

template <Operation operation>
bool time_operation(const char* name) {
  std::vector<fixproof::q16_16> ours;
  std::vector<Plain> plain;
  const double of_ours = time_of<operation>(&fixproof::q16_16::from_raw, ours);
  const double of_plain = time_of<operation>(&Plain::from_raw, plain);
  std::printf("%-9s type %5.2f ns, idiom %5.2f ns: %4.2f", name, of_ours, of_plain,
              of_ours / of_plain);
#ifdef FPM_IS_HERE
  std::vector<fpm::fixed_16_16> theirs;
  const double of_fpm = time_of<operation>(&fpm::fixed_16_16::from_raw_value, theirs);
  std::printf(", fpm %5.2f ns: %4.2f", of_fpm, of_ours / of_fpm);
#endif
  for (std::size_t i = 0; i < count; ++i) {
    if (ours[i].raw() != plain[i].raw) {
      std::printf(", wrong result\n");
      return false;
    }
  }
  std::printf("\n");
  return true;
}

}  // namespace

int main() {
  bool right = time_operation<Operation::multiply>("multiply");
  right = time_operation<Operation::divide>("divide") && right;
  right = time_operation<Operation::add>("add") && right;
  right = time_operation<Operation::subtract>("subtract") && right;
  right = time_operation<Operation::add_to>("+=") && right;
  return right ? 0 : 1;
}
