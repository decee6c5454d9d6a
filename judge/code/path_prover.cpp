#include "judge/code/path_prover.hpp"

#include <fmt/format.h>

#include <limits>

#include "judge/code/abstract_functions.hpp"
#include "verify/proof/model.hpp"
#include "x86model/symbolic/smt.hpp"

namespace fixproof::judge {

namespace sym = x86model::symbolic;
using proof::Satisfiability;
using proof::Standing;

namespace {

/// Nearly every condition is decided in hundredths of a second.
constexpr int seconds_of_condition = 2;
constexpr int no_limit = std::numeric_limits<int>::max();

/// Declares all that `roots` depend on and `variables`, and defines the roots.
std::string beginning(sym::Terms& terms, const std::vector<sym::Term>& roots,
                      const std::vector<sym::Term>& variables, proof::Arithmetic arithmetic) {
  std::vector<sym::Term> declared = roots;
  declared.insert(declared.end(), variables.begin(), variables.end());
  return fmt::format("(set-logic QF_UFBV)\n(set-option :produce-models true)\n{}{}{}{}",
                     proof::abstractions(arithmetic), declare_functions(arithmetic),
                     sym::declare_variables(terms, declared), sym::define(terms, roots));
}

}  // namespace

MayHold may_hold(sym::Terms& terms, const Ask& ask, double& seconds) {
  return [&](sym::Term condition) {
    if (terms.is_constant(condition)) return terms.value(condition) != 0;
    const proof::SolverAnswer answer =
        ask(fmt::format("{}(assert {})\n(check-sat)\n",
                        beginning(terms, {condition}, {}, proof::Arithmetic::abstract),
                        sym::name_in_smt(terms, condition)),
            seconds_of_condition);
    seconds += answer.seconds;
    return answer.verdict != Satisfiability::unsatisfiable;
  };
}

std::optional<MachineDivide> divide_of(sym::Terms& terms, const Path& path) {
  if (path.divide_error) return std::nullopt;
  std::vector<sym::Term> roots{path.condition};
  if (path.returns()) roots.push_back(path.result);
  return divide_in(terms, roots);
}

std::string question(const Paths& paths, const Path& path, const Claim& claim,
                     const std::string& in_case, proof::Arithmetic arithmetic) {
  sym::Terms& terms = paths.terms;
  std::vector<sym::Term> roots{path.condition};
  std::string right = path.traps ? claim.may_trap : claim.may_fault;
  if (path.returns()) {
    roots.push_back(path.result);
    roots.push_back(path.kept);
    right = fmt::format(
        "(and {} {})", sym::name_in_smt(terms, path.kept),
        fmt::format(fmt::runtime(claim.is_right), sym::name_in_smt(terms, path.result)));
  }
  roots.insert(roots.end(), claim.mentions.begin(), claim.mentions.end());
  std::vector<sym::Term> operands;
  for (std::size_t i = 0; i < paths.operands.size(); ++i) {
    operands.push_back(terms.variable(operand_name(i), paths.operands[i].bits));
  }
  return fmt::format("{}{}(assert {})\n(assert {})\n(assert (not {}))\n(check-sat)\n",
                     beginning(terms, roots, operands, arithmetic), claim.definitions,
                     sym::name_in_smt(terms, path.condition), in_case, right);
}

PathAnswer ask_all(const Paths& paths, const std::function<Claim(const Path&)>& claim,
                   proof::Arithmetic arithmetic, const Ask& ask,
                   const std::function<bool(std::span<const std::uint64_t>)>& fails) {
  PathAnswer result{.standing = Standing::proven};
  std::size_t number = 0;
  for (const Path& path : paths.all) {
    ++number;
    const Claim claimed = claim(path);
    const auto undecided = [&](const std::string& why) {
      result.standing = Standing::open;
      result.remark = fmt::format("path {} of {}: {}", number, paths.all.size(), why);
      return result;
    };
    for (const std::string& one : claimed.cases) {
      const proof::SolverAnswer answer =
          ask(question(paths, path, claimed, one, arithmetic), no_limit);
      result.seconds += answer.seconds;
      if (answer.verdict == Satisfiability::unsatisfiable) continue;
      if (answer.verdict != Satisfiability::satisfiable) {
        return undecided(answer.remark.empty() ? "the solver has no answer in time"
                                               : answer.remark);
      }
      std::vector<std::uint64_t> words;
      for (std::size_t i = 0; i < paths.operands.size(); ++i) {
        words.push_back(proof::word_in_model(answer.model, operand_name(i)));
      }
      if (!fails(words)) {
        return undecided(
            "the counterexample is right when run: it needs products or quotients that do not "
            "exist, or something in a register or on the stack");
      }
      result.standing = Standing::disproven;
      return result;
    }
  }
  return result;
}

}  // namespace fixproof::judge
