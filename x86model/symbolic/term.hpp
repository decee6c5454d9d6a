/// @file
/// Terms over bit vectors and truth values, each kept once, constants folded as they are built.
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
  apply,     ///< name(arguments): a function that is left abstract
  add,
  sub,
  bit_and,
  bit_xor,
  concat,       ///< first argument above the second
  extract,      ///< width bits from bit `value` on
  sign_extend,  ///< to the term's width
  ite,          ///< truth value, then, else
  equal,
  below,  ///< unsigned
  both,
  either,
  negation,
};

/// A term of a Terms: only a number there.
struct Term {
  std::uint32_t id = 0;
  friend auto operator<=>(const Term&, const Term&) = default;
};

/// What a term is. Truth values have width 0; bit vectors 1 to 64 bits.
struct Node {
  Op op = Op::constant;
  int width = 0;
  std::uint64_t value = 0;
  std::string name{};
  std::vector<Term> arguments{};

  friend auto operator<=>(const Node&, const Node&) = default;
};

/// The terms of one symbolic run. Operands of an operation have the same width.
class Terms {
 public:
  [[nodiscard]] const Node& operator[](Term t) const { return *nodes_[t.id]; }
  [[nodiscard]] std::size_t size() const { return nodes_.size(); }
  [[nodiscard]] int width(Term t) const { return (*this)[t].width; }
  [[nodiscard]] bool is_constant(Term t) const { return (*this)[t].op == Op::constant; }
  /// The bits of a constant; 0 or 1 for a truth value.
  [[nodiscard]] std::uint64_t value(Term t) const { return (*this)[t].value; }
  /// Whether `t` depends on no other variable than that one, and on no abstract function.
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
  /// The term for `node`; a constant where its arguments are constants.
  Term make(Op op, int width, std::vector<Term> arguments, std::uint64_t value = 0);

  std::map<Node, Term> known_;
  std::vector<const Node*> nodes_;
};

/// "x" and 12 as x12.
std::string numbered(std::string name, std::uint64_t number);

/// The value of an operation on values; `widths` are those of the arguments. Op::apply, variables
/// and constants are no operations.
std::uint64_t value_of(Op op, int width, std::uint64_t value,
                       std::span<const std::uint64_t> arguments, std::span<const int> widths);

}  // namespace x86model::symbolic
