// Times exponentials and logarithms of 16.16: the type, libfixmath, and double with lrint. First
// checks every result: the type must be exact, the others within the errors stated here. The
// counter `off` is the largest error in ulp.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "fixed/exponential.hpp"
#include "fixed/fixed.hpp"
#include "oracle/exponential.hpp"
#if defined(FIXPROOF_LIBFIXMATH)
#include <libfixmath/fix16.h>
#endif

namespace {

using fixproof::q16_16;
using oracle::Exponential;
using Words = std::vector<std::int32_t>;

/// More elements than libfixmath's result cache holds.
constexpr std::size_t count = 16384;

struct Contender {
  std::string name;
  Exponential function;
  std::function<void(const Words& in, Words& out)> run;
  std::int64_t error;  ///< the largest, in ulps
};

template <class OfWord>
std::function<void(const Words&, Words&)> each(OfWord of_word) {
  return [of_word](const Words& in, Words& out) {
    for (std::size_t i = 0; i < count; ++i) out[i] = of_word(in[i]);
  };
}

template <class OfNumber>
auto by_type(OfNumber of_number) {
  return each([of_number](std::int32_t word) { return of_number(q16_16::from_raw(word)).raw(); });
}

template <class OfDouble>
auto by_double(OfDouble of_double) {
  return each([of_double](std::int32_t word) {
    return static_cast<std::int32_t>(std::lrint(of_double(word / 65536.0) * 65536));
  });
}

std::vector<Contender> contenders() {
  std::vector<Contender> all{
      {"exp/q16_16", Exponential::exp, by_type([](q16_16 x) { return exp(x); }), 0},
      {"exp/double", Exponential::exp, by_double([](double x) { return std::exp(x); }), 1},
      {"exp2/q16_16", Exponential::exp2, by_type([](q16_16 x) { return exp2(x); }), 0},
      {"exp2/double", Exponential::exp2, by_double([](double x) { return std::exp2(x); }), 1},
      {"log/q16_16", Exponential::log, by_type([](q16_16 x) { return log(x); }), 0},
      {"log/double", Exponential::log, by_double([](double x) { return std::log(x); }), 1},
      {"log2/q16_16", Exponential::log2, by_type([](q16_16 x) { return log2(x); }), 0},
      {"log2/double", Exponential::log2, by_double([](double x) { return std::log2(x); }), 1},
      {"log10/q16_16", Exponential::log10, by_type([](q16_16 x) { return log10(x); }), 0},
      {"log10/double", Exponential::log10, by_double([](double x) { return std::log10(x); }), 1},
  };
#if defined(FIXPROOF_LIBFIXMATH)
  all.push_back({"exp/libfixmath", Exponential::exp, each(fix16_exp), 1'000'000});
  all.push_back({"log/libfixmath", Exponential::log, each(fix16_log), 1'000'000});
#endif
  return all;
}

void time_contender(benchmark::State& state, const Contender& contender) {
  const bool is_power =
      contender.function == Exponential::exp || contender.function == Exponential::exp2;
  Words in(count);
  Words out(count);
  std::mt19937 random(54);
  // Exponents within +-8; numbers of all lengths.
  for (std::size_t i = 0; i < count; ++i) {
    const auto word = static_cast<std::int32_t>(random());
    in[i] =
        is_power ? word >> 12 : static_cast<std::int32_t>((random() | 0x80000000U) >> (1 + i % 31));
  }
  contender.run(in, out);
  std::int64_t off = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto exact =
        oracle::fast::nearest(contender.function, in[i], 16, oracle::Rounding::half_up);
    off = std::max<std::int64_t>(off, std::abs(out[i] - exact.value_or(0)));
  }
  if (off > contender.error) {
    state.SkipWithError("wrong result");
    return;
  }
  for ([[maybe_unused]] auto _ : state) {
    contender.run(in, out);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
  state.counters["off"] = static_cast<double>(off);
}

}  // namespace

int main(int argc, char** argv) {
  for (const Contender& contender : contenders()) {
    benchmark::RegisterBenchmark(contender.name.c_str(), [contender](benchmark::State& state) {
      time_contender(state, contender);
    });
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
