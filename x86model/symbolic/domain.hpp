/// @file
/// Terms as the domain of x86model/alu.hpp: with them its instructions speak of all numbers at
/// once. Products and quotients are applications of abstract functions, whose names end in the
/// width of the operands: umulN and smulN; udivN and uremN; sdivN, sremN and sfaultN.
#pragma once

#include <cstdint>
#include <optional>

#include "x86model/flags.hpp"
#include "x86model/symbolic/term.hpp"

namespace x86model::symbolic {

/// The flags that routines read, as truth values: not PF and AF. Empty if Intel leaves a flag
/// undefined.
struct FlagTerms {
  std::optional<Term> carry, zero, sign, overflow;

  [[nodiscard]] bool are_defined(std::uint16_t flags) const;
  /// A defined flag.
  [[nodiscard]] Term get(Flag flag) const;
  /// These flags, with those in `keep` replaced by the ones of `before`.
  [[nodiscard]] FlagTerms keeping(std::uint16_t keep, const FlagTerms& before) const;
  void set(const FlagTerms& flags) { *this = flags; }
};

/// What x86model::Words computes with numbers. The width of a term is that of its value, so most
/// functions ignore the widths that Words needs.
class Domain {
 public:
  using Value = Term;
  using Wide = Term;
  using Truth = Term;
  using Flags = FlagTerms;
  /// The bits of the widest value. A carry out of it has no place in a sum.
  static constexpr int widest = 64;

  // NOLINTNEXTLINE(*-explicit-*): where there are terms, there is their domain
  Domain(Terms& terms) : t_(&terms) {}

  [[nodiscard]] Term truth(bool value) const { return t_->truth(value); }
  [[nodiscard]] Term constant(std::uint64_t value, int bits) const {
    return t_->constant(value, bits);
  }

  [[nodiscard]] Term sum(Term a, Term b, Term carry, int bits) const {
    return t_->add(t_->add(a, b), number(carry, bits));
  }
  [[nodiscard]] Term difference(Term a, Term b, Term borrow, int bits) const {
    return t_->sub(t_->sub(a, b), number(borrow, bits));
  }
  [[nodiscard]] Term carry_of(Term a, Term b, Term carry, int bits) const {
    if (bits == widest) {
      const Term total = sum(a, b, carry, bits);
      return either(below(total, a), t_->both(carry, equal(total, a)));
    }
    return bit(sum(widened(a), widened(b), carry, bits + 1), bits);
  }
  [[nodiscard]] Term borrow_of(Term a, Term b, Term borrow, int bits) const {
    if (bits == widest) return either(below(a, b), t_->both(borrow, equal(a, b)));
    return bit(difference(widened(a), widened(b), borrow, bits + 1), bits);
  }
  [[nodiscard]] Term bit_and(Term a, Term b) const { return t_->bit_and(a, b); }
  [[nodiscard]] Term bit_xor(Term a, Term b) const { return t_->bit_xor(a, b); }

  [[nodiscard]] Term extract(Term a, int low, int width) const {
    return t_->extract(a, low, width);
  }
  [[nodiscard]] Term concat(Term high, Term low, int /*low_bits*/) const {
    return t_->concat(high, low);
  }
  [[nodiscard]] Term join(Term high, Term low, int /*low_bits*/) const {
    return t_->concat(high, low);
  }
  [[nodiscard]] Term sign_extend(Term a, int /*bits*/, int wanted) const {
    return t_->sign_extend(a, wanted);
  }
  [[nodiscard]] Term zero_extend(Term a, int /*bits*/, int wanted) const {
    return t_->zero_extend(a, wanted);
  }
  [[nodiscard]] Term unsigned_product(Term a, Term b, int bits) const {
    return apply("umul", a, b, bits, 2 * bits);
  }
  [[nodiscard]] Term signed_product(Term a, Term b, int bits) const {
    return apply("smul", a, b, bits, 2 * bits);
  }
  [[nodiscard]] Term unsigned_quotient(Term n, Term d, int bits) const {
    return apply("udiv", n, d, bits, bits);
  }
  [[nodiscard]] Term unsigned_remainder(Term n, Term d, int bits) const {
    return apply("urem", n, d, bits, bits);
  }
  [[nodiscard]] Term signed_quotient(Term n, Term d, int bits) const {
    return apply("sdiv", n, d, bits, bits);
  }
  [[nodiscard]] Term signed_remainder(Term n, Term d, int bits) const {
    return apply("srem", n, d, bits, bits);
  }
  [[nodiscard]] Term signed_quotient_overflows(Term n, Term d, int bits) const {
    return apply("sfault", n, d, bits, 0);
  }

  [[nodiscard]] Term bit(Term a, int position) const { return t_->bit(a, position); }
  [[nodiscard]] Term equal(Term a, Term b) const { return t_->equal(a, b); }
  [[nodiscard]] Term below(Term a, Term b) const { return t_->below(a, b); }
  [[nodiscard]] Term negation(Term a) const { return t_->negation(a); }
  [[nodiscard]] Term either(Term a, Term b) const { return t_->either(a, b); }
  [[nodiscard]] Term differ(Term a, Term b) const {
    return either(t_->both(a, negation(b)), t_->both(negation(a), b));
  }

  [[nodiscard]] FlagTerms flags(Term carry, Term parity, Term half_carry, Term zero, Term sign,
                                Term overflow, std::uint16_t undefined) const;
  [[nodiscard]] FlagTerms undefined_flags() const { return {}; }
  // flags() ignores these two.
  [[nodiscard]] Term has_even_parity(Term /*a*/) const { return truth(false); }
  [[nodiscard]] Term half_carry(Term /*a*/, Term /*b*/, Term /*result*/) const {
    return truth(false);
  }

 private:
  [[nodiscard]] Term widened(Term a) const { return t_->zero_extend(a, t_->width(a) + 1); }
  /// A truth value as 0 or 1.
  [[nodiscard]] Term number(Term truth, int width) const {
    return t_->ite(truth, constant(1, width), constant(0, width));
  }
  [[nodiscard]] Term apply(const char* function, Term a, Term b, int bits, int width) const {
    return t_->apply(numbered(function, static_cast<std::uint64_t>(bits)), {a, b}, width);
  }

  Terms* t_;
};

/// high:low as one term. If the words come from ADD and ADC, or from NEG, NEG and SBB, it is the
/// sum or the negation of the joined operands.
Term join(Terms& terms, Term high, Term low);

}  // namespace x86model::symbolic
