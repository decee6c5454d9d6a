// Shifts and rotates by a count that depends on operands: in steps of 1, 2, 4 and so on, each taken
// if its bit of the count is set. A bit that is known leaves no trace in the terms.
#include <algorithm>

#include "judge/code/user_instructions.hpp"

namespace fixproof::judge {

namespace {

namespace alu = x86model::alu;
using x86model::CF;
using x86model::OF;
using ShiftTerm = x86model::symbolic::Term;
using x86model::symbolic::FlagTerms;
using x86model::symbolic::Terms;

/// What a step shifts. The last step that is taken decides the carry.
struct Shifted {
  ShiftTerm value;
  ShiftTerm carry;
  ShiftTerm fill;  ///< what moves in: the second operand of SHLD and SHRD, or 0
};

/// Shifts by a number that is not 0.
using ShiftStep = Shifted (*)(Terms& t, const Shifted& from, int by);

/// The low part of `low` below `high`, where either may have no bits.
ShiftTerm joined(Terms& t, ShiftTerm high, int high_from, int high_bits, ShiftTerm low,
                 int low_from, int low_bits) {
  if (high_bits == 0) return t.extract(low, low_from, low_bits);
  if (low_bits == 0) return t.extract(high, high_from, high_bits);
  return t.concat(t.extract(high, high_from, high_bits), t.extract(low, low_from, low_bits));
}

ShiftTerm as_bit(Terms& t, ShiftTerm truth) {
  return t.ite(truth, t.constant(1, 1), t.constant(0, 1));
}

/// SHL and SHLD. A count of all bits or more, which only bytes and words have, leaves 0; CF is
/// undefined then.
Shifted left(Terms& t, const Shifted& from, int by) {
  const int bits = t.width(from.value);
  const ShiftTerm zero = t.constant(0, bits);
  if (by >= bits) return {zero, from.carry, zero};
  const int rest = bits - by;
  return {joined(t, from.value, 0, rest, from.fill, rest, by), t.bit(from.value, rest),
          joined(t, from.fill, 0, rest, zero, 0, by)};
}

/// SHR and SHRD.
Shifted right(Terms& t, const Shifted& from, int by) {
  const int bits = t.width(from.value);
  const ShiftTerm zero = t.constant(0, bits);
  if (by >= bits) return {zero, from.carry, zero};
  const int rest = bits - by;
  return {joined(t, from.fill, 0, by, from.value, by, rest), t.bit(from.value, by - 1),
          joined(t, zero, 0, by, from.fill, by, rest)};
}

Shifted right_with_sign(Terms& t, const Shifted& from, int by) {
  const int bits = t.width(from.value);
  const int low = std::min(by, bits - 1);
  return {t.sign_extend(t.extract(from.value, low, bits - low), bits),
          t.bit(from.value, std::min(by, bits) - 1), from.fill};
}

Shifted rotated_left(Terms& t, const Shifted& from, int by) {
  const int bits = t.width(from.value);
  const int turn = by % bits;
  const ShiftTerm value = joined(t, from.value, 0, bits - turn, from.value, bits - turn, turn);
  return {value, t.bit(value, 0), from.fill};
}

Shifted rotated_right(Terms& t, const Shifted& from, int by) {
  const int bits = t.width(from.value);
  Shifted to = rotated_left(t, from, bits - by % bits);
  to.carry = t.bit(to.value, bits - 1);
  return to;
}

/// RCL: CF is one more bit, above the value.
Shifted rotated_left_through_carry(Terms& t, const Shifted& from, int by) {
  const int bits = t.width(from.value);
  const int turn = by % (bits + 1);
  if (turn == 0) return from;
  const ShiftTerm carry = as_bit(t, from.carry);
  // What is below the carry once it has moved in, and what came round below that.
  const ShiftTerm low = joined(t, carry, 0, 1, from.value, bits - turn + 1, turn - 1);
  return {joined(t, from.value, 0, bits - turn, low, 0, turn), t.bit(from.value, bits - turn),
          from.fill};
}

Shifted rotated_right_through_carry(Terms& t, const Shifted& from, int by) {
  const int all = t.width(from.value) + 1;
  return rotated_left_through_carry(t, from, all - by % all);
}

/// The bits of a count that count: 5, or 6 for operands of 64 bits.
ShiftTerm masked_count(const Execution& e, std::size_t n) {
  const ShiftTerm count =
      e.operand(n).kind == Operand::Kind::immediate ? e.value(n) : e.narrow_value(n);
  return e.t.extract(count, 0, e.bits == 64 ? 6 : 5);
}

Shifted shifted_by(const Execution& e, ShiftStep step, Shifted value, ShiftTerm count) {
  for (int i = 0; i < e.t.width(count); ++i) {
    const ShiftTerm taken = e.t.bit(count, i);
    if (e.t.is_constant(taken) && e.t.value(taken) == 0) continue;
    const Shifted next = step(e.t, value, 1 << i);
    value = {e.t.ite(taken, next.value, value.value), e.t.ite(taken, next.carry, value.carry),
             e.t.ite(taken, next.fill, value.fill)};
  }
  return value;
}

/// The flags of one of two states. Each is undefined if it is in either.
FlagTerms chosen(Terms& t, ShiftTerm condition, const FlagTerms& yes, const FlagTerms& no) {
  const auto flag = [&](std::optional<ShiftTerm> a, std::optional<ShiftTerm> b) {
    return a && b ? std::optional(t.ite(condition, *a, *b)) : std::nullopt;
  };
  return {flag(yes.carry, no.carry), flag(yes.zero, no.zero), flag(yes.sign, no.sign),
          flag(yes.overflow, no.overflow)};
}

/// What a rotate by one makes of OF; all other counts leave it undefined.
enum class TurnOverflow {
  two_bits,        ///< whether the two highest bits of the result differ: rotates to the right
  carry_and_sign,  ///< whether CF and the highest bit differ: rotates to the left
};

void rotate(const Execution& e, ShiftStep step, TurnOverflow kind, bool reads_carry) {
  const ShiftTerm count = masked_count(e, 1);
  const FlagTerms before = e.m.flags;
  const ShiftTerm carry = reads_carry ? e.carry() : e.t.truth(false);
  const ShiftTerm fill = e.zero();
  const Shifted to = shifted_by(e, step, {e.value(0), carry, fill}, count);
  e.write(0, to.value);
  FlagTerms after = before;
  after.carry = to.carry;
  after.overflow.reset();
  if (count == e.t.constant(1, e.t.width(count))) {
    const ShiftTerm other =
        kind == TurnOverflow::two_bits ? e.t.bit(to.value, e.bits - 2) : to.carry;
    after.overflow = e.d.differ(alu::sign(e.d, to.value, e.bits), other);
  }
  e.m.flags = chosen(e.t, e.is_zero(count), before, after);
}

/// A shift by a count that is not known to be 1, so that OF is undefined unless the count is 0.
void shift(const Execution& e, ShiftStep step, ShiftTerm fill, ShiftTerm count,
           bool may_lose_carry) {
  const FlagTerms before = e.m.flags;
  const Shifted to = shifted_by(e, step, {e.value(0), e.t.truth(false), fill}, count);
  e.write(0, to.value);
  const int undefined = OF | (may_lose_carry ? CF : 0);
  const auto result = alu::result(e.d, to.value, e.bits, to.carry, to.carry, to.carry, undefined);
  e.m.flags = chosen(e.t, e.is_zero(count), before, result.flags);
}

void single_shift(const Execution& e, ShiftStep step) {
  // SHL and SHR by all bits or more leave CF undefined; 32 and 64 bits have no such counts.
  shift(e, step, e.zero(), masked_count(e, 1), e.bits < 32 && step != right_with_sign);
}

void double_shift(const Execution& e, ShiftStep step) {
  // By more than all bits, which 32 and 64 bits cannot be, the result is undefined.
  if (e.bits < 32) not_modelled();
  shift(e, step, e.value(1), masked_count(e, 2), false);
}

/// The shifts of BMI2, which change no flags.
void shift_without_flags(const Execution& e, ShiftStep step) {
  const Shifted from{e.value(1), e.t.truth(false), e.zero()};
  e.write(0, shifted_by(e, step, from, masked_count(e, 2)).value);
}

}  // namespace

namespace meaning {

void shl(const Execution& e) { single_shift(e, left); }
void shr(const Execution& e) { single_shift(e, right); }
void sar(const Execution& e) { single_shift(e, right_with_sign); }
void shld(const Execution& e) { double_shift(e, left); }
void shrd(const Execution& e) { double_shift(e, right); }

void rol(const Execution& e) { rotate(e, rotated_left, TurnOverflow::carry_and_sign, false); }
void ror(const Execution& e) { rotate(e, rotated_right, TurnOverflow::two_bits, false); }
void rcl(const Execution& e) {
  rotate(e, rotated_left_through_carry, TurnOverflow::carry_and_sign, true);
}
void rcr(const Execution& e) {
  rotate(e, rotated_right_through_carry, TurnOverflow::two_bits, true);
}

void shlx(const Execution& e) { shift_without_flags(e, left); }
void shrx(const Execution& e) { shift_without_flags(e, right); }
void sarx(const Execution& e) { shift_without_flags(e, right_with_sign); }
void rorx(const Execution& e) { shift_without_flags(e, rotated_right); }

}  // namespace meaning

}  // namespace fixproof::judge
