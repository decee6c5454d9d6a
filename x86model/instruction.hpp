/// @file
/// Instructions as plain data: a mnemonic and up to three operands.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace x86model {

/// The general registers, in the order of their encoding.
enum class Register : std::uint8_t { ax, cx, dx, bx, sp, bp, si, di };
inline constexpr std::size_t register_count = 8;

/// The instructions that the routines and loops use.
enum class Mnemonic : std::uint8_t {
  // data movement
  mov,
  push,
  pop,
  // arithmetic
  add,
  adc,
  sub,
  sbb,
  cmp,
  neg,
  inc,
  dec,
  mul,
  imul,
  div,
  idiv,
  // logic and shifts
  and_,
  xor_,
  shl,
  shr,
  sar,
  rol,
  shld,
  shrd,
  // strings; the direction flag is clear, as calling conventions require
  stosb,
  stosw,
  // control flow
  jmp,
  js,
  jns,
  jz,
  jnz,
  ja,
  jg,
  loop,
  call,
  ret,
};
inline constexpr std::size_t mnemonic_count = static_cast<std::size_t>(Mnemonic::ret) + 1;

/// Operand size in terms of the machine word: 16 and 32 bits at full width, 8 and 16 at half width.
/// Bytes exist only at full width. A byte register has the number of its encoding: AL, CL, DL and
/// BL share those of ax, cx, dx and bx; AH, CH, DH and BH follow.
enum class Size : std::uint8_t { none, byte, word, dword, qword };  // the last for users' code

/// How a constant scales with the width of the machine word.
enum class Scaling : std::uint8_t {
  literal,    ///< the same at every width
  bytes,      ///< a byte count, written for 16-bit words
  half_unit,  ///< the top bit of a word (8000h): half an ulp of the product
  word_bits,  ///< the number of bits of a word (16)
};

/// A named place in memory.
enum class Symbol : std::uint8_t { none, cos_table, inc_j, texture, screen, z_buff };

/// How the address of a memory operand is formed.
enum class Addressing : std::uint8_t {
  base,         ///< 16-bit register plus displacement, modulo 2^16
  direct,       ///< displacement only
  index,        ///< 32-bit register plus displacement, modulo 2^32
  index_twice,  ///< twice that register plus displacement, modulo 2^32
};

/// The segment of a memory operand: the default of its base register, or an override. CS is the
/// only override, because CosSin's table is in the code segment.
enum class SegmentOverride : std::uint8_t { none, cs };

struct Operand {
  enum class Kind : std::uint8_t { none, reg, memory, immediate, label };

  Kind kind = Kind::none;
  Size size = Size::none;
  Scaling scaling = Scaling::literal;
  Symbol symbol = Symbol::none;  ///< memory: added to the displacement
  Addressing addressing = Addressing::base;
  SegmentOverride segment = SegmentOverride::none;
  Register reg = Register::ax;  ///< register, or base of a memory operand
  std::int32_t value = 0;       ///< immediate, displacement in bytes, or position of a label
  const char* name = nullptr;   ///< label
};

/// Rows of a listing that the assembler resolves.
enum class Directive : std::uint8_t { none, procedure, label, if_, else_, endif };

/// The condition of a row on the build.
enum class Condition : std::uint8_t {
  none,
  mul_rounding,
  div_rounding,
  chapter_52,
  endif_as_scanned,
  repaired,
  shl_as_printed
};

/// A row of a listing; after assembly, an instruction.
struct Instruction {
  Mnemonic mnemonic = Mnemonic::ret;
  std::array<Operand, 3> operands{};
  Directive directive = Directive::none;
  Condition condition = Condition::none;
  /// The name of the procedure or label at this row, or null.
  const char* label = nullptr;
  /// Whether `label` is that of a procedure.
  bool is_procedure = false;
};

}  // namespace x86model
