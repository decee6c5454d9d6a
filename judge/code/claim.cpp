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

/// A product of unsigned or signed words as an abstract function, of twice their width. A product
/// of 64-bit words has its halves from two functions. States that the operands commute, because a
/// routine may take them in the other order.
std::string abstract_product(bool is_signed, int width, const std::string& x, const std::string& y,
                             std::string& facts) {
  const auto apply = [&](const std::string& name) {
    facts += fmt::format("(assert (= ({0} {1} {2}) ({0} {2} {1})))\n", name, x, y);
    return fmt::format("({} {} {})", name, x, y);
  };
  const char* const sign = is_signed ? "s" : "u";
  if (width < 64) return apply(fmt::format("{}mul{}", sign, width));
  if (is_signed) {
    // Code may have the unsigned product, and correct it for each negative factor.
    const auto if_negative = [](const std::string& a, const std::string& b) {
      return fmt::format("(ite (bvslt {} (_ bv0 64)) {} (_ bv0 64))", a, b);
    };
    facts += fmt::format("(assert (= (smulh64 {0} {1}) (bvsub (bvsub {2} {3}) {4})))\n", x, y,
                         apply("umulh64"), if_negative(x, y), if_negative(y, x));
  }
  return fmt::format("(concat {} {})", apply(fmt::format("{}mulh64", sign)), apply("mullo64"));
}

/// The product of words of at most 16 bits, as IMUL of 32 bits computes it.
std::string extended_product(const cases::Format& format) {
  const int bits = format.word_bits;
  const char* const extend = format.is_signed ? "sign_extend" : "zero_extend";
  const auto extended = [&](const char* x) {
    return fmt::format("((_ {} {}) {})", extend, 32 - bits, x);
  };
  std::string text;
  const std::string whole = abstract_product(true, 32, extended("a"), extended("b"), text);
  text += fmt::format("(define-fun short () (_ BitVec {}) ((_ extract {} 0) {}))\n", 2 * bits,
                      2 * bits - 1, whole);
  text += fmt::format("(assert (= {} ((_ {} {}) short)))\n", whole, extend, 64 - 2 * bits);
  return text + fmt::format("(define-fun product () (_ BitVec {}) ((_ {} {}) short))\n",
                            product_bits(format), extend, product_bits(format) - 2 * bits);
}

std::string product_of_digits() {
  const auto digit = [](const char* word, const char* bits) {
    return fmt::format("((_ extract {}) (magnitude {}))", bits, word);
  };
  const auto part = [&](const char* x, const char* y, int shift) {
    return fmt::format("(bvshl (concat (_ bv0 32) (umul16 {} {})) (_ bv{} 64))", digit("a", x),
                       digit("b", y), shift);
  };
  constexpr const char* high = "31 16";
  constexpr const char* low = "15 0";
  return fmt::format("(bvadd {} {} {} {})", part(high, high, 32), part(low, high, 16),
                     part(high, low, 16), part(low, low, 0));
}

std::string product_of(Shape shape, const cases::Format& format) {
  const int bits = product_bits(format);
  std::string text;
  if (shape == Shape::of_extended || shape == Shape::of_signed) {
    if (shape == Shape::of_extended) {
      text = extended_product(format);
    } else {
      const std::string product = abstract_product(true, format.word_bits, "a", "b", text);
      text += fmt::format("(define-fun product () (_ BitVec {}) {})\n", bits, product);
    }
    // The sign, which abstract arithmetic does not know.
    if (format.is_signed) {
      text += fmt::format(
          "(assert (= (bvslt product (_ bv0 {0})) (and (opposite a b) (distinct a (_ bv0 {1})) "
          "(distinct b (_ bv0 {1})))))\n",
          bits, format.word_bits);
    }
    return text + fmt::format(
                      "(define-fun product-size () (_ BitVec {0}) (ite (bvslt product (_ bv0 {0})) "
                      "(bvneg product) product))\n",
                      bits);
  }
  const bool is_signed = format.is_signed;
  const std::string size =
      shape == Shape::of_digits
          ? product_of_digits()
          : abstract_product(false, format.word_bits, is_signed ? "(magnitude a)" : "a",
                             is_signed ? "(magnitude b)" : "b", text);
  return text + fmt::format(
                    "(define-fun product-size () (_ BitVec {0}) ((_ zero_extend {1}) {2}))\n"
                    "(define-fun product () (_ BitVec {0}) {3})\n",
                    bits, bits - 2 * format.word_bits, size,
                    is_signed ? "(signed (opposite a b) product-size)" : "product-size");
}

