#include "judge/code/claim.hpp"

#include <fmt/format.h>

#include "judge/check/ports.hpp"
#include "judge/check/word.hpp"

namespace fixproof::judge {

namespace {

using cases::Operation;
using oracle::Rounding;

/// {0} is the width W of a word, {1} is 2W, and {2} is the number of fraction bits. A quantity of
/// 2W bits is called wide.
constexpr const char* signs =
    R"((define-fun widened ((x (_ BitVec {0}))) (_ BitVec {1}) (concat (_ bv0 {0}) x))
(define-fun magnitude ((x (_ BitVec {0}))) (_ BitVec {0}) (ite (bvslt x (_ bv0 {0})) (bvneg x) x))
(define-fun signed ((negative Bool) (x (_ BitVec {1}))) (_ BitVec {1}) (ite negative (bvneg x) x))
(define-fun opposite ((x (_ BitVec {0})) (y (_ BitVec {0}))) Bool
  (xor (bvslt x (_ bv0 {0})) (bvslt y (_ bv0 {0}))))
)";

std::string filled(const char* text, const cases::Format& format) {
  return fmt::format(fmt::runtime(text), format.word_bits, 2 * format.word_bits,
                     format.fraction_bits);
}

/// Defines `product`, wide and signed, and `product-size`, its magnitude. The assertion holds for
/// all products; it gives abstract arithmetic the sign.
std::string product_of(Shape shape, const cases::Format& format) {
  if (shape == Shape::of_signed) {
    return filled(R"((define-fun product () (_ BitVec {1}) (smul{0} a b))
(define-fun product-size () (_ BitVec {1}) (signed (bvslt product (_ bv0 {1})) product))
(assert (= (bvslt product (_ bv0 {1}))
  (and (opposite a b) (distinct a (_ bv0 {0})) (distinct b (_ bv0 {0})))))
)",
                  format);
  }
  std::string size = filled("(umul{0} (magnitude a) (magnitude b))", format);
  if (shape == Shape::of_digits) {
    const auto digit = [](const char* word, const char* bits) {
      return fmt::format("((_ extract {}) (magnitude {}))", bits, word);
    };
    const auto part = [&](const char* x, const char* y, int shift) {
      return fmt::format("(bvshl (concat (_ bv0 32) (umul16 {} {})) (_ bv{} 64))", digit("a", x),
                         digit("b", y), shift);
    };
    constexpr const char* high = "31 16";
    constexpr const char* low = "15 0";
    size = fmt::format("(bvadd {} {} {} {})", part(high, high, 32), part(low, high, 16),
                       part(high, low, 16), part(low, low, 0));
  }
  return filled("(define-fun product-size () (_ BitVec {1}) ", format) + size + ")\n" +
         filled("(define-fun product () (_ BitVec {1}) (signed (opposite a b) product-size))\n",
                format);
}

/// Returns the rounded product, wide.
std::string rounded_product(Rounding rounding, const cases::Format& format) {
  const int bits = 2 * format.word_bits;
  const int f = format.fraction_bits;
  const auto cut = [&](const std::string& x) {
    return f == 0 ? x
                  : fmt::format("((_ sign_extend {}) ((_ extract {} {}) {}))", f, bits - 1, f, x);
  };
  const auto plus = [&](const std::string& x, const std::string& add) {
    return f == 0 ? x : fmt::format("(bvadd {} {})", x, add);
  };
  const std::string half =
      fmt::format("(_ bv{} {})", f == 0 ? 0 : std::uint64_t{1} << (f - 1), bits);
  const auto with_sign = [&](const std::string& x) {
    return fmt::format("(signed (bvslt product (_ bv0 {})) {})", bits, x);
  };
  switch (rounding) {
    case Rounding::floor:
      return cut("product");
    case Rounding::half_up:
      return cut(plus("product", half));
    case Rounding::half_away:
      return with_sign(cut(plus("product-size", half)));
    case Rounding::truncate:
      return with_sign(cut("product-size"));
    case Rounding::ceiling:
      return cut(
          plus("product",
               f == 0 ? half : fmt::format("(_ bv{} {})", (std::uint64_t{1} << f) - 1, bits)));
    case Rounding::half_even:
      break;
  }
  // Adds a half, less one unit if the floor is even, so that such a tie rounds down.
  if (f == 0) return "product";
  const std::string odd = fmt::format("((_ extract {0} {0}) product)", f);
  return cut(
      plus(plus("product", fmt::format("(_ bv{} {})", (std::uint64_t{1} << (f - 1)) - 1, bits)),
           fmt::format("(concat (_ bv0 {}) {})", bits - 1, odd)));
}

