/// @file
/// Executes one instruction on a machine.
#pragma once

#include <cstdint>

#include "x86model/alu.hpp"
#include "x86model/inline.hpp"
#include "x86model/instruction.hpp"
#include "x86model/machine.hpp"

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

template <class M>
X86MODEL_INLINE int bits_of(Size size) {
  if (size == Size::byte) return 8;
  return size == Size::word ? M::word_bits : 2 * M::word_bits;
}

/// Whether a machine's memory has bytes and segments; see ByteMemory.
template <class M>
concept HasBytes = requires(M m, std::uint32_t value) {
  m.memory.read_byte(value, value);
  m.memory.write_byte(value, value);
  m.memory.write_extra_byte(value, value);
  m.memory.write_extra_word(value, value);
};

template <class M>
X86MODEL_INLINE std::uint32_t address_of(const Operand& o, const M& m) {
  const std::int32_t displacement = o.value + x86model::address_of(o.symbol);
  if constexpr (M::word_bits == 16) {
    const auto constant = static_cast<std::uint32_t>(displacement);
    if (o.addressing == Addressing::direct) return constant & alu::mask(16);
    if (o.addressing != Addressing::base) {
      const std::uint32_t index = m.registers.read(o.reg, Size::dword);
      return (o.addressing == Addressing::index_twice ? 2 * index : index) + constant;
    }
  }
  const auto base = m.registers.read(o.reg, Size::word);
  return (base + static_cast<std::uint32_t>(scaled_bytes<M::word_bits>(displacement))) &
         alu::mask(M::word_bits);
}

template <class M>
X86MODEL_INLINE std::uint32_t immediate(const Operand& o) {
  switch (o.scaling) {
    case Scaling::literal:
      break;
    case Scaling::bytes:
      return static_cast<std::uint32_t>(scaled_bytes<M::word_bits>(o.value));
    case Scaling::half_unit:
      return std::uint32_t{1} << (M::word_bits - 1);
    case Scaling::word_bits:
      return M::word_bits;
  }
  return static_cast<std::uint32_t>(o.value);
}

/// The word at `address` in the segment of operand `o`. A machine without `read_code` has no data
/// in its code segment.
template <class M>
X86MODEL_INLINE bool read_word(const Operand& o, const M& m, std::uint32_t address,
                               std::uint32_t& value) {
  if (o.segment == SegmentOverride::none) return m.memory.read(address, value);
  if constexpr (requires { m.memory.read_code(address, value); }) {
    return m.memory.read_code(address, value);
  }
  return false;
}

/// Reads `size` bits at an operand into `value`. @return false if the address is not in memory
template <class M>
X86MODEL_INLINE bool read(const Operand& o, Size size, const M& m, std::uint32_t& value) {
  if (o.kind == Operand::Kind::reg) {
    value = m.registers.read(o.reg, size);
    return true;
  }
  if (o.kind == Operand::Kind::immediate) {
    value = immediate<M>(o) & alu::mask(bits_of<M>(size));
    return true;
  }
  const std::uint32_t address = address_of(o, m);
  if (size == Size::byte) {
    if constexpr (HasBytes<M>) {
      return o.segment == SegmentOverride::none && m.memory.read_byte(address, value);
    }
    return false;
  }
  if (!read_word(o, m, address, value)) return false;
  if (size == Size::word) return true;
  std::uint32_t high = 0;
  if (!read_word(o, m, address + M::word_bits / 8, high)) return false;
  value |= high << M::word_bits;
  return true;
}

template <class M>
X86MODEL_INLINE bool write(const Operand& o, Size size, M& m, std::uint32_t value) {
  if (o.kind == Operand::Kind::reg) {
    m.registers.write(o.reg, size, value);
    return true;
  }
  // The code segment is not writable.
  if (o.segment != SegmentOverride::none) return false;
  const std::uint32_t address = address_of(o, m);
  if (size == Size::byte) {
    if constexpr (HasBytes<M>) return m.memory.write_byte(address, value);
    return false;
  }
  if (!m.memory.write(address, value)) return false;
  return size == Size::word || m.memory.write(address + M::word_bits / 8, value >> M::word_bits);
}

/// The word at the top of the stack.
template <class M>
X86MODEL_INLINE bool read_stack(const M& m, std::uint32_t top, std::uint32_t& value) {
  if constexpr (requires { m.memory.read_stack(top, value); }) {
    return m.memory.read_stack(top, value);
  } else {
    return m.memory.read(top, value);
  }
}

template <class M>
X86MODEL_INLINE bool write_stack(M& m, std::uint32_t top, std::uint32_t value) {
  if constexpr (requires { m.memory.write_stack(top, value); }) {
    return m.memory.write_stack(top, value);
  } else {
    return m.memory.write(top, value);
  }
}

