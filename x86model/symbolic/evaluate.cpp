#include "x86model/symbolic/evaluate.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include "x86model/alu.hpp"
#include "x86model/cosine_table.hpp"
#include "x86model/words.hpp"

namespace x86model::symbolic {

Evaluation::Evaluation(const Terms& terms, Function function)
    : terms_(terms), function_(std::move(function)) {}

void Evaluation::set(const std::string& variable, std::uint64_t value) {
  variables_[variable] = value;
  ++round_;
}

std::uint64_t Evaluation::operator()(Term term) {
  if (term.id >= values_.size()) {
    values_.resize(terms_.size());
    valid_in_.resize(terms_.size());
  }
  if (valid_in_[term.id] == round_) return values_[term.id];
  const Node& node = terms_[term];
  std::array<std::uint64_t, 3> arguments{};
  std::array<int, 3> widths{};
  for (std::size_t i = 0; i < node.arguments.size(); ++i) {
    arguments.at(i) = (*this)(node.arguments[i]);
    widths.at(i) = terms_.width(node.arguments[i]);
  }
  const auto given = std::span(arguments).first(node.arguments.size());
  std::uint64_t value = node.value;
  if (node.op == Op::variable) {
    value = variables_[node.name];
  } else if (node.op == Op::apply) {
    value = function_(node.name, given);
  } else if (node.op != Op::constant) {
    value = value_of(node.op, node.width, node.value, given, widths);
  }
  values_[term.id] = value;
  valid_in_[term.id] = round_;
  return value;
}

std::uint64_t concrete(const std::string& name, std::span<const std::uint64_t> arguments) {
  const auto a = arguments[0];
  if (name == "cosword") {
    const auto entry = static_cast<std::uint32_t>(cosine_table.at(a / 4));
    return entry >> (a % 4 == 0 ? 0 : 16) & 0xFFFFU;
  }
  const Words d;
  const int bits = name.ends_with("32") ? 32 : 16;
  const auto b = static_cast<std::uint32_t>(arguments[1]);
  const std::string what = name.substr(0, name.size() - 2);
  const auto x = static_cast<std::uint32_t>(a);
  const std::uint64_t whole = bits == 32 ? ~std::uint64_t{0} : x86model::mask(2 * bits);
  if (what == "umul") return d.unsigned_product(x, b, bits);
  if (what == "smul") return d.signed_product(x, b, bits) & whole;
  const bool faults = what.front() == 'u' ? alu::div_faults(d, d.extract(a, bits, bits), b)
                                          : d.signed_quotient_overflows(a, b, bits);
  if (what == "sfault") return faults ? 1 : 0;
  if (what == "udiv") return faults ? 0 : d.unsigned_quotient(a, b, bits);
  if (what == "urem") return faults ? 0 : d.unsigned_remainder(a, b, bits);
  if (what == "sdiv") return faults ? 0 : d.signed_quotient(a, b, bits);
  if (what == "srem") return faults ? 0 : d.signed_remainder(a, b, bits);
  throw std::invalid_argument("no such function: " + name);
}

}  // namespace x86model::symbolic
