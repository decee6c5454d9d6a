/// @file
/// Makes accuracy subjects from number types.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "measure/accuracy/subjects.hpp"
#include "measure/host/host_numbers.hpp"

namespace fixproof::measure {

/// The subject for N and a named operation; nothing if N does not have the operation.
template <class N>
std::optional<Subject> subject_of_number(std::string name, const std::string& operation) {
  using Number = MeasuredNumber<N>;
  const auto by = [&name](auto answer) { return Subject{std::move(name), "", answer}; };
  if (operation == "mul") {
    return by([](CaseWords in) -> std::optional<double> {
      return Number::in_units(Number::of_word(in[0]) * Number::of_word(in[1]));
    });
  }
  if (operation == "div") {
    return by([](CaseWords in) -> std::optional<double> {
      return Number::in_units(Number::of_word(in[0]) / Number::of_word(in[1]));
    });
  }
  if (operation == "dot of rounded products") {
    return by([](CaseWords in) -> std::optional<double> {
      N sum = Number::of_word(in[0]) * Number::of_word(in[3]);
      for (std::size_t k = 1; k < 3; ++k) {
        sum = sum + Number::of_word(in[k]) * Number::of_word(in[3 + k]);
      }
      return Number::in_units(sum);
    });
  }
  if constexpr (requires(N x) { Number::root(x); }) {
    if (operation == "sqrt") {
      return by([](CaseWords in) -> std::optional<double> {
        return Number::in_units(Number::root(Number::of_word(in[0])));
      });
    }
  }
  if constexpr (requires(N x) { Number::cosine(x); }) {
    if (operation == "cos") {
      return by([](CaseWords in) -> std::optional<double> {
        return Number::in_units(Number::cosine(Number::of_word(in[0])));
      });
    }
    if (operation == "sin") {
      return by([](CaseWords in) -> std::optional<double> {
        return Number::in_units(Number::sine(Number::of_word(in[0])));
      });
    }
  }
  if constexpr (requires(N x) { Number::sine_of_radians(x); }) {
    if (operation == "sin of radians") {
      return by([](CaseWords in) -> std::optional<double> {
        return Number::in_units(Number::sine_of_radians(Number::of_word(in[0])));
      });
    }
  }
  return std::nullopt;
}

}  // namespace fixproof::measure
