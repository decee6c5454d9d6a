#include "verify/proof/specification.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "x86model/cosine_table.hpp"

namespace fixproof::proof {

namespace {

constexpr const char* signs = R"((define-fun magnitude ((x (_ BitVec 32))) (_ BitVec 32)
  (ite (bvslt x (_ bv0 32)) (bvneg x) x))
(define-fun opposite ((x (_ BitVec 32)) (y (_ BitVec 32))) Bool
  (xor (bvslt x (_ bv0 32)) (bvslt y (_ bv0 32))))
(define-fun signed ((negative Bool) (x (_ BitVec 32))) (_ BitVec 32)
  (ite negative (bvneg x) x))
(define-fun high ((x (_ BitVec 32))) (_ BitVec 16) ((_ extract 31 16) x))
(define-fun low ((x (_ BitVec 32))) (_ BitVec 16) ((_ extract 15 0) x))
)";

/// The exact product in units of 2^-32, from one signed multiply (386) or from the words of the
/// magnitudes (8088, lemma product-of-words).
constexpr const char* product_i386 =
    R"((define-fun exact ((x (_ BitVec 32)) (y (_ BitVec 32))) (_ BitVec 64)
  (smul32 x y))
)";
constexpr const char* product_i8088 = R"((define-fun wide ((x (_ BitVec 32))) (_ BitVec 64)
  (concat (_ bv0 32) x))
(define-fun exact ((x (_ BitVec 32)) (y (_ BitVec 32))) (_ BitVec 64)
  (let ((m (magnitude x)) (n (magnitude y)))
    (bvadd (bvshl (wide (umul16 (high m) (high n))) (_ bv32 64))
           (bvshl (bvadd (wide (umul16 (low m) (high n))) (wide (umul16 (high m) (low n))))
                  (_ bv16 64))
           (wide (umul16 (low m) (low n))))))
)";

/// In units of 2^-32, half a result unit is 2^15 and a result unit is 2^16.
std::string multiply(const cases::Variant& v) {
  const char* half = v.build.mul_round ? "(_ bv32768 64)" : "(_ bv0 64)";
  if (v.build.target == cases::Target::i386) {
    return fmt::format(R"({}(define-fun product ((x (_ BitVec 32)) (y (_ BitVec 32))) (_ BitVec 32)
  ((_ extract 47 16) (bvadd (exact x y) {})))
)",
                       product_i386, half);
  }
  return fmt::format(R"({}(define-fun product ((x (_ BitVec 32)) (y (_ BitVec 32))) (_ BitVec 32)
  (signed (opposite x y) ((_ extract 47 16) (bvadd (exact x y) {}))))
)",
                     product_i8088, half);
}

/// Divides the magnitudes to a truncated quotient and a remainder. Adds one to the quotient if
/// twice the remainder is at least the divisor, then applies the sign.
constexpr const char* divide_i386_rounded =
    R"((define-fun dividend () (_ BitVec 64) (concat (_ bv0 16) (magnitude a) (_ bv0 16)))
(define-fun divisor () (_ BitVec 32) (magnitude b))
(define-fun half-or-more () Bool
  (bvuge (concat (urem32 dividend divisor) (_ bv0 1)) (concat (_ bv0 1) divisor)))
(define-fun quotient () (_ BitVec 32)
  (signed (opposite a b)
    (bvadd (udiv32 dividend divisor) (ite half-or-more (_ bv1 32) (_ bv0 32)))))
(define-fun faults () Bool (bvuge (concat (_ bv0 16) (high (magnitude a))) divisor))
)";
constexpr const char* divide_i386_unrounded =
    R"((define-fun dividend () (_ BitVec 64) (concat ((_ sign_extend 16) a) (_ bv0 16)))
(define-fun quotient () (_ BitVec 32) (sdiv32 dividend b))
(define-fun faults () Bool (sfault32 dividend b))
)";
/// Divides by the whole part of the divisor's magnitude, digit by digit (lemma two-digit-division).
constexpr const char* divide_i8088 =
    R"((define-fun divisor () (_ BitVec 16) (high (magnitude b)))
(define-fun first () (_ BitVec 32) (concat (_ bv0 16) (high (magnitude a))))
(define-fun second () (_ BitVec 32) (concat (urem16 first divisor) (low (magnitude a))))
(define-fun half-or-more () Bool
  (bvuge (concat (urem16 second divisor) (_ bv0 1)) (concat (_ bv0 1) divisor)))
