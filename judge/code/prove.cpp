#include "judge/code/prove.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "judge/check/cases.hpp"
#include "judge/code/abstract_functions.hpp"
#include "judge/code/path_prover.hpp"
#include "judge/code/verdict.hpp"
#include "x86model/symbolic/evaluate.hpp"

namespace fixproof::judge {

namespace {

namespace sym = x86model::symbolic;
using proof::Arithmetic;

constexpr std::uint64_t cases_to_compare = 1000;

class Prover {
 public:
  Prover(const Subject& subject, const check::Rules& rules, On machine, const proof::Solver& solver,
         int max_seconds, const std::function<void(const ProofStep&)>& observe)
      : subject_(subject),
        rules_(rules),
        runner_(subject, machine),
        ask_([&solver, max_seconds](const std::string& script, int at_most) {
          return solver.ask(script, std::min(at_most, max_seconds));
        }),
        observe_(observe),
        listing_(subject.image),
        signature_(subject.frame.signature) {}

  RoutineProof prove() {
    if (!is_claimable()) {
      proof_.why =
          "only mul, div, add and sub of words of 8, 16 and 32 bits, and signed muldiv "
          "if --overflow and --no-result are any or de can be proven, and a --rule only if general "
          "rules express it or it is Doom's";
      return proof_;
    }
    observe_({});
    SymbolicRun run = run_symbolically(subject_.image, subject_.frame, signature_, listing_, terms_,
                                       may_hold(terms_, ask_, proof_.seconds));
    if (!run.obstacle.empty()) {
      proof_.why = run.obstacle;
      return proof_;
    }
    paths_ = std::move(run.paths);
    proof_.paths = paths_.size();
    if (!terms_are_those_of_machine()) return proof_;
    for (const Arithmetic arithmetic : {Arithmetic::abstract, Arithmetic::exact}) {
      for (const bool halves : {false, true}) {
        if (!quotient_claim(rules_, terms_, {}, halves)) break;
        const auto claim = [&](const Path& path) {
          return *quotient_claim(rules_, terms_, divide_of(terms_, path), halves);
        };
        if (is_final(claim, arithmetic)) return proof_;
      }
      for (const Shape shape : shapes) {
        if (arithmetic == Arithmetic::exact && shape != Shape::of_signed) continue;
        const auto claim = claim_of(rules_, shape);
        if (claim && is_final([&](const Path&) { return *claim; }, arithmetic)) return proof_;
      }
    }
    return proof_;
  }

 private:
  [[nodiscard]] bool is_claimable() const {
    if (rules_.variant.from || rules_.within || rules_.faithful || !takes_words()) return false;
    const auto has_claim = [&](Shape shape) { return claim_of(rules_, shape).has_value(); };
    return std::any_of(shapes.begin(), shapes.end(), has_claim) ||
           quotient_claim(rules_, terms_, {}, false);
  }

  /// Tells whether all operands and the result are words, as the claims have them.
  [[nodiscard]] bool takes_words() const {
    const int bits = rules_.variant.format.word_bits;
    const auto is_word = [bits](const Parameter& p) {
      return p.bits == bits && !p.is_pointer && !p.constant;
    };
    return signature_.result_bits == bits && std::ranges::all_of(signature_.operands, is_word);
  }

  /// Compares the terms with the machine, because a wrong decoding would make a wrong proof.
  bool terms_are_those_of_machine() {
    check::GeneratedCases cases(subject_.variant, {.cases = cases_to_compare});
    sym::Evaluation evaluation(terms_, concrete_function);
    std::vector<std::uint32_t> words(signature_.operands.size());
    while (cases.next(words)) {
      for (std::size_t i = 0; i < words.size(); ++i) evaluation.set(operand_name(i), words[i]);
      const Answer answer = runner_.answers(words).front();
      int taken = 0;
      bool same = true;
      for (const Path& path : paths_) {
        if (evaluation(path.condition) == 0) continue;
        ++taken;
        same = answer.ending.end == (path.divide_error ? End::divide_error
                                     : path.traps      ? End::bad_instruction
                                                       : End::returned) &&
               (!path.returns() || evaluation(path.result) == answer.words[0]);
      }
      if (taken == 1 && same) continue;
      proof_.why = "the model of the instructions and the machine differ";
      return false;
    }
    return true;
  }

  /// Asks about all paths. Returns whether the outcome is final.
  bool is_final(const std::function<Claim(const Path&)>& claim, Arithmetic arithmetic) {
    ++attempts_;
    const auto observed = [&](const Path& path) {
      observe_({.attempt = attempts_,
                .path = static_cast<std::size_t>(&path - paths_.data()) + 1,
                .paths = paths_.size()});
      return claim(path);
    };
    const PathAnswer answer =
        ask_all({terms_, paths_, signature_.operands}, observed, arithmetic, ask_,
                [&](std::span<const std::uint64_t> words) { return fails(words); });
    proof_.seconds += answer.seconds;
    proof_.standing = answer.standing;
    if (!answer.remark.empty()) proof_.why = answer.remark;
    return answer.standing == proof::Standing::proven ||
           answer.standing == proof::Standing::disproven;
  }

  /// Runs a counterexample, and keeps it if the routine fails.
  bool fails(std::span<const std::uint64_t> operands) {
    std::vector<std::uint32_t> words;
    for (const std::uint64_t word : operands) words.push_back(static_cast<std::uint32_t>(word));
    const Answer given = runner_.answers(words).front();
    const check::JudgedCase one = judged_case(subject_.variant, words, given);
    if (check::keeps(rules_, one.operands(), one.said) && given.broken == 0) return false;
    proof_.counterexample = one;
    return true;
  }

  const Subject& subject_;
  const check::Rules& rules_;
  Runner runner_;
  Ask ask_;
  const std::function<void(const ProofStep&)>& observe_;
  std::size_t attempts_ = 0;
  Listing listing_;
  Signature signature_;
  sym::Terms terms_;
  std::vector<Path> paths_;
  RoutineProof proof_;
};

}  // namespace

RoutineProof prove(const Subject& subject, const check::Rules& rules, On machine,
                   const proof::Solver& solver, int max_seconds,
                   const std::function<void(const ProofStep&)>& observe) {
  return Prover(subject, rules, machine, solver, max_seconds, observe).prove();
}

}  // namespace fixproof::judge
