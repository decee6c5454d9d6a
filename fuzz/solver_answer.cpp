// Target `solver_answer`: the input is what a solver prints about a few questions whose answer is
// known. The text must raise a SolverError or be a correct answer. No question without a solution
// may get a model, the words of a model must satisfy the question in C++, and no model may satisfy
// a claim and its negation.
#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "fuzz/control_characters.hpp"
#include "fuzz/finding.hpp"
#include "verify/proof/model.hpp"
#include "verify/proof/s_expression.hpp"
#include "verify/proof/solver_program.hpp"

using namespace fixproof;
using proof::Satisfiability;

namespace {

struct Claim {
  std::string_view text;
  /// Of the words `a` and `b`; empty if no words satisfy it.
  std::function<bool(std::uint32_t a, std::uint32_t b)> holds;
};

/// `f` may be any function, `twice` is defined.
std::string question(std::string_view claim) {
  return fmt::format(
      "(set-logic QF_UFBV)\n(declare-const a (_ BitVec 32))\n(declare-const b (_ BitVec 32))\n"
      "(declare-const n Int)\n(declare-fun f ((_ BitVec 32)) (_ BitVec 32))\n"
      "(define-fun twice () (_ BitVec 32) (bvadd a a))\n(assert {})\n(check-sat)\n",
      claim);
}

const std::array<Claim, 5>& claims() {
  static const std::array<Claim, 5> all{{
      {"(and (bvult a b) (= (bvmul a b) (_ bv62499 32)))",
       [](std::uint32_t a, std::uint32_t b) { return a < b && a * b == 62499; }},
      {"(and (bvsgt a (_ bv0 32)) (bvsgt b (_ bv0 32)) (bvslt (bvadd a b) (_ bv0 32)))",
       [](std::uint32_t a, std::uint32_t b) {
         return a != 0 && a >> 31U == 0 && b != 0 && b >> 31U == 0 && (a + b) >> 31U == 1;
       }},
      {"(and (distinct a b) (= (f a) b) (= (f b) a) (> n 3))",
       [](std::uint32_t a, std::uint32_t b) { return a != b; }},
      {"(= ((_ extract 0 0) twice) #b1)", {}},
      {"(and (= a b) (distinct (f a) (f b)))", {}},
  }};
  return all;
}

std::uint32_t word(std::string_view model, std::string_view name) {
  try {
    return static_cast<std::uint32_t>(proof::word_in_model(model, name));
  } catch (const std::exception& error) {
    fuzz::report_finding(fmt::format("accepted, but no word for {}: {}", name, error.what()));
  }
}

/// The model that satisfies the question, if there is one.
std::optional<std::string> model_of(const std::string& said, const std::string& script) {
  try {
    const proof::SolverAnswer answer = proof::answer_in({said, "", 0, true}, "solver", script);
    if (answer.verdict == Satisfiability::satisfiable) return answer.model;
    if ((answer.verdict == Satisfiability::unsatisfiable) != (said == "unsat\n")) {
      fuzz::report_finding("taken for " + proof::name_of(answer.verdict));
    }
  } catch (const proof::SolverError& error) {
    if (fuzz::has_control_character(error.what())) {
      fuzz::report_finding("a control character in a message");
    }
  } catch (const std::exception& error) {
    fuzz::report_finding(fmt::format("not a SolverError: {}", error.what()));
  }
  return std::nullopt;
}

void check(const Claim& claim, const std::string& said) {
  const auto model = model_of(said, question(claim.text));
  if (!model) return;
  if (!claim.holds) fuzz::report_finding(fmt::format("a model for {}", claim.text));
  const std::uint32_t a = word(*model, "a");
  const std::uint32_t b = word(*model, "b");
  if (!claim.holds(a, b)) {
    fuzz::report_finding(fmt::format("a = {:08x}, b = {:08x} for {}", a, b, claim.text));
  }
  if (proof::fault_of_model(question(fmt::format("(not {})", claim.text)), *model).empty()) {
    fuzz::report_finding(fmt::format("a model for {} and its negation", claim.text));
  }
}

/// What is read must be the same once it is written and read again.
void check_expressions(const std::string& text) {
  try {
    const auto all = proof::read_expressions(text);
    std::string written;
    for (const auto& one : all) written += proof::text_of(one) + '\n';
    if (proof::read_expressions(written) != all) fuzz::report_finding("read otherwise: " + written);
  } catch (const std::invalid_argument&) {
    // An unbalanced text is refused.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string said(data, data + size);
  check_expressions(said);
  for (const Claim& claim : claims()) check(claim, said);
  // Supplies the verdict, so that the fuzzer need not guess it before a model is read.
  for (const Claim& claim : claims()) check(claim, "sat\n" + said);
  return 0;
}
