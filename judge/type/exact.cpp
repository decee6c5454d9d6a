#include "judge/type/exact.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "x86model/symbolic/smt.hpp"

namespace fixproof::judge {

namespace {

/// A word, or any other number, with more bits.
std::string extended(const char* x, int from, int to, bool is_signed) {
  return fmt::format("((_ {} {}) {})", is_signed ? "sign_extend" : "zero_extend", to - from, x);
}

std::string number(std::uint64_t value, int bits) {
  return fmt::format("(_ bv{} {})", value, bits);
}

Exact exact(const std::string& value, int bits, int excess = 0, std::string definitions = {}) {
  definitions += fmt::format(
      "(define-fun exact () (_ BitVec {0}) {1})\n(define-fun exact-size () (_ BitVec {0}) (ite "
      "(bvslt exact (_ bv0 {0})) (bvneg exact) exact))\n",
      bits, value);
  return {.definitions = std::move(definitions), .bits = bits, .excess = excess};
}

}  // namespace

Exact exact_negative(const cases::Format& format) {
  const int bits = format.word_bits + 2;
  return exact(fmt::format("(bvneg {})", extended("a", format.word_bits, bits, format.is_signed)),
               bits);
}

Exact exact_magnitude(const cases::Format& format) {
  const int bits = format.word_bits + 2;
  const std::string a = extended("a", format.word_bits, bits, format.is_signed);
  return exact(fmt::format("(ite (bvslt {0} {1}) (bvneg {0}) {0})", a, number(0, bits)), bits);
}

Exact exact_shift(const cases::Format& format, bool is_right) {
  const int word = format.word_bits;
  const int bits = std::max(2 * word + 2, 40);
  const std::string zero = number(0, bits);
  // As many places as the word has bits shift everything out, or out of every range.
  std::string text = fmt::format(
      "(define-fun value () (_ BitVec {0}) {1})\n(define-fun given () (_ BitVec {0}) {2})\n"
      "(define-fun places () (_ BitVec {0}) {3})\n"
      "(define-fun limited ((x (_ BitVec {0}))) (_ BitVec {0}) (ite (bvsgt x {4}) {4} x))\n"
      "(define-fun down () (_ BitVec {0}) (limited (bvneg places)))\n",
      bits, extended("a", word, bits, format.is_signed), extended("b", 32, bits, true),
      is_right ? "(bvneg given)" : "given", number(static_cast<std::uint64_t>(word), bits));
  return exact(fmt::format("(ite (bvslt places {0}) (ite (bvslt value {0}) (bvnot (bvlshr (bvnot "
                           "value) down)) (bvlshr value down)) (bvshl value (limited places)))",
                           zero),
               bits, 0, std::move(text));
}

Exact exact_conversion(const cases::Format& from, const cases::Format& to) {
  const int up = std::max(to.fraction_bits - from.fraction_bits, 0);
  const int excess = std::max(from.fraction_bits - to.fraction_bits, 0);
  const int bits = std::max(from.word_bits + up, to.word_bits + excess) + 3;
  const std::string a = extended("a", from.word_bits, bits, from.is_signed);
  return exact(fmt::format("(bvshl {} {})", a, number(static_cast<std::uint64_t>(up), bits)), bits,
               excess);
}

Exact exact_mul_add(const cases::Format& format, Shape shape) {
  const int bits = product_bits(format) + 2;
  return exact(fmt::format("(bvadd ((_ sign_extend 2) product) (bvshl {} {}))",
                           extended("c", format.word_bits, bits, format.is_signed),
                           number(static_cast<std::uint64_t>(format.fraction_bits), bits)),
               bits, format.fraction_bits, define_product(format, shape));
}

Exact exact_remainder(const cases::Format& format, const x86model::symbolic::Terms& terms,
                      const std::optional<MachineDivide>& divide) {
  constexpr int bits = 70;  // more than a register, and a sign
  const int word = format.word_bits;
  if (!divide)
    return exact(number(0, bits), bits, 0, "(define-fun is-of-operands () Bool false)\n");
  const auto wide = [&](x86model::symbolic::Term term) {
    return extended(x86model::symbolic::name_in_smt(terms, term).c_str(), terms.width(term), bits,
                    divide->is_signed);
  };
  return exact(fmt::format("(ite (= b {}) {} {})", number(0, word), number(0, bits),
                           wide(divide->remainder)),
               bits, 0,
               fmt::format("(define-fun is-of-operands () Bool (and (= {} {}) (= {} {})))\n",
                           wide(divide->dividend), extended("a", word, bits, format.is_signed),
                           wide(divide->divisor), extended("b", word, bits, format.is_signed)));
}

}  // namespace fixproof::judge
