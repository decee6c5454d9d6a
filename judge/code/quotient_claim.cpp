#include "judge/code/quotient_claim.hpp"

#include <fmt/format.h>

#include <array>
#include <set>
#include <string_view>

#include "judge/check/word.hpp"
#include "x86model/symbolic/smt.hpp"

namespace fixproof::judge {

namespace {

namespace sym = x86model::symbolic;
using oracle::Rounding;

/// What a rounding asks of an integer k: lower and upper bounds of twice the dividend, `n2`, with
/// the sign of the divisor. `x2` is 2k times the divisor, `d` is the divisor, both without sign,
/// and `even` tells whether k is even.
struct Bounds {
  std::string low;
  std::string high;
};

Bounds bounds_of(Rounding rounding) {
  const Bounds half_up{"(bvsge n2 (bvsub x2 d))", "(bvslt n2 (bvadd x2 d))"};
  const Bounds floor{"(bvsge n2 x2)", "(bvslt n2 (bvadd x2 (bvadd d d)))"};
  const Bounds ceiling{"(bvsgt n2 (bvsub x2 (bvadd d d)))", "(bvsle n2 x2)"};
  const auto by_sign = [](const Bounds& positive, const Bounds& negative) {
    return Bounds{fmt::format("(ite is-negative {} {})", negative.low, positive.low),
                  fmt::format("(ite is-negative {} {})", negative.high, positive.high)};
  };
  switch (rounding) {
    case Rounding::half_up:
      return half_up;
    case Rounding::floor:
      return floor;
    case Rounding::ceiling:
      return ceiling;
    case Rounding::truncate:
      return by_sign(floor, ceiling);
    case Rounding::half_away:
      return by_sign(half_up, {"(bvsgt n2 (bvsub x2 d))", "(bvsle n2 (bvadd x2 d))"});
    case Rounding::half_even:
      break;
  }
  return {"(or (bvsgt n2 (bvsub x2 d)) (and even (= n2 (bvsub x2 d))))",
          "(or (bvslt n2 (bvadd x2 d)) (and even (= n2 (bvadd x2 d))))"};
}

class Writer {
 public:
  Writer(const check::Rules& rules, const sym::Terms& terms,
         const std::optional<MachineDivide>& divide, bool halves, const DivideRules& more)
      : rules_(rules),
        more_(more),
        format_(rules.variant.format),
        terms_(terms),
        divide_(divide),
        halves_(halves),
        word_(format_.word_bits),
        wide_(std::max(2 * word_, 64) + 12) {}

  Claim claim() {
    define_operands();
    define_bounds();
    if (divide_) {
      define_divide();
      define_result();
    } else {
      add("(define-fun found () Bool false)");
      add("(define-fun k () {} {})", sort(), number(0));
    }
    add("(define-fun cut () (_ BitVec {0}) ((_ extract {1} 0) k))", word_, word_ - 1);
    const bool any_overflow = rules_.overflow == check::Overflow::any;
    const bool may_overflow = any_overflow || rules_.overflow == check::Overflow::error;
    Claim claim;
    claim.definitions = text_;
    if (divide_) {
      claim.mentions = {divide_->dividend, divide_->divisor, divide_->quotient, divide_->remainder};
    }
    claim.cases = signs();
    claim.may_fault = fmt::format(
        "(ite lacks {} (or faults (and (not fits) {})))",
        rules_.no_result == check::NoResult::any || rules_.no_result == check::NoResult::error
            ? "true"
            : "false",
        may_overflow ? "true" : "false");
    claim.is_right =
        fmt::format("(ite lacks {} (and (not faults) (ite fits (and found (= {{0}} cut)) {})))",
                    without_quotient(), out_of_range());
    return claim;
  }

