/// @file
/// The instructions of the listings as tables: one row for each mnemonic, and one for each of its
/// encodings. clock_rows.hpp has their clocks, execute.hpp their meaning and flags.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>

#include "x86model/clocks.hpp"
#include "x86model/instruction.hpp"

namespace x86model {

struct MnemonicRow {
  Mnemonic mnemonic;
  std::string_view name;
  /// The instructions with the same operands that a programmer may write in its place; see
  /// mutants.hpp. The rest of the array repeats the mnemonic itself.
  std::array<Mnemonic, 3> confused_with;

  constexpr MnemonicRow(Mnemonic m, std::string_view text, std::initializer_list<Mnemonic> others)
      : mnemonic(m), name(text), confused_with{m, m, m} {
    std::size_t i = 0;
    for (const Mnemonic other : others) confused_with[i++] = other;
  }
};

/// In the order of Mnemonic.
inline constexpr auto mnemonic_rows = [] {
  using enum Mnemonic;
  return std::to_array<MnemonicRow>({
      {mov, "mov", {add}},
      {push, "push", {pop}},
      {pop, "pop", {push}},
      {add, "add", {adc, sub, and_}},
      {adc, "adc", {add, sbb}},
      {sub, "sub", {sbb, add, cmp}},
      {sbb, "sbb", {sub, adc}},
      {cmp, "cmp", {sub, add, and_}},
      {neg, "neg", {inc, dec}},
      {inc, "inc", {dec, neg}},
      {dec, "dec", {inc, neg}},
      {mul, "mul", {imul, div}},
      {imul, "imul", {mul, idiv}},
      {div, "div", {idiv, mul}},
      {idiv, "idiv", {div, imul}},
      {and_, "and", {xor_, add}},
      {xor_, "xor", {and_, add}},
      {shl, "shl", {shr, rol}},
      {shr, "shr", {sar, shl}},
      {sar, "sar", {shr, shl}},
      {rol, "rol", {shl, shr}},
      {shld, "shld", {shrd}},
      {shrd, "shrd", {shld}},
      {stosb, "stosb", {stosw}},
      {stosw, "stosw", {stosb}},
      {jmp, "jmp", {}},
      {js, "js", {jns}},
      {jns, "jns", {js}},
      {jz, "jz", {js, jns}},
      {jnz, "jnz", {jz, loop}},
      {ja, "ja", {jg}},
      {jg, "jg", {ja, jns}},
      {loop, "loop", {jnz}},
      {call, "call", {}},
      {ret, "ret", {}},
  });
}();
static_assert(mnemonic_rows.size() == mnemonic_count);
static_assert([] {
  for (std::size_t i = 0; i < mnemonic_rows.size(); ++i) {
    if (static_cast<std::size_t>(mnemonic_rows[i].mnemonic) != i) return false;
  }
  return true;
}());

/// The operands of an encoding in their order, in the terms of Intel's manuals. `r/m` is a register
/// or memory in a ModR/M byte, `a` the accumulator, `r` a register.
enum class Encoded : std::uint8_t {
  nothing,
  rm_r,
  r_rm,
  rm_r_count,  ///< a doubleword or a word; the count is a byte
  rm,
  rm_of_words,  ///< the same, but not for bytes
  rm_1,         ///< a shift by one
  rm_count,     ///< a shift by a byte
  rm_imm8,      ///< a byte, sign-extended to a word or doubleword
  rm_imm,
  a_imm,
  a_offset,  ///< memory at a displacement without a ModR/M byte
  offset_a,
  r,  ///< in the opcode
  rel8,
  rel16,
};

struct EncodingRow {
  Mnemonic mnemonic;
  /// If has_bytes(operands), the even opcode is for bytes, and the next one for words and
  /// doublewords.
  std::uint8_t opcode;
  Encoded operands;
  std::uint8_t digit = 0;  ///< `/digit`: the middle bits of a ModR/M byte that names no register
  Cpu since = Cpu::i8088;
  bool follows_0f = false;  ///< the opcode is the second byte, after 0Fh
};

/// Whether bit 0 of the opcode selects bytes or words.
constexpr bool has_bytes(Encoded e) {
  using enum Encoded;
  return e == rm_r || e == r_rm || e == rm || e == rm_1 || e == rm_count || e == rm_imm ||
         e == a_imm || e == a_offset || e == offset_a;
}
constexpr bool has_mod_rm(Encoded e) { return e >= Encoded::rm_r && e <= Encoded::rm_imm; }
/// Whether the middle bits of the ModR/M byte belong to the opcode.
constexpr bool has_digit(Encoded e) { return e >= Encoded::rm && e <= Encoded::rm_imm; }

/// From the iAPX 86,88 User's Manual, table 4-14, the iAPX 286 Programmer's Reference Manual,
/// appendix B, and the 80386 Programmer's Reference Manual, appendix A. The first has 83 /4 and 83
/// /6 as not used; captured states show that an 8086 executes them. Of two encodings of equal
/// length, the one that NASM chooses comes first.
inline constexpr auto encoding_rows = [] {
  using enum Mnemonic;
  using enum Encoded;
  return std::to_array<EncodingRow>({
      {mov, 0x88, rm_r},
      {mov, 0x8A, r_rm},
      {mov, 0xA0, a_offset},
      {mov, 0xA2, offset_a},
      {push, 0x50, r},
      {push, 0xFF, rm_of_words, 6},
      {pop, 0x58, r},
      {pop, 0x8F, rm_of_words, 0},
      // The eight operations of these five encodings differ in the same three bits.
      {add, 0x00, rm_r},
      {add, 0x02, r_rm},
      {add, 0x83, rm_imm8, 0},
      {add, 0x04, a_imm},
      {add, 0x80, rm_imm, 0},
      {adc, 0x10, rm_r},
      {adc, 0x12, r_rm},
      {adc, 0x83, rm_imm8, 2},
      {adc, 0x14, a_imm},
      {adc, 0x80, rm_imm, 2},
      {sbb, 0x18, rm_r},
      {sbb, 0x1A, r_rm},
      {sbb, 0x83, rm_imm8, 3},
      {sbb, 0x1C, a_imm},
      {sbb, 0x80, rm_imm, 3},
      {and_, 0x20, rm_r},
      {and_, 0x22, r_rm},
      {and_, 0x83, rm_imm8, 4},
      {and_, 0x24, a_imm},
      {and_, 0x80, rm_imm, 4},
      {sub, 0x28, rm_r},
      {sub, 0x2A, r_rm},
      {sub, 0x83, rm_imm8, 5},
      {sub, 0x2C, a_imm},
      {sub, 0x80, rm_imm, 5},
      {xor_, 0x30, rm_r},
      {xor_, 0x32, r_rm},
      {xor_, 0x83, rm_imm8, 6},
      {xor_, 0x34, a_imm},
      {xor_, 0x80, rm_imm, 6},
      {cmp, 0x38, rm_r},
      {cmp, 0x3A, r_rm},
      {cmp, 0x83, rm_imm8, 7},
      {cmp, 0x3C, a_imm},
      {cmp, 0x80, rm_imm, 7},
      {inc, 0x40, r},
      {inc, 0xFE, rm, 0},
      {dec, 0x48, r},
      {dec, 0xFE, rm, 1},
      {neg, 0xF6, rm, 3},
      {mul, 0xF6, rm, 4},
      {imul, 0xF6, rm, 5},
      {div, 0xF6, rm, 6},
      {idiv, 0xF6, rm, 7},
      {rol, 0xD0, rm_1, 0},
      {rol, 0xC0, rm_count, 0, Cpu::i286},
      {shl, 0xD0, rm_1, 4},
      {shl, 0xC0, rm_count, 4, Cpu::i286},
      {shr, 0xD0, rm_1, 5},
      {shr, 0xC0, rm_count, 5, Cpu::i286},
      {sar, 0xD0, rm_1, 7},
      {sar, 0xC0, rm_count, 7, Cpu::i286},
      {shld, 0xA4, rm_r_count, 0, Cpu::i386, true},
      {shrd, 0xAC, rm_r_count, 0, Cpu::i386, true},
      {stosb, 0xAA, nothing},
      {stosw, 0xAB, nothing},
      {jz, 0x74, rel8},
      {jnz, 0x75, rel8},
      {ja, 0x77, rel8},
      {js, 0x78, rel8},
      {jns, 0x79, rel8},
      {jg, 0x7F, rel8},
      {loop, 0xE2, rel8},
      {jmp, 0xEB, rel8},
      {jmp, 0xE9, rel16},
      {jmp, 0xFF, rm_of_words, 4},
      {call, 0xE8, rel16},
      {ret, 0xC3, nothing},
  });
}();

/// The rows of a mnemonic, which stand together.
constexpr std::span<const EncodingRow> encodings_of(Mnemonic mnemonic) {
  // Where the rows of each mnemonic begin, and how many there are.
  constexpr auto places = [] {
    std::array<std::array<std::size_t, 2>, mnemonic_count> all{};
    for (std::size_t i = encoding_rows.size(); i-- > 0;) {
      auto& [first, count] = all[static_cast<std::size_t>(encoding_rows[i].mnemonic)];
      count = first == i + 1 ? count + 1 : 1;
      first = i;
    }
    return all;
  }();
  const auto& [first, count] = places.at(static_cast<std::size_t>(mnemonic));
  return std::span(encoding_rows).subspan(first, count);
}
static_assert(
    [] {
      std::size_t count = 0;
      for (const MnemonicRow& row : mnemonic_rows) count += encodings_of(row.mnemonic).size();
      return count == encoding_rows.size();
    }(),
    "the rows of a mnemonic stand together");

}  // namespace x86model
