/// @file
/// Terms over bit vectors and truth values, stored once each, with constant folding.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace x86model::symbolic {

enum class Op : std::uint8_t {
  constant,  ///< value
  variable,  ///< name
  apply,     ///< name(arguments): an abstract function
  add,
  sub,
  bit_and,
  bit_xor,
  concat,       ///< first argument above the second
  extract,      ///< `width` bits from bit `value` upwards
  sign_extend,  ///< to the term's width
  ite,          ///< truth value, then, else
  equal,
  below,  ///< unsigned
  both,
  either,
  negation,
};

/// A handle to a term of a Terms.
struct Term {
  std::uint32_t id = 0;
  friend auto operator<=>(const Term&, const Term&) = default;
};

/// The definition of a term. Truth values have width 0; bit vectors 1 to 64 bits.
struct Node {
  Op op = Op::constant;
  int width = 0;
  std::uint64_t value = 0;
  std::string name{};
  std::vector<Term> arguments{};

  friend auto operator<=>(const Node&, const Node&) = default;
};

/// The terms of one symbolic run. All operands of an operation have the same width.
class Terms {
 public:
  [[nodiscard]] const Node& operator[](Term t) const { return *nodes_[t.id]; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] int width(Term t) const { return (*this)[t].width; }
  [[nodiscard]] bool is_constant(Term t) const { return (*this)[t].op == Op::constant; }
  /// The value of a constant; 0 or 1 for a truth value.
  [[nodiscard]] std::uint64_t value(Term t) const { return (*this)[t].value; }
  /// Whether `t` depends only on that variable and on no abstract function.
  [[nodiscard]] bool depends_only_on(Term variable, Term t) const;

  Term constant(std::uint64_t value, int width);
  Term truth(bool value) { return constant(value ? 1 : 0, 0); }
  Term variable(const std::string& name, int width);
  Term apply(const std::string& function, std::vector<Term> arguments, int width);

  Term add(Term a, Term b);
  Term sub(Term a, Term b);
  Term bit_and(Term a, Term b);
  Term bit_xor(Term a, Term b);
  Term concat(Term high, Term low);
  /// Bits `low` to `low` + `width` - 1.
  Term extract(Term a, int low, int width);
  Term zero_extend(Term a, int width);
  Term sign_extend(Term a, int width);
  Term ite(Term condition, Term yes, Term no);

  Term equal(Term a, Term b);
  Term below(Term a, Term b);
  Term both(Term a, Term b);
  Term either(Term a, Term b);
  Term negation(Term a);
  /// Whether bit `position` is set.
  Term bit(Term a, int position);

 private:
  Term keep(Node node);
  /// The term for `node`; folded to a constant if all arguments are constants.
  Term make(Op op, int width, std::vector<Term> arguments, std::uint64_t value = 0);

  std::map<Node, Term> known_;
  std::vector<const Node*> nodes_;
};

/// The name followed by the number: "x" and 12 give "x12".
std::string numbered(std::string name, std::uint64_t number);

/// The value of an operation on constants; `widths` are those of the arguments. Not for Op::apply,
/// variables and constants.
std::uint64_t value_of(Op op, int width, std::uint64_t value,
                       std::span<const std::uint64_t> arguments, std::span<const int> widths);

}  // namespace x86model::symbolic
