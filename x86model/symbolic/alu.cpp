#include "x86model/symbolic/alu.hpp"

#include <string>

namespace x86model::symbolic {

namespace {

Term sign(Terms& t, Term a) { return t.bit(a, t.width(a) - 1); }

Term is_zero(Terms& t, Term a) { return t.equal(a, t.constant(0, t.width(a))); }

Term differ(Terms& t, Term a, Term b) {
  return t.either(t.both(a, t.negation(b)), t.both(t.negation(a), b));
}

Result with_result_flags(Terms& t, Term value, FlagTerm carry, FlagTerm overflow) {
  return {value, {carry, is_zero(t, value), sign(t, value), overflow}};
}

/// A truth value as 0 or 1, `width` bits wide.
Term number(Terms& t, Term truth, int width) {
  return t.ite(truth, t.constant(1, width), t.constant(0, width));
}

Term carry_of(Terms& t, Term a, Term b, Term carry) {
  const int bits = t.width(a);
  const Term wide = t.add(t.zero_extend(a, bits + 1), t.zero_extend(b, bits + 1));
  return t.bit(t.add(wide, number(t, carry, bits + 1)), bits);
}

Term borrow_of(Terms& t, Term a, Term b, Term borrow) {
  const int bits = t.width(a);
  const Term wide = t.sub(t.zero_extend(a, bits + 1), t.zero_extend(b, bits + 1));
  return t.bit(t.sub(wide, number(t, borrow, bits + 1)), bits);
}

/// `a` with zeros appended below or above; the number of zeros may be 0.
Term with_zeros_below(Terms& t, Term a, int zeros) {
  return zeros == 0 ? a : t.concat(a, t.constant(0, zeros));
}

FlagTerm only_if(bool defined, Term flag) { return defined ? FlagTerm(flag) : std::nullopt; }

std::string sized(const char* name, int width) {
  return numbered(name, static_cast<std::uint64_t>(width));
}

}  // namespace

Result add(Terms& t, Term a, Term b, Term carry) {
  const Term value = t.add(t.add(a, b), number(t, carry, t.width(a)));
  const Term overflow = sign(t, t.bit_and(t.bit_xor(a, value), t.bit_xor(b, value)));
  return with_result_flags(t, value, carry_of(t, a, b, carry), overflow);
}

Result sub(Terms& t, Term a, Term b, Term borrow) {
  const Term value = t.sub(t.sub(a, b), number(t, borrow, t.width(a)));
  const Term overflow = sign(t, t.bit_and(t.bit_xor(a, b), t.bit_xor(a, value)));
  return with_result_flags(t, value, borrow_of(t, a, b, borrow), overflow);
}

Term join(Terms& t, Term high, Term low) {
  const Node lower = t[low];
  const Node upper = t[high];
  const Term none = t.truth(false);
  const int bits = lower.width;
  const auto zero = t.constant(0, bits);
  // The upper word is u plus a carry, or a - u less a borrow, of the lower word.
  if (lower.op == Op::add && upper.op == Op::add) {
    const Term a = lower.arguments[0];
    const Term b = lower.arguments[1];
    const Term carry = number(t, carry_of(t, a, b, none), bits);
    const Node sum = t[upper.arguments[0]];
    if (upper.arguments[1] == carry && sum.op == Op::add) {
      return t.add(join(t, sum.arguments[0], a), join(t, sum.arguments[1], b));
    }
  }
  if (lower.op == Op::sub && upper.op == Op::sub && lower.arguments[0] == zero) {
    const Term l = lower.arguments[1];
    const Term borrow = number(t, borrow_of(t, zero, l, none), bits);
    const Node rest = t[upper.arguments[0]];
    if (upper.arguments[1] == borrow && rest.op == Op::sub && rest.arguments[0] == zero) {
      return t.sub(t.constant(0, 2 * bits), join(t, rest.arguments[1], l));
    }
  }
  return t.concat(high, low);
}

Result logic(Terms& t, Term value) {
  return with_result_flags(t, value, t.truth(false), t.truth(false));
}

Result shift(Terms& t, Mnemonic op, Term a, int count) {
  const int bits = t.width(a);
  const bool by_one = count == 1;
  if (op == Mnemonic::rol) {
    const int turn = count % bits;
    const Term value =
        turn == 0 ? a : t.concat(t.extract(a, 0, bits - turn), t.extract(a, bits - turn, turn));
    const Term carry = t.bit(value, 0);
    return {value,
            {carry, std::nullopt, std::nullopt, only_if(by_one, differ(t, sign(t, value), carry))}};
  }
  if (op == Mnemonic::sar) {
    const Term wide = t.sign_extend(a, 64);
    const Term value = t.extract(wide, count, bits);
    return with_result_flags(t, value, t.bit(wide, count - 1), only_if(by_one, t.truth(false)));
  }
  // From here on, a count of at least the width gives 0 and an undefined CF.
  if (count >= bits) {
    return with_result_flags(t, t.constant(0, bits), std::nullopt, std::nullopt);
  }
  if (op == Mnemonic::shl) {
    const Term value = with_zeros_below(t, t.extract(a, 0, bits - count), count);
    const Term carry = t.bit(a, bits - count);
    return with_result_flags(t, value, carry, only_if(by_one, differ(t, sign(t, value), carry)));
  }
  const Term value = t.zero_extend(t.extract(a, count, bits - count), bits);
  return with_result_flags(t, value, t.bit(a, count - 1), only_if(by_one, sign(t, a)));
}

Result double_shift(Terms& t, Mnemonic op, Term a, Term fill, int count) {
  const int bits = t.width(a);
  const int rest = bits - count;
  const bool left = op == Mnemonic::shld;
  const Term value = left ? t.concat(t.extract(a, 0, rest), t.extract(fill, rest, count))
                          : t.concat(t.extract(fill, 0, count), t.extract(a, count, rest));
  const Term carry = t.bit(a, left ? rest : count - 1);
  const Term overflow = differ(t, sign(t, a), sign(t, value));
  return with_result_flags(t, value, carry, only_if(count == 1, overflow));
}

Result multiply(Terms& t, Mnemonic op, Term a, Term b) {
  const int bits = t.width(a);
  const bool is_signed = op == Mnemonic::imul;
  const Term product = t.apply(sized(is_signed ? "smul" : "umul", bits), {a, b}, 2 * bits);
  const Term low = t.extract(product, 0, bits);
  const Term low_extended = is_signed ? t.sign_extend(low, 2 * bits) : t.zero_extend(low, 2 * bits);
  const Term high_matters = t.negation(t.equal(product, low_extended));
  return {product, {high_matters, std::nullopt, std::nullopt, high_matters}};
}

Division divide(Terms& t, Mnemonic op, Term dividend, Term divisor) {
  const int bits = t.width(divisor);
  if (op == Mnemonic::idiv) {
    return {t.apply(sized("sdiv", bits), {dividend, divisor}, bits),
            t.apply(sized("srem", bits), {dividend, divisor}, bits),
            t.apply(sized("sfault", bits), {dividend, divisor}, 0)};
  }
  return {t.apply(sized("udiv", bits), {dividend, divisor}, bits),
          t.apply(sized("urem", bits), {dividend, divisor}, bits),
          t.negation(t.below(t.extract(dividend, bits, bits), divisor))};
}

std::optional<Term> taken(Terms& t, Mnemonic op, const FlagTerms& f) {
  const auto all_defined = [](auto... flags) { return (flags.has_value() && ...); };
  switch (op) {
    case Mnemonic::js:
      return f.sign;
    case Mnemonic::jns:
      return f.sign ? std::optional(t.negation(*f.sign)) : std::nullopt;
    case Mnemonic::jz:
      return f.zero;
    case Mnemonic::jnz:
      return f.zero ? std::optional(t.negation(*f.zero)) : std::nullopt;
    case Mnemonic::ja:
      if (!all_defined(f.carry, f.zero)) return std::nullopt;
      return t.both(t.negation(*f.carry), t.negation(*f.zero));
    case Mnemonic::jg: {
      if (!all_defined(f.zero, f.sign, f.overflow)) return std::nullopt;
      const Term same = t.either(t.both(*f.sign, *f.overflow),
                                 t.both(t.negation(*f.sign), t.negation(*f.overflow)));
      return t.both(t.negation(*f.zero), same);
    }
    default:
      return t.truth(true);
  }
}

}  // namespace x86model::symbolic
