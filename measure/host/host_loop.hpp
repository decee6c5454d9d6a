/// @file
/// The timed loops. Their operands and results are accessible, so that every timed result can be
/// judged.
#pragma once

#include <array>
#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "measure/host/host_numbers.hpp"
#include "xsharp/transform.hpp"

namespace fixproof::measure {

/// One result and its operands, in ulps.
struct HostCase {
  /// In the number's own precision: a, b; for a coordinate, a row of the transform and x, y, z.
  std::array<double, 7> operands{};
  double result = 0;
};

class HostLoop : private boost::noncopyable {
 public:
  HostLoop() = default;
  virtual ~HostLoop() = default;

  /// Sets the operands of apply_all(), case by case.
  virtual void load(std::span<const std::uint32_t> words) = 0;
  /// Computes independent results.
  virtual void apply_all() = 0;
  /// A result of the last apply_all(); `i` counts cases, or coordinates.
  [[nodiscard]] virtual HostCase result(std::size_t i) const = 0;

  /// Sets the start of apply_in_chain() and the additional operand of each step. Vertices have no
  /// chain.
  virtual void load_chain(std::uint32_t /*start*/, std::span<const std::uint32_t> /*words*/) {}
  /// Makes each result an operand of the next step.
  virtual void apply_in_chain() {}
  [[nodiscard]] virtual HostCase chain_result(std::size_t /*i*/) const { return {}; }
};

/// The operations of one or two operands. chained() gives the operands of a chain step from the
/// last result and the step's word.
struct HostProduct {
  static constexpr std::size_t operands = 2;
  template <class N>
  static N of(N a, N b) {
    return a * b;
  }
  template <class N>
  static std::pair<N, N> chained(N last, N taken) {
    return {last, taken};
  }
};

struct HostQuotient {
  static constexpr std::size_t operands = 2;
  template <class N>
  static N of(N a, N b) {
    return a / b;
  }
  template <class N>
  static std::pair<N, N> chained(N last, N taken) {
    return {taken, last};
  }
};

struct HostRoot {
  static constexpr std::size_t operands = 1;
  template <class N>
  static N of(N a, N /*none*/) {
    return MeasuredNumber<N>::root(a);
  }
  template <class N>
  static std::pair<N, N> chained(N last, N taken) {
    return {taken + last, taken};
  }
};

/// The cosine of an angle; there is no chain.
struct HostCosine {
  static constexpr std::size_t operands = 1;
  template <class N>
  static N of(N a, N /*none*/) {
    return MeasuredNumber<N>::cosine(a);
  }
  template <class N>
  static std::pair<N, N> chained(N /*last*/, N taken) {
    return {taken, taken};
  }
};

/// `__restrict` rules out aliasing, so that no contender pays for the possibility.
template <class Operation, class N>
[[gnu::noinline]] void apply_to_arrays(const N* __restrict a, const N* __restrict b,
                                       N* __restrict out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) out[i] = Operation::of(a[i], b[i]);
}

template <class Operation, class N>
[[gnu::noinline]] void apply_from_result_to_result(N x, const N* __restrict taken,
                                                   N* __restrict out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b] = Operation::chained(x, taken[i]);
    out[i] = x = Operation::of(a, b);
  }
}

/// The vertex loop of the pipeline, identical for all number types.
template <class N>
[[gnu::noinline]] void transform_vertices(const xsharp::Transform<N>& transform,
                                          const xsharp::Vec3<N>* __restrict in,
                                          xsharp::Vec3<N>* __restrict out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) out[i] = xsharp::apply_products(transform, in[i]);
}

template <class Operation, class N>
class ArrayLoop final : public HostLoop {
 public:
  void load(std::span<const std::uint32_t> words) override {
    a_.clear();
    b_.clear();
    for (std::size_t i = 0; i < words.size(); i += Operation::operands) {
      a_.push_back(Number::of_word(words[i]));
      b_.push_back(Number::of_word(words[i + Operation::operands - 1]));
    }
    out_.resize(a_.size());
  }
  void apply_all() override {
    apply_to_arrays<Operation>(a_.data(), b_.data(), out_.data(), a_.size());
  }
  [[nodiscard]] HostCase result(std::size_t i) const override {
    return seen(a_[i], b_[i], out_[i]);
  }

  void load_chain(std::uint32_t start, std::span<const std::uint32_t> words) override {
    starts_.fill(Number::of_word(start));
    taken_.clear();
    for (const std::uint32_t word : words) taken_.push_back(Number::of_word(word));
    chain_.resize(taken_.size());
  }
  void apply_in_chain() override {
    // The start depends on the last result, so that passes cannot overlap.
    unsigned char low = 0;
    std::memcpy(&low, &chain_.back(), 1);
    apply_from_result_to_result<Operation>(starts_[low & 1U], taken_.data(), chain_.data(),
                                           taken_.size());
  }
  [[nodiscard]] HostCase chain_result(std::size_t i) const override {
    const auto [a, b] = Operation::chained(i == 0 ? starts_[0] : chain_[i - 1], taken_[i]);
    return seen(a, b, chain_[i]);
  }

 private:
  using Number = MeasuredNumber<N>;

  static HostCase seen(N a, N b, N result) {
    return {{Number::in_units(a), Number::in_units(b)}, Number::in_units(result)};
  }

  std::vector<N> a_;
  std::vector<N> b_;
  std::vector<N> out_;
  std::array<N, 2> starts_{};  ///< equal values
  std::vector<N> taken_;
  std::vector<N> chain_;
};

/// A case has twelve words of a transform and three of a vertex. Only the first case's transform is
/// used.
template <class N>
class VertexLoop final : public HostLoop {
 public:
  void load(std::span<const std::uint32_t> words) override {
    for (std::size_t i = 0; i < 12; ++i) {
      transform_.rows[i / 4][i % 4] = Number::of_word(words[i]);
    }
    in_.clear();
    for (std::size_t i = 12; i < words.size(); i += 15) {
      in_.push_back({Number::of_word(words[i]), Number::of_word(words[i + 1]),
                     Number::of_word(words[i + 2])});
    }
    out_.resize(in_.size());
  }
  void apply_all() override { transform_vertices(transform_, in_.data(), out_.data(), in_.size()); }
  [[nodiscard]] HostCase result(std::size_t i) const override {
    HostCase seen;
    const auto& row = transform_.rows[i % 3];
    for (std::size_t k = 0; k < 4; ++k) seen.operands[k] = Number::in_units(row[k]);
    const auto& v = in_[i / 3];
    seen.operands[4] = Number::in_units(v.x);
    seen.operands[5] = Number::in_units(v.y);
    seen.operands[6] = Number::in_units(v.z);
    const auto& out = out_[i / 3];
    seen.result = Number::in_units(i % 3 == 0 ? out.x : i % 3 == 1 ? out.y : out.z);
    return seen;
  }

 private:
  using Number = MeasuredNumber<N>;

  xsharp::Transform<N> transform_;
  std::vector<xsharp::Vec3<N>> in_;
  std::vector<xsharp::Vec3<N>> out_;
};

}  // namespace fixproof::measure