/// Returns `exact`, of `bits` bits, rounded and without its `excess` lowest bits.
std::string rounded(Rounding rounding, int bits, int excess) {
  const int f = excess;
  if (f == 0) return "exact";
  const auto number = [&](std::uint64_t value) { return fmt::format("(_ bv{} {})", value, bits); };
  const auto cut = [&](const std::string& x) {
    return fmt::format("((_ sign_extend {}) ((_ extract {} {}) {}))", f, bits - 1, f, x);
  };
  const auto with_sign = [&](const std::string& x) {
    return fmt::format("(ite (bvslt exact {0}) (bvneg {1}) {1})", number(0), x);
  };
  const std::uint64_t half = std::uint64_t{1} << (f - 1);
  const std::uint64_t below_one = 2 * half - 1;  // correct for 64, too
  const auto plus = [&](const char* x, std::uint64_t add) {
    return fmt::format("(bvadd {} {})", x, number(add));
  };
  switch (rounding) {
    case Rounding::floor:
      return cut("exact");
    case Rounding::half_up:
      return cut(plus("exact", half));
    case Rounding::half_away:
      return with_sign(cut(plus("exact-size", half)));
    case Rounding::truncate:
      return with_sign(cut("exact-size"));
    case Rounding::ceiling:
      return cut(plus("exact", below_one));
    case Rounding::half_even:
      break;
  }
  // Adds a half, less one unit if the floor is even, so that such a tie rounds down.
  const std::string odd =
      fmt::format("((_ zero_extend {0}) ((_ extract {1} {1}) exact))", bits - 1, f);
  return cut(fmt::format("(bvadd {} {})", plus("exact", half - 1), odd));
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
std::string overflowed(const check::Rules& rules, int bits) {
  const cases::Format& format = rules.variant.format;
  const auto word = [&](std::uint64_t value) {
    return fmt::format("(_ bv{} {})", value, format.word_bits);
  };
  const auto by_sign = [&](std::uint64_t low) {
    return fmt::format("(ite (bvslt rounded (_ bv0 {})) {} {})", bits, word(low),
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

bool is_sum_of_two(Operation operation) {
  return operation == Operation::add || operation == Operation::sub;
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
  if (!cases::is_of_type(format) || rules.variant.from) return false;
  if (has_quotient(rules.variant.operation)) {
    const bool has_instruction = format.word_bits == 16 || format.word_bits == 32;
    return format.is_signed && has_instruction && shape != Shape::of_extended &&
           (shape != Shape::of_digits || format.word_bits == 32) && has_claimable_quotient(rules);
  }
  if (is_sum_of_two(rules.variant.operation)) return shape == Shape::of_signed;
  return has_product(format, shape);
}

/// A rounded result.
struct RoundedText {
  int bits = 0;                        ///< signed
  std::string text{};                  ///< its value, if it does not lack
  std::string lacks = "false";         ///< a Boolean: whether there is none
  std::string out_of_range = "false";  ///< a Boolean: whether it is known to be no word
};

/// Defines `rounded`, `cut`, its word, `lacks`, `found` and `fits`, and states what the rules ask.
Claim claim_about(const std::string& exact, const RoundedText& of, const check::Rules& rules) {
  const int bits = rules.variant.format.word_bits;
  Claim claim{.definitions = exact};
  claim.definitions += fmt::format(
      "(define-fun rounded () (_ BitVec {0}) {1})\n"
      "(define-fun cut () (_ BitVec {2}) ((_ extract {3} 0) rounded))\n"
      "(define-fun lacks () Bool {4})\n"
      "(define-fun found () Bool true)\n"
      "(define-fun fits () Bool (and (not {5}) (= rounded ((_ {6} {7}) cut))))\n",
      of.bits, of.text, bits, bits - 1, of.lacks, of.out_of_range,
      rules.variant.format.is_signed ? "sign_extend" : "zero_extend", of.bits - bits);
  const bool any_lack = rules.no_result == check::NoResult::any;
  const bool any_overflow = rules.overflow == check::Overflow::any;
  const bool overflow_faults = any_overflow || rules.overflow == check::Overflow::error;
  claim.may_fault = overflow_faults ? "(or lacks (not fits))" : "lacks";
  const std::string other = overflowed(rules, of.bits);
  claim.is_right =
      fmt::format("(ite lacks {} (ite fits (= {{0}} cut) {}))", any_lack ? "true" : "false",
                  any_overflow    ? std::string("true")
                  : other.empty() ? std::string("false")
                                  : fmt::format("(= {{0}} {})", other));
  return claim;
}

}  // namespace

int product_bits(const cases::Format& format) {
  return 2 * format.word_bits + (format.is_signed ? 0 : 2);
}

bool has_product(const cases::Format& format, Shape shape) {
  switch (shape) {
    case Shape::of_signed:
      return format.is_signed && format.word_bits > 8;
    case Shape::of_magnitudes:
      return format.word_bits > 8;
    case Shape::of_digits:
      return format.is_signed && format.word_bits == 32;
    case Shape::of_extended:
      break;
  }
  return format.word_bits <= 16;
}

std::string define_product(const cases::Format& format, Shape shape) {
  // The square of the largest magnitude: abstract arithmetic does not know how large products are.
  const int bits = product_bits(format);
  const int word = format.word_bits;
  const std::string square =
      format.is_signed
          ? fmt::format("(bvshl (_ bv1 {0}) (_ bv{1} {0}))", bits, 2 * word - 2)
          : fmt::format(
                "(bvsub (bvshl (_ bv1 {0}) (_ bv{1} {0})) (bvsub (bvshl (_ bv1 {0}) (_ "
                "bv{2} {0})) (_ bv1 {0})))",
                bits, 2 * word, word + 1);
  return filled(signs, format) + product_of(shape, format) +
         fmt::format("(assert (bvule product-size {}))\n", square);
}

Exact exact_product(const cases::Format& format, Shape shape) {
  const int bits = product_bits(format);
  return {.definitions = define_product(format, shape) +
                         fmt::format("(define-fun exact () (_ BitVec {0}) product)\n"
                                     "(define-fun exact-size () (_ BitVec {0}) product-size)\n",
                                     bits),
          .bits = bits,
          .excess = format.fraction_bits};
}

Exact exact_sum(const cases::Format& format, const char* operation) {
  const int more = 2;
  const char* const extend = format.is_signed ? "sign_extend" : "zero_extend";
  return {.definitions = filled(signs, format) +
                         fmt::format("(define-fun exact () (_ BitVec {0}) ({1} ((_ {2} {3}) a) ((_ "
                                     "{2} {3}) b)))\n",
                                     format.word_bits + more, operation, extend, more),
          .bits = format.word_bits + more};
}

Claim rounded_claim(const Exact& exact, const check::Rules& rules) {
  return claim_about(
      exact.definitions,
      {.bits = exact.bits, .text = rounded(rules.rounding, exact.bits, exact.excess)}, rules);
}

std::optional<Claim> claim_of(const check::Rules& rules, Shape shape) {
  const cases::Format& format = rules.variant.format;
  const int bits = format.word_bits;
  const Operation operation = rules.variant.operation;
  if (!is_claimable(rules, shape)) return std::nullopt;
  Claim claim;
  if (operation == Operation::mul) {
    claim = rounded_claim(exact_product(format, shape), rules);
  } else if (has_quotient(operation)) {
    claim = claim_about(
        filled(signs, format) + quotient_of(shape, operation == Operation::mul_div, format),
        {.bits = 2 * bits,
         .text = rounded_quotient(rules.rounding, format),
         .lacks = fmt::format("(= {} (_ bv0 {}))", operation == Operation::div ? "b" : "c", bits),
         .out_of_range = "faults"},
        rules);
  } else if (is_sum_of_two(operation)) {
    claim =
        rounded_claim(exact_sum(format, operation == Operation::add ? "bvadd" : "bvsub"), rules);
  } else {
    return std::nullopt;
  }
  return is_guarded(rules) ? guarded(claim, format) : claim;
}

}  // namespace fixproof::judge
