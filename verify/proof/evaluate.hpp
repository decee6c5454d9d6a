/// @file
/// Evaluates SMT-LIB terms: bit vectors, integers, Booleans and functions.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "verify/proof/s_expression.hpp"

namespace fixproof::proof {

struct Sort {
  enum class Kind { boolean, integer, bits } kind = Kind::boolean;
  unsigned width = 0;  ///< of bit vectors

  friend bool operator==(const Sort&, const Sort&) = default;
};

/// A bit vector holds its unsigned value, a Boolean 0 or 1.
struct Value {
  Sort sort;
  boost::multiprecision::cpp_int number;

  friend bool operator==(const Value&, const Value&) = default;
};

/// A declared or defined function. A constant has no parameters.
struct Function {
  std::vector<std::pair<std::string, Sort>> parameters;
  Sort result;
  const Expression* body = nullptr;  ///< null: 0 for all arguments

  [[nodiscard]] bool has_sorts_of(const Function& other) const;
};

/// @throws std::invalid_argument for another sort than Bool, Int and (_ BitVec n)
Sort sort_of(const Expression& expression);

/// Reads `(define-fun NAME PARAMETERS SORT BODY)`, which must outlive the result.
/// @throws std::invalid_argument for anything else
Function defined_function(const Expression& command);

class Evaluator {
 public:
  /// @param functions they and their bodies must outlive this object
  explicit Evaluator(const std::map<std::string, Function>& functions) : functions_(functions) {}

  /// @throws std::invalid_argument for an unknown name or operation, or sorts that do not match,
  /// for terms and calls that nest too deeply, integers of more than 4096 bits, and more than 2^20
  /// terms in all
  Value value_of(const Expression& term);

 private:
  using Scope = std::vector<std::pair<std::string, Value>>;

  Value value_of(const Expression& term, const Scope& scope);
  Value value_of_atom(const std::string& atom, const Scope& scope);
  Value value_of_list(const std::vector<Expression>& list, const Scope& scope);
  Value call(const std::string& name, const Function& function, std::vector<Value> arguments);

  const std::map<std::string, Function>& functions_;
  int depth_ = 0;  ///< of nested terms and calls: a model may define a function by itself
  int steps_ = 0;  ///< terms evaluated so far
  std::map<std::string, Value> constants_;  ///< those evaluated so far
};

}  // namespace fixproof::proof