 private:
  template <class... Values>
  void add(const char* line, Values... values) {
    text_ += fmt::format(fmt::runtime(line), values...) + '\n';
  }
  [[nodiscard]] std::string sort() const { return fmt::format("(_ BitVec {})", wide_); }
  [[nodiscard]] std::string number(std::int64_t value) const {
    return value < 0 ? fmt::format("(bvneg (_ bv{} {}))", -value, wide_)
                     : fmt::format("(_ bv{} {})", value, wide_);
  }
  [[nodiscard]] std::string widened(const std::string& text, int bits, bool is_signed) const {
    return fmt::format("((_ {} {}) {})", is_signed ? "sign_extend" : "zero_extend", wide_ - bits,
                       text);
  }

  void define_operands() {
    add("(define-fun size ((x {0})) {0} (ite (bvslt x {1}) (bvneg x) x))", sort(), number(0));
    const std::string divisor = widened("b", word_, format_.is_signed);
    const std::string whole =
        fmt::format("(bvlshr (size {}) {})", divisor, number(format_.fraction_bits));
    add("(define-fun exact-divisor () {} {})", sort(),
        more_.divides_by_whole_part
            ? fmt::format("(ite (bvslt {0} {1}) (bvneg {2}) {2})", divisor, number(0), whole)
            : divisor);
    add("(define-fun lacks () Bool (= exact-divisor {}))", number(0));
    add("(define-fun d () {} (size exact-divisor))", sort());
    add("(define-fun doubled () {} (bvshl {} {}))", sort(), widened("a", word_, format_.is_signed),
        number(more_.divides_by_whole_part ? 1 : format_.fraction_bits + 1));
    // The truncated magnitude of the quotient is at least 2^word_bits.
    add("(define-fun faults () Bool {})",
        more_.faults_beyond_bits
            ? fmt::format("(bvsge (size doubled) (bvshl d {}))", number(word_ + 1))
            : "false");
    add("(define-fun n2 () {} (ite (bvslt exact-divisor {}) (bvneg doubled) doubled))", sort(),
        number(0));
    add("(define-fun is-negative () Bool (bvslt n2 {}))", number(0));
  }

  /// Defines whether the rounded result is a word.
  void define_bounds() {
    const Bounds bounds = bounds_of(rules_.rounding);
    add("(define-fun low-side ((x2 {}) (even Bool)) Bool {})", sort(), bounds.low);
    add("(define-fun high-side ((x2 {}) (even Bool)) Bool {})", sort(), bounds.high);
    const std::string lowest =
        format_.is_signed ? fmt::format("(bvneg (bvshl d {}))", number(word_)) : number(0);
    const std::string highest = fmt::format("(bvsub (bvshl d {}) (bvadd d d))",
                                            number(format_.is_signed ? word_ : word_ + 1));
    // The lowest word is even, the highest odd.
    add("(define-fun fits () Bool (and (low-side {} true) (high-side {} false)))", lowest, highest);
  }

  [[nodiscard]] std::string wide(sym::Term term) const {
    return widened(sym::name_in_smt(terms_, term), terms_.width(term), divide_->is_signed);
  }

  void define_divide() {
    add("(define-fun md () {} {})", sort(), wide(divide_->divisor));
    add("(define-fun mn () {} {})", sort(), wide(divide_->dividend));
    add("(define-fun q () {} {})", sort(), wide(divide_->quotient));
    add("(define-fun r () {} {})", sort(), wide(divide_->remainder));
    add("(assert (=> (distinct md {0}) (and (bvslt (size r) (size md)) "
        "(or (= r {0}) (= (bvslt r {0}) (bvslt mn {0}))) (bvsle (size r) (size mn)) "
        "(bvsle (size q) (size mn)) "
        "(= (= q {0}) (bvslt (size mn) (size md))) (or (= q {0}) (= (bvslt q {0}) (xor (bvslt mn "
        "{0}) (bvslt md {0})))))))",
        number(0));
    // q times the divisor without sign
    add("(define-fun qd () {} (ite (bvslt md {}) (bvneg (bvsub mn r)) (bvsub mn r)))", sort(),
        number(0));
    relate_to_limits();
  }

