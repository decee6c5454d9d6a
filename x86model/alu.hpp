/// @file
/// What the arithmetic instructions compute: their results and flags, from Intel's Software
/// Developer's Manual (volume 2) for the 386. The 8088 agrees on every form that an 8088 listing
/// uses.
///
/// Each is a function of the domain `D` that it computes in: Words for numbers, symbolic::Domain
/// for all numbers at once. Operands are `bits` wide, at most 32, in the domain of terms 64. Counts
/// are numbers in every domain. Flags that the manual leaves undefined are marked so; the caller
/// preserves flags that an instruction does not change.
#pragma once

#include <cstdint>

#include "x86model/flags.hpp"
#include "x86model/inline.hpp"

namespace x86model::alu {

template <class D>
using Value = typename D::Value;
template <class D>
using Wide = typename D::Wide;
template <class D>
using Truth = typename D::Truth;

template <class D>
struct Result {
  Value<D> value;
  typename D::Flags flags;
};

template <class D>
X86MODEL_INLINE Truth<D> sign(D d, Value<D> value, int bits) {
  return d.bit(value, bits - 1);
}

/// A result with its flags: SF, ZF and PF depend only on the value.
template <class D>
X86MODEL_INLINE Result<D> result(D d, Value<D> value, int bits, Truth<D> carry, Truth<D> auxiliary,
                                 Truth<D> overflow, int undefined = 0) {
  return {value,
          d.flags(carry, d.has_even_parity(value), auxiliary, d.equal(value, d.constant(0, bits)),
                  sign(d, value, bits), overflow, static_cast<std::uint16_t>(undefined))};
}

template <class D>
X86MODEL_INLINE Result<D> add(D d, Value<D> a, Value<D> b, Truth<D> carry, int bits) {
  const Value<D> value = d.sum(a, b, carry, bits);
  const Truth<D> overflow = sign(d, d.bit_and(d.bit_xor(a, value), d.bit_xor(b, value)), bits);
  return result(d, value, bits, d.carry_of(a, b, carry, bits), d.half_carry(a, b, value), overflow);
}

template <class D>
X86MODEL_INLINE Result<D> sub(D d, Value<D> a, Value<D> b, Truth<D> borrow, int bits) {
  const Value<D> value = d.difference(a, b, borrow, bits);
  const Truth<D> overflow = sign(d, d.bit_and(d.bit_xor(a, b), d.bit_xor(a, value)), bits);
  return result(d, value, bits, d.borrow_of(a, b, borrow, bits), d.half_carry(a, b, value),
                overflow);
}

/// AND and XOR: CF and OF cleared, AF undefined.
template <class D>
X86MODEL_INLINE Result<D> logic(D d, Value<D> value, int bits) {
  const Truth<D> no = d.truth(false);
  return result(d, value, bits, no, no, no, AF);
}

/// A result of a shift by `count` > 0: AF is undefined; OF is defined only for a shift by one.
template <class D>
X86MODEL_INLINE Result<D> shifted(D d, Value<D> value, int bits, int count, Truth<D> carry,
                                  Truth<D> overflow, int undefined = 0) {
  return result(d, value, bits, carry, d.truth(false), overflow,
                AF | (count == 1 ? 0 : OF) | undefined);
}

/// SHLD, 0 < count < bits: shifts `a` left and fills from the top of `fill`.
template <class D>
X86MODEL_INLINE Result<D> shld(D d, Value<D> a, Value<D> fill, int count, int bits) {
  const int rest = bits - count;
  const Value<D> value = d.concat(d.extract(a, 0, rest), d.extract(fill, rest, count), count);
  return shifted(d, value, bits, count, d.bit(a, rest),
                 d.differ(sign(d, a, bits), sign(d, value, bits)));
}

/// SHRD, 0 < count < bits: shifts `a` right and fills from the bottom of `fill`.
template <class D>
X86MODEL_INLINE Result<D> shrd(D d, Value<D> a, Value<D> fill, int count, int bits) {
  const int rest = bits - count;
  const Value<D> value = d.concat(d.extract(fill, 0, count), d.extract(a, count, rest), rest);
  return shifted(d, value, bits, count, d.bit(a, count - 1),
                 d.differ(sign(d, a, bits), sign(d, value, bits)));
}

/// The result of SHL and SHR by 31 >= count >= bits: 0, with CF undefined.
template <class D>
X86MODEL_INLINE Result<D> shifted_out(D d, int count, int bits) {
  const Truth<D> no = d.truth(false);
  return shifted(d, d.constant(0, bits), bits, count, no, no, CF);
}

/// SHL, 0 < count < 32. OF tells whether the sign changes.
template <class D>
X86MODEL_INLINE Result<D> shl(D d, Value<D> a, int count, int bits) {
  if (count >= bits) return shifted_out(d, count, bits);
  return shld(d, a, d.constant(0, bits), count, bits);
}

/// SHR, 0 < count < 32. OF is the sign of the operand, which always changes to 0.
template <class D>
X86MODEL_INLINE Result<D> shr(D d, Value<D> a, int count, int bits) {
  if (count >= bits) return shifted_out(d, count, bits);
  return shrd(d, a, d.constant(0, bits), count, bits);
}

/// SAR, 0 < count < 32, or 64 in 64-bit code. If count >= bits, CF is the sign.
template <class D>
X86MODEL_INLINE Result<D> sar(D d, Value<D> a, int count, int bits) {
  if constexpr (D::widest == 64) {
    if (bits == 64) {
      const Value<D> value = d.sign_extend(d.extract(a, count, bits - count), bits - count, bits);
      return shifted(d, value, bits, count, d.bit(a, count - 1), d.truth(false));
    }
  }
  const Wide<D> wide = d.sign_extend(a, bits, 64);
  return shifted(d, d.extract(wide, count, bits), bits, count, d.bit(wide, count - 1),
                 d.truth(false));
}

/// ROL, 0 < count < 32. Sets only CF and OF; the caller preserves the other flags.
template <class D>
X86MODEL_INLINE Result<D> rol(D d, Value<D> a, int count, int bits) {
  const int turn = count % bits;
  const int rest = bits - turn;
  const Value<D> value =
      turn == 0 ? a : d.concat(d.extract(a, 0, rest), d.extract(a, rest, turn), turn);
  const Truth<D> carry = d.bit(value, 0);
  const Truth<D> no = d.truth(false);
  return {value, d.flags(carry, no, no, no, no, d.differ(sign(d, value, bits), carry),
                         count == 1 ? std::uint16_t{0} : std::uint16_t{OF})};
}

template <class D>
struct Product {
  Wide<D> wide;
  typename D::Flags flags;
};

/// MUL and IMUL: CF and OF tell whether the high half is significant; other flags are undefined.
template <class D>
X86MODEL_INLINE Product<D> product(D d, Wide<D> wide, Truth<D> high_matters) {
  const Truth<D> no = d.truth(false);
  return {wide, d.flags(high_matters, no, no, no, no, high_matters, SF | ZF | AF | PF)};
}

template <class D>
X86MODEL_INLINE Product<D> mul(D d, Value<D> a, Value<D> b, int bits) {
  const Wide<D> wide = d.unsigned_product(a, b, bits);
  const Wide<D> low = d.zero_extend(d.extract(wide, 0, bits), bits, 2 * bits);
  return product(d, wide, d.negation(d.equal(wide, low)));
}

template <class D>
X86MODEL_INLINE Product<D> imul(D d, Value<D> a, Value<D> b, int bits) {
  const Wide<D> wide = d.signed_product(a, b, bits);
  const Wide<D> low = d.sign_extend(d.extract(wide, 0, bits), bits, 2 * bits);
  return product(d, wide, d.negation(d.equal(wide, low)));
}

/// Whether DIV raises #DE: the divisor is zero, or the quotient does not fit.
template <class D>
X86MODEL_INLINE Truth<D> div_faults(D d, Value<D> high, Value<D> divisor) {
  // The quotient fits if and only if the high half is below the divisor.
  return d.negation(d.below(high, divisor));
}

/// The condition of a jump or a set instruction, as the low four bits of their opcodes have it:
/// each odd one is the opposite of the one before it.
enum class ConditionCode : std::uint8_t {
  overflow,
  carry = 2,  ///< below, of unsigned numbers
  zero = 4,   ///< equal
  not_zero,
  carry_or_zero,  ///< below or equal
  above,
  sign,
  not_sign,
  parity,
  less = 12,  ///< of signed numbers
  less_or_equal = 14,
  greater,
};

/// The flags that a condition reads.
X86MODEL_INLINE std::uint16_t flags_read(ConditionCode condition) {
  constexpr std::uint16_t by_pair[8]{OF, CF, ZF, CF | ZF, SF, PF, SF | OF, ZF | SF | OF};
  return by_pair[static_cast<unsigned>(condition) / 2];
}

/// Whether a condition holds; all flags that it reads are defined.
template <class D>
X86MODEL_INLINE Truth<D> holds(D d, ConditionCode condition, const typename D::Flags& flags) {
  const auto code = static_cast<unsigned>(condition);
  Truth<D> truth{};
  switch (static_cast<ConditionCode>(code & ~1U)) {
    case ConditionCode::overflow:
      truth = flags.get(OF);
      break;
    case ConditionCode::carry:
      truth = flags.get(CF);
      break;
    case ConditionCode::zero:
      truth = flags.get(ZF);
      break;
    case ConditionCode::carry_or_zero:
      truth = d.either(flags.get(CF), flags.get(ZF));
      break;
    case ConditionCode::sign:
      truth = flags.get(SF);
      break;
    case ConditionCode::parity:
      truth = flags.get(PF);
      break;
    case ConditionCode::less:
      truth = d.differ(flags.get(SF), flags.get(OF));
      break;
    default:
      truth = d.either(flags.get(ZF), d.differ(flags.get(SF), flags.get(OF)));
      break;
  }
  return code % 2 == 0 ? truth : d.negation(truth);
}

}  // namespace x86model::alu
