#include "bench/batch_presets.hpp"

#include <benchmark/benchmark.h>

#include <memory>
#include <string>

#include "bench/batch_operands.hpp"
#include "fixed/batch.hpp"
#include "fixed/fixed.hpp"

namespace batch_bench {

namespace {

template <class N>
bool same_results(const Operands<N>& x, const Operands<N>& y) {
  return x.out == y.out && x.moved == y.moved && x.points == y.points;
}

template <class N>
void add_pair(const std::string& name, const auto& batch, const auto& loop) {
  const auto add_one = [&name](const char* contender, const auto& run, const auto& other) {
    const auto make = [run, other](std::size_t count) {
      const auto x = std::make_shared<Operands<N>>(count);
      return Loop{[x, run] { run(*x); },
                  [x, other] {
                    Operands<N> y(x->out.size());
                    other(y);
                    return same_results(*x, y);
                  }};
    };
    benchmark::RegisterBenchmark((name + contender).c_str(), [make](benchmark::State& state) {
      time_loop(state, make);
    })->Arg(1024);
  };
  add_one("/batch", batch, loop);
  add_one("/loop", loop, batch);
}

template <class Operation, class N>
void loop_over(Operands<N>& x) {
  apply<Operation>(x.a.data(), x.b.data(), x.c.data(), x.out.data(), x.out.size());
}

template <class N>
void add_preset(const std::string& preset) {
  const std::string name = "preset/" + preset;
  add_pair<N>(
      name + "/multiply", [](Operands<N>& x) { fixed::batch::multiply(x.a, x.b, x.out); },
      [](Operands<N>& x) { loop_over<Multiply>(x); });
  add_pair<N>(
      name + "/divide", [](Operands<N>& x) { fixed::batch::divide(x.a, x.b, x.out); },
      [](Operands<N>& x) { loop_over<Divide>(x); });
  add_pair<N>(
      name + "/transform",
      [](Operands<N>& x) { fixed::batch::transform(x.rows, x.vertices, x.moved); },
      [](Operands<N>& x) {
        apply_transform(x.rows, x.vertices.data(), x.moved.data(), x.moved.size());
      });
  add_pair<N>(
      name + "/project",
      [](Operands<N>& x) { fixed::batch::project(x.vertices, x.constant, x.points); },
      [](Operands<N>& x) {
        apply_project(x.vertices.data(), x.constant, x.points.data(), x.points.size());
      });
}

}  // namespace

void add_presets() {
  add_preset<fixed::q16_16_saturating>("saturating");
  add_preset<fixed::q16_16_trapping>("trapping");
  add_preset<fixed::q16_16_i386>("i386");
  add_preset<fixed::q16_16_i8088>("i8088");
}

}  // namespace batch_bench
