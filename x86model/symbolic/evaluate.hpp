/// @file
/// Evaluates terms for concrete operands.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "x86model/symbolic/term.hpp"

namespace x86model::symbolic {

/// Evaluates terms of one Terms and caches each value for the current operands.
class Evaluation {
 public:
  using Function =
      std::function<std::uint64_t(const std::string& name, std::span<const std::uint64_t>)>;

  /// @param function evaluates abstract functions
  Evaluation(const Terms& terms, Function function);

  /// Sets a variable and clears the cache. A variable that was never set is 0.
  void set(const std::string& variable, std::uint64_t value);

  std::uint64_t operator()(Term term);

 private:
  const Terms& terms_;
  Function function_;
  std::map<std::string, std::uint64_t> variables_;
  std::vector<std::uint64_t> values_;    ///< by term
  std::vector<std::uint64_t> valid_in_;  ///< by term: the round in which its value was computed
  std::uint64_t round_ = 1;
};

/// The abstract functions of domain.hpp as x86model/words.hpp computes them, and `cosword` from the
/// cosine table. A quotient that faults is 0. @throws std::invalid_argument for any other function
std::uint64_t concrete(const std::string& name, std::span<const std::uint64_t> arguments);

}  // namespace x86model::symbolic