(define-fun quotient () (_ BitVec 32)
  (signed (opposite a b)
    (bvadd (concat (udiv16 first divisor) (udiv16 second divisor))
      (ite {} (_ bv1 32) (_ bv0 32)))))
(define-fun faults () Bool (= divisor (_ bv0 16)))
)";

std::string divide(const cases::Variant& v) {
  if (v.build.target == cases::Target::i8088) {
    return fmt::format(fmt::runtime(divide_i8088), v.build.div_round ? "half-or-more" : "false");
  }
  return v.build.div_round ? divide_i386_rounded : divide_i386_unrounded;
}

/// Reduces the angle by whole turns (lemma whole-turns), then by quadrants. entry(i) is the cosine
/// of i tenths of a degree, 0 <= i <= 900.
static_assert(x86model::cosine_table[900] == 0, "asserted below: cos(90 degrees) is 0");
constexpr const char* cosine_and_sine =
    R"((define-fun entry ((i (_ BitVec 16))) (_ BitVec 32)
  (concat (cosword (bvadd (bvshl i (_ bv2 16)) (_ bv2 16))) (cosword (bvshl i (_ bv2 16)))))
(assert (= (entry (_ bv900 16)) (_ bv0 32)))
(declare-const turned (_ BitVec 16))
(declare-const turns (_ BitVec 16))
(assert (and (bvult turned (_ bv3600 16)) (bvsle (bvneg (_ bv10 16)) turns) (bvsle turns (_ bv9 16))))
(assert (= ((_ sign_extend 16) angle)
  (bvadd ((_ zero_extend 16) turned) (bvmul (_ bv3600 32) ((_ sign_extend 16) turns)))))
(define-fun cosine () (_ BitVec 32)
  (ite (bvule turned (_ bv900 16)) (entry turned)
  (ite (bvule turned (_ bv1800 16)) (bvneg (entry (bvsub (_ bv1800 16) turned)))
  (ite (bvule turned (_ bv2700 16)) (bvneg (entry (bvsub turned (_ bv1800 16))))
    (entry (bvsub (_ bv3600 16) turned))))))
(define-fun sine () (_ BitVec 32)
  (ite (bvule turned (_ bv900 16)) (entry (bvsub (_ bv900 16) turned))
  (ite (bvule turned (_ bv1800 16)) (entry (bvsub turned (_ bv900 16)))
  (ite (bvule turned (_ bv2700 16)) (bvneg (entry (bvsub (_ bv2700 16) turned)))
    (bvneg (entry (bvsub turned (_ bv2700 16))))))))
)";

/// The digit products of product_i8088, in the order of the listing.
std::vector<std::string> digit_products(const cases::Variant& v) {
  if (v.build.target != cases::Target::i8088) return {};
  std::vector<std::string> products;
  for (const auto& [x, y] :
       {std::pair("high", "high"), {"low", "high"}, {"high", "low"}, {"low", "low"}}) {
    products.push_back(fmt::format("(umul16 ({} (magnitude a)) ({} (magnitude b)))", x, y));
  }
  return products;
}

/// The sum of three products and an addend. The 8088 passes the second factor to FixedMul first
/// (lemma order-of-factors).
std::string sum(const cases::Variant& v,
                const std::vector<std::pair<std::string, std::string>>& products,
                const std::string& translation) {
  std::string text = "(bvadd";
  for (const auto& [row, column] : products) {
    text += v.build.target == cases::Target::i386 ? fmt::format(" (product {} {})", row, column)
                                                  : fmt::format(" (fixedmul {} {})", column, row);
  }
  return text + (translation.empty() ? ")" : " " + translation + ")");
}

std::vector<std::string> transformed_point(const cases::Variant& v) {
  std::vector<std::string> words;
  for (int row = 0; row < 3; ++row) {
    std::vector<std::pair<std::string, std::string>> products;
    for (int k = 0; k < 3; ++k) {
      products.emplace_back(fmt::format("x{}", 4 * row + k), fmt::format("v{}", k));
    }
    words.push_back(sum(v, products, fmt::format("x{}", 4 * row + 3)));
  }
  return words;
}

std::vector<std::string> transform_product(const cases::Variant& v) {
  std::vector<std::string> words;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      std::vector<std::pair<std::string, std::string>> products;
      for (int k = 0; k < 3; ++k) {
        products.emplace_back(fmt::format("p{}", 4 * row + k), fmt::format("q{}", 4 * k + column));
      }
      const std::string translation = fmt::format("p{}", 4 * row + 3);
      if (column == 3 && cases::loses_carry(v)) {
        words.push_back(fmt::format("(sum-in-parts {} {})", sum(v, products, ""), translation));
      } else {
        words.push_back(sum(v, products, column == 3 || v.build.chapter_52 ? translation : ""));
      }
    }
  }
  return words;
}

