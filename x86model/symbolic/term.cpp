#include "x86model/symbolic/term.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace x86model::symbolic {

namespace {

std::uint64_t low_bits(std::uint64_t value, int width) {
  return width >= 64 ? value : value & ((std::uint64_t{1} << width) - 1);
}

}  // namespace

std::string numbered(std::string name, std::uint64_t number) {
  name += std::to_string(number);
  return name;
}

std::uint64_t value_of(Op op, int width, std::uint64_t value,
                       std::span<const std::uint64_t> arguments, std::span<const int> widths) {
  const auto a = arguments[0];
  const auto b = arguments.size() > 1 ? arguments[1] : 0;
  switch (op) {
    case Op::add:
      return low_bits(a + b, width);
    case Op::sub:
      return low_bits(a - b, width);
    case Op::bit_and:
      return a & b;
    case Op::bit_xor:
      return a ^ b;
    case Op::concat:
      return a << widths[1] | b;
    case Op::extract:
      return low_bits(a >> value, width);
    case Op::sign_extend: {
      const std::uint64_t sign = std::uint64_t{1} << (widths[0] - 1);
      return low_bits((a ^ sign) - sign, width);
    }
    case Op::ite:
      return a != 0 ? b : arguments[2];
    case Op::equal:
      return a == b ? 1 : 0;
    case Op::below:
      return a < b ? 1 : 0;
    case Op::both:
      return a & b;
    case Op::either:
      return a | b;
    case Op::negation:
      return a ^ 1U;
    case Op::constant:
    case Op::variable:
    case Op::apply:
      break;
  }
  throw std::logic_error("not an operation");
}

Term Terms::keep(Node node) {
  const auto [place, is_new] =
      known_.try_emplace(std::move(node), Term{static_cast<std::uint32_t>(nodes_.size())});
  if (is_new) nodes_.push_back(&place->first);
  return place->second;
}

Term Terms::make(Op op, int width, std::vector<Term> arguments, std::uint64_t value) {
  if (std::all_of(arguments.begin(), arguments.end(), [&](Term t) { return is_constant(t); })) {
    std::vector<std::uint64_t> values;
    std::vector<int> widths;
    for (const Term t : arguments) {
      values.push_back((*this)[t].value);
      widths.push_back((*this)[t].width);
    }
    return constant(value_of(op, width, value, values, widths), width);
  }
  return keep({.op = op, .width = width, .value = value, .arguments = std::move(arguments)});
}

bool Terms::depends_only_on(Term variable, Term t) const {
  std::set<Term> seen;
  std::vector<Term> left{t};
  while (!left.empty()) {
    const Term next = left.back();
    left.pop_back();
    if (!seen.insert(next).second) continue;
    const Node& node = (*this)[next];
    if (node.op == Op::apply || (node.op == Op::variable && next != variable)) return false;
    left.insert(left.end(), node.arguments.begin(), node.arguments.end());
  }
  return true;
}

Term Terms::constant(std::uint64_t value, int width) {
  return keep({.width = width, .value = low_bits(value, width == 0 ? 1 : width)});
}

Term Terms::variable(const std::string& name, int width) {
  return keep({.op = Op::variable, .width = width, .name = name});
}

Term Terms::apply(const std::string& function, std::vector<Term> arguments, int width) {
  return keep(
      {.op = Op::apply, .width = width, .name = function, .arguments = std::move(arguments)});
}

Term Terms::add(Term a, Term b) {
  if (is_constant(a)) std::swap(a, b);
  if (is_constant(b)) {
    if (value(b) == 0) return a;
    // Folds (x + c) + d to x + (c + d), so that loops that add a constant leave one addition.
    const Node& sum = (*this)[a];
    if (sum.op == Op::add && is_constant(sum.arguments[1])) {
      return add(sum.arguments[0], constant(value(sum.arguments[1]) + value(b), width(b)));
    }
  }
  return make(Op::add, width(a), {a, b});
}

Term Terms::sub(Term a, Term b) {
  if (a == b) return constant(0, width(a));
  if (is_constant(b)) return add(a, constant(0 - value(b), width(b)));
  return make(Op::sub, width(a), {a, b});
}

Term Terms::bit_and(Term a, Term b) {
  if (a == b) return a;
  return make(Op::bit_and, width(a), {a, b});
}

Term Terms::bit_xor(Term a, Term b) {
  if (a == b) return constant(0, width(a));
  return make(Op::bit_xor, width(a), {a, b});
}

