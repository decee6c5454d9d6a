#include "judge/code/prove.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <vector>

#include "judge/check/cases.hpp"
#include "judge/code/abstract_functions.hpp"
#include "judge/code/claim.hpp"
#include "judge/code/quotient_claim.hpp"
#include "judge/code/symbolic.hpp"
#include "judge/code/verdict.hpp"
#include "verify/proof/model.hpp"
#include "x86model/symbolic/evaluate.hpp"
#include "x86model/symbolic/smt.hpp"

namespace fixproof::judge {

namespace {

namespace sym = x86model::symbolic;
using proof::Arithmetic;
using proof::Satisfiability;

constexpr std::uint64_t cases_to_compare = 1000;

class Prover {
 public:
  Prover(const Subject& subject, const check::Rules& rules, On machine, const proof::Solver& solver,
         int max_seconds)
      : subject_(subject),
        rules_(rules),
        runner_(subject, machine),
        solver_(solver),
        max_seconds_(max_seconds),
        listing_(subject.image) {}

  RoutineProof prove() {
    if (!claim_of(rules_, Shape::of_signed) && !quotient_claim(rules_, terms_, {}, false)) {
      proof_.why =
          "only mul, add and sub of signed words of 16 and 32 bits, div of up to 32 bits, and "
          "muldiv "
          "if --overflow and --no-result are any or de can be proven, and a --rule only if general "
          "rules express it or it is Doom's";
      return proof_;
    }
    SymbolicRun run = run_symbolically(subject_, listing_, terms_);
    if (!run.obstacle.empty()) {
      proof_.why = run.obstacle;
      return proof_;
    }
    paths_ = std::move(run.paths);
    proof_.paths = paths_.size();
    if (!terms_are_those_of_machine()) return proof_;
    for (const Arithmetic arithmetic : {Arithmetic::abstract, Arithmetic::exact}) {
      for (const bool halves : {false, true}) {
        const ClaimOf claim = [&](const Path& path) {
          return quotient_claim(rules_, terms_, divide_of(path), halves);
        };
        if (claim(paths_.front()) && ask_all(claim, arithmetic)) return proof_;
      }
      for (const Shape shape : shapes) {
        if (arithmetic == Arithmetic::exact && shape != Shape::of_signed) continue;
        const auto claim = claim_of(rules_, shape);
        if (claim && ask_all([&](const Path&) { return claim; }, arithmetic)) return proof_;
      }
    }
    if (proof_.why.empty()) proof_.why = "the solver does not decide in time";
    return proof_;
  }

 private:
  [[nodiscard]] std::size_t operands() const { return cases::words_in(subject_.variant.operation); }

  /// Compares the terms with the machine, because a wrong decoding would make a wrong proof.
  bool terms_are_those_of_machine() {
    check::GeneratedCases cases(subject_.variant, {.cases = cases_to_compare});
    sym::Evaluation evaluation(terms_, concrete_function);
    std::vector<std::uint32_t> words(operands());
    while (cases.next(words)) {
      for (std::size_t i = 0; i < words.size(); ++i) evaluation.set(operand_name(i), words[i]);
      const Answer answer = runner_.answers(words).front();
      int taken = 0;
      bool same = true;
      for (const Path& path : paths_) {
        if (evaluation(path.condition) == 0) continue;
        ++taken;
        same = path.divide_error ? answer.ending.end == End::divide_error
                                 : answer.ending.end == End::returned &&
                                       evaluation(path.result) == answer.words[0];
      }
      if (taken == 1 && same) continue;
      proof_.why = "the model of the instructions and the machine differ";
      return false;
    }
    return true;
  }

  using ClaimOf = std::function<std::optional<Claim>(const Path&)>;

  /// The divide that the path depends on, if it is the only one.
  std::optional<MachineDivide> divide_of(const Path& path) {
    if (path.divide_error) return std::nullopt;
    return divide_in(terms_, std::array{path.condition, path.result});
  }

  /// @return whether the outcome is final
  bool ask_all(const ClaimOf& claim, Arithmetic arithmetic) {
    for (const Path& path : paths_) {
      const Claim claimed = *claim(path);
      for (const std::string& one : claimed.cases) {
        const auto is_final = ask(question(path, claimed, one, arithmetic));
        if (is_final) return *is_final;
      }
    }
    proof_.standing = proof::Standing::proven;
    return true;
  }

  /// Asks one question. @return nothing if its claim holds, or else whether the outcome is final
  std::optional<bool> ask(const std::string& script) {
    const proof::SolverAnswer answer = solver_.ask(script, max_seconds_);
    proof_.seconds += answer.seconds;
    if (answer.verdict == Satisfiability::unsatisfiable) return std::nullopt;
    if (answer.verdict != Satisfiability::satisfiable) {
      if (!answer.remark.empty()) proof_.why = answer.remark;
      return false;
    }
    std::vector<std::uint32_t> words;
    for (std::size_t i = 0; i < operands(); ++i) {
      words.push_back(proof::word_in_model(answer.model, operand_name(i)));
    }
    const Answer given = runner_.answers(words).front();
    const check::JudgedCase one = judged_case(subject_.variant, words, given);
    const bool is_right = check::keeps(rules_, one.operands(), one.said) && given.broken == 0;
    if (is_right) return false;  // a counterexample of abstract arithmetic only
    proof_.standing = proof::Standing::disproven;
    proof_.counterexample = one;
    return true;
  }

  std::string question(const Path& path, const Claim& claim, const std::string& in_case,
                       Arithmetic arithmetic) {
    std::vector<sym::Term> roots{path.condition};
    std::string right = claim.may_fault;
    if (!path.divide_error) {
      roots.push_back(path.result);
      roots.push_back(path.kept);
      right = fmt::format(
          "(and {} {})", sym::name_in_smt(terms_, path.kept),
          fmt::format(fmt::runtime(claim.is_right), sym::name_in_smt(terms_, path.result)));
    }
    if (const auto divide = divide_of(path)) {
      for (const sym::Term part :
           {divide->dividend, divide->divisor, divide->quotient, divide->remainder}) {
        roots.push_back(part);
      }
    }
    std::vector<sym::Term> declared = roots;
    for (std::size_t i = 0; i < operands(); ++i) {
      declared.push_back(terms_.variable(operand_name(i), subject_.variant.format.word_bits));
    }
    return fmt::format(
        "(set-logic QF_UFBV)\n(set-option :produce-models true)\n{}{}{}{}{}(assert {})\n"
        "(assert {})\n(assert (not {}))\n(check-sat)\n",
        proof::abstractions(arithmetic), declare_functions(arithmetic),
        sym::declare_variables(terms_, declared), sym::define(terms_, roots), claim.definitions,
        sym::name_in_smt(terms_, path.condition), in_case, right);
  }

  const Subject& subject_;
  const check::Rules& rules_;
  Runner runner_;
  const proof::Solver& solver_;
  int max_seconds_;
  Listing listing_;
  sym::Terms terms_;
  std::vector<Path> paths_;
  RoutineProof proof_;
};

}  // namespace

RoutineProof prove(const Subject& subject, const check::Rules& rules, On machine,
                   const proof::Solver& solver, int max_seconds) {
  return Prover(subject, rules, machine, solver, max_seconds).prove();
}

}  // namespace fixproof::judge
