#include "verify/proof/query.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <tuple>

#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/interpreter.hpp"
#include "verify/proof/model.hpp"
#include "verify/proof/specification.hpp"
#include "x86model/symbolic/call.hpp"
#include "x86model/symbolic/smt.hpp"

namespace fixproof::proof {

namespace {

namespace x86 = x86model;
namespace sym = x86model::symbolic;

bool calls_fixed_mul(const cases::Variant& v) {
  return v.build.target == cases::Target::i8088 &&
         (v.operation == cases::Operation::xformvec || v.operation == cases::Operation::concat);
}

/// The facts that a proof needs about unsigned divides without a fault: the remainder is below the
/// divisor, the quotient is at most the dividend, and the quotient of a magnitude times 2^16 is not
/// 2^32 - 1 (lemmas quotient-below-dividend and not-all-ones).
std::string facts_of_divides(const sym::Terms& terms, std::span<const sym::Term> roots) {
  std::string text;
  for (const sym::Term term : sym::reached_from(terms, roots)) {
    const sym::Node& node = terms[term];
    if (node.op != sym::Op::apply || !node.name.starts_with("u")) continue;
    const std::string result = sym::name_in_smt(terms, term);
    const std::string dividend = sym::name_in_smt(terms, node.arguments[0]);
    const std::string divisor = sym::name_in_smt(terms, node.arguments[1]);
    const int bits = node.width;
    const auto know = [&](const std::string& fact) {
      text += fmt::format("(assert (=> (bvult ((_ extract {} {}) {}) {}) {}))\n", 2 * bits - 1,
                          bits, dividend, divisor, fact);
    };
    if (node.name.starts_with("urem")) know(fmt::format("(bvult {} {})", result, divisor));
    if (node.name.starts_with("udiv")) {
      know(fmt::format("(bvule (concat (_ bv0 {}) {}) {})", bits, result, dividend));
    }
    if (node.name == "udiv32") {
      know(
          fmt::format("(not (and (= {0} (bvnot (_ bv0 32))) (= ((_ extract 15 0) {1}) (_ bv0 16))"
                      " (bvule {1} (_ bv140737488355328 64))))",
                      result, dividend));
    }
  }
  return text;
}

/// Declares the variables, including operands on which the path does not depend.
std::string declare(sym::Terms& terms, std::vector<sym::Term> roots, x86::Routine routine) {
  for (int i = 0; i < x86::arity(routine).in; ++i) {
    roots.push_back(
        terms.variable(sym::operand_name(routine, i), routine == x86::Routine::cossin ? 16 : 32));
  }
  return sym::declare_variables(terms, roots);
}

/// States that the path's products equal those of the specification, in order. Empty if their
/// numbers differ or there are none.
std::string same_products(const sym::Terms& terms, std::span<const sym::Term> roots,
                          const Specification& wanted) {
  std::string text;
  std::size_t count = 0;
  for (const sym::Term term : sym::reached_from(terms, roots)) {
    if (terms[term].op != sym::Op::apply || terms[term].name != "umul16") continue;
    if (count < wanted.products.size()) {
      text += fmt::format(" (= {} {})", sym::name_in_smt(terms, term), wanted.products[count]);
    }
    ++count;
  }
  if (count == 0 || count != wanted.products.size()) return "";
  return fmt::format("(and{})", text);
}

/// The instructions of a procedure as text, which does not depend on its position.
std::vector<std::string> body(std::span<const x86::Instruction> code, std::string_view procedure) {
  const auto is_there = [&](const x86::Instruction& i) {
    return i.is_procedure && procedure == i.label;
  };
  std::vector<std::string> text;
  for (auto i = std::find_if(code.begin(), code.end(), is_there); i != code.end(); ++i) {
    std::string line(i->label == nullptr ? "" : i->label);
    line += fmt::format("/{}", static_cast<int>(i->mnemonic));
    for (const x86::Operand& o : i->operands) {
      line += fmt::format("/{}.{}.{}.{}.{}.{}", static_cast<int>(o.kind), static_cast<int>(o.size),
                          static_cast<int>(o.scaling), static_cast<int>(o.reg),
                          o.kind == x86::Operand::Kind::label ? 0 : o.value,
                          o.name == nullptr ? "" : o.name);
    }
    text.push_back(line);
  }
  return text;
}

/// Whether the FixedMul that an 8088 transform calls is the one that has its own proof.
bool calls_proven_fixed_mul(const cases::Variant& v, std::span<const x86::Instruction> code) {
  const x86::Program alone = x86::assemble(x86::listing(x86::Routine::mul, x86::Target::i8088),
                                           machine_code::model_build(v.build));
  return body(code, "FixedMul") == body(alone.instructions(), "FixedMul");
}

std::vector<sym::Path> paths_of(const cases::Variant& v, sym::Terms& terms, const sym::State& start,
                                std::span<const x86::Instruction> code) {
  sym::RunOptions options{.calls_are_fixed_mul = calls_fixed_mul(v)};
  if (v.operation == cases::Operation::cossin) {
    options.enumerated = terms.variable(sym::operand_name(x86::Routine::cossin, 0), 16);
  }
  return sym::run(terms, code, start, options);
}

}  // namespace

std::vector<std::string> questions(const cases::Variant& v, std::span<const x86::Instruction> code,
                                   Arithmetic arithmetic) {
  if (calls_fixed_mul(v) && !calls_proven_fixed_mul(v, code)) {
    throw std::logic_error("the FixedMul that is called is not the one that is proven");
  }
  const x86::Routine routine = machine_code::key_of(v).routine;
  sym::Terms terms;
  const sym::State start = sym::enter(terms, routine);
  const Specification wanted = specification(v);
  std::vector<std::string> scripts;
  std::vector<sym::Term> conditions;
  for (const sym::Path& path : paths_of(v, terms, start, code)) {
    conditions.push_back(path.condition);
    std::vector<sym::Term> roots{path.condition, path.in_table};
    std::string right;
    if (path.outcome == x86::Outcome::returned) {
      roots.push_back(sym::preserves_state(terms, routine, start, path.state));
      right = fmt::format("(not {}) {}", wanted.faults, sym::name_in_smt(terms, roots.back()));
      const auto words = sym::results(terms, routine, path.state);
      for (std::size_t i = 0; i < words.size(); ++i) {
        roots.push_back(words[i]);
        right += fmt::format(" (= {} {})", sym::name_in_smt(terms, words[i]), wanted.words[i]);
      }
    } else {
      right = path.outcome == x86::Outcome::divide_error ? wanted.faults : "false";
    }
    const std::string before = fmt::format(
        "(set-logic QF_UFBV)\n(set-option :produce-models true)\n{}{}{}{}{}(assert {})\n",
        abstractions(arithmetic), declare(terms, roots, routine), wanted.definitions,
        sym::define(terms, roots), facts_of_divides(terms, roots),
        sym::name_in_smt(terms, path.condition));
    const auto add = [&](std::string_view known, std::string_view shown) {
      scripts.push_back(fmt::format("{}{}(assert (not {}))\n(check-sat)\n", before, known, shown));
    };
    std::string known;
    if (const std::string same = same_products(terms, roots, wanted);
        !same.empty() && arithmetic == Arithmetic::abstract) {
      add("", same);
      known = fmt::format("(assert {})\n", same);
    }
    add(known, fmt::format("(and {} {})", sym::name_in_smt(terms, path.in_table), right));
  }
  std::string some_path;
  for (const sym::Term condition : conditions) {
    some_path += fmt::format(" {}", sym::name_in_smt(terms, condition));
  }
  scripts.push_back(fmt::format(
      "(set-logic QF_UFBV)\n(set-option :produce-models true)\n{}{}{}{}(assert (not (or "
      "false{})))\n"
      "(check-sat)\n",
      abstractions(arithmetic), declare(terms, conditions, routine), sym::define(terms, conditions),
      facts_of_divides(terms, conditions), some_path));
  return scripts;
}

bool has_same_terms(const cases::Variant& v, std::span<const x86::Instruction> code) {
  if (calls_fixed_mul(v) && !calls_proven_fixed_mul(v, code)) return false;
  const x86::Routine routine = machine_code::key_of(v).routine;
  sym::Terms terms;
  const sym::State start = sym::enter(terms, routine);
  using Behaviour = std::tuple<sym::Term, sym::Term, x86::Outcome, std::vector<sym::Term>>;
  const auto behaviour = [&](std::span<const x86::Instruction> of) {
    std::set<Behaviour> ways;
    for (const sym::Path& path : paths_of(v, terms, start, of)) {
      std::vector<sym::Term> left;
      if (path.outcome == x86::Outcome::returned) {
        left = sym::results(terms, routine, path.state);
        left.push_back(sym::preserves_state(terms, routine, start, path.state));
      }
      ways.emplace(path.condition, path.in_table, path.outcome, left);
    }
    return ways;
  };
  return behaviour(parties::program_of(v).instructions()) == behaviour(code);
}

std::vector<std::uint32_t> operands_in(const cases::Variant& v, const std::string& model) {
  const x86::Routine routine = machine_code::key_of(v).routine;
  std::vector<std::uint32_t> values;
  for (int i = 0; i < x86::arity(routine).in; ++i) {
    values.push_back(
        static_cast<std::uint32_t>(word_in_model(model, sym::operand_name(routine, i))));
  }
  return values;
}

}  // namespace fixproof::proof