Term Terms::concat(Term high, Term low) {
  const Node& h = (*this)[high];
  const Node& l = (*this)[low];
  // Adjacent parts of one term are one part of it.
  if (h.op == Op::extract && h.value >= static_cast<std::uint64_t>(l.width)) {
    const int from = static_cast<int>(h.value) - l.width;
    if (extract(h.arguments[0], from, l.width) == low) {
      return extract(h.arguments[0], from, h.width + l.width);
    }
  }
  const bool repeats_a_bit = h.op == Op::sign_extend && width(h.arguments[0]) == 1;
  if (repeats_a_bit && l.op == Op::sign_extend && h.arguments == l.arguments) {
    return sign_extend(h.arguments[0], h.width + l.width);
  }
  // Adjacent constants are one constant, so that what is extended or shifted twice is so once.
  if (h.op == Op::constant && l.op == Op::concat && is_constant(l.arguments[0])) {
    return concat(concat(high, l.arguments[0]), l.arguments[1]);
  }
  if (l.op == Op::constant && h.op == Op::concat && is_constant(h.arguments[1])) {
    return concat(h.arguments[0], concat(h.arguments[1], low));
  }
  return make(Op::concat, h.width + l.width, {high, low});
}

Term Terms::extract(Term a, int low, int wanted) {
  const Node& node = (*this)[a];
  if (low == 0 && wanted == node.width) return a;
  if (node.op == Op::extract) {
    return extract(node.arguments[0], static_cast<int>(node.value) + low, wanted);
  }
  if (node.op == Op::concat) {
    const Term lower = node.arguments[1];
    const int lower_width = width(lower);
    if (low + wanted <= lower_width) return extract(lower, low, wanted);
    if (low >= lower_width) return extract(node.arguments[0], low - lower_width, wanted);
    const Term upper = node.arguments[0];
    const int of_lower = lower_width - low;
    return concat(extract(upper, 0, wanted - of_lower), extract(lower, low, of_lower));
  }
  if (node.op == Op::sign_extend) {
    const Term inner = node.arguments[0];
    const int rest = width(inner) - low;
    if (wanted <= rest) return extract(inner, low, wanted);
    if (width(inner) == 1) return sign_extend(inner, wanted);
    // Copies of the sign alone stay a part of this term, so that concat() can join them to it.
    if (rest > 0) return sign_extend(extract(inner, low, rest), wanted);
  }
  return make(Op::extract, wanted, {a}, static_cast<std::uint64_t>(low));
}

Term Terms::zero_extend(Term a, int wanted) {
  const int more = wanted - width(a);
  return more == 0 ? a : concat(constant(0, more), a);
}

Term Terms::sign_extend(Term a, int wanted) {
  if (wanted == width(a)) return a;
  const Node& node = (*this)[a];
  if (node.op == Op::sign_extend) return sign_extend(node.arguments[0], wanted);
  if (node.op == Op::concat && is_constant(node.arguments[0])) {
    const Term high = node.arguments[0];
    if (value(extract(high, width(high) - 1, 1)) == 0) return zero_extend(a, wanted);
  }
  return make(Op::sign_extend, wanted, {a});
}

Term Terms::ite(Term condition, Term yes, Term no) {
  if (is_constant(condition)) return value(condition) != 0 ? yes : no;
  if (yes == no) return yes;
  return make(Op::ite, width(yes), {condition, yes, no});
}

Term Terms::equal(Term a, Term b) { return a == b ? truth(true) : make(Op::equal, 0, {a, b}); }

Term Terms::below(Term a, Term b) { return a == b ? truth(false) : make(Op::below, 0, {a, b}); }

Term Terms::both(Term a, Term b) {
  if (is_constant(a)) return value(a) != 0 ? b : a;
  if (is_constant(b)) return value(b) != 0 ? a : b;
  // A chain that already contains b or its negation: ((x and y) and z) and y.
  const Term contrary = negation(b);
  for (Term chain = a;; chain = (*this)[chain].arguments[0]) {
    const bool is_link = (*this)[chain].op == Op::both;
    const Term said = is_link ? (*this)[chain].arguments[1] : chain;
    if (said == b) return a;
    if (said == contrary) return truth(false);
    if (!is_link) break;
  }
  return make(Op::both, 0, {a, b});
}

Term Terms::either(Term a, Term b) {
  if (is_constant(a)) return value(a) != 0 ? a : b;
  if (is_constant(b)) return value(b) != 0 ? b : a;
  return make(Op::either, 0, {a, b});
}

Term Terms::negation(Term a) {
  const Node& node = (*this)[a];
  if (node.op == Op::negation) return node.arguments[0];
  return make(Op::negation, 0, {a});
}

Term Terms::bit(Term a, int position) { return equal(extract(a, position, 1), constant(1, 1)); }

}  // namespace x86model::symbolic
