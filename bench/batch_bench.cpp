// The batch operations on each of their paths, beside the type in a loop, the plain idiom, float
// and double, and beside copying what they read. Named operation/contender/elements: 1024 of them
// stay in the first caches, a million do not. Every result is held against what it should be first.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "fixed/batch.hpp"
#include "fixed/fixed.hpp"

namespace {

using fixed::q16_16;
using fixed::batch::path;
using Rounded = q16_16;
using Truncated = fixed::number<16, fixed::policy{.divide = fixed::rounding::truncate}>;

template <class T>
T of_raw(std::int32_t raw) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(raw) / 65536;
  } else if constexpr (std::is_integral_v<T>) {
    return raw;
  } else {
    return T::from_raw(raw);
  }
}

/// Operands within +-128 and divisors from a half, so that nothing overflows; and room for results.
template <class T>
struct Operands {
  std::vector<T> a, b, c, out, out_y, out_z;
  std::vector<std::array<T, 3>> vertices, moved;
  std::vector<std::array<T, 2>> points;
  std::array<std::array<T, 4>, 3> rows{};
  T constant = of_raw<T>(-100 * 65536);

  explicit Operands(std::size_t count)
      : out(count), out_y(count), out_z(count), moved(count), points(count) {
    std::mt19937 random(54);
    const auto draw = [&random](int bits) {
      return static_cast<std::int32_t>(random()) >> (32 - bits);
    };
    for (std::size_t i = 0; i < count; ++i) {
      a.push_back(of_raw<T>(draw(24)));
      const std::int32_t magnitude = (draw(24) & 0x7fffff) | 0x8000;
      b.push_back(of_raw<T>(draw(1) < 0 ? -magnitude : magnitude));
      c.push_back(of_raw<T>(draw(24)));
      vertices.push_back({a[i], c[i], b[i]});
    }
    for (auto& row : rows) {
      for (T& x : row) x = of_raw<T>(draw(18));
    }
  }
};

/// One loop: what is timed, and whether the results of the last run are right.
struct Loop {
  std::function<void()> run;
  std::function<bool()> right;
};

void time_loop(benchmark::State& state, const std::function<Loop(std::size_t)>& make) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Loop loop = make(count);
  loop.run();
  if (!loop.right()) {
    state.SkipWithError("wrong result");
    return;
  }
  for ([[maybe_unused]] auto _ : state) {
    loop.run();
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void add(const std::string& name, const std::function<Loop(std::size_t)>& make) {
  benchmark::RegisterBenchmark(name.c_str(),
                               [make](benchmark::State& state) { time_loop(state, make); })
      ->Arg(1024)
      ->Arg(1'000'000);
}

/// The operations, for one element, as each kind of number has them.
struct Multiply {
  template <class T>
  static T of(T a, T b, T /*c*/) {
    if constexpr (std::is_integral_v<T>) {
      return static_cast<T>((std::int64_t{a} * b + 0x8000) >> 16);
    } else {
      return a * b;
    }
  }
};
struct MulAdd {
  template <class T>
  static T of(T a, T b, T c) {
    if constexpr (std::is_integral_v<T>) {
      return static_cast<T>((std::int64_t{a} * b + std::int64_t{c} * 65536 + 0x8000) >> 16);
    } else if constexpr (std::is_floating_point_v<T>) {
      return a * b + c;
    } else {
      return fixed::mul_add(a, b, c);
    }
  }
};
struct Divide {
  template <class T>
  static T of(T a, T b, T /*c*/) {
    if constexpr (std::is_integral_v<T>) {
      return static_cast<T>(std::int64_t{a} * 65536 / b);
    } else {
      return a / b;
    }
  }
};
struct Root {
  template <class T>
  static T of(T a, T /*b*/, T /*c*/) {
    if constexpr (std::is_floating_point_v<T>) {
      return std::sqrt(a);
    } else {
      return fixed::sqrt(a);
    }
  }
};

template <class Operation, class T>
[[gnu::noinline]] void apply(const T* __restrict a, const T* __restrict b, const T* __restrict c,
                             T* __restrict out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) out[i] = Operation::of(a[i], b[i], c[i]);
}

template <class T>
[[gnu::noinline]] void apply_transform(const std::array<std::array<T, 4>, 3>& rows,
                                       const std::array<T, 3>* __restrict in,
                                       std::array<T, 3>* __restrict out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto product = [&](std::size_t j) { return Multiply::of(rows[k][j], in[i][j], T{}); };
      out[i][k] = static_cast<T>(product(0) + product(1) + product(2) + rows[k][3]);
    }
  }
}

template <class T>
[[gnu::noinline]] void apply_project(const std::array<T, 3>* __restrict in, T constant,
                                     std::array<T, 2>* __restrict out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      out[i][k] = Multiply::of(Divide::of(in[i][k], in[i][2], T{}), constant, T{});
    }
  }
}

