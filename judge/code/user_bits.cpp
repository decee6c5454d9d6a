// Instructions on single bits.
#include <optional>

#include "judge/code/user_instructions.hpp"

namespace fixproof::judge {

namespace {

namespace alu = x86model::alu;
using BitTerm = x86model::symbolic::Term;

/// Leaves SF and OF undefined.
void set_flags_of_bits(const Execution& e, std::optional<BitTerm> carry,
                       std::optional<BitTerm> zero) {
  e.m.flags = e.d.undefined_flags();
  e.m.flags.carry = carry;
  e.m.flags.zero = zero;
}

/// How a bit that BT reads is left.
enum class BitChange { none, set, reset, complemented };

void bit_test(const Execution& e, BitChange change) {
  // A register counts bits from the start of memory, beyond the operand too.
  if (e.operand(0).kind == Operand::Kind::memory && e.operand(1).kind == Operand::Kind::reg) {
    not_modelled();
  }
  const BitTerm value = e.value(0);
  // A 1 at the position, which counts modulo the size.
  BitTerm mask = e.number(1);
  for (int digit = 0; (1 << digit) < e.bits; ++digit) {
    const int by = 1 << digit;
    const BitTerm moved = e.t.concat(e.t.extract(mask, 0, e.bits - by), e.t.constant(0, by));
    mask = e.t.ite(e.t.bit(e.value(1), digit), moved, mask);
  }
  const BitTerm is_set = e.t.negation(e.is_zero(e.t.bit_and(value, mask)));
  const BitTerm without = e.t.bit_and(value, e.inverse(mask));
  if (change == BitChange::set) e.write(0, e.t.bit_xor(without, mask));
  if (change == BitChange::reset) e.write(0, without);
  if (change == BitChange::complemented) e.write(0, e.t.bit_xor(value, mask));
  set_flags_of_bits(e, is_set, e.m.flags.zero);
}

enum class Side { top, bottom };

/// The number of zeros at one end of a value, `bits` - 1 of them if all are: by halves, the larger
/// ones first.
BitTerm zeros_at(const Execution& e, Side side, BitTerm value) {
  BitTerm count{};
  int counted = 0;
  for (int half = e.bits / 2; half > 0; half /= 2) {
    const int rest = e.bits - half;
    const bool at_top = side == Side::top;
    const BitTerm none = e.is_zero(e.t.extract(value, at_top ? rest : 0, half));
    const BitTerm filled = e.t.constant(0, half);
    const BitTerm moved = at_top ? e.t.concat(e.t.extract(value, 0, rest), filled)
                                 : e.t.concat(filled, e.t.extract(value, half, rest));
    value = e.t.ite(none, moved, value);
    const BitTerm digit = e.t.ite(none, e.t.constant(1, 1), e.t.constant(0, 1));
    count = counted++ == 0 ? digit : e.t.concat(count, digit);
  }
  return e.t.zero_extend(count, e.bits);
}

/// BSF and BSR: the position of the lowest or highest 1. Without one, the register is undefined.
void scan(const Execution& e, Side side) {
  const BitTerm value = e.value(1);
  const BitTerm zeros = zeros_at(e, side, value);
  const BitTerm position = side == Side::bottom
                               ? zeros
                               : e.t.bit_xor(zeros, e.number(static_cast<unsigned>(e.bits) - 1));
  const BitTerm none = e.is_zero(value);
  // Nothing is known of the upper half of a register of 64 bits either.
  const int width = e.bits == 16 ? 16 : e.m.width();
  e.write_whole(0, e.t.ite(none, e.anything(width), e.t.zero_extend(position, width)));
  set_flags_of_bits(e, std::nullopt, none);
}

/// TZCNT and LZCNT: as many as there are bits, if all are zeros.
void count_zeros(const Execution& e, Side side) {
  const BitTerm value = e.value(1);
  const BitTerm none = e.is_zero(value);
  const BitTerm count =
      e.t.ite(none, e.number(static_cast<unsigned>(e.bits)), zeros_at(e, side, value));
  e.write(0, count);
  set_flags_of_bits(e, none, e.is_zero(count));
}

/// BLSR, BLSI and BLSMSK.
void lowest_bit(const Execution& e, BitTerm result, BitTerm carry) {
  e.write(0, result);
  e.m.flags = alu::logic(e.d, result, e.bits).flags;
  e.m.flags.carry = carry;
}
BitTerm less_one(const Execution& e) { return e.t.sub(e.value(1), e.number(1)); }

}  // namespace

namespace meaning {

void bt(const Execution& e) { bit_test(e, BitChange::none); }
void bts(const Execution& e) { bit_test(e, BitChange::set); }
void btr(const Execution& e) { bit_test(e, BitChange::reset); }
void btc(const Execution& e) { bit_test(e, BitChange::complemented); }

void bsf(const Execution& e) { scan(e, Side::bottom); }
void bsr(const Execution& e) { scan(e, Side::top); }
void tzcnt(const Execution& e) { count_zeros(e, Side::bottom); }
void lzcnt(const Execution& e) { count_zeros(e, Side::top); }

void popcnt(const Execution& e) {
  const BitTerm value = e.value(1);
  // Adds the two halves of each field of bits, from fields of two bits on.
  BitTerm sums = value;
  for (int half = 1; half < e.bits; half *= 2) {
    std::uint64_t low_halves = 0;
    for (int at = 0; at < e.bits; at += 2 * half) {
      low_halves |= ((std::uint64_t{1} << half) - 1) << at;
    }
    const BitTerm mask = e.number(low_halves);
    const BitTerm upper = e.t.concat(e.t.constant(0, half), e.t.extract(sums, half, e.bits - half));
    sums = e.t.add(e.t.bit_and(sums, mask), e.t.bit_and(upper, mask));
  }
  e.write(0, sums);
  const BitTerm no = e.t.truth(false);
  e.m.flags = {.carry = no, .zero = e.is_zero(value), .sign = no, .overflow = no};
}

void bswap(const Execution& e) {
  if (e.bits == 16) not_modelled();  // undefined
  const BitTerm value = e.value(0);
  BitTerm turned = e.t.extract(value, 0, 8);
  for (int low = 8; low < e.bits; low += 8) turned = e.t.concat(turned, e.t.extract(value, low, 8));
  e.write(0, turned);
}

void andn(const Execution& e) {
  const auto result = alu::logic(e.d, e.t.bit_and(e.inverse(e.value(1)), e.value(2)), e.bits);
  e.write(0, result.value);
  e.m.flags = result.flags;
}

void blsr(const Execution& e) {
  lowest_bit(e, e.t.bit_and(e.value(1), less_one(e)), e.is_zero(e.value(1)));
}
void blsmsk(const Execution& e) {
  lowest_bit(e, e.t.bit_xor(e.value(1), less_one(e)), e.is_zero(e.value(1)));
}
void blsi(const Execution& e) {
  const BitTerm value = e.value(1);
  lowest_bit(e, e.t.bit_and(value, e.t.sub(e.zero(), value)), e.t.negation(e.is_zero(value)));
}

}  // namespace meaning

}  // namespace fixproof::judge
