// Tests that a model is accepted if and only if it satisfies its question, and that the solvers
// answer the test questions.
#include "verify/proof/model.hpp"

#include <gtest/gtest.h>

#include <boost/process/search_path.hpp>
#include <string>
#include <utility>
#include <vector>

#include "verify/proof/known_answers.hpp"
#include "verify/proof/solver.hpp"

namespace {

using namespace fixproof;
using proof::fault_of_model;

std::string question(const std::string& claim) {
  return "(set-logic QF_UFBV)\n(declare-const a (_ BitVec 8))\n(declare-const n Int)\n"
         "(declare-fun f ((_ BitVec 8)) (_ BitVec 8))\n(define-fun twice () (_ BitVec 8) (bvadd a "
         "a))\n(assert " +
         claim + ")\n(check-sat)\n";
}

std::string a_is(const std::string& value) {
  return "((define-fun a () (_ BitVec 8) " + value + "))";
}

// Each claim holds by the definitions of SMT-LIB 2.6, with a = 0x96 = 150 = -106, f = 0 and n = 0.
TEST(Model, EvaluatesEveryOperation) {
  for (const char* claim : {"(= twice #x2c)",
                            "(= (bvsub #x01 a) #x6b)",
                            "(= (bvmul a #x03) #xc2)",
                            "(= (bvand a #x0f) #x06)",
                            "(= (bvor a #x0f) #x9f)",
                            "(= (bvxor a #xff) #x69)",
                            "(= (bvudiv a #x07) #x15)",
                            "(= (bvudiv a #x00) #xff)",
                            "(= (bvurem a #x07) #x03)",
                            "(= (bvurem a #x00) a)",
                            "(= (bvsdiv a #x07) #xf1)",
                            "(= (bvsdiv a #x00) #x01)",
                            "(= (bvsrem a #x07) #xff)",
                            "(= (bvsrem a #x00) a)",
                            "(= (bvshl a #x02) #x58)",
                            "(= (bvshl a #x08) #x00)",
                            "(= (bvlshr a #x02) #x25)",
                            "(= (bvneg a) #x6a)",
                            "(= (bvnot a) #x69)",
                            "(= (concat a #b101) #b10010110101)",
                            "(= ((_ extract 7 4) a) #x9)",
                            "(= ((_ sign_extend 4) a) #xf96)",
                            "(= ((_ zero_extend 4) a) #x096)",
                            "(bvult a #x97)",
                            "(bvule a #x96)",
                            "(bvugt a #x95)",
                            "(bvuge a #x96)",
                            "(bvslt a #x00)",
                            "(bvsle a #x96)",
                            "(bvsgt #x00 a)",
                            "(bvsge #x00 a)",
                            "(distinct a #x00 #x01)",
                            "(= a (_ bv150 8) #x96)",
                            "(ite (bvslt a #x00) true false)",
                            "(and true (or false (not false)) (xor true false))",
                            "(=> false false)",
                            "(let ((b (bvadd a #x01)) (c a)) (= b #x97))",
                            "(= (f a) #x00)",
                            "(= n (- 0))",
                            "(= (div (- 7) 2) (- 4))",
                            "(= (mod (- 7) 2) 1)",
                            "(= (div 7 (- 2)) (- 3))",
                            "(< n 1 2)",
                            "(<= n 0)",
                            "(> (+ 1 2 3) (* 1 5))",
                            "(>= (- 9 2 3) 4)"}) {
    EXPECT_EQ(fault_of_model(question(claim), a_is("#x96")), "") << claim;
    EXPECT_EQ(fault_of_model(question("(not " + std::string(claim) + ")"), a_is("#x96")),
              "it does not satisfy assertion 1 of 1")
        << claim;
  }
}

TEST(Model, ReadsTheModelsOfBothSolvers) {
  const std::string claim = question("(and (= (f a) #x05) (= (f #x00) #x07) (= n (- 3)))");
  for (const char* model :
       {"(\n  (define-fun a () (_ BitVec 8)\n    #x01)\n  (define-fun n () Int\n    (- 3))\n"
        "  (define-fun f ((x!0 (_ BitVec 8))) (_ BitVec 8)\n    (ite (= x!0 #x00) #x07\n      "
        "#x05))\n)",
        "(model (define-fun a () (_ BitVec 8) #b00000001)\n(define-fun n () Int (- 3))\n"
        "(define-fun f ((_arg_1 (_ BitVec 8))) (_ BitVec 8) (ite (= #b00000000 _arg_1) #b00000111 "
        "#b00000101)))",
        "((define-fun k!0 ((x!0 (_ BitVec 8))) (_ BitVec 8) x!0) (define-fun a () (_ BitVec 8) "
        "#x01)"
        " (define-fun f ((x!0 (_ BitVec 8))) (_ BitVec 8) (ite (= (k!0 x!0) #x00) #x07 #x05))"
        " (define-fun n () Int (- 3)))"}) {
    EXPECT_EQ(fault_of_model(claim, model), "") << model;
    EXPECT_EQ(proof::word_in_model(model, "a"), 1U);
    EXPECT_EQ(proof::word_in_model(model, "omitted"), 0U);
  }
}

TEST(Model, NamesWhatIsWrong) {
  const std::string claim = question("(= twice #x0a)");
  EXPECT_EQ(fault_of_model(claim, a_is("#x05")), "");
  const std::vector<std::pair<std::string, std::string>> wrong{
      {"", "not a list of definitions"},
      {"()", "it does not satisfy assertion 1 of 1"},
      {a_is("#x04"), "it does not satisfy assertion 1 of 1"},
      {a_is("#x0005"), "a is of another sort"},
      {a_is("#x0g"), "'0g' is not a number"},
      {a_is("5"), "a is of another sort"},
      {a_is("a"), "nested too deeply"},
      {a_is("junk"), "unknown name junk"},
      {a_is("(bvfoo #x05)"), "cannot apply bvfoo to 1 arguments"},
      {"((define-fun a () (_ BitVec 8) #x05)", "a ) is missing"},
      {"((define-fun a () (_ BitVec 8) #x05)))", "one ) too many"},
      {"((define-fun a () (_ BitVec 9) #b000000101))", "a is of another sort"},
      {"((define-fun a () Real 5))", "unknown sort Real"},
      {"((define-fun b () (_ BitVec 8) #x05))", "it does not satisfy assertion 1 of 1"},
      {"((define-fun = ((x (_ BitVec 8)) (y (_ BitVec 8))) Bool true))",
       "it does not satisfy assertion 1 of 1"},
      {"((define-fun a () (_ BitVec 8) #x04) (define-fun twice () (_ BitVec 8) #x0a))",
       "it does not satisfy assertion 1 of 1"},
      {"((define-fun f () (_ BitVec 8) #x05))", "f is of another sort"},
      {a_is("(_ bv5 0)"), "a bit vector has 0 bits"},
      {a_is("((_ extract 7 0) (bvsdiv (_ bv5 0) (_ bv1 0)))"), "a bit vector has 0 bits"},
      {a_is("(_ bv5 1025)"), "'1025' is not a size"},
      {a_is("((_ extract 7 0) #b" + std::string(1024, '1') + "1)"), "a bit vector has 1025 bits"},
      {a_is("((_ extract 7 0) #x" + std::string(256, 'f') + "f)"), "a bit vector has 1028 bits"},
      {a_is("((_ extract 7 0) ((_ zero_extend 1017) #x05))"), "a bit vector has 1025 bits"},
      {"((define-fun five () Int 5) (define-fun a () (_ BitVec 8) (_ bvfive 8)))",
       "unknown literal (_ bvfive 8)"},
      {a_is("(_ bv 8)"), "unknown literal (_ bv 8)"},
      {a_is("(_ b 8)"), "unknown literal (_ b 8)"},
      {"((define-fum a () (_ BitVec 8) #x05))",
       "not a definition: (define-fum a () (_ BitVec 8) #x05)"},
      {std::string(5000, '('), "nested too deeply"}};
  for (const auto& [model, fault] : wrong) EXPECT_EQ(fault_of_model(claim, model), fault) << model;
}

// The counterexample that is shown is the one that was checked.
TEST(Model, UsesTheFirstOfTwoDefinitions) {
  const std::string model =
      "((define-fun a () (_ BitVec 8) #x05) (define-fun a () (_ BitVec 8) #x04))";
  EXPECT_EQ(fault_of_model(question("(= twice #x0a)"), model), "");
  EXPECT_EQ(proof::word_in_model(model, "a"), 5U);
}

// The counterexample is read without the question.
TEST(Model, MustNotUseTheNamesOfTheQuestion) {
  const std::string claim = question("(and (= a #x05) (= n (ite (= twice #x0a) 7 8)))");
  EXPECT_EQ(fault_of_model(claim, "((define-fun a () (_ BitVec 8) #x05) (define-fun n () Int 7))"),
            "");
  EXPECT_EQ(fault_of_model(claim,
                           "((define-fun a () (_ BitVec 8) #x05)"
                           " (define-fun n () Int (ite (= twice #x0a) 7 8)))"),
            "unknown name twice");
  EXPECT_EQ(fault_of_model(claim,
                           "((define-fun a () (_ BitVec 8) #x05)"
                           " (define-fun twice () (_ BitVec 8) #x00)"
                           " (define-fun n () Int (ite (= twice #x0a) 7 8)))"),
            "n has another value in the question");
  // z3 repeats definitions of the question with names of its own that nothing else can read.
  EXPECT_EQ(fault_of_model(claim,
                           "((define-fun a () (_ BitVec 8) #x05) (define-fun n () Int 7)"
                           " (define-fun twice () (_ BitVec 8) (bvadd (_ fold-rec-2 0) a)))"),
            "");
}

// Each of these models would exhaust time or memory if the evaluator did not refuse it.
TEST(Model, IsEvaluatedInBoundedTime) {
  std::string squares = "((define-fun s0 () Int 9)";
  std::string calls = "((define-fun c0 ((x Int)) Int x)";
  for (int i = 1; i < 60; ++i) {
    squares += " (define-fun s" + std::to_string(i) + " () Int (* s" + std::to_string(i - 1) +
               " s" + std::to_string(i - 1) + "))";
    const std::string before = "(c" + std::to_string(i - 1) + " x)";
    calls +=
        " (define-fun c" + std::to_string(i) + " ((x Int)) Int (+ " + before + " " + before + "))";
  }
  const std::string claim = question("(= n 0)");
  EXPECT_EQ(fault_of_model(claim, squares + " (define-fun n () Int s59))"),
            "an integer has more than 4096 bits");
  EXPECT_EQ(fault_of_model(claim, calls + " (define-fun n () Int (c59 0)))"),
            "its evaluation takes too many steps");
  EXPECT_EQ(fault_of_model(claim, "((define-fun n () Int 1" + std::string(1233, '0') + "))"),
            "a number has more than 1233 digits");
}

TEST(Model, TakesVectorsOfUpTo1024Bits) {
  EXPECT_EQ(fault_of_model(question("(= #x" + std::string(256, 'f') + " #b" +
                                    std::string(1024, '1') + " ((_ sign_extend 1016) #xff))"),
                           "()"),
            "");
}

TEST(Solvers, AnswerTheTestQuestions) {
  std::size_t satisfiable = 0;
  for (const proof::KnownAnswer& known : proof::known_answers()) {
    if (known.verdict == proof::Satisfiability::satisfiable) ++satisfiable;
  }
  EXPECT_EQ(2 * satisfiable, proof::known_answers().size());
  EXPECT_GE(satisfiable, 8U);
  EXPECT_NO_THROW(proof::Solver("z3"));
}

TEST(Solvers, BothAnswerTheTestQuestions) {
  if (boost::process::search_path("cvc5").empty()) GTEST_SKIP() << "cvc5 is not installed";
  EXPECT_NO_THROW(proof::Solver("both"));
}

}  // namespace