/// Multiplies and divides {0}-bit words; results of {1} bits. {2} and {3} are {0} - 1 and {1} - 1.
constexpr const char* abstract =
    R"((declare-fun umul{0} ((_ BitVec {0}) (_ BitVec {0})) (_ BitVec {1}))
(declare-fun udiv{0} ((_ BitVec {1}) (_ BitVec {0})) (_ BitVec {0}))
(declare-fun urem{0} ((_ BitVec {1}) (_ BitVec {0})) (_ BitVec {0}))
(declare-fun sdiv{0} ((_ BitVec {1}) (_ BitVec {0})) (_ BitVec {0}))
(declare-fun srem{0} ((_ BitVec {1}) (_ BitVec {0})) (_ BitVec {0}))
(declare-fun sfault{0} ((_ BitVec {1}) (_ BitVec {0})) Bool)
)";
constexpr const char* exact = R"((define-fun widened{0} ((x (_ BitVec {0}))) (_ BitVec {1})
  (concat (_ bv0 {0}) x))
(define-fun narrowed{0} ((x (_ BitVec {1}))) (_ BitVec {0}) ((_ extract {2} 0) x))
(define-fun umul{0} ((x (_ BitVec {0})) (y (_ BitVec {0}))) (_ BitVec {1})
  (bvmul (widened{0} x) (widened{0} y)))
(define-fun udiv{0} ((x (_ BitVec {1})) (y (_ BitVec {0}))) (_ BitVec {0})
  (narrowed{0} (bvudiv x (widened{0} y))))
(define-fun urem{0} ((x (_ BitVec {1})) (y (_ BitVec {0}))) (_ BitVec {0})
  (narrowed{0} (bvurem x (widened{0} y))))
(define-fun sdiv{0} ((x (_ BitVec {1})) (y (_ BitVec {0}))) (_ BitVec {0})
  (narrowed{0} (bvsdiv x ((_ sign_extend {0}) y))))
(define-fun srem{0} ((x (_ BitVec {1})) (y (_ BitVec {0}))) (_ BitVec {0})
  (narrowed{0} (bvsrem x ((_ sign_extend {0}) y))))
(define-fun sfault{0} ((x (_ BitVec {1})) (y (_ BitVec {0}))) Bool
  (or (= y (_ bv0 {0})) (and (= x (concat #b1 (_ bv0 {3}))) (= y (bvnot (_ bv0 {0}))))
      (not (= (bvsdiv x ((_ sign_extend {0}) y)) ((_ sign_extend {0}) (sdiv{0} x y))))))
)";
constexpr const char* signed_product =
    R"((define-fun smul{0} ((x (_ BitVec {0})) (y (_ BitVec {0}))) (_ BitVec {1})
  (bvsub (umul{0} x y) (bvadd
    (ite (bvslt x (_ bv0 {0})) (concat y (_ bv0 {0})) (_ bv0 {1}))
    (ite (bvslt y (_ bv0 {0})) (concat x (_ bv0 {0})) (_ bv0 {1})))))
)";

}  // namespace

std::string abstractions(Arithmetic arithmetic) {
  std::string text =
      "(declare-fun fixedmul ((_ BitVec 32) (_ BitVec 32)) (_ BitVec 32))\n"
      "(declare-fun cosword ((_ BitVec 16)) (_ BitVec 16))\n";
  for (const int n : {16, 32}) {
    text += fmt::format(fmt::runtime(arithmetic == Arithmetic::exact ? exact : abstract), n, 2 * n,
                        n - 1, 2 * n - 1);
    text += fmt::format(fmt::runtime(signed_product), n, 2 * n);
  }
  return text;
}

Specification specification(const cases::Variant& v) {
  switch (v.operation) {
    case cases::Operation::mul:
      return {signs + multiply(v), "false", {"(product a b)"}, digit_products(v)};
    case cases::Operation::div:
      return {signs + divide(v), "faults", {"quotient"}};
    case cases::Operation::cossin:
      return {cosine_and_sine, "false", {"cosine", "sine"}};
    case cases::Operation::xformvec:
      return {signs + multiply(v), "false", transformed_point(v)};
    case cases::Operation::concat:
      return {signs + multiply(v) + sum_in_parts, "false", transform_product(v)};
    default:
      throw std::invalid_argument("no routine");
  }
}

}  // namespace fixproof::proof