template <class M>
X86MODEL_INLINE bool push(M& m, std::uint32_t value) {
  const std::uint32_t top =
      (m.registers.read(Register::sp, Size::word) - M::word_bits / 8) & alu::mask(M::word_bits);
  if (!write_stack(m, top, value)) return false;
  m.registers.write(Register::sp, Size::word, top);
  return true;
}

template <class M>
X86MODEL_INLINE bool pop(M& m, std::uint32_t& value) {
  const std::uint32_t top = m.registers.read(Register::sp, Size::word);
  if (!read_stack(m, top, value)) return false;
  m.registers.write(Register::sp, Size::word, top + M::word_bits / 8);
  return true;
}

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

/// STOSB and STOSW in 16-bit code: stores AL or AX at ES:DI and advances DI. Does not change flags.
template <Mnemonic op, class M>
X86MODEL_INLINE bool store_string(M& m) {
  if constexpr (HasBytes<M>) {
    constexpr bool byte = op == Mnemonic::stosb;
    const std::uint32_t place = m.registers.read(Register::di, Size::word);
    const std::uint32_t value = m.registers.read(Register::ax, Size::word);
    const bool done =
        byte ? m.memory.write_extra_byte(place, value) : m.memory.write_extra_word(place, value);
    if (done) m.registers.write(Register::di, Size::word, place + (byte ? 1 : 2));
    return done;
  }
  return false;
}

X86MODEL_INLINE bool is_multiply(Mnemonic op) {
  return op == Mnemonic::mul || op == Mnemonic::imul;
}
X86MODEL_INLINE bool is_divide(Mnemonic op) { return op == Mnemonic::div || op == Mnemonic::idiv; }

template <Mnemonic op>
X86MODEL_INLINE alu::Result two_operand(std::uint32_t a, std::uint32_t b, bool carry, int bits) {
  if constexpr (op == Mnemonic::add) return alu::add(a, b, false, bits);
  if constexpr (op == Mnemonic::adc) return alu::add(a, b, carry, bits);
  if constexpr (op == Mnemonic::sub || op == Mnemonic::cmp) return alu::sub(a, b, false, bits);
  if constexpr (op == Mnemonic::sbb) return alu::sub(a, b, carry, bits);
  if constexpr (op == Mnemonic::and_) return alu::logic(a & b, bits);
  if constexpr (op == Mnemonic::xor_) return alu::logic(a ^ b, bits);
}

template <Mnemonic op>
X86MODEL_INLINE alu::Result one_operand(std::uint32_t a, int bits) {
  if constexpr (op == Mnemonic::neg) return alu::sub(0, a, false, bits);
  if constexpr (op == Mnemonic::inc) return alu::add(a, 1, false, bits);
  if constexpr (op == Mnemonic::dec) return alu::sub(a, 1, false, bits);
}

template <Mnemonic op>
X86MODEL_INLINE alu::Result shift(std::uint32_t a, int count, int bits) {
  if constexpr (op == Mnemonic::shl) return alu::shl(a, count, bits);
  if constexpr (op == Mnemonic::shr) return alu::shr(a, count, bits);
  if constexpr (op == Mnemonic::sar) return alu::sar(a, count, bits);
  if constexpr (op == Mnemonic::rol) return alu::rol(a, count, bits);
}

}  // namespace detail

