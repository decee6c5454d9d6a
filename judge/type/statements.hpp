/// @file
/// What a function of the type must return for all operands.
#pragma once

#include <functional>
#include <vector>

#include "judge/code/path_prover.hpp"
#include "judge/type/exact.hpp"
#include "judge/type/number_type.hpp"

namespace fixproof::judge {

/// States what a function must return on a path.
using Statement = std::function<Claim(x86model::symbolic::Terms& terms, const Path& path)>;

struct Statements {
  /// Each is enough. Under abstract arithmetic, one may speak of other products and quotients than
  /// the function takes, and then it is not proven.
  std::vector<Statement> ways{};
  /// Under exact arithmetic, a word that it calls wrong is wrong. None for quotients of 128 bits.
  Statement definition{};
};

/// A claim that does not depend on the path.
Statements stated(const Claim& claim);
/// An exact result, rounded by the rules. Where they say DE, the function raises an error.
Statements rounded(const Exact& exact, const check::Rules& rules);
/// The same for each shape of product that the words have.
Statements products(const cases::Format& format, const check::Rules& rules,
                    Exact (*exact)(const cases::Format&, Shape));
/// a / b. No way for words of 64 bits.
Statements quotients(const NumberType& type);
/// a % b. No way for words of 64 bits.
Statements remainders(const NumberType& type);

/// What a function of fixed/checked.hpp returns of an operation.
enum class Form {
  has_value,      ///< whether the result is in range, as 0 or 1
  value_or_zero,  ///< the result, or 0 if it is not in range
  overflows,      ///< the opposite of has_value
  as_is,          ///< the result by the rules
};

/// The same statements about a form, which raises no error.
Statements in_form(Form form, const Statements& of);

}  // namespace fixproof::judge
