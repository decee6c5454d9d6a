/// @file
/// Contenders, their verification and their timing. A kernel K computes one operation:
///
///     using in, out                     the types of its elements
///     static constexpr const char* name
///     static void run(const View<in, out>&, std::size_t count)
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "measure/bench/fair/columns.hpp"
#include "measure/bench/fair/operations.hpp"

namespace fair {

/// One contender with its arrays.
class Run {
 public:
  Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  virtual ~Run() = default;
  virtual void run(std::size_t times) = 0;
  /// Returns the largest error of the last run.
  [[nodiscard]] virtual Ulp error() const = 0;
};

/// A function that forms a chain with `Op`: each result is an operand of the next.
template <class Op, class F>
struct Chain {
  using in = typename F::in;
  using out = typename F::in;
  static constexpr const char* name = F::name;
  static void run(const View<in, out>& v, std::size_t count) {
    in last = of_word<in>(Op::chain[0]);
    for (std::size_t i = 0; i < count; ++i) {
      const auto [a, b] = Op::link(last, v.b[i]);
      last = F::of(a, b);
      v.x[i] = last;
    }
  }
};

/// The operation of a chain. Each exact result follows from the contender's last result.
template <class Op>
struct Chained {
  static constexpr std::size_t inputs = 2, outputs = 1, results = 1;
  static Drawn draw(Draw& /*from*/) { return {}; }
  /// None: the same function is tried at the edges in a loop.
  static std::vector<Words> edge_words() { return {}; }
  template <class In>
  static In input(const Words& /*words*/, std::size_t /*k*/, std::size_t i) {
    return of_word<In>(Op::chain[1 + i % 2]);
  }
  template <class Arrays>
  static Ulp error(const Words& /*words*/, const Arrays& arrays, std::size_t count) {
    Ulp largest = 0;
    Ulp last = Op::chain[0];
    for (std::size_t i = 0; i < count; ++i) {
      const auto [a, b] = Op::link(last, Ulp{1} * Op::chain[1 + i % 2]);
      last = arrays.result(i, 0);
      largest = std::max(largest, std::abs(last - Op::of(a, b)));
    }
    return largest;
  }
};

/// Returns the largest error of all elements.
template <class Op, class Arrays>
Ulp largest_error(const Words& words, const Arrays& arrays, std::size_t count) {
  if constexpr (requires { Op::error(words, arrays, count); }) {
    return Op::error(words, arrays, count);
  } else {
    Ulp largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < Op::results; ++k) {
        const Ulp off = std::abs(arrays.result(i, k) - Op::exact(words, i, k));
        largest = std::max(largest, std::isnan(off) ? no_result : off);
      }
    }
    return largest;
  }
}

template <class Op, class K>
class KernelRun final : public Run {
 public:
  KernelRun(const Words& words, std::size_t count, std::size_t offset)
      : words_(words), count_(count), arrays_(words, count, offset), view_(arrays_.view()) {}

  void run(std::size_t times) override {
    for (; times != 0; --times) {
      once(view_, count_);
      asm volatile("" : : : "memory");
    }
  }
  [[nodiscard]] Ulp error() const override { return largest_error<Op>(words_, arrays_, count_); }

 private:
  using in = typename K::in;
  using out = typename K::out;

  [[gnu::noinline, gnu::flatten]] static void once(const View<in, out>& view, std::size_t count) {
    K::run(view, count);
  }

  const Words& words_;
  std::size_t count_;
  Arrays<Op, in, out> arrays_;
  View<in, out> view_;
};

/// A loop over F::of(a) or F::of(a, b), which returns a result, or two in an array.
template <class F>
struct Each {
  using in = typename F::in;
  using out = typename F::out;
  static constexpr const char* name = F::name;
  static void run(const View<in, out>& v, std::size_t count) {
    const in* __restrict a = v.a;
    const in* __restrict b = v.b;
    out* __restrict x = v.x;
    out* __restrict y = v.y;
    for (std::size_t i = 0; i < count; ++i) {
      if constexpr (requires { x[i] = F::of(a[i]); }) {
        x[i] = F::of(a[i]);
      } else if constexpr (requires { x[i] = F::of(a[i], b[i]); }) {
        x[i] = F::of(a[i], b[i]);
      } else {
        const auto results = F::of(a[i]);
        x[i] = results[0];
        y[i] = results[1];
      }
    }
  }
};

enum class Role { ours, peer };

struct Contender {
  std::string name;
  Role role;
  std::unique_ptr<Run> (*make)(const Words&, std::size_t count, std::size_t offset);
  /// The largest error over the edges, once it is known; negative before.
  Ulp edge_error = -1;
};

template <class Op, class K>
Contender contender(Role role) {
  return {K::name, role, [](const Words& words, std::size_t count, std::size_t offset) {
            return std::unique_ptr<Run>(std::make_unique<KernelRun<Op, K>>(words, count, offset));
          }};
}

/// Elements, and the offset of each array in bytes.
using Sizes = std::vector<std::pair<std::size_t, std::size_t>>;

/// The contenders of one operation, in one shape.
struct Group {
  std::string operation;
  std::string shape;  ///< chain, loop or batch
  std::vector<Contender> contenders;
  std::vector<Words> (*edges)();
  Words (*draw)(std::size_t count);
  Sizes sizes;
};

template <class Op>
std::vector<Words> edges_of() {
  if constexpr (requires { Op::edge_words(); }) {
    return Op::edge_words();
  } else {
    return {lattice<Op>()};
  }
}

/// The groups of one operation.
template <class Op>
class Operation {
 public:
  Operation(const char* name, const Sizes& batches)
      : chain_{name, "chain", {}, edges_of<Chained<Op>>, drawn<Chained<Op>>, {{4096, 0}}},
        loop_{name, "loop", {}, edges_of<Op>, drawn<Op>, {{4096, 0}}},
        batch_{name, "batch", {}, edges_of<Op>, drawn<Op>, batches} {}

  template <class F>
  Operation& in_chain(Role role = Role::peer) {
    chain_.contenders.push_back(contender<Chained<Op>, Chain<Op, F>>(role));
    return *this;
  }
  /// A loop over elements. Peers compete with batches too.
  template <class K>
  Operation& in_loop(Role role = Role::peer) {
    loop_.contenders.push_back(contender<Op, K>(role));
    return role == Role::peer ? in_batch<K>() : *this;
  }
  template <class K>
  Operation& in_batch(Role role = Role::peer) {
    batch_.contenders.push_back(contender<Op, K>(role));
    return *this;
  }
  /// A function of one or two words, in a chain and in a loop.
  template <class F>
  Operation& each(Role role = Role::peer) {
    in_chain<F>(role);
    return in_loop<Each<F>>(role);
  }

  void add_to(std::vector<Group>& all) const {
    for (const Group* one : {&chain_, &loop_, &batch_}) {
      if (!one->contenders.empty()) all.push_back(*one);
    }
  }

 private:
  Group chain_, loop_, batch_;
};

}  // namespace fair