  /// Asserts that q is at least, or at most, a limit t of the format if and only if q d is at
  /// least, or at most, t d. Code that saturates compares one, and the claim the other.
  void relate_to_limits() {
    const int bits = format_.word_bits - (format_.is_signed ? 1 : 0) + (halves_ ? 1 : 0);
    const std::string limit = fmt::format("(bvshl {} {})", number(1), number(bits));
    const std::string limit_d = fmt::format("(bvshl (size md) {})", number(bits));
    for (const bool negative : {false, true}) {
      if (negative && !format_.is_signed) continue;
      for (const auto& [t, td] :
           {std::pair(number(0), number(0)), std::pair(number(1), std::string("(size md)")),
            std::pair(number(-1), std::string("(bvneg (size md))"))}) {
        const std::string at = negative ? fmt::format("(bvneg {})", limit) : limit;
        const std::string at_d = negative ? fmt::format("(bvneg {})", limit_d) : limit_d;
        for (const char* const compare : {"bvsge", "bvsle"}) {
          add("(assert (=> (distinct md {0}) (= ({1} q (bvadd {2} {3})) ({1} qd (bvadd {4} "
              "{5})))))",
              number(0), compare, at, t, at_d, td);
        }
      }
    }
  }

  /// Defines k, the integer near q or q / 2 that the rounding asks for, and whether there is one.
  void define_result() {
    // The machine may divide magnitudes, so that its quotient has another sign than the exact one.
    add("(define-fun same-divisor () Bool (or (= md exact-divisor) (= md (bvneg exact-divisor))))");
    add("(define-fun turned () Bool (distinct is-negative (xor (bvslt mn {0}) (bvslt md {0}))))",
        number(0));
    add("(define-fun turn ((x {0})) {0} (ite turned (bvneg x) x))", sort());
    const std::string one = number(1);
    add("(define-fun base () {} {})", sort(),
        halves_ ? fmt::format("((_ sign_extend 1) ((_ extract {} 1) q))", wide_ - 1) : "q");
    // 2k d is 2 (q d) + 2i d, or where q is near 2k it is q d + (2i - odd) d.
    add("(define-fun double () {} {})", sort(),
        halves_ ? "(bvsub qd (ite (= (bvand q " + one + ") " + one + ") d " + number(0) + "))"
                : "(bvadd qd qd)");
    std::string chosen = number(0);
    std::string any;
    for (int i = 0; i < 4; ++i) {
      const std::string more = i == 0   ? "(bvneg (bvadd d d))"
                               : i == 1 ? number(0)
                               : i == 2 ? "(bvadd d d)"
                                        : "(bvshl d " + number(2) + ")";
      add("(define-fun k{0} () {1} (bvadd (turn base) {2}))", i, sort(), number(i - 1));
      add("(define-fun x{0} () {1} (bvadd (turn double) {2}))", i, sort(), more);
      add("(define-fun even{0} () Bool (= ((_ extract 0 0) k{0}) #b0))", i);
      add("(define-fun ok{0} () Bool (and (low-side x{0} even{0}) (high-side x{0} even{0})))", i);
      chosen = fmt::format("(ite ok{0} k{0} {1})", i, chosen);
      any += fmt::format(" ok{}", i);
    }
    add("(define-fun found () Bool (and same-divisor (or {})))", any);
    add("(define-fun k () {} {})", sort(), chosen);
  }

  [[nodiscard]] std::vector<std::string> signs() const {
    if (!format_.is_signed) return {"true"};
    std::vector<std::string> all;
    for (const char* const of_a : {"bvslt", "bvsge"}) {
      for (const char* const of_b : {"bvslt", "bvsge"}) {
        all.push_back(
            fmt::format("(and ({0} a (_ bv0 {2})) ({1} b (_ bv0 {2})))", of_a, of_b, word_));
      }
    }
    return all;
  }

  [[nodiscard]] std::string is_word(std::uint64_t word) const {
    return fmt::format("(= {{0}} (_ bv{} {}))", word, word_);
  }
  [[nodiscard]] std::string by_sign(std::uint64_t low) const {
    return fmt::format("(ite is-negative {} {})", is_word(low), is_word(cases::highest(format_)));
  }

