/// @file
/// Expected result and fault of one batch element. They come from the operators of the number type
/// under its policy and under policies that treat faults differently.
#pragma once

#include "fixed/batch/batch.hpp"
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace batch_test {

enum class Fault { none, divide_error, overflow, domain_error };

template <class Number>
struct Expected {
  Number value;
  Fault fault = Fault::none;
};

/// The policy without exceptions. It gives the value that a batch writes for a faulty element.
constexpr fixproof::policy quiet(fixproof::policy p) {
  if (p.range == fixproof::overflow::trap) p.range = fixproof::overflow::wrap;
  p.fault = fixproof::divide_fault::none;
  return p;
}

/// The policy that throws on every fault that a report counts.
constexpr fixproof::policy loud(fixproof::policy p) {
  if (p.range == fixproof::overflow::saturate) p.range = fixproof::overflow::trap;
  return p;
}

template <class Number, fixproof::policy P>
auto as(Number x) {
  return fixproof::number<typename Number::raw_type, Number::fraction_bits, P>::from_raw(x.raw());
}

/// Expects `operation` of the numbers. The callable receives them under both policies.
template <class Number, class Operation, class... Numbers>
Expected<Number> expected(const Operation& operation, Numbers... numbers) {
  constexpr fixproof::policy P = Number::rules;
  Expected<Number> result{
      as<fixproof::number<typename Number::raw_type, Number::fraction_bits, quiet(P)>, P>(
          operation(as<Number, quiet(P)>(numbers)...))};
  try {
    static_cast<void>(operation(as<Number, loud(P)>(numbers)...));
  } catch (const fixproof::divide_error&) {
    result.fault = Fault::divide_error;
  } catch (const fixproof::overflow_error&) {
    result.fault = Fault::overflow;
  } catch (const fixproof::domain_error&) {
    result.fault = Fault::domain_error;
  }
  return result;
}

/// Expects a quotient. A zero divisor always counts as a fault, whatever the policy does with it.
template <class Number>
Expected<Number> expected_quotient(Number n, Number d) {
  auto result = expected<Number>([](auto a, auto b) { return a / b; }, n, d);
  if constexpr (Number::rules.range == fixproof::overflow::wrap) {
    if (!fixproof::try_divide(n, d)) result.fault = Fault::divide_error;
  }
  return result;
}

/// The fault of an element is the first fault of its steps.
template <class Number>
Fault first_fault(std::initializer_list<Expected<Number>> steps) {
  for (const auto& step : steps) {
    if (step.fault != Fault::none) return step.fault;
  }
  return Fault::none;
}

/// The marks and the report of a batch, both filled with noise at first.
class Marked {
 public:
  // NOLINTNEXTLINE(*-avoid-c-arrays): std::vector<bool> is no span
  explicit Marked(std::size_t count) : size_(count), marks_(std::make_unique<bool[]>(count)) {
    for (std::size_t i = 0; i < count; ++i) marks_[i] = i % 3 == 0;
  }
  fixproof::batch::options how(fixproof::batch::path path) { return {path, {marks_.get(), size_}}; }

  /// Compares the marks and the report with the expected faults.
  void check(const fixproof::batch::report& report, const std::vector<Fault>& faults) const {
    fixproof::batch::report whole;
    for (std::size_t i = 0; i < faults.size(); ++i) {
      ASSERT_EQ(marks_[i], faults[i] != Fault::none) << "element " << i;
      if (faults[i] == Fault::none) continue;
      whole.divide_errors += faults[i] == Fault::divide_error ? 1U : 0U;
      whole.overflows += faults[i] == Fault::overflow ? 1U : 0U;
      whole.domain_errors += faults[i] == Fault::domain_error ? 1U : 0U;
      whole.first = std::min(whole.first, i);
    }
    EXPECT_EQ(report.divide_errors, whole.divide_errors);
    EXPECT_EQ(report.overflows, whole.overflows);
    EXPECT_EQ(report.domain_errors, whole.domain_errors);
    EXPECT_EQ(report.first, whole.first);
  }

 private:
  std::size_t size_;
  // NOLINTNEXTLINE(*-avoid-c-arrays): std::vector<bool> is no span
  std::unique_ptr<bool[]> marks_;
};

/// The paths that this processor has. The fastest has code of its own for short spans.
inline std::vector<fixproof::batch::path> paths() {
  using enum fixproof::batch::path;
  std::vector<fixproof::batch::path> there;
  for (const auto path : {portable, neon, avx2, avx512, fastest}) {
    if (fixproof::batch::has(path)) there.push_back(path);
  }
  return there;
}

/// Lengths with and without a remainder on every path, and some that span many blocks.
inline std::vector<std::size_t> lengths() {
  std::vector<std::size_t> all;
  for (std::size_t n = 0; n <= 70; ++n) all.push_back(n);
  all.insert(all.end(), {127, 128, 1000});
  return all;
}

/// Operands of small and large magnitude, including range ends, zeros and ones.
template <class Number>
std::vector<Number> operands(std::size_t count, unsigned seed) {
  using raw = typename Number::raw_type;
  using limits = std::numeric_limits<raw>;
  std::mt19937 random(seed);
  constexpr std::int32_t one = 1 << Number::fraction_bits;
  constexpr auto special = std::to_array<std::int32_t>(
      {0, 1, -1, limits::max(), limits::min(), one, -one, limits::min() + 1, 3});
  std::vector<Number> all(count);
  for (Number& x : all) {
    const auto word = static_cast<std::int32_t>(random());
    const std::int32_t drawn =
        random() % 8 == 0 ? special[random() % special.size()]
                          : (word >> (32 - limits::digits - 1)) >> (random() % limits::digits);
    x = Number::from_raw(static_cast<raw>(drawn));
  }
  return all;
}

/// A result buffer with `before` guard elements in front and one behind.
template <class T>
class Guarded {
 public:
  explicit Guarded(std::size_t count, std::size_t before = 1)
      : before_(before), all_(before + count + 1) {
    std::memset(static_cast<void*>(all_.data()), 0x5a, all_.size() * sizeof(T));
  }
  std::span<T> inside() { return std::span(all_).subspan(before_, all_.size() - before_ - 1); }
  std::vector<T> copy() { return {inside().begin(), inside().end()}; }
  [[nodiscard]] bool intact() const {
    T noise;
    std::memset(static_cast<void*>(&noise), 0x5a, sizeof(T));
    return std::memcmp(&noise, &all_[before_ - 1], sizeof(T)) == 0 &&
           std::memcmp(&noise, &all_.back(), sizeof(T)) == 0;
  }

 private:
  std::size_t before_;
  std::vector<T> all_;
};

}  // namespace batch_test