/// Defines `size`, `rest` and `unit`, the magnitudes of the truncated quotient, the remainder and
/// the divisor, all wide. Also defines `negative`, the sign of the exact quotient, and `faults`,
/// whether the machine's divide faults. The assertions hold for IDIV: a zero divisor faults, and
/// every quotient has the sign of the exact one.
std::string quotient_of(Shape shape, bool of_product, const cases::Format& format) {
  const char* divisor = of_product ? "c" : "b";
  std::string text = of_product ? product_of(shape, format) : "";
  const std::string negative =
      of_product ? filled("(xor (opposite a b) (bvslt c (_ bv0 {0})))", format) : "(opposite a b)";
  text += fmt::format("(define-fun negative () Bool {})\n", negative);
  if (shape == Shape::of_signed) {
    const std::string dividend =
        of_product ? "product" : filled("(bvshl ((_ sign_extend {0}) a) (_ bv{2} {1}))", format);
    return text +
           fmt::format("(define-fun dividend () (_ BitVec {}) {})\n", 2 * format.word_bits,
                       dividend) +
           fmt::format(
               fmt::runtime(filled(
                   R"((define-fun size () (_ BitVec {1}) (widened (magnitude (sdiv{0} dividend {{0}}))))
(define-fun rest () (_ BitVec {1}) (widened (magnitude (srem{0} dividend {{0}}))))
(define-fun unit () (_ BitVec {1}) (widened (magnitude {{0}})))
(define-fun faults () Bool (sfault{0} dividend {{0}}))
(assert (or faults (distinct {{0}} (_ bv0 {0}))))
(assert (or faults (= (sdiv{0} dividend {{0}}) (_ bv0 {0}))
  (= (bvslt (sdiv{0} dividend {{0}}) (_ bv0 {0})) negative)))
)",
                   format)),
               divisor);
  }
  const std::string dividend =
      of_product ? "product-size" : filled("(bvshl (widened (magnitude a)) (_ bv{2} {1}))", format);
  return text +
         fmt::format("(define-fun dividend () (_ BitVec {}) {})\n", 2 * format.word_bits,
                     dividend) +
         fmt::format(fmt::runtime(fmt::format(
                         R"((define-fun unit () (_ BitVec {1}) (widened (magnitude {{0}})))
(define-fun size () (_ BitVec {1}) (widened (udiv{0} dividend (magnitude {{0}}))))
(define-fun rest () (_ BitVec {1}) (widened (urem{0} dividend (magnitude {{0}}))))
(define-fun faults () Bool (bvuge ((_ extract {2} {0}) dividend) (magnitude {{0}})))
)",
                         format.word_bits, 2 * format.word_bits, 2 * format.word_bits - 1)),
                     divisor);
}

/// Returns the rounded quotient, wide. Its magnitude is `size` or one more.
std::string rounded_quotient(Rounding rounding, const cases::Format& format) {
  std::string more;
  const std::string doubled = filled("(bvadd rest rest)", format);
  switch (rounding) {
    case Rounding::truncate:
      more = "false";
      break;
    case Rounding::floor:
      more = filled("(and negative (distinct rest (_ bv0 {1})))", format);
      break;
    case Rounding::ceiling:
      more = filled("(and (not negative) (distinct rest (_ bv0 {1})))", format);
      break;
    case Rounding::half_away:
      more = fmt::format("(bvuge {} unit)", doubled);
      break;
    case Rounding::half_up:
      more = fmt::format("(ite negative (bvugt {0} unit) (bvuge {0} unit))", doubled);
      break;
    case Rounding::half_even:
      more = fmt::format("(or (bvugt {0} unit) (and (= {0} unit) (= ((_ extract 0 0) size) #b1)))",
                         doubled);
      break;
  }
  return filled("(signed negative (bvadd size (ite ", format) + more +
         filled(" (_ bv1 {1}) (_ bv0 {1}))))", format);
}

/// Returns the word for a result out of range, or nothing if no word replaces it.
std::string overflowed(const check::Rules& rules) {
  const cases::Format& format = rules.variant.format;
  const auto word = [&](std::uint64_t value) {
    return fmt::format("(_ bv{} {})", value, format.word_bits);
  };
  const auto by_sign = [&](std::uint64_t low) {
    return fmt::format("(ite (bvslt rounded (_ bv0 {})) {} {})", 2 * format.word_bits, word(low),
                       word(cases::highest(format)));
  };
  switch (rules.overflow) {
    case check::Overflow::wrap:
      return "cut";
    case check::Overflow::saturate:
      return by_sign(cases::lowest(format));
    case check::Overflow::symmetric:
      return by_sign(check::minus_highest(format));
    case check::Overflow::maximum:
      return word(cases::highest(format));
    case check::Overflow::minimum:
      return word(cases::lowest(format));
    default:
      return "";
  }
}

