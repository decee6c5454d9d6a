/// @file
/// Executes one instruction on a machine: which operands it reads and writes, and which flags it
/// changes.
///
/// A machine `M` is one of words (machine.hpp) or of terms (symbolic/machine.hpp). It has the
/// domain in which alu.hpp computes, `flags`, registers, operands and a stack; `faults_if` tells
/// whether a condition raises #DE. An instruction `I` has an array of operands, of the type that
/// the machine reads.
#pragma once

#include <cstdint>
#include <optional>

#include "x86model/alu.hpp"
#include "x86model/inline.hpp"
#include "x86model/instruction.hpp"

namespace x86model {

/// How an instruction or a run ended.
enum class Outcome : std::uint8_t {
  proceeds,        ///< the instruction completed
  returned,        ///< RET from the routine itself
  divide_error,    ///< #DE; the machine is unchanged
  undefined_flag,  ///< an instruction read a flag that Intel leaves undefined
  bad_address,     ///< an access outside memory
  step_limit,      ///< the run exceeded its step limit
};

namespace detail {

X86MODEL_INLINE bool is_two_operand(Mnemonic op) {
  return op == Mnemonic::add || op == Mnemonic::adc || op == Mnemonic::sub || op == Mnemonic::sbb ||
         op == Mnemonic::cmp || op == Mnemonic::and_ || op == Mnemonic::xor_;
}
X86MODEL_INLINE bool is_one_operand(Mnemonic op) {
  return op == Mnemonic::neg || op == Mnemonic::inc || op == Mnemonic::dec;
}
X86MODEL_INLINE bool is_shift(Mnemonic op) {
  return op == Mnemonic::shl || op == Mnemonic::shr || op == Mnemonic::sar || op == Mnemonic::rol;
}
X86MODEL_INLINE bool is_double_shift(Mnemonic op) {
  return op == Mnemonic::shld || op == Mnemonic::shrd;
}
X86MODEL_INLINE bool is_store_string(Mnemonic op) {
  return op == Mnemonic::stosb || op == Mnemonic::stosw;
}
X86MODEL_INLINE bool is_multiply(Mnemonic op) {
  return op == Mnemonic::mul || op == Mnemonic::imul;
}
X86MODEL_INLINE bool is_divide(Mnemonic op) { return op == Mnemonic::div || op == Mnemonic::idiv; }

X86MODEL_INLINE bool adds_carry(Mnemonic op) { return op == Mnemonic::adc || op == Mnemonic::sbb; }

/// The condition of a jump other than LOOP; nothing if it jumps always.
X86MODEL_INLINE std::optional<alu::ConditionCode> condition_of(Mnemonic op) {
  switch (op) {
    case Mnemonic::js:
      return alu::ConditionCode::sign;
    case Mnemonic::jns:
      return alu::ConditionCode::not_sign;
    case Mnemonic::jz:
      return alu::ConditionCode::zero;
    case Mnemonic::jnz:
      return alu::ConditionCode::not_zero;
    case Mnemonic::ja:
      return alu::ConditionCode::above;
    case Mnemonic::jg:
      return alu::ConditionCode::greater;
    default:
      return std::nullopt;
  }
}

/// @param carry CF for ADC and SBB, otherwise false
template <Mnemonic op, class D>
X86MODEL_INLINE alu::Result<D> two_operand(D d, alu::Value<D> a, alu::Value<D> b,
                                           alu::Truth<D> carry, int bits) {
  if constexpr (op == Mnemonic::add || op == Mnemonic::adc) return alu::add(d, a, b, carry, bits);
  if constexpr (op == Mnemonic::sub || op == Mnemonic::cmp || op == Mnemonic::sbb) {
    return alu::sub(d, a, b, carry, bits);
  }
  if constexpr (op == Mnemonic::and_) return alu::logic(d, d.bit_and(a, b), bits);
  if constexpr (op == Mnemonic::xor_) return alu::logic(d, d.bit_xor(a, b), bits);
}

template <Mnemonic op, class D>
X86MODEL_INLINE alu::Result<D> one_operand(D d, alu::Value<D> a, int bits) {
  const alu::Truth<D> no = d.truth(false);
  if constexpr (op == Mnemonic::neg) return alu::sub(d, d.constant(0, bits), a, no, bits);
  if constexpr (op == Mnemonic::inc) return alu::add(d, a, d.constant(1, bits), no, bits);
  if constexpr (op == Mnemonic::dec) return alu::sub(d, a, d.constant(1, bits), no, bits);
}

template <Mnemonic op, class D>
X86MODEL_INLINE alu::Result<D> shift(D d, alu::Value<D> a, alu::Value<D> b, int count, int bits) {
  if constexpr (op == Mnemonic::shl) return alu::shl(d, a, count, bits);
  if constexpr (op == Mnemonic::shr) return alu::shr(d, a, count, bits);
  if constexpr (op == Mnemonic::sar) return alu::sar(d, a, count, bits);
  if constexpr (op == Mnemonic::rol) return alu::rol(d, a, count, bits);
  if constexpr (op == Mnemonic::shld) return alu::shld(d, a, b, count, bits);
  if constexpr (op == Mnemonic::shrd) return alu::shrd(d, a, b, count, bits);
}

/// MUL and IMUL of AX by `b` to DX:AX, or of EAX to EDX:EAX.
template <Mnemonic op, class M, class V>
X86MODEL_INLINE void multiply(M& m, V b, Size size) {
  const auto d = m.domain();
  const int bits = m.bits_of(size);
  const V a = m.read(Register::ax, size);
  const auto product = op == Mnemonic::mul ? alu::mul(d, a, b, bits) : alu::imul(d, a, b, bits);
  m.write(Register::ax, size, d.extract(product.wide, 0, bits));
  m.write(Register::dx, size, d.extract(product.wide, bits, bits));
  m.flags.set(product.flags);
}

/// DIV and IDIV of DX:AX by `b`, or of EDX:EAX: quotient to AX, remainder, with the sign of the
/// dividend, to DX. Leaves all six flags undefined. @return whether it raises #DE
template <Mnemonic op, class M, class V>
X86MODEL_INLINE bool divide(M& m, V b, Size size) {
  const auto d = m.domain();
  const int bits = m.bits_of(size);
  const V high = m.read(Register::dx, size);
  const auto n = d.join(high, m.read(Register::ax, size), bits);
  if constexpr (op == Mnemonic::div) {
    if (m.faults_if(alu::div_faults(d, high, b))) return true;
    m.write(Register::ax, size, d.unsigned_quotient(n, b, bits));
    m.write(Register::dx, size, d.unsigned_remainder(n, b, bits));
  } else {
    if (m.faults_if(d.signed_quotient_overflows(n, b, bits))) return true;
    m.write(Register::ax, size, d.signed_quotient(n, b, bits));
    m.write(Register::dx, size, d.signed_remainder(n, b, bits));
  }
  m.flags = d.undefined_flags();
  return false;
}

}  // namespace detail

/// Executes one instruction that is not a jump, call or return.
/// @return proceeds, or the reason why not; after divide_error and undefined_flag the machine is
/// unchanged
template <Mnemonic op, class I, class M>
// One branch per kind of instruction; an instantiation keeps only one.
// NOLINTNEXTLINE(readability-function-cognitive-complexity)
X86MODEL_INLINE Outcome execute(const I& instruction, M& m) {
  using namespace detail;
  const auto& first = instruction.operands[0];
  const auto& second = instruction.operands[1];
  const Size size = first.size;
  const auto d = m.domain();
  const int bits = m.bits_of(size);
  typename M::Domain::Value a{};
  typename M::Domain::Value b{};

  if constexpr (op == Mnemonic::mov) {
    if (!m.read(second, size, b) || !m.write(first, size, b)) return Outcome::bad_address;
  } else if constexpr (op == Mnemonic::push) {
    if (!m.read(first, size, a) || !m.push(a)) return Outcome::bad_address;
  } else if constexpr (op == Mnemonic::pop) {
    if (!m.pop(a) || !m.write(first, size, a)) return Outcome::bad_address;
  } else if constexpr (is_store_string(op)) {
    if (!m.store_string(op == Mnemonic::stosb ? Size::byte : Size::word)) {
      return Outcome::bad_address;
    }
  } else if constexpr (is_two_operand(op)) {
    if (adds_carry(op) && !m.flags.are_defined(CF)) return Outcome::undefined_flag;
    if (!m.read(first, size, a) || !m.read(second, size, b)) return Outcome::bad_address;
    const auto carry = adds_carry(op) ? m.flags.get(CF) : d.truth(false);
    const auto result = two_operand<op>(d, a, b, carry, bits);
    if constexpr (op != Mnemonic::cmp) {
      if (!m.write(first, size, result.value)) return Outcome::bad_address;
    }
    m.flags = result.flags;
  } else if constexpr (is_one_operand(op)) {
    if (!m.read(first, size, a)) return Outcome::bad_address;
    const auto result = one_operand<op>(d, a, bits);
    if (!m.write(first, size, result.value)) return Outcome::bad_address;
    // INC and DEC do not change CF.
    m.flags = op == Mnemonic::neg ? result.flags : result.flags.keeping(CF, m.flags);
  } else if constexpr (is_shift(op) || is_double_shift(op)) {
    const auto& amount = is_shift(op) ? second : instruction.operands[2];
    // The count is taken modulo 32, or 64 in 64-bit code; one of 0 changes nothing, not even flags.
    const int count = static_cast<int>(m.count_in(amount) & (bits == 64 ? 63U : 31U));
    if (!m.read(first, size, a) || !m.read(second, size, b)) return Outcome::bad_address;
    if (count == 0) return Outcome::proceeds;
    const auto result = shift<op>(d, a, b, count, bits);
    if (!m.write(first, size, result.value)) return Outcome::bad_address;
    m.flags = op == Mnemonic::rol ? result.flags.keeping(SF | ZF | AF | PF, m.flags) : result.flags;
  } else if constexpr (is_multiply(op)) {
    if (!m.read(first, size, b)) return Outcome::bad_address;
    multiply<op>(m, b, size);
  } else if constexpr (is_divide(op)) {
    if (!m.read(first, size, b)) return Outcome::bad_address;
    if (divide<op>(m, b, size)) return Outcome::divide_error;
  } else {
    static_assert(op == Mnemonic::mov, "control flow belongs to the interpreter");
  }
  return Outcome::proceeds;
}

constexpr bool is_control_flow(Mnemonic op) { return op >= Mnemonic::jmp; }

/// LOOP in 16-bit code: decrements CX and jumps unless it becomes 0. Does not change flags.
/// @return whether it jumps
template <class M>
X86MODEL_INLINE auto count_down(M& m) {
  const auto d = m.domain();
  const int bits = m.bits_of(Size::word);
  const auto count =
      d.difference(m.read(Register::cx, Size::word), d.constant(1, bits), d.truth(false), bits);
  m.write(Register::cx, Size::word, count);
  return d.negation(d.equal(count, d.constant(0, bits)));
}

/// Evaluates the condition of a jump other than LOOP, for which see count_down(). @return proceeds,
/// or undefined_flag if the condition reads an undefined flag
template <class D>
X86MODEL_INLINE Outcome jump_taken(D d, Mnemonic op, const typename D::Flags& flags,
                                   alu::Truth<D>& taken) {
  const auto condition = detail::condition_of(op);
  if (!condition) {
    taken = d.truth(true);
    return Outcome::proceeds;
  }
  if (!flags.are_defined(alu::flags_read(*condition))) return Outcome::undefined_flag;
  taken = alu::holds(d, *condition, flags);
  return Outcome::proceeds;
}

}  // namespace x86model
