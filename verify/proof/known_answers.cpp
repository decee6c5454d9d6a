#include "verify/proof/known_answers.hpp"

#include <array>

namespace fixproof::proof {

namespace {

constexpr Satisfiability sat = Satisfiability::satisfiable;
constexpr Satisfiability unsat = Satisfiability::unsatisfiable;

/// Two constants of 32 bits.
std::string of_words(const std::string& claim) {
  return "(set-logic QF_UFBV)\n(set-option :produce-models true)\n"
         "(declare-const a (_ BitVec 32))\n(declare-const b (_ BitVec 32))\n(assert " +
         claim + ")\n(check-sat)\n";
}

/// Functions like those of the abstract arithmetic and of open memory.
std::string of_functions(const std::string& claim) {
  return "(set-logic QF_UFBV)\n"
         "(declare-fun product ((_ BitVec 32) (_ BitVec 32)) (_ BitVec 64))\n"
         "(declare-fun byte ((_ BitVec 16)) (_ BitVec 8))\n"
         "(declare-fun refused ((_ BitVec 32)) Bool)\n"
         "(define-fun word ((at (_ BitVec 16))) (_ BitVec 16)\n"
         "  (concat (byte (bvadd at (_ bv1 16))) (byte at)))\n"
         "(declare-const a (_ BitVec 32))\n(declare-const b (_ BitVec 32))\n"
         "(declare-const at (_ BitVec 16))\n(assert " +
         claim + ")\n(check-sat)\n";
}

std::string of_integers(const std::string& logic, const std::string& claim) {
  return "(set-logic " + logic + ")\n(declare-const x Int)\n(declare-const y Int)\n(assert " +
         claim + ")\n(check-sat)\n";
}

}  // namespace

std::span<const KnownAnswer> known_answers() {
  static const std::array all{
      // The sum of two positive words is negative if it overflows; one bit more never does.
      KnownAnswer{"overflow", sat, of_words(R"((and (bvsgt a (_ bv0 32)) (bvsgt b (_ bv0 32))
  (bvslt (bvadd a b) (_ bv0 32))))")},
      KnownAnswer{"no overflow", unsat, of_words(R"((and (bvsgt a (_ bv0 32)) (bvsgt b (_ bv0 32))
  (bvslt (bvadd ((_ sign_extend 1) a) ((_ sign_extend 1) b)) (_ bv0 33))))")},
      // A carry of the low halves is lost if they are added on their own.
      KnownAnswer{"lost carry", sat, of_words(R"((distinct (bvadd a b)
  (concat (bvadd ((_ extract 31 16) a) ((_ extract 31 16) b))
          (bvadd ((_ extract 15 0) a) ((_ extract 15 0) b)))))")},
      KnownAnswer{"carry", unsat, of_words(R"(
  (let ((low (bvadd (concat #b0 ((_ extract 15 0) a)) (concat #b0 ((_ extract 15 0) b)))))
    (distinct (bvadd a b)
      (concat (bvadd ((_ extract 31 16) a) ((_ extract 31 16) b)
                     ((_ zero_extend 15) ((_ extract 16 16) low)))
              ((_ extract 15 0) low)))))")},
      // The most negative word is its own negative.
      KnownAnswer{"magnitude", sat, of_words(R"(
  (bvslt (ite (bvslt a (_ bv0 32)) (bvneg a) a) (_ bv0 32)))")},
      KnownAnswer{"unsigned magnitude", unsat, of_words(R"(
  (bvugt (ite (bvslt a (_ bv0 32)) (bvneg a) a) (_ bv2147483648 32)))")},
      // The 64-bit product of two bytes.
      KnownAnswer{"product", sat, of_words(R"((and (bvult a (_ bv256 32)) (bvult b (_ bv256 32))
  (= (bvmul ((_ zero_extend 32) a) ((_ zero_extend 32) b)) (_ bv62499 64))))")},
      KnownAnswer{"product of a prime", unsat, of_words(R"((and
  (bvult (_ bv1 32) a) (bvult a (_ bv32 32)) (bvult (_ bv1 32) b) (bvult b (_ bv32 32))
  (= (bvmul ((_ zero_extend 32) a) ((_ zero_extend 32) b)) (_ bv251 64))))")},
      // Only a divisor of zero gives all ones.
      KnownAnswer{"quotient by zero", sat, of_words(R"((and (bvult a (_ bv16 32))
  (= (bvudiv ((_ extract 7 0) a) ((_ extract 7 0) b)) #xff)))")},
      KnownAnswer{"quotient", unsat,
                  of_words(R"((let ((n ((_ extract 7 0) a)) (d ((_ extract 7 0) b)))
  (and (distinct d #x00) (not (bvult (bvurem n d) d)))))")},
      KnownAnswer{"different products", sat, of_functions(R"((and (distinct a b)
  (distinct (product a b) (product b a)) (refused a) (not (refused b))))")},
      KnownAnswer{"equal products", unsat, of_functions(R"((and (= a b)
  (distinct ((_ extract 47 16) (product a b)) ((_ extract 47 16) (product b a)))))")},
      KnownAnswer{"overlapping words", sat, of_functions(R"(
  (and (= (word at) #x1234) (= (word (bvadd at (_ bv1 16))) #x5612)))")},
      KnownAnswer{"contradictory words", unsat, of_functions(R"(
  (and (= (word at) #x1234) (= (word (bvadd at (_ bv1 16))) #x5678)))")},
      KnownAnswer{"linear integers", sat, of_integers("QF_LIA", R"(
  (and (= x (+ y (* 3600 (div x 3600)))) (<= 0 y) (< y 3600) (< x (- 7000)) (= y 1)))")},
      KnownAnswer{"linear integers without a solution", unsat, of_integers("QF_LIA", R"(
  (and (= x (+ y (* 3600 (div x 3600)))) (distinct y (mod x 3600))))")},
      KnownAnswer{"nonlinear integers", sat, of_integers("QF_NIA", R"(
  (and (= (* x y) 143) (> x 1) (< x y) (< y 143)))")},
      KnownAnswer{"nonlinear integers without a solution", unsat, of_integers("QF_NIA", R"(
  (distinct (* (+ x 1) (+ y 1)) (+ (* x y) x y 1)))")}};
  return all;
}

}  // namespace fixproof::proof
