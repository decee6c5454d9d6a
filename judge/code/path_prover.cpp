#include "judge/code/path_prover.hpp"

#include <fmt/format.h>

#include "judge/code/abstract_functions.hpp"
#include "verify/proof/model.hpp"
#include "x86model/symbolic/smt.hpp"

namespace fixproof::judge {

namespace sym = x86model::symbolic;
using proof::Satisfiability;
using proof::Standing;

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
  std::vector<sym::Term> declared = roots;
  for (std::size_t i = 0; i < paths.operands.size(); ++i) {
    declared.push_back(terms.variable(operand_name(i), paths.operands[i].bits));
  }
  return fmt::format(
      "(set-logic QF_UFBV)\n(set-option :produce-models true)\n{}{}{}{}{}(assert {})\n"
      "(assert {})\n(assert (not {}))\n(check-sat)\n",
      proof::abstractions(arithmetic), declare_functions(arithmetic),
      sym::declare_variables(terms, declared), sym::define(terms, roots), claim.definitions,
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
      const proof::SolverAnswer answer = ask(question(paths, path, claimed, one, arithmetic));
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
        return undecided("the counterexample has products or quotients that do not exist");
      }
      result.standing = Standing::disproven;
      return result;
    }
  }
  return result;
}

}  // namespace fixproof::judge
