// The batch operations on each of their paths, beside the type in a loop, the plain idiom, float
// and double, and beside copying what they read. Named operation/contender/elements: 1024 of them
// stay in the first caches, a million do not. Every result is first held against what integers of
// 128 bits make of the operands; floating point within what it resolves.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "bench/batch_operands.hpp"
#include "bench/batch_presets.hpp"
#include "fixed/batch.hpp"
#include "fixed/fixed.hpp"

namespace {

using namespace batch_bench;
using fixed::q16_16;
using fixed::batch::path;

void add(const std::string& name, const std::function<Loop(std::size_t)>& make) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [make](benchmark::State& state) { time_loop(state, make); })
      ->Arg(1024)
      ->Arg(1'000'000);
}

/// Whether x is the number whose stored integer is `right`; float within what it resolves.
template <class T>
bool same(T x, std::int64_t right) {
  if constexpr (std::is_floating_point_v<T>) {
    const double exact = static_cast<double>(right) / 65536;
    return std::fabs(static_cast<double>(x) - exact) <= std::fabs(exact) * 0x1p-20 + 0x1p-9;
  } else if constexpr (std::is_integral_v<T>) {
    return x == right;
  } else {
    return x.raw() == right;
  }
}

template <class Operation, class T>
bool right_elements(const std::vector<T>& out, bool truncates) {
  const Operands<std::int32_t> x(out.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!same(out[i], Operation::expected(x.a[i], x.b[i], x.c[i], truncates))) return false;
  }
  return true;
}

template <class Operation, class T>
void add_plain(const std::string& name, bool truncates = false) {
  add(name, [truncates](std::size_t count) {
    const auto x = std::make_shared<Operands<T>>(count);
    return Loop{[x, count] {
                  apply<Operation>(x->a.data(), x->b.data(), x->c.data(), x->out.data(), count);
                },
                [x, truncates] { return right_elements<Operation>(x->out, truncates); }};
  });
}

std::string name_of(path p) {
  return std::array{"portable", "neon", "avx2", "avx512"}[static_cast<std::size_t>(p)];
}

template <class Function>
void on_every_path(const Function& function) {
  using enum path;
  for (const path p : {portable, neon, avx2, avx512}) {
    if (fixed::batch::has(p)) function(p, name_of(p));
  }
}

template <class Operation, class Call>
void add_operation(const std::string& name, const Call& call) {
  on_every_path([&](path p, const std::string& path_name) {
    add(name + "/batch_" + path_name, [p, call](std::size_t count) {
      const auto x = std::make_shared<Operands<q16_16>>(count);
      return Loop{[x, p, call] {
                    call(*x, fixed::batch::options{p, {}});
                  },
                  [x] { return right_elements<Operation>(x->out, false); }};
    });
  });
  add_plain<Operation, q16_16>(name + "/q16_16");
  if constexpr (!std::is_same_v<Operation, Root>) {
    add_plain<Operation, std::int32_t>(name + "/idiom", true);
  }
  add_plain<Operation, float>(name + "/float");
  add_plain<Operation, double>(name + "/double");
}

template <class T>
bool right_vertices(const std::vector<std::array<T, 3>>& out) {
  const Operands<std::int32_t> x(out.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      std::int64_t sum = x.rows[k][3];
      for (std::size_t j = 0; j < 3; ++j)
        sum += nearest(Wide{x.rows[k][j]} * x.vertices[i][j], one);
      if (!same(out[i][k], sum)) return false;
    }
  }
  return true;
}

template <class T>
bool right_points(const std::vector<std::array<T, 2>>& out, bool truncates) {
  const Operands<std::int32_t> x(out.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& v = x.vertices[i];
      const std::int64_t quotient = Divide::expected(v[k], v[2], 0, truncates);
      if (!same(out[i][k], nearest(Wide{quotient} * x.constant, one))) return false;
    }
  }
  return true;
}

template <class T>
void add_plain_vertices(const std::string& contender, bool truncates = false) {
  add("transform/" + contender, [](std::size_t count) {
    const auto x = std::make_shared<Operands<T>>(count);
    return Loop{
        [x, count] { apply_transform(x->rows, x->vertices.data(), x->moved.data(), count); },
        [x] { return right_vertices(x->moved); }};
  });
  add("project/" + contender, [truncates](std::size_t count) {
    const auto x = std::make_shared<Operands<T>>(count);
    return Loop{
        [x, count] { apply_project(x->vertices.data(), x->constant, x->points.data(), count); },
        [x, truncates] { return right_points(x->points, truncates); }};
  });
}

