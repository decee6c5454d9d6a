#include "verify/proof/lemmas.hpp"

#include <array>

namespace fixproof::proof {

namespace {

constexpr std::array all_lemmas{
    Lemma{"product-of-words",
          "a product is the sum of the four products of its factors' 16-bit digits",
          R"((set-logic QF_NIA)
(declare-const h Int) (declare-const l Int) (declare-const j Int) (declare-const k Int)
(assert (not (= (* (+ (* 65536 h) l) (+ (* 65536 j) k))
                (+ (* 4294967296 h j) (* 65536 (+ (* l j) (* h k))) (* l k)))))
(check-sat)
)"},
    Lemma{"order-of-factors", "a product is the same whichever factor comes first",
          R"((set-logic QF_NIA)
(declare-const x Int) (declare-const y Int)
(assert (not (= (* x y) (* y x))))
(check-sat)
)"},
    Lemma{"signed-product",
          "a product of signed words is that of the unsigned ones less what the signs add",
          // X = x + 2^n [x < 0], with s and t 0 or 1 and w = 2^n for any n.
          R"((set-logic QF_NIA)
(declare-const x Int) (declare-const y Int) (declare-const w Int)
(declare-const s Int) (declare-const t Int)
(assert (or (= s 0) (= s 1))) (assert (or (= t 0) (= t 1)))
(define-fun ux () Int (+ x (* s w)))
(define-fun uy () Int (+ y (* t w)))
(assert (not (= (* x y) (+ (* ux uy) (* (- 1) s w uy) (* (- 1) t w ux) (* s t w w)))))
(check-sat)
)"},
    Lemma{"product-of-magnitudes", "a product is that of the magnitudes, with its sign",
          R"((set-logic QF_NIA)
(declare-const x Int) (declare-const y Int)
(define-fun mx () Int (ite (< x 0) (- x) x))
(define-fun my () Int (ite (< y 0) (- y) y))
(assert (not (= (* x y) (ite (xor (< x 0) (< y 0)) (- (* mx my)) (* mx my)))))
(check-sat)
)"},
    Lemma{"one-quotient", "there are no two quotients with remainders below the divisor",
          // m and n stand for the products q d and p d. The only assumption about them is that they
          // are at least a divisor apart if q and p differ.
          R"((set-logic QF_LIA)
(declare-const q Int) (declare-const r Int) (declare-const p Int) (declare-const s Int)
(declare-const d Int) (declare-const m Int) (declare-const n Int)
(assert (> d 0))
(assert (and (<= 0 r) (< r d) (<= 0 s) (< s d)))
(assert (= (+ m r) (+ n s)))
(assert (=> (>= q (+ p 1)) (>= m (+ n d))))
(assert (=> (>= p (+ q 1)) (>= n (+ m d))))
(assert (=> (= p q) (= m n)))
(assert (not (and (= q p) (= r s))))
(check-sat)
)"},
    Lemma{"products-are-apart", "the fact that one-quotient asks for",
          R"((set-logic QF_NIA)
(declare-const q Int) (declare-const p Int) (declare-const d Int)
(assert (> d 0))
(assert (>= q (+ p 1)))
(assert (not (>= (* q d) (+ (* p d) d))))
(check-sat)
)"},
    Lemma{"two-digit-division",
          "the second of two divides gives the lower digit of the quotient of both, which fits",
          // m, n and k stand for the products of b with the first quotient q, the second quotient
          // p, and 65536 q + p. Distributivity relates them.
          R"((set-logic QF_LIA)
(declare-const h Int) (declare-const l Int) (declare-const b Int)
(declare-const q Int) (declare-const r Int) (declare-const p Int) (declare-const s Int)
(declare-const m Int) (declare-const n Int) (declare-const k Int)
(assert (and (<= 0 h) (< h 65536) (<= 0 l) (< l 65536) (< 0 b) (<= 0 q) (<= 0 p)))
(assert (and (= h (+ m r)) (<= 0 r) (< r b)))
(assert (and (= (+ (* 65536 r) l) (+ n s)) (<= 0 s) (< s b)))
(assert (= k (+ (* 65536 m) n)))
(assert (=> (>= p 65536) (>= n (* 65536 b))))
(assert (not (and (= (+ (* 65536 h) l) (+ k s)) (< p 65536))))
(check-sat)
)"},
    Lemma{"quotient-below-dividend", "a quotient is not above its dividend",
          R"((set-logic QF_NIA)
(declare-const n Int) (declare-const d Int) (declare-const q Int) (declare-const r Int)
(assert (and (>= d 1) (>= q 0) (>= r 0)))
(assert (= n (+ (* q d) r)))
(assert (not (<= q n)))
(check-sat)
)"},
    Lemma{"not-all-ones", "no quotient of a magnitude times 2^16 is 2^32 - 1",
          R"((set-logic QF_LIA)
(declare-const n Int) (declare-const d Int) (declare-const r Int)
(assert (and (<= 0 n) (<= n 2147483648) (<= 0 r) (< r d)))
(assert (= (* 65536 n) (+ (* 4294967295 d) r)))
(check-sat)
)"},
    Lemma{"whole-turns",
          "every 16-bit angle is whole turns, -10 to 9, and less than a turn besides",
          R"((set-logic QF_LIA)
(declare-const angle Int)
(assert (and (<= (- 32768) angle) (<= angle 32767)))
(define-fun turns () Int (div angle 3600))
(define-fun turned () Int (mod angle 3600))
(assert (not (and (= angle (+ turned (* 3600 turns))) (<= 0 turned) (< turned 3600)
                  (<= (- 10) turns) (<= turns 9))))
(check-sat)
)"},
};

}  // namespace

std::span<const Lemma> lemmas() { return all_lemmas; }

}  // namespace fixproof::proof
