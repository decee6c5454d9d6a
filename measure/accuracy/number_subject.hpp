/// @file
/// Makes accuracy subjects from number types.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "measure/accuracy/subjects.hpp"
#include "measure/host/host_numbers.hpp"

namespace fixproof::measure {

/// The operations, on the operands `x` of a case. A number may lack those with a decltype.
namespace operations {

inline constexpr auto product = []<class N>(const N* x) { return x[0] * x[1]; };
/// Empty for a divide error.
inline constexpr auto quotient = []<class N>(const N* x) -> std::optional<N> {
  if constexpr (requires { fixproof::try_divide(x[0], x[1]); }) {
    return fixproof::try_divide(x[0], x[1]);
  } else {
    return x[0] / x[1];
  }
};
inline constexpr auto root = []<class N>(const N* x) -> decltype(MeasuredNumber<N>::root(*x)) {
  return MeasuredNumber<N>::root(*x);
};
inline constexpr auto cosine = []<class N>(const N* x) -> decltype(MeasuredNumber<N>::cosine(*x)) {
  return MeasuredNumber<N>::cosine(*x);
};
inline constexpr auto sine = []<class N>(const N* x) -> decltype(MeasuredNumber<N>::sine(*x)) {
  return MeasuredNumber<N>::sine(*x);
};
inline constexpr auto sine_of_radians =
    []<class N>(const N* x) -> decltype(MeasuredNumber<N>::sine_of_radians(*x)) {
  return MeasuredNumber<N>::sine_of_radians(*x);
};
inline constexpr auto rounded_products = []<class N>(const N* x) {
  return x[0] * x[3] + x[1] * x[4] + x[2] * x[5];
};

}  // namespace operations

/// The subject for an operation in N.
template <class N, class Operation>
Subject subject_of(Operation /*operation*/, std::string name, std::string alike) {
  return {std::move(name), std::move(alike), [](CaseWords in) -> std::optional<double> {
            std::array<N, 6> x{};
            for (std::size_t i = 0; i < in.size(); ++i) x[i] = MeasuredNumber<N>::of_word(in[i]);
            const std::optional<N> result = Operation{}(x.data());
            return result ? std::optional(MeasuredNumber<N>::in_units(*result)) : std::nullopt;
          }};
}

/// The subject for N and a named operation; nothing if N does not have the operation.
template <class N>
std::optional<Subject> subject_of_number(const std::string& name, std::string_view operation) {
  std::optional<Subject> found;
  const auto find = [&](const char* known, auto function) {
    if constexpr (requires(N x) { function(&x); }) {
      if (operation == known) found = subject_of<N>(function, name, "");
    }
  };
  find("mul", operations::product);
  find("div", operations::quotient);
  find("sqrt", operations::root);
  find("cos", operations::cosine);
  find("sin", operations::sine);
  find("sin of radians", operations::sine_of_radians);
  find("dot of rounded products", operations::rounded_products);
  return found;
}

}  // namespace fixproof::measure
