// What recording costs: the same loops with the plain type, with the recorded type while no log is
// open, and with an open log. Every run must end in the same state as that of the plain type.
#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>

#define FIXPROOF_RECORD 1
#include "fixed/record/recorded.hpp"

namespace {

using namespace fixproof;

template <class Real>
struct Ball {
  Real x, y, vx, vy;
};

/// Balls in a box that push each other apart, as in docs/examples/lockstep.
template <class Real>
class Physics {
 public:
  static constexpr std::int64_t frames = 40;

  /// A function of its own, so that a profiler counts its instructions, and that its code does not
  /// depend on what surrounds it.
  [[gnu::noinline]] std::uint32_t run() {
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      balls_[i] = {Real(static_cast<int>(i % 4) * 3 - 5), Real(static_cast<int>(i / 4) * 3 - 5),
                   Real(static_cast<int>(i) - 7), Real(3 - static_cast<int>(i))};
    }
    for (std::int64_t frame = 0; frame < frames; ++frame) step(frame);
    std::uint32_t sum = 0;
    for (const Ball<Real>& ball : balls_) {
      for (const Real number : {ball.x, ball.y, ball.vx, ball.vy}) {
        sum = sum * 31 + static_cast<std::uint32_t>(number.raw());
      }
    }
    return sum;
  }

 private:
  static void keep_inside(Real& place, Real& speed) {
    if (place < low_wall) {
      place = low_wall;
      speed *= bounce;
    } else if (place > wall) {
      place = wall;
      speed *= bounce;
    }
  }
  void step(std::int64_t frame) {
    record::frame(frame);
    for (Ball<Real>& ball : balls_) {
      ball.vy += gravity * dt;
      ball.x += ball.vx * dt;
      ball.y += ball.vy * dt;
      keep_inside(ball.x, ball.vx);
      keep_inside(ball.y, ball.vy);
    }
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      for (std::size_t j = i + 1; j < balls_.size(); ++j) push_apart(balls_[i], balls_[j]);
    }
  }
  static void push_apart(Ball<Real>& a, Ball<Real>& b) {
    const Real dx = a.x - b.x;
    const Real dy = a.y - b.y;
    const Real square = dx * dx + dy * dy;
    if (square >= reach || square == 0) return;
    const Real distance = sqrt(square);
    if (distance == 0) return;
    const Real push = (one - distance) / distance;
    a.vx += dx * push;
    a.vy += dy * push;
    b.vx -= dx * push;
    b.vy -= dy * push;
  }

  static constexpr Real dt{1.0 / 64};
  static constexpr Real gravity{-9.8125};
  static constexpr Real bounce{-0.75};
  static constexpr Real wall{8};
  static constexpr Real low_wall{-8};
  static constexpr Real reach{4};
  static constexpr Real one{1};

  std::array<Ball<Real>, 16> balls_{};
};

constexpr std::size_t chain_length = 4096;

/// A number that the compiler does not know. Otherwise it computes a loop once for all runs.
struct Unknown {
  std::int32_t start = 0;
};

/// Each operation on the result of the one before.
template <class Real, char Operation>
struct Chain : Unknown {
  [[gnu::noinline]] std::uint32_t run() {
    Real x = Real::from_raw(242483 + start);  // 3.7
    const Real y = Real::from_raw(Operation == '*' ? 65521 : 77777);
    for (std::size_t i = 0; i < chain_length; ++i) {
      if constexpr (Operation == '+') x = x + y;
      if constexpr (Operation == '*') x = x * y;
      if constexpr (Operation == '/') x = y / (x + y);
      if constexpr (Operation == 's') x = sqrt(x) + y;
    }
    return static_cast<std::uint32_t>(x.raw());
  }
};

/// Operations that do not wait for each other, and that the compiler may put into vector registers.
template <class Real>
struct Array {
  std::array<Real, chain_length> a{}, b{};
  [[gnu::noinline]] std::uint32_t run() {
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] = q16_16();
      b[i] = q16_16::from_raw(static_cast<std::int32_t>(i * 77));
    }
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = a[i] + b[i];
    std::uint32_t sum = 0;
    for (const Real x : a) sum = sum * 31 + static_cast<std::uint32_t>(x.raw());
    return sum;
  }
};

