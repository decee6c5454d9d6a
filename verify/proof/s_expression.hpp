/// @file
/// S-expressions, the syntax of SMT-LIB.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace fixproof::proof {

/// An atom or a list of expressions.
struct Expression {
  std::string atom{};  ///< empty for a list
  std::vector<Expression> list{};

  [[nodiscard]] bool is_atom() const { return !atom.empty(); }
  friend bool operator==(const Expression&, const Expression&) = default;
};

/// Reads all expressions in `text`. @throws std::invalid_argument if the parentheses do not match
std::vector<Expression> read_expressions(std::string_view text);

/// The expression as text, for messages.
std::string text_of(const Expression& expression);

}  // namespace fixproof::proof