void add_vertices() {
  on_every_path([](path p, const std::string& path_name) {
    const fixed::batch::options how{p, {}};
    add("transform/batch_" + path_name, [how](std::size_t count) {
      const auto x = std::make_shared<Operands<q16_16>>(count);
      return Loop{[x, how] { fixed::batch::transform(x->rows, x->vertices, x->moved, how); },
                  [x] { return right_vertices(x->moved); }};
    });
    add("transform_columns/batch_" + path_name, [how](std::size_t count) {
      const auto x = std::make_shared<Operands<q16_16>>(count);
      return Loop{[x, how] {
                    fixed::batch::transform(x->rows, x->a, x->c, x->b, x->out, x->out_y, x->out_z,
                                            how);
                  },
                  [x, count] {
                    for (std::size_t i = 0; i < count; ++i) {
                      x->moved[i] = {x->out[i], x->out_y[i], x->out_z[i]};
                    }
                    return right_vertices(x->moved);
                  }};
    });
    add("project/batch_" + path_name, [how](std::size_t count) {
      const auto x = std::make_shared<Operands<q16_16>>(count);
      return Loop{[x, how] { fixed::batch::project(x->vertices, x->constant, x->points, how); },
                  [x] { return right_points(x->points, false); }};
    });
  });
  add_plain_vertices<q16_16>("q16_16");
  add_plain_vertices<std::int32_t>("idiom", true);
  add_plain_vertices<float>("float");
  add_plain_vertices<double>("double");
  add("transform/copy", [](std::size_t count) {
    const auto x = std::make_shared<Operands<q16_16>>(count);
    const std::size_t bytes = count * sizeof x->vertices[0];
    return Loop{
        [x, bytes] { std::memcpy(static_cast<void*>(x->moved.data()), x->vertices.data(), bytes); },
        [x] { return x->moved == x->vertices; }};
  });
}

void add_dot() {
  const auto right = [](const Operands<q16_16>& x) {
    Wide sum = 0;
    for (std::size_t i = 0; i < x.a.size(); ++i) sum += Wide{x.a[i].raw()} * x.b[i].raw();
    const auto wrapped = static_cast<std::int32_t>(nearest(sum, one));
    return [&x, wrapped] { return x.out[0].raw() == wrapped; };
  };
  on_every_path([&](path p, const std::string& path_name) {
    add("dot/batch_" + path_name, [p, right](std::size_t count) {
      const auto x = std::make_shared<Operands<q16_16>>(count);
      return Loop{[x, p] { x->out[0] = fixed::batch::dot(x->a, x->b, p); },
                  [x, judge = right(*x)] { return judge(); }};
    });
  });
  add("dot/q16_16", [right](std::size_t count) {
    const auto x = std::make_shared<Operands<q16_16>>(count);
    return Loop{[x] { x->out[0] = fixed::dot(x->a, x->b); },
                [x, judge = right(*x)] { return judge(); }};
  });
}

}  // namespace

int main(int argc, char** argv) {
  add_operation<Multiply>(
      "multiply", [](auto& x, const auto& how) { fixed::batch::multiply(x.a, x.b, x.out, how); });
  add_operation<MulAdd>("mul_add", [](auto& x, const auto& how) {
    fixed::batch::mul_add(x.a, x.b, x.c, x.out, how);
  });
  add_operation<Divide>(
      "divide", [](auto& x, const auto& how) { fixed::batch::divide(x.a, x.b, x.out, how); });
  add_operation<Root>("sqrt",
                      [](auto& x, const auto& how) { fixed::batch::sqrt(x.c, x.out, how); });
  add_dot();
  add_vertices();
  add("copy", [](std::size_t count) {
    const auto x = std::make_shared<Operands<q16_16>>(count);
    const std::size_t bytes = count * sizeof(q16_16);
    return Loop{[x, bytes] { std::memcpy(static_cast<void*>(x->out.data()), x->a.data(), bytes); },
                [x] { return x->out == x->a; }};
  });
  add_presets();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
