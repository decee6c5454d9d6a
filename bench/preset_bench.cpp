// Every operation under every preset: the batch on the quickest path beside a loop over the type,
// on 1024 elements, which stay in the first caches. Named preset/operation/batch and .../loop. Each
// is first held against what integers of 128 bits make of the operands by the rules of the preset,
// and where these never throw, of words that overflow too.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <memory>
#include <string>

#include "bench/batch_loops.hpp"
#include "bench/batch_operands.hpp"
#include "fixed/batch.hpp"
#include "fixed/fixed.hpp"

namespace {

using namespace batch_bench;

template <class N>
std::shared_ptr<Operands<N>> operands(const Words& words) {
  return std::make_shared<Operands<N>>(words);
}

template <class N>
struct Preset {
  std::string name;

  /// \param run         of Operands<N>&
  /// \param right       of Words and the Operands<N> that were run
  /// \param may_be_any  whether no word makes it throw
  void add(const std::string& contender, const auto& run, const auto& right,
           bool may_be_any = N::never_throws) const {
    add_loop(name + '/' + contender, {1024}, [=](std::size_t count) {
      const auto is_right = [=](Draw draw) {
        const Words words(count, N::fraction_bits, draw);
        const auto x = operands<N>(words);
        run(*x);
        return right(words, *x);
      };
      const auto x = operands<N>(Words(count, N::fraction_bits, Draw::in_range));
      return Loop{[=] { run(*x); },
                  [=] {
                    return right(Words(count, N::fraction_bits, Draw::in_range), *x) &&
                           (!may_be_any || is_right(Draw::any));
                  }};
    });
  }

  template <class Operation>
  void add_operation(const std::string& operation, const auto& batch,
                     bool may_be_any = N::never_throws) const {
    const auto right = [](const Words& words, const Operands<N>& x) {
      return right_elements<Operation>(words, x.out);
    };
    add(operation + "/batch", batch, right, may_be_any);
    add(
        operation + "/loop",
        [](Operands<N>& x) {
          apply<Operation>(x.a.data(), x.b.data(), x.c.data(), x.out.data(), x.out.size());
        },
        right, may_be_any);
  }

  void add_all() const {
    add_operation<Multiply>("multiply",
                            [](Operands<N>& x) { fixed::batch::multiply(x.a, x.b, x.out); });
    add_operation<MulAdd>("mul_add",
                          [](Operands<N>& x) { fixed::batch::mul_add(x.a, x.b, x.c, x.out); });
    add_operation<Divide>(
        "divide", [](Operands<N>& x) { fixed::batch::divide(x.a, x.b, x.out); },
        N::divide_never_throws);
    add_operation<Root>("sqrt", [](Operands<N>& x) { fixed::batch::sqrt(x.c, x.out); });

    const auto dot = [](const Words& words, const Operands<N>& x) {
      return right_dot(words, x.out[0]);
    };
    add(
        "dot/batch", [](Operands<N>& x) { x.out[0] = fixed::batch::dot(x.a, x.small); }, dot);
    add(
        "dot/loop", [](Operands<N>& x) { x.out[0] = fixed::dot(x.a, x.small); }, dot);

    const auto vertices = [](const Words& words, const Operands<N>& x) {
      return right_vertices(words, x.moved);
    };
    add(
        "transform/batch",
        [](Operands<N>& x) { fixed::batch::transform(x.rows, x.vertices, x.moved); }, vertices);
    add(
        "transform/loop",
        [](Operands<N>& x) {
          apply_transform(x.rows, x.vertices.data(), x.moved.data(), x.moved.size());
        },
        vertices);

    const auto points = [](const Words& words, const Operands<N>& x) {
      return right_points(words, x.points);
    };
    add(
        "project/batch",
        [](Operands<N>& x) { fixed::batch::project(x.vertices, x.constant, x.points); }, points,
        N::divide_never_throws);
    add(
        "project/loop",
        [](Operands<N>& x) {
          apply_project(x.vertices.data(), x.constant, x.points.data(), x.points.size());
        },
        points, N::divide_never_throws);
  }
};

/// The presets of 16.16 or of 8.8.
template <int F>
void add_presets(const std::string& prefix) {
  using namespace fixed;
  Preset<number<F>>{prefix}.add_all();
  Preset<number<F, policies::saturating>>{prefix + "_saturating"}.add_all();
  Preset<number<F, policies::trapping>>{prefix + "_trapping"}.add_all();
  Preset<number<F, policies::i386_rounded>>{prefix + "_i386"}.add_all();
  Preset<number<F, policies::i386_mul_rounded>>{prefix + "_i386_mul_rounded"}.add_all();
  Preset<number<F, policies::i386_div_rounded>>{prefix + "_i386_div_rounded"}.add_all();
  Preset<number<F, policies::i386_unrounded>>{prefix + "_i386_unrounded"}.add_all();
  Preset<number<F, policies::i8088_rounded>>{prefix + "_i8088"}.add_all();
  Preset<number<F, policies::i8088_mul_rounded>>{prefix + "_i8088_mul_rounded"}.add_all();
  Preset<number<F, policies::i8088_div_rounded>>{prefix + "_i8088_div_rounded"}.add_all();
  Preset<number<F, policies::i8088_unrounded>>{prefix + "_i8088_unrounded"}.add_all();
}

}  // namespace

int main(int argc, char** argv) {
  add_presets<16>("q16_16");
  add_presets<8>("q8_8");
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
