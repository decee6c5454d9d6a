/// @file
/// The notation of the listings: `mov(ax, word[bp + 4])`.
///
/// Every function only builds a row. Displacements and `bytes()` are written for 16-bit machine
/// words and scale with the width of the machine.
#pragma once

#include "x86model/instruction.hpp"

namespace x86model::notation {

constexpr Operand register_operand(Register r, Size size) {
  return {.kind = Operand::Kind::reg, .size = size, .reg = r};
}

inline constexpr Operand ax = register_operand(Register::ax, Size::word);
inline constexpr Operand bx = register_operand(Register::bx, Size::word);
inline constexpr Operand cx = register_operand(Register::cx, Size::word);
inline constexpr Operand dx = register_operand(Register::dx, Size::word);
inline constexpr Operand sp = register_operand(Register::sp, Size::word);
inline constexpr Operand bp = register_operand(Register::bp, Size::word);
inline constexpr Operand si = register_operand(Register::si, Size::word);
inline constexpr Operand di = register_operand(Register::di, Size::word);
inline constexpr Operand eax = register_operand(Register::ax, Size::dword);
inline constexpr Operand ebx = register_operand(Register::bx, Size::dword);
inline constexpr Operand ecx = register_operand(Register::cx, Size::dword);
inline constexpr Operand edx = register_operand(Register::dx, Size::dword);
inline constexpr Operand ebp = register_operand(Register::bp, Size::dword);
inline constexpr Operand esi = register_operand(Register::si, Size::dword);
inline constexpr Operand edi = register_operand(Register::di, Size::dword);
// AH and DH have the numbers of SP and SI; see Size.
inline constexpr Operand al = register_operand(Register::ax, Size::byte);
inline constexpr Operand bl = register_operand(Register::bx, Size::byte);
inline constexpr Operand ah = register_operand(Register::sp, Size::byte);
inline constexpr Operand dh = register_operand(Register::si, Size::byte);

/// The address of a memory operand: base or index register, named place and displacement.
struct Address {
  Register base = Register::ax;
  Symbol symbol = Symbol::none;
  std::int32_t displacement = 0;
  Addressing addressing = Addressing::base;
  SegmentOverride segment = SegmentOverride::none;

