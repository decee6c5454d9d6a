#include "x86model/symbolic/smt.hpp"

#include <optional>
#include <utility>

namespace x86model::symbolic {

namespace {

/// `(_ name a b)`, or `(_ name a)` without b.
std::string indexed(std::string name, std::uint64_t a, std::optional<std::uint64_t> b = {}) {
  std::string text = "(_ ";
  text += numbered(std::move(name), a);
  if (b) text += numbered(" ", *b);
  return text += ')';
}

std::uint64_t bits(int width) { return static_cast<std::uint64_t>(width); }

std::string sort(int width) { return width == 0 ? "Bool" : indexed("BitVec ", bits(width)); }

std::string constant(const Node& node) {
  if (node.width == 0) return node.value != 0 ? "true" : "false";
  return indexed("bv", node.value, bits(node.width));
}

/// The operator with its indices.
std::string operation(const Terms& terms, const Node& node) {
  switch (node.op) {
    case Op::add:
      return "bvadd";
    case Op::sub:
      return "bvsub";
    case Op::bit_and:
      return "bvand";
    case Op::bit_xor:
      return "bvxor";
    case Op::concat:
      return "concat";
    case Op::extract:
      return indexed("extract ", node.value + bits(node.width) - 1, node.value);
    case Op::sign_extend:
      return indexed("sign_extend ", bits(node.width - terms.width(node.arguments[0])));
    case Op::ite:
      return "ite";
    case Op::equal:
      return "=";
    case Op::below:
      return "bvult";
    case Op::both:
      return "and";
    case Op::either:
      return "or";
    case Op::negation:
      return "not";
    case Op::apply:
    case Op::variable:
    case Op::constant:
      break;
  }
  return node.name;
}

bool has_definition(const Node& node) { return node.op != Op::constant && node.op != Op::variable; }

}  // namespace

std::set<Term> reached_from(const Terms& terms, std::span<const Term> roots) {
  std::set<Term> reached;
  std::vector<Term> left(roots.begin(), roots.end());
  while (!left.empty()) {
    const Term t = left.back();
    left.pop_back();
    if (!reached.insert(t).second) continue;
    const auto& arguments = terms[t].arguments;
    left.insert(left.end(), arguments.begin(), arguments.end());
  }
  return reached;
}

std::string name_in_smt(const Terms& terms, Term term) {
  const Node& node = terms[term];
  if (node.op == Op::constant) return constant(node);
  return node.op == Op::variable ? node.name : numbered("t", term.id);
}

std::string define(const Terms& terms, std::span<const Term> roots) {
  std::string text;
  for (const Term t : reached_from(terms, roots)) {
    const Node& node = terms[t];
    if (!has_definition(node)) continue;
    text += numbered("(define-fun t", t.id);
    text.append(" () ").append(sort(node.width)).append(" (").append(operation(terms, node));
    for (const Term argument : node.arguments)
      text.append(" ").append(name_in_smt(terms, argument));
    text += "))\n";
  }
  return text;
}

std::string declare_variables(const Terms& terms, std::span<const Term> roots) {
  std::set<std::string> lines;
  for (const Term t : reached_from(terms, roots)) {
    const Node& node = terms[t];
    if (node.op == Op::variable) {
      std::string line = "(declare-const ";
      lines.insert(line.append(node.name).append(" ").append(sort(node.width)).append(")\n"));
    }
  }
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

}  // namespace x86model::symbolic