/// A claim for the operands that pass Doom's comparison, and an end of the range for the others.
Claim guarded(Claim claim, const cases::Format& format) {
  const int bits = format.word_bits;
  claim.definitions += fmt::format(
      "(define-fun shifted () (_ BitVec {0}) ((_ sign_extend 14) ((_ extract {1} 14) (magnitude "
      "a))))\n"
      "(define-fun guarded () Bool (not (bvslt shifted (magnitude b))))\n"
      "(define-fun end () (_ BitVec {0}) (ite (opposite a b) (_ bv{2} {0}) (_ bv{3} {0})))\n",
      bits, bits - 1, cases::lowest(format), cases::highest(format));
  claim.may_fault = fmt::format("(and (not guarded) {})", claim.may_fault);
  claim.is_right = fmt::format("(ite guarded (= {{0}} end) {})", claim.is_right);
  return claim;
}

bool has_quotient(Operation operation) {
  return operation == Operation::div || operation == Operation::mul_div;
}

bool is_guarded(const check::Rules& rules) {
  return rules.port != nullptr && rules.port->has_guard;
}

/// Tells whether a claim can state what a quotient must be. The machine's divide gives none that is
/// out of range. If there is no result, the routine can only fault, or anything is right.
bool has_claimable_quotient(const check::Rules& rules) {
  const bool told =
      rules.overflow == check::Overflow::any || rules.overflow == check::Overflow::error;
  const bool is_lack_told =
      rules.no_result == check::NoResult::any || rules.no_result == check::NoResult::error;
  const cases::Format& format = rules.variant.format;
  return told && is_lack_told &&
         (rules.variant.operation != Operation::div || format.fraction_bits != format.word_bits);
}

bool is_claimable(const check::Rules& rules, Shape shape) {
  const cases::Format& format = rules.variant.format;
  if (rules.port != nullptr && !rules.port->is_general && !is_guarded(rules)) return false;
  if (!format.is_signed || (format.word_bits != 16 && format.word_bits != 32)) return false;
  if (shape == Shape::of_digits && format.word_bits != 32) return false;
  return !has_quotient(rules.variant.operation) || has_claimable_quotient(rules);
}

}  // namespace

std::optional<Claim> claim_of(const check::Rules& rules, Shape shape) {
  const cases::Format& format = rules.variant.format;
  const int bits = format.word_bits;
  const Operation operation = rules.variant.operation;
  if (!is_claimable(rules, shape)) return std::nullopt;
  std::string definitions = filled(signs, format);
  std::string rounded;
  std::string lacks = "false";
  std::string out_of_range = "false";
  if (operation == Operation::mul) {
    definitions += product_of(shape, format);
    rounded = rounded_product(rules.rounding, format);
  } else if (has_quotient(operation)) {
    definitions += quotient_of(shape, operation == Operation::mul_div, format);
    rounded = rounded_quotient(rules.rounding, format);
    lacks = fmt::format("(= {} (_ bv0 {}))", operation == Operation::div ? "b" : "c", bits);
    out_of_range = "faults";
  } else if ((operation == Operation::add || operation == Operation::sub) &&
             shape == Shape::of_signed) {
    rounded = fmt::format("({0} ((_ sign_extend {1}) a) ((_ sign_extend {1}) b))",
                          operation == Operation::add ? "bvadd" : "bvsub", bits);
  } else {
    return std::nullopt;
  }
  definitions += fmt::format(
      "(define-fun rounded () (_ BitVec {0}) {1})\n"
      "(define-fun cut () (_ BitVec {2}) ((_ extract {3} 0) rounded))\n"
      "(define-fun lacks () Bool {4})\n"
      "(define-fun fits () Bool (and (not {5}) (= rounded ((_ sign_extend {2}) cut))))\n",
      2 * bits, rounded, bits, bits - 1, lacks, out_of_range);
  const bool any_lack = rules.no_result == check::NoResult::any;
  const bool any_overflow = rules.overflow == check::Overflow::any;
  Claim claim{.definitions = definitions};
  const bool overflow_faults = any_overflow || rules.overflow == check::Overflow::error;
  claim.may_fault = overflow_faults ? "(or lacks (not fits))" : "lacks";
  const std::string other = overflowed(rules);
  claim.is_right =
      fmt::format("(ite lacks {} (ite fits (= {{0}} cut) {}))", any_lack ? "true" : "false",
                  any_overflow    ? std::string("true")
                  : other.empty() ? std::string("false")
                                  : fmt::format("(= {{0}} {})", other));
  return is_guarded(rules) ? guarded(claim, format) : claim;
}

}  // namespace fixproof::judge
