// Times sine and cosine in radians: the type, scalar and in batches, libfixmath, float and double,
// for angles within +-8 and for all of 16.16. First checks every result: the type must be exact,
// the others within the errors stated here. The counter `off` is the largest error in ulp.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "batch/radian.hpp"
#include "fixed/fixed.hpp"
#include "oracle/fast_sine.hpp"
#if defined(FIXPROOF_LIBFIXMATH)
#include <libfixmath/fix16.h>
#endif

namespace {

using fixproof::q16_16;

/// More elements than libfixmath's result cache holds.
constexpr std::size_t count = 16384;

struct Arrays {
  std::vector<q16_16> angles;
  std::vector<q16_16> sines;
  std::vector<q16_16> cosines;
};

struct Contender {
  std::string name;
  std::function<void(Arrays&)> run;
  bool has_cosines;
  /// Maximum errors in ulp, for angles within +-8 and for all.
  std::int64_t near_error;
  std::int64_t far_error;
};

template <class OfWord>
std::function<void(Arrays&)> each(OfWord of_word) {
  return [of_word](Arrays& a) {
    for (std::size_t i = 0; i < count; ++i) {
      a.sines[i] = q16_16::from_raw(of_word(a.angles[i].raw()));
    }
  };
}

template <class Float>
std::int32_t sine_in(std::int32_t raw) {
  return static_cast<std::int32_t>(std::lrint(std::sin(static_cast<Float>(raw) / 65536) * 65536));
}

std::vector<Contender> contenders() {
  std::vector<Contender> all{
      {"sin/q16_16",
       each([](std::int32_t raw) { return fixproof::sin(q16_16::from_raw(raw)).raw(); }), false, 0,
       0},
      {"sin/q16_16_batch", [](Arrays& a) { fixproof::batch::sin(a.angles, a.sines); }, false, 0, 0},
      {"sin_cos/q16_16",
       [](Arrays& a) {
         for (std::size_t i = 0; i < count; ++i) {
           const auto both = fixproof::sin_cos(a.angles[i]);
           a.cosines[i] = both.cos;
           a.sines[i] = both.sin;
         }
       },
       true, 0, 0},
      {"sin_cos/q16_16_batch",
       [](Arrays& a) { fixproof::batch::sin_cos(a.angles, a.cosines, a.sines); }, true, 0, 0},
      {"sin/double", each(sine_in<double>), false, 1, 1},
      {"sin/float", each(sine_in<float>), false, 1, 100},
  };
#if defined(FIXPROOF_LIBFIXMATH)
  all.push_back({"sin/libfixmath", each(fix16_sin), false, 600, 5000});
#endif
  return all;
}

std::int64_t distance(q16_16 result, oracle::Word exact) {
  return std::abs(std::int64_t{result.raw()} - static_cast<std::int32_t>(exact));
}

std::int64_t largest_error(const Arrays& a, bool has_cosines) {
  std::int64_t largest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto angle = static_cast<oracle::Word>(a.angles[i].raw());
    largest = std::max(largest, distance(a.sines[i], oracle::fast::sin(angle, 16)));
    if (!has_cosines) continue;
    largest = std::max(largest, distance(a.cosines[i], oracle::fast::cos(angle, 16)));
  }
  return largest;
}

void time_contender(benchmark::State& state, const Contender& contender, bool far) {
  Arrays a{std::vector<q16_16>(count), std::vector<q16_16>(count), std::vector<q16_16>(count)};
  std::mt19937 random(54);
  for (q16_16& angle : a.angles) {
    const auto word = static_cast<std::int32_t>(random());
    angle = q16_16::from_raw(far ? word : word >> 12);
  }
  contender.run(a);
  const std::int64_t off = largest_error(a, contender.has_cosines);
  if (off > (far ? contender.far_error : contender.near_error)) {
    state.SkipWithError("wrong result");
    return;
  }
  for ([[maybe_unused]] auto _ : state) {
    contender.run(a);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
  state.counters["off"] = static_cast<double>(off);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Contender> all = contenders();
  for (const bool far : {false, true}) {
    for (const Contender& contender : all) {
      const std::string name = contender.name + (far ? "/all" : "/within_8");
      benchmark::RegisterBenchmark(name.c_str(), [&contender, far](benchmark::State& state) {
        time_contender(state, contender, far);
      });
    }
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
