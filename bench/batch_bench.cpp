// Times batch operations on each path against loops over the type, the plain idiom, float and
// double, and against copying the operands. Names are operation/contender/elements: 1024 elements
// fit the first-level caches, a million do not, and ten million vertices fit no cache. First checks
// every result against 128-bit integers, floating point within its resolution.
#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "batch/batch.hpp"
#include "bench/batch_loops.hpp"
#include "bench/batch_operands.hpp"
#include "fixed/fixed.hpp"

namespace {

using namespace batch_bench;
using fixproof::q16_16;
using fixproof::batch::path;

template <class T>
Words words_for(const Operands<T>& x) {
  return Words(x.a.size());
}

template <class T>
std::shared_ptr<Operands<T>> operands(std::size_t count) {
  return std::make_shared<Operands<T>>(Words(count));
}

/// \param far also times a size that fits no cache
void add(const std::string& name, const std::function<Loop(std::size_t)>& make, bool far = false) {
  std::vector<std::int64_t> sizes{1024, 1'000'000};
  if (far) sizes.push_back(10'000'000);
  add_loop(name, sizes, make);
}

template <class Operation, class T>
void add_plain(const std::string& name) {
  add(name, [](std::size_t count) {
    const auto x = operands<T>(count);
    return Loop{[x, count] {
                  apply<Operation>(x->a.data(), x->b.data(), x->c.data(), x->out.data(), count);
                },
                [x] { return right_elements<Operation>(words_for(*x), x->out); }};
  });
}

std::string name_of(path p) {
  return std::array{"portable", "neon", "avx2", "avx512"}[static_cast<std::size_t>(p)];
}

template <class Function>
void on_every_path(const Function& function) {
  using enum path;
  for (const path p : {portable, neon, avx2, avx512}) {
    if (fixproof::batch::has(p)) function(p, name_of(p));
  }
}

template <class Operation, class Call>
void add_operation(const std::string& name, const Call& call) {
  on_every_path([&](path p, const std::string& path_name) {
    add(name + "/batch_" + path_name, [p, call](std::size_t count) {
      const auto x = operands<q16_16>(count);
      return Loop{[x, p, call] {
                    call(*x, fixproof::batch::options{p, {}});
                  },
                  [x] { return right_elements<Operation>(words_for(*x), x->out); }};
    });
  });
  add_plain<Operation, q16_16>(name + "/q16_16");
  if constexpr (!std::is_same_v<Operation, Root>) {
    add_plain<Operation, std::int32_t>(name + "/idiom");
  }
  add_plain<Operation, float>(name + "/float");
  add_plain<Operation, double>(name + "/double");
}

template <class T>
void add_plain_vertices(const std::string& contender) {
  add("transform/" + contender, [](std::size_t count) {
    const auto x = operands<T>(count);
    return Loop{
        [x, count] { apply_transform(x->rows, x->vertices.data(), x->moved.data(), count); },
        [x] { return right_vertices(words_for(*x), x->moved); }};
  });
  add("project/" + contender, [](std::size_t count) {
    const auto x = operands<T>(count);
    return Loop{
        [x, count] { apply_project(x->vertices.data(), x->constant, x->points.data(), count); },
        [x] { return right_points(words_for(*x), x->points); }};
  });
}

void add_vertices() {
  on_every_path([](path p, const std::string& path_name) {
    const fixproof::batch::options how{p, {}};
    const bool far = p == fixproof::batch::best();
    add(
        "transform/batch_" + path_name,
        [how](std::size_t count) {
          const auto x = operands<q16_16>(count);
          return Loop{[x, how] { fixproof::batch::transform(x->rows, x->vertices, x->moved, how); },
                      [x] { return right_vertices(words_for(*x), x->moved); }};
        },
        far);
    add(
        "transform_columns/batch_" + path_name,
        [how](std::size_t count) {
          const auto x = operands<q16_16>(count);
          return Loop{[x, how] {
                        fixproof::batch::transform(x->rows, x->a, x->c, x->b, x->out, x->out_y,
                                                   x->out_z, how);
                      },
                      [x, count] {
                        for (std::size_t i = 0; i < count; ++i) {
                          x->moved[i] = {x->out[i], x->out_y[i], x->out_z[i]};
                        }
                        return right_vertices(words_for(*x), x->moved);
                      }};
        },
        far);
    add("project/batch_" + path_name, [how](std::size_t count) {
      const auto x = operands<q16_16>(count);
      return Loop{[x, how] { fixproof::batch::project(x->vertices, x->constant, x->points, how); },
                  [x] { return right_points(words_for(*x), x->points); }};
    });
  });
  add_plain_vertices<q16_16>("q16_16");
  add_plain_vertices<std::int32_t>("idiom");
  add_plain_vertices<float>("float");
  add_plain_vertices<double>("double");
  add(
      "transform/copy",
      [](std::size_t count) {
        const auto x = operands<q16_16>(count);
        const std::size_t bytes = count * sizeof x->vertices[0];
        return Loop{[x, bytes] {
                      std::memcpy(static_cast<void*>(x->moved.data()), x->vertices.data(), bytes);
                    },
                    [x] { return x->moved == x->vertices; }};
      },
      true);
}

void add_dot() {
  on_every_path([&](path p, const std::string& path_name) {
    add("dot/batch_" + path_name, [p](std::size_t count) {
      const auto x = operands<q16_16>(count);
      return Loop{[x, p] { x->out[0] = fixproof::batch::dot(x->a, x->small, p); },
                  [x] { return right_dot(words_for(*x), x->out[0]); }};
    });
  });
  add("dot/q16_16", [](std::size_t count) {
    const auto x = operands<q16_16>(count);
    return Loop{[x] { x->out[0] = fixproof::dot(x->a, x->small); },
                [x] { return right_dot(words_for(*x), x->out[0]); }};
  });
}

}  // namespace

int main(int argc, char** argv) {
  add_operation<Multiply>("multiply", [](auto& x, const auto& how) {
    fixproof::batch::multiply(x.a, x.b, x.out, how);
  });
  add_operation<MulAdd>("mul_add", [](auto& x, const auto& how) {
    fixproof::batch::mul_add(x.a, x.b, x.c, x.out, how);
  });
  add_operation<Divide>(
      "divide", [](auto& x, const auto& how) { fixproof::batch::divide(x.a, x.b, x.out, how); });
  add_operation<Root>("sqrt",
                      [](auto& x, const auto& how) { fixproof::batch::sqrt(x.c, x.out, how); });
  add_dot();
  add_vertices();
  add("copy", [](std::size_t count) {
    const auto x = operands<q16_16>(count);
    const std::size_t bytes = count * sizeof(q16_16);
    return Loop{[x, bytes] { std::memcpy(static_cast<void*>(x->out.data()), x->a.data(), bytes); },
                [x] { return x->out == x->a; }};
  });
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
