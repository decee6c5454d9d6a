#include "verify/proof/lost_carry.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "verify/parties/interpreter.hpp"
#include "verify/proof/specification.hpp"
#include "x86model/symbolic/call.hpp"
#include "x86model/symbolic/smt.hpp"

namespace fixproof::proof {

namespace {

namespace sym = x86model::symbolic;
using x86model::Routine;

std::vector<sym::Term> results_of(sym::Terms& terms, const sym::State& start,
                                  const x86model::Program& program) {
  const auto paths = sym::run(terms, program.instructions(), start, {.calls_are_fixed_mul = true});
  if (paths.size() != 1 || paths[0].outcome != x86model::Outcome::returned) {
    throw std::logic_error("a ConcatXforms with more than one path");
  }
  return sym::results(terms, Routine::concat, paths[0].state);
}

/// The dot product of row `row` of the first transform with the fourth column of the second. The
/// listing passes the second factor to FixedMul first.
std::string sum_of_products(int row) {
  std::string text = "(bvadd";
  for (int k = 0; k < 3; ++k) text += fmt::format(" (fixedmul q{} p{})", 4 * k + 3, 4 * row + k);
  return text + ")";
}

/// {0} is the sum, {1} the translation, {2} the printed result and {3} the repaired result.
constexpr const char* fourth_column =
    R"((define-fun sum () (_ BitVec 32) {0})
(assert (not (and (= {2} (sum-in-parts sum {1})) (= {3} (bvadd sum {1})))))
)";

/// For any two words, not only those of a transform.
constexpr const char* difference = R"((declare-const s (_ BitVec 32))
(declare-const t (_ BitVec 32))
(define-fun low-words () (_ BitVec 17)
  (bvadd (concat #b0 ((_ extract 15 0) s)) (concat #b0 ((_ extract 15 0) t))))
(define-fun carry () Bool (= ((_ extract 16 16) low-words) #b1))
(assert (not (and (= (distinct (sum-in-parts s t) (bvadd s t)) carry)
                  (= (bvadd s t) (bvadd (sum-in-parts s t) (ite carry (_ bv65536 32) (_ bv0 32)))))))
(check-sat)
)";

}  // namespace

std::vector<std::string> lost_carry_questions(bool mul_round) {
  const auto program = [mul_round](bool repaired) {
    return parties::program_of(
        {.operation = cases::Operation::concat,
         .build = {.target = cases::Target::i8088, .mul_round = mul_round, .repaired = repaired}});
  };
  return lost_carry_between(program(false), program(true));
}

std::vector<std::string> lost_carry_between(const x86model::Program& printed,
                                            const x86model::Program& repaired) {
  sym::Terms terms;
  const sym::State start = sym::enter(terms, Routine::concat);
  const auto lossy = results_of(terms, start, printed);
  const auto whole = results_of(terms, start, repaired);
  std::vector<sym::Term> roots = lossy;
  roots.insert(roots.end(), whole.begin(), whole.end());
  for (int i = 0; i < x86model::arity(Routine::concat).in; ++i) {
    roots.push_back(terms.variable(sym::operand_name(Routine::concat, i), 32));
  }
  const std::string logic =
      fmt::format("(set-logic QF_UFBV)\n(set-option :produce-models true)\n{}", sum_in_parts);
  const std::string before = fmt::format(
      "{}"
      "(declare-fun fixedmul ((_ BitVec 32) (_ BitVec 32)) (_ BitVec 32))\n{}{}",
      logic, sym::declare_variables(terms, roots), sym::define(terms, roots));
  std::vector<std::string> scripts;
  std::string others;
  for (std::size_t i = 0; i < lossy.size(); ++i) {
    const std::string is = sym::name_in_smt(terms, lossy[i]);
    const std::string should_be = sym::name_in_smt(terms, whole[i]);
    if (i % 4 != 3) {
      others += fmt::format(" (= {} {})", is, should_be);
      continue;
    }
    scripts.push_back(before +
                      fmt::format(fmt::runtime(fourth_column),
                                  sum_of_products(static_cast<int>(i / 4)), fmt::format("p{}", i),
                                  is, should_be) +
                      "(check-sat)\n");
  }
  scripts.push_back(fmt::format("{}(assert (not (and{})))\n(check-sat)\n", before, others));
  scripts.push_back(logic + difference);
  return scripts;
}

}  // namespace fixproof::proof