/// Whether x is the number that `right` is; float within what it resolves.
template <class T, class N>
bool same(T x, N right) {
  if constexpr (std::is_floating_point_v<T>) {
    const auto exact = static_cast<double>(right);
    return std::fabs(static_cast<double>(x) - exact) <= std::fabs(exact) * 1e-4 + 1e-2;
  } else if constexpr (std::is_integral_v<T>) {
    return x == right.raw();
  } else {
    return x.raw() == right.raw();
  }
}

/// `Right` is the type that has the rounding of T.
template <class Operation, class T, class Right>
bool right_elements(const std::vector<T>& out) {
  const Operands<Right> operands(out.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Right a = operands.a[i];
    if (std::is_same_v<Operation, Root> && a.raw() < 0) continue;  // NaN in floating point
    if (!same(out[i], Operation::of(a, operands.b[i], operands.c[i]))) return false;
  }
  return true;
}

template <class Operation, class T, class Right>
void add_plain(const std::string& name) {
  add(name, [](std::size_t count) {
    const auto x = std::make_shared<Operands<T>>(count);
    return Loop{[x, count] {
                  apply<Operation>(x->a.data(), x->b.data(), x->c.data(), x->out.data(), count);
                },
                [x] { return right_elements<Operation, T, Right>(x->out); }};
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
                  [x] { return right_elements<Operation, q16_16, Rounded>(x->out); }};
    });
  });
  add_plain<Operation, q16_16, Rounded>(name + "/q16_16");
  if constexpr (!std::is_same_v<Operation, Root>) {
    using Right = std::conditional_t<std::is_same_v<Operation, Divide>, Truncated, Rounded>;
    add_plain<Operation, std::int32_t, Right>(name + "/idiom");
  }
  add_plain<Operation, float, Rounded>(name + "/float");
  add_plain<Operation, double, Rounded>(name + "/double");
}

template <std::size_t size, class T, class Right>
bool right_tuples(const std::vector<std::array<T, size>>& out) {
  Operands<Right> operands(out.size());
  std::vector<std::array<Right, size>> right(out.size());
  if constexpr (size == 3) {
    apply_transform(operands.rows, operands.vertices.data(), right.data(), out.size());
  } else {
    apply_project(operands.vertices.data(), operands.constant, right.data(), out.size());
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    for (std::size_t k = 0; k < size; ++k) {
      if (!same(out[i][k], right[i][k])) return false;
    }
  }
  return true;
}

template <class T, class Right>
void add_plain_vertices(const std::string& contender) {
  add("transform/" + contender, [](std::size_t count) {
    const auto x = std::make_shared<Operands<T>>(count);
    return Loop{
        [x, count] { apply_transform(x->rows, x->vertices.data(), x->moved.data(), count); },
        [x] { return right_tuples<3, T, Rounded>(x->moved); }};
  });
  add("project/" + contender, [](std::size_t count) {
    const auto x = std::make_shared<Operands<T>>(count);
    return Loop{
        [x, count] { apply_project(x->vertices.data(), x->constant, x->points.data(), count); },
        [x] { return right_tuples<2, T, Right>(x->points); }};
  });
}

void add_vertices() {
  on_every_path([](path p, const std::string& path_name) {
    const fixed::batch::options how{p, {}};
    add("transform/batch_" + path_name, [how](std::size_t count) {
      const auto x = std::make_shared<Operands<q16_16>>(count);
      return Loop{[x, how] { fixed::batch::transform(x->rows, x->vertices, x->moved, how); },
                  [x] { return right_tuples<3, q16_16, Rounded>(x->moved); }};
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
                    return right_tuples<3, q16_16, Rounded>(x->moved);
                  }};
    });
    add("project/batch_" + path_name, [how](std::size_t count) {
      const auto x = std::make_shared<Operands<q16_16>>(count);
      return Loop{[x, how] { fixed::batch::project(x->vertices, x->constant, x->points, how); },
                  [x] { return right_tuples<2, q16_16, Rounded>(x->points); }};
    });
  });
  add_plain_vertices<q16_16, Rounded>("q16_16");
  add_plain_vertices<std::int32_t, Truncated>("idiom");
  add_plain_vertices<float, Rounded>("float");
  add_plain_vertices<double, Rounded>("double");
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
    return [&x, sum = fixed::dot(x.a, x.b)] { return x.out[0] == sum; };
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
                      [](auto& x, const auto& how) { fixed::batch::sqrt(x.a, x.out, how); });
  add_dot();
  add_vertices();
  add("copy", [](std::size_t count) {
    const auto x = std::make_shared<Operands<q16_16>>(count);
    const std::size_t bytes = count * sizeof(q16_16);
    return Loop{[x, bytes] { std::memcpy(static_cast<void*>(x->out.data()), x->a.data(), bytes); },
                [x] { return x->out == x->a; }};
  });
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
