#include "x86model/symbolic/domain.hpp"

namespace x86model::symbolic {

bool FlagTerms::are_defined(std::uint16_t flags) const {
  return (flags & (PF | AF)) == 0 && ((flags & CF) == 0 || carry) && ((flags & ZF) == 0 || zero) &&
         ((flags & SF) == 0 || sign) && ((flags & OF) == 0 || overflow);
}

Term FlagTerms::get(Flag flag) const {
  return (flag == CF ? carry : flag == ZF ? zero : flag == SF ? sign : overflow).value();
}

FlagTerms FlagTerms::keeping(std::uint16_t keep, const FlagTerms& before) const {
  FlagTerms all = *this;
  if ((keep & CF) != 0) all.carry = before.carry;
  if ((keep & ZF) != 0) all.zero = before.zero;
  if ((keep & SF) != 0) all.sign = before.sign;
  if ((keep & OF) != 0) all.overflow = before.overflow;
  return all;
}

FlagTerms Domain::flags(Term carry, Term /*parity*/, Term /*half_carry*/, Term zero, Term sign,
                        Term overflow, std::uint16_t undefined) const {
  return FlagTerms{carry, zero, sign, overflow}.keeping(undefined, {});
}

Term join(Terms& t, Term high, Term low) {
  const Domain d = t;
  const Node lower = t[low];
  const Node upper = t[high];
  const Term none = t.truth(false);
  const int bits = lower.width;
  const auto zero = t.constant(0, bits);
  const auto number = [&](Term truth) { return t.ite(truth, t.constant(1, bits), zero); };
  // The upper word is u plus a carry, or a - u less a borrow, of the lower word.
  if (lower.op == Op::add && upper.op == Op::add) {
    const Term a = lower.arguments[0];
    const Term b = lower.arguments[1];
    const Term carry = number(d.carry_of(a, b, none, bits));
    const Node sum = t[upper.arguments[0]];
    if (upper.arguments[1] == carry && sum.op == Op::add) {
      return t.add(join(t, sum.arguments[0], a), join(t, sum.arguments[1], b));
    }
  }
  if (lower.op == Op::sub && upper.op == Op::sub && lower.arguments[0] == zero) {
    const Term l = lower.arguments[1];
    const Term borrow = number(d.borrow_of(zero, l, none, bits));
    const Node rest = t[upper.arguments[0]];
    if (upper.arguments[1] == borrow && rest.op == Op::sub && rest.arguments[0] == zero) {
      return t.sub(t.constant(0, 2 * bits), join(t, rest.arguments[1], l));
    }
  }
  return t.concat(high, low);
}

}  // namespace x86model::symbolic