  [[nodiscard]] std::string out_of_range() const {
    switch (rules_.overflow) {
      case check::Overflow::any:
        return "true";
      case check::Overflow::wrap:
        return "(and found (= {0} cut))";
      case check::Overflow::saturate:
        return by_sign(cases::lowest(format_));
      case check::Overflow::symmetric:
        return by_sign(check::minus_highest(format_));
      case check::Overflow::maximum:
        return is_word(cases::highest(format_));
      case check::Overflow::minimum:
        return is_word(cases::lowest(format_));
      case check::Overflow::word:
        return is_word(rules_.overflow_word);
      case check::Overflow::error:
        break;
    }
    return "false";
  }

  /// The results for a zero divisor. Rules that depend on the sign also accept 0 for 0 / 0.
  [[nodiscard]] std::string without_quotient() const {
    const auto by_dividend = [&](std::uint64_t low) {
      const std::string zero = is_word(0);
      const std::string high = is_word(cases::highest(format_));
      return fmt::format("(ite (= doubled {0}) {1} (ite (bvslt doubled {0}) {3} {2}))", number(0),
                         more_.has_zero_by_zero ? zero : fmt::format("(or {} {})", zero, high),
                         high, is_word(low));
    };
    switch (rules_.no_result) {
      case check::NoResult::any:
        return "true";
      case check::NoResult::saturate:
        return by_dividend(cases::lowest(format_));
      case check::NoResult::symmetric:
        return by_dividend(check::minus_highest(format_));
      case check::NoResult::maximum:
        return is_word(cases::highest(format_));
      case check::NoResult::minimum:
        return is_word(cases::lowest(format_));
      case check::NoResult::zero:
        return is_word(0);
      case check::NoResult::word:
        return is_word(rules_.no_result_word);
      default:
        return "false";
    }
  }

  const check::Rules& rules_;
  const DivideRules& more_;
  cases::Format format_;
  const sym::Terms& terms_;
  const std::optional<MachineDivide>& divide_;
  bool halves_;
  int word_;
  int wide_;  ///< bits that hold every sum and double
  std::string text_;
};

}  // namespace

std::optional<MachineDivide> divide_in(sym::Terms& terms, std::span<const sym::Term> roots) {
  // The names of quotients and remainders, without the width of the divisor.
  struct Names {
    std::string_view quotient, remainder;
    bool is_signed;
  };
  constexpr std::array<Names, 4> all{{{"squot", "srest", true},
                                      {"uquot", "urest", false},
                                      {"sdiv", "srem", true},
                                      {"udiv", "urem", false}}};
  std::set<std::vector<sym::Term>> operands;
  Names names{};
  for (const sym::Term each : sym::reached_from(terms, roots)) {
    const sym::Node node = terms[each];
    if (node.op != sym::Op::apply || node.arguments.size() != 2) continue;
    for (const Names& of : all) {
      if (!node.name.starts_with(of.quotient) && !node.name.starts_with(of.remainder)) continue;
      operands.insert(node.arguments);
      names = of;
    }
  }
  if (operands.size() != 1) return std::nullopt;
  const std::vector<sym::Term> both = *operands.begin();
  const int bits = terms.width(both[1]);
  const auto apply = [&](std::string_view name) {
    return terms.apply(sym::numbered(std::string(name), static_cast<std::uint64_t>(bits)), both,
                       bits);
  };
  return MachineDivide{.dividend = both[0],
                       .divisor = both[1],
                       .quotient = apply(names.quotient),
                       .remainder = apply(names.remainder),
                       .is_signed = names.is_signed};
}

std::optional<Claim> quotient_claim(const check::Rules& rules, const sym::Terms& terms,
                                    const std::optional<MachineDivide>& divide, bool halves,
                                    const DivideRules& more) {
  const cases::Format& format = rules.variant.format;
  if (rules.variant.operation != cases::Operation::div || rules.variant.from || rules.port ||
      format.word_bits > 32 || format.is_decimal || format.fraction_bits < 0) {
    return std::nullopt;
  }
  return Writer(rules, terms, divide, halves, more).claim();
}

}  // namespace fixproof::judge