  // Allows a bare base register as an address: word[di].
  constexpr Address(Operand r)  // NOLINT(google-explicit-constructor)
      : base(r.reg), addressing(r.size == Size::dword ? Addressing::index : Addressing::base) {}
  // Allows a bare name as an address: dword[IncJ].
  constexpr Address(Symbol s)  // NOLINT(google-explicit-constructor)
      : symbol(s), addressing(Addressing::direct) {}
  constexpr Address(Register r, Symbol s, std::int32_t d, Addressing a = Addressing::base)
      : base(r), symbol(s), displacement(d), addressing(a) {}
};

constexpr Address operator+(Address a, int displacement) {
  a.displacement += displacement;
  return a;
}
constexpr Address operator+(Symbol s, Address a) {
  a.symbol = s;
  return a;
}
/// An address in the code segment: CS:[CosTable + BX].
constexpr Address cs(Address a) {
  a.segment = SegmentOverride::cs;
  return a;
}
/// Twice a 32-bit register: ZBuff + twice(edi).
constexpr Address twice(Operand r) { return {r.reg, Symbol::none, 0, Addressing::index_twice}; }

inline constexpr Symbol CosTable = Symbol::cos_table;
inline constexpr Symbol IncJ = Symbol::inc_j;
inline constexpr Symbol Texture = Symbol::texture;
inline constexpr Symbol Screen = Symbol::screen;
inline constexpr Symbol ZBuff = Symbol::z_buff;

template <Size size>
struct Memory {
  constexpr Operand operator[](Address a) const {
    return {.kind = Operand::Kind::memory,
            .size = size,
            .scaling = Scaling::bytes,
            .symbol = a.symbol,
            .addressing = a.addressing,
            .segment = a.segment,
            .reg = a.base,
            .value = a.displacement};
  }
};
inline constexpr Memory<Size::byte> byte;
inline constexpr Memory<Size::word> word;
inline constexpr Memory<Size::dword> dword;

/// An immediate: a number, or one of the width-dependent constants below.
struct Immediate {
  Operand operand;
  constexpr Immediate(int value)  // NOLINT(google-explicit-constructor)
      : operand{.kind = Operand::Kind::immediate, .value = value} {}
  constexpr explicit Immediate(Scaling scaling, int value = 0)
      : operand{.kind = Operand::Kind::immediate, .scaling = scaling, .value = value} {}
};
inline constexpr Immediate half_unit{Scaling::half_unit};
inline constexpr Immediate word_bits{Scaling::word_bits};
constexpr Immediate bytes(int count) { return Immediate{Scaling::bytes, count}; }

constexpr Instruction row(Mnemonic m, Operand a = {}, Operand b = {}, Operand c = {}) {
  return {.mnemonic = m, .operands = {a, b, c}};
}
constexpr Instruction row(Mnemonic m, Operand a, Immediate i) { return row(m, a, i.operand); }
constexpr Instruction jump(Mnemonic m, const char* target) {
  return row(m, {.kind = Operand::Kind::label, .name = target});
}
/// A jump with a word displacement, for a target more than 127 bytes ahead.
constexpr Instruction jmp_near(const char* target) {
  return row(Mnemonic::jmp, {.kind = Operand::Kind::label, .size = Size::word, .name = target});
}

constexpr Instruction mov(Operand to, Operand from) { return row(Mnemonic::mov, to, from); }
constexpr Instruction push(Operand a) { return row(Mnemonic::push, a); }
constexpr Instruction pop(Operand a) { return row(Mnemonic::pop, a); }
constexpr Instruction add(Operand a, Operand b) { return row(Mnemonic::add, a, b); }
constexpr Instruction add(Operand a, Immediate b) { return row(Mnemonic::add, a, b); }
constexpr Instruction adc(Operand a, Operand b) { return row(Mnemonic::adc, a, b); }
constexpr Instruction adc(Operand a, Immediate b) { return row(Mnemonic::adc, a, b); }
constexpr Instruction sub(Operand a, Operand b) { return row(Mnemonic::sub, a, b); }
constexpr Instruction sub(Operand a, Immediate b) { return row(Mnemonic::sub, a, b); }
constexpr Instruction sbb(Operand a, Immediate b) { return row(Mnemonic::sbb, a, b); }
constexpr Instruction cmp(Operand a, Operand b) { return row(Mnemonic::cmp, a, b); }
constexpr Instruction cmp(Operand a, Immediate b) { return row(Mnemonic::cmp, a, b); }
constexpr Instruction neg(Operand a) { return row(Mnemonic::neg, a); }
constexpr Instruction inc(Operand a) { return row(Mnemonic::inc, a); }
constexpr Instruction dec(Operand a) { return row(Mnemonic::dec, a); }
constexpr Instruction mul(Operand a) { return row(Mnemonic::mul, a); }
constexpr Instruction imul(Operand a) { return row(Mnemonic::imul, a); }
constexpr Instruction div(Operand a) { return row(Mnemonic::div, a); }
constexpr Instruction idiv(Operand a) { return row(Mnemonic::idiv, a); }
constexpr Instruction and_(Operand a, Operand b) { return row(Mnemonic::and_, a, b); }
constexpr Instruction xor_(Operand a, Immediate b) { return row(Mnemonic::xor_, a, b); }
constexpr Instruction shl(Operand a, Immediate n) { return row(Mnemonic::shl, a, n); }
constexpr Instruction shr(Operand a, Immediate n) { return row(Mnemonic::shr, a, n); }
constexpr Instruction sar(Operand a, Immediate n) { return row(Mnemonic::sar, a, n); }
constexpr Instruction rol(Operand a, Immediate n) { return row(Mnemonic::rol, a, n); }
constexpr Instruction shld(Operand a, Operand b, Immediate n) {
  return row(Mnemonic::shld, a, b, n.operand);
}
constexpr Instruction shrd(Operand a, Operand b, Immediate n) {
  return row(Mnemonic::shrd, a, b, n.operand);
}
constexpr Instruction stosb() { return row(Mnemonic::stosb); }
constexpr Instruction stosw() { return row(Mnemonic::stosw); }
/// A jump to an offset in a register; see code_address.
constexpr Instruction jmp(Operand to) { return row(Mnemonic::jmp, to); }
constexpr Instruction jmp(const char* to) { return jump(Mnemonic::jmp, to); }
constexpr Instruction js(const char* to) { return jump(Mnemonic::js, to); }
constexpr Instruction jns(const char* to) { return jump(Mnemonic::jns, to); }
constexpr Instruction jz(const char* to) { return jump(Mnemonic::jz, to); }
constexpr Instruction jnz(const char* to) { return jump(Mnemonic::jnz, to); }
constexpr Instruction ja(const char* to) { return jump(Mnemonic::ja, to); }
constexpr Instruction jg(const char* to) { return jump(Mnemonic::jg, to); }
constexpr Instruction loop(const char* to) { return jump(Mnemonic::loop, to); }
constexpr Instruction call(const char* procedure) { return jump(Mnemonic::call, procedure); }
constexpr Instruction ret() { return row(Mnemonic::ret); }

constexpr Instruction proc(const char* name) {
  return {.directive = Directive::procedure, .label = name, .is_procedure = true};
}
constexpr Instruction label(const char* name) {
  return {.directive = Directive::label, .label = name};
}
constexpr Instruction if_(Condition c) { return {.directive = Directive::if_, .condition = c}; }
constexpr Instruction else_() { return {.directive = Directive::else_}; }
constexpr Instruction endif() { return {.directive = Directive::endif}; }

inline constexpr Condition mul_rounding_on = Condition::mul_rounding;
inline constexpr Condition div_rounding_on = Condition::div_rounding;
inline constexpr Condition chapter_52 = Condition::chapter_52;
inline constexpr Condition endif_as_scanned = Condition::endif_as_scanned;
inline constexpr Condition repaired = Condition::repaired;
inline constexpr Condition shl_as_printed = Condition::shl_as_printed;

}  // namespace x86model::notation