/// Executes one instruction that is not a jump, call or return.
/// @return proceeds, or the reason why not; after divide_error and undefined_flag the machine is
/// unchanged
template <Mnemonic op, class M>
// One branch per kind of instruction; an instantiation keeps only one.
// NOLINTNEXTLINE(readability-function-cognitive-complexity)
X86MODEL_INLINE Outcome execute(const Instruction& instruction, M& m) {
  using namespace detail;
  const Operand& first = instruction.operands[0];
  const Operand& second = instruction.operands[1];
  const Size size = first.size;
  const int bits = bits_of<M>(size);
  std::uint32_t a = 0;
  std::uint32_t b = 0;

  if constexpr (op == Mnemonic::mov) {
    if (!read(second, size, m, b) || !write(first, size, m, b)) return Outcome::bad_address;
  } else if constexpr (op == Mnemonic::push) {
    if (!read(first, size, m, a) || !push(m, a)) return Outcome::bad_address;
  } else if constexpr (op == Mnemonic::pop) {
    if (!pop(m, a) || !write(first, size, m, a)) return Outcome::bad_address;
  } else if constexpr (is_store_string(op)) {
    if (!store_string<op>(m)) return Outcome::bad_address;
  } else if constexpr (is_two_operand(op)) {
    if constexpr (op == Mnemonic::adc || op == Mnemonic::sbb) {
      if ((m.flags.undefined & CF) != 0) return Outcome::undefined_flag;
    }
    if (!read(first, size, m, a) || !read(second, size, m, b)) return Outcome::bad_address;
    const alu::Result result = two_operand<op>(a, b, (m.flags.value & CF) != 0, bits);
    if constexpr (op != Mnemonic::cmp) {
      if (!write(first, size, m, result.value)) return Outcome::bad_address;
    }
    m.flags = result.flags;
  } else if constexpr (is_one_operand(op)) {
    if (!read(first, size, m, a)) return Outcome::bad_address;
    const alu::Result result = one_operand<op>(a, bits);
    if (!write(first, size, m, result.value)) return Outcome::bad_address;
    // INC and DEC do not change CF.
    m.flags = op == Mnemonic::neg ? result.flags : result.flags.keeping(CF, m.flags);
  } else if constexpr (is_shift(op) || is_double_shift(op)) {
    const Operand& amount = is_shift(op) ? second : instruction.operands[2];
    // The 386 takes the count modulo 32; a count of 0 changes nothing, not even flags.
    const int count = static_cast<int>(immediate<M>(amount) & 31U);
    if (!read(first, size, m, a) || !read(second, size, m, b)) return Outcome::bad_address;
    if (count == 0) return Outcome::proceeds;
    alu::Result result{};
    if constexpr (is_shift(op)) result = shift<op>(a, count, bits);
    if constexpr (op == Mnemonic::shld) result = alu::shld(a, b, count, bits);
    if constexpr (op == Mnemonic::shrd) result = alu::shrd(a, b, count, bits);
    if (!write(first, size, m, result.value)) return Outcome::bad_address;
    m.flags = op == Mnemonic::rol ? result.flags.keeping(SF | ZF | AF | PF, m.flags) : result.flags;
  } else if constexpr (is_multiply(op)) {
    if (!read(first, size, m, b)) return Outcome::bad_address;
    a = m.registers.read(Register::ax, size);
    const alu::Product product = op == Mnemonic::mul ? alu::mul(a, b, bits) : alu::imul(a, b, bits);
    m.registers.write(Register::ax, size, product.low);
    m.registers.write(Register::dx, size, product.high);
    // Not as a whole: g++ would then store two halves on the stack and wait to load them as one.
    m.flags.value = product.flags.value;
    m.flags.undefined = product.flags.undefined;
  } else if constexpr (is_divide(op)) {
    if (!read(first, size, m, b)) return Outcome::bad_address;
    const std::uint32_t high = m.registers.read(Register::dx, size);
    const std::uint32_t low = m.registers.read(Register::ax, size);
    const auto quotient =
        op == Mnemonic::div ? alu::div(high, low, b, bits) : alu::idiv(high, low, b, bits);
    if (!quotient) return Outcome::divide_error;
    m.registers.write(Register::ax, size, quotient->quotient);
    m.registers.write(Register::dx, size, quotient->remainder);
    m.flags = all_undefined;
  } else {
    static_assert(op == Mnemonic::mov, "control flow belongs to the interpreter");
  }
  return Outcome::proceeds;
}

constexpr bool is_control_flow(Mnemonic op) { return op >= Mnemonic::jmp; }

/// LOOP in 16-bit code: decrements CX and jumps unless it becomes 0. Does not change flags.
/// @return whether it jumps
template <class M>
X86MODEL_INLINE bool count_down(M& m) {
  const std::uint32_t count = m.registers.read(Register::cx, Size::word) - 1;
  m.registers.write(Register::cx, Size::word, count);
  return m.registers.read(Register::cx, Size::word) != 0;
}

/// Evaluates the condition of a jump other than LOOP, for which see count_down(). @return proceeds,
/// or undefined_flag if the condition reads an undefined flag
X86MODEL_INLINE Outcome jump_taken(Mnemonic op, const Flags& flags, bool& taken) {
  std::uint16_t reads = 0;
  const auto set = [&](Flag f) { return (flags.value & f) != 0; };
  switch (op) {
    case Mnemonic::js:
      reads = SF;
      taken = set(SF);
      break;
    case Mnemonic::jns:
      reads = SF;
      taken = !set(SF);
      break;
    case Mnemonic::jz:
      reads = ZF;
      taken = set(ZF);
      break;
    case Mnemonic::jnz:
      reads = ZF;
      taken = !set(ZF);
      break;
    case Mnemonic::ja:
      reads = CF | ZF;
      taken = !set(CF) && !set(ZF);
      break;
    case Mnemonic::jg:
      reads = ZF | SF | OF;
      taken = !set(ZF) && set(SF) == set(OF);
      break;
    default:
      taken = true;
      break;
  }
  return (flags.undefined & reads) != 0 ? Outcome::undefined_flag : Outcome::proceeds;
}

}  // namespace x86model