/// Particles that fall through air. They do not depend on each other, so the compiler puts them
/// into vector registers if they are plain.
template <class Real>
class Particles {
 public:
  [[gnu::noinline]] std::uint32_t run() {
    for (std::size_t i = 0; i < count; ++i) {
      x_[i] = y_[i] = Real(0);
      vx_[i] = Real::from_raw(static_cast<std::int32_t>(i * 1021) - 131072);
      vy_[i] = Real::from_raw(static_cast<std::int32_t>(i * 509));
    }
    for (std::int64_t frame = 0; frame < frames; ++frame) {
      record::frame(frame);
      for (std::size_t i = 0; i < count; ++i) {
        vx_[i] -= vx_[i] * drag;
        vy_[i] += gravity - vy_[i] * drag;
        x_[i] += vx_[i] * dt;
        y_[i] += vy_[i] * dt;
      }
    }
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      for (const Real number : {x_[i], y_[i], vx_[i], vy_[i]}) {
        sum = sum * 31 + static_cast<std::uint32_t>(number.raw());
      }
    }
    return sum;
  }

 private:
  static constexpr std::size_t count = 256;
  static constexpr std::int64_t frames = 10;
  static constexpr Real drag{1.0 / 32};
  static constexpr Real dt{1.0 / 64};
  static constexpr Real gravity{-9.8125 / 64};

  std::array<Real, count> x_{}, y_{}, vx_{}, vy_{};
};

/// Products of 4x4 matrices, each of the last one.
template <class Real>
struct Matrices : Unknown {
  using Matrix = std::array<std::array<Real, 4>, 4>;

  [[gnu::noinline]] std::uint32_t run() {
    Matrix product{};
    Matrix turn{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        product[i][j] = Real(i == j ? 1 : 0);
        turn[i][j] = Real::from_raw(start + static_cast<std::int32_t>((i * 4 + j) * 2731) - 16384);
      }
    }
    for (int times = 0; times < 64; ++times) product = multiplied(product, turn);
    std::uint32_t sum = 0;
    for (const auto& row : product) {
      for (const Real number : row) sum = sum * 31 + static_cast<std::uint32_t>(number.raw());
    }
    return sum;
  }

  static Matrix multiplied(const Matrix& a, const Matrix& b) {
    Matrix product{};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        product[i][j] =
            a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] + a[i][3] * b[3][j];
      }
    }
    return product;
  }
};

/// A biquad, the usual filter for sound: a low pass.
template <class Real>
struct Biquad : Unknown {
  [[gnu::noinline]] std::uint32_t run() {
    Real x1(0);
    Real x2(0);
    Real y1(0);
    Real y2(0);
    std::uint32_t sum = 0;
    for (std::uint32_t i = 0; i < chain_length; ++i) {
      const Real x = Real::from_raw(start + (static_cast<std::int32_t>(i * 2654435761U) >> 12));
      const Real y = b0 * x + b1 * x1 + b2 * x2 - a1 * y1 - a2 * y2;
      x2 = x1;
      x1 = x;
      y2 = y1;
      y1 = y;
      sum = sum * 31 + static_cast<std::uint32_t>(y.raw());
    }
    return sum;
  }

  static constexpr Real b0{0.0675}, b1{0.1349}, b2{0.0675}, a1{-1.143}, a2{0.4128};
};

template <class Plain, class Loop>
void time(benchmark::State& state, bool has_log) {
  Plain plain;
  Loop loop;
  const std::uint32_t expected = plain.run();
  const auto file = std::filesystem::temp_directory_path() / "fixproof_record_bench.log";
  {
    std::optional<record::log> log;
    if (has_log) log.emplace(file.string());
    for ([[maybe_unused]] auto _ : state) {
      benchmark::DoNotOptimize(loop);
      const std::uint32_t sum = loop.run();
      if (sum != expected) {
        state.SkipWithError("the recorded type has another result");
        return;
      }
    }
    if (log) {
      state.counters["records"] = benchmark::Counter(static_cast<double>(record::where().records),
                                                     benchmark::Counter::kAvgIterations);
    }
  }
  if (has_log) {
    state.counters["bytes"] = benchmark::Counter(
        static_cast<double>(std::filesystem::file_size(file)), benchmark::Counter::kAvgIterations);
    std::filesystem::remove(file);
  }
}

template <template <class> class Loop>
void add(const std::string& name) {
  using recorded_type = recorded<q16_16>;
  benchmark::RegisterBenchmark((name + "/plain").c_str(), [](benchmark::State& state) {
    time<Loop<q16_16>, Loop<q16_16>>(state, false);
  });
  benchmark::RegisterBenchmark((name + "/no_log").c_str(), [](benchmark::State& state) {
    time<Loop<q16_16>, Loop<recorded_type>>(state, false);
  });
  benchmark::RegisterBenchmark((name + "/log").c_str(), [](benchmark::State& state) {
    time<Loop<q16_16>, Loop<recorded_type>>(state, true);
  });
}

template <class Real>
using Sum = Chain<Real, '+'>;
template <class Real>
using Product = Chain<Real, '*'>;
template <class Real>
using Quotient = Chain<Real, '/'>;
template <class Real>
using Root = Chain<Real, 's'>;

}  // namespace

int main(int argc, char** argv) {
  add<Physics>("physics");
  add<Particles>("particles");
  add<Matrices>("matrices");
  add<Biquad>("biquad");
  add<Product>("chain_mul");
  add<Quotient>("chain_div_add");
  add<Root>("chain_sqrt_add");
  add<Sum>("chain_add");
  add<Array>("array_add");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
