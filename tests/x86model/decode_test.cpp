// The captured cases of tests/verify/vectors show that the processor decodes the encodings that are
// run in the same way.
#include "x86model/decode.hpp"

#include <fmt/format.h>

#include "tests/support/test.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "x86model/encoding.hpp"
#include "x86model/forms.hpp"
#include "x86model/loop.hpp"
#include "x86model/text.hpp"

namespace {

using Bytes = std::vector<std::uint8_t>;
using x86model::Cpu;

std::uint8_t to_byte(int value) { return static_cast<std::uint8_t>(value); }

/// The instruction as text followed by its length, or the reason to skip it.
std::string decoded(const Bytes& bytes, Cpu cpu) {
  const auto result = x86model::decode(bytes, cpu);
  if (const auto* reason = std::get_if<x86model::Undecoded>(&result)) {
    constexpr std::array names{"cut off", "prefix", "form", "addressing"};
    return names.at(static_cast<std::size_t>(*reason));
  }
  const auto& [instruction, length] = std::get<x86model::Decoded>(result);
  return fmt::format("{}; {}", x86model::text_of(instruction), length);
}

constexpr std::string_view no_prefix = "prefix";
constexpr std::string_view no_form = "form";
constexpr std::string_view no_addressing = "addressing";

void expect_all(const Bytes& bytes, std::string_view text) {
  EXPECT_EQ(decoded(bytes, Cpu::i8088), text);
  EXPECT_EQ(decoded(bytes, Cpu::i286), text);
  EXPECT_EQ(decoded(bytes, Cpu::i386), text);
}

void expect_each(const Bytes& bytes, std::string_view of_8088, std::string_view of_286,
                 std::string_view of_386) {
  EXPECT_EQ(decoded(bytes, Cpu::i8088), of_8088);
  EXPECT_EQ(decoded(bytes, Cpu::i286), of_286);
  EXPECT_EQ(decoded(bytes, Cpu::i386), of_386);
}

TEST(Decode, OperandsStandInTheirOrder) {
  expect_all({0x01, 0xC8}, "add ax, cx; 2");
  expect_all({0x03, 0xC8}, "add cx, ax; 2");
  expect_all({0x89, 0xE5}, "mov bp, sp; 2");
  expect_all({0x8B, 0xFE}, "mov di, si; 2");
  expect_all({0x88, 0xE0}, "mov al, ah; 2");
  expect_all({0x8A, 0xD6}, "mov dl, dh; 2");
  expect_all({0x88, 0xC7}, "mov bh, al; 2");
}

TEST(Decode, ImmediatesOfEachWidth) {
  expect_all({0x3D, 0x34, 0x92}, "cmp ax, 37428; 3");
  expect_all({0x81, 0xEB, 0x01, 0x80}, "sub bx, 32769; 4");
  expect_all({0x83, 0xDA, 0x7F}, "sbb dx, 127; 3");
  expect_all({0x83, 0xF2, 0x80}, "xor dx, -128; 3");
  EXPECT_EQ(decoded({0x66, 0x05, 1, 2, 3, 4}, Cpu::i386), "add eax, 67305985; 6");
  EXPECT_EQ(decoded({0x66, 0x83, 0xC6, 0xFF}, Cpu::i386), "add esi, -1; 4");
}

TEST(Decode, OneOperand) {
  expect_all({0x43}, "inc bx; 1");
  expect_all({0x4F}, "dec di; 1");
  expect_all({0xFF, 0xC9}, "dec cx; 2");
  expect_all({0xF7, 0xDA}, "neg dx; 2");
  expect_all({0xF7, 0xE3}, "mul bx; 2");
  expect_all({0xF7, 0xF6}, "div si; 2");
  EXPECT_EQ(decoded({0x66, 0xF7, 0xFB}, Cpu::i386), "idiv ebx; 3");
  expect_all({0xF7, 0xFB}, no_form);
}

TEST(Decode, Shifts) {
  expect_all({0xD1, 0xE3}, "shl bx, 1; 2");
  expect_all({0xD1, 0xEB}, "shr bx, 1; 2");
  expect_each({0xC1, 0xE3, 0x82}, no_form, "shl bx, 130; 3", "shl bx, 130; 3");
  EXPECT_EQ(decoded({0x66, 0xC1, 0xC0, 0x10}, Cpu::i386), "rol eax, 16; 4");
  EXPECT_EQ(decoded({0x66, 0x0F, 0xA4, 0xC2, 0x10}, Cpu::i386), "shld edx, eax, 16; 5");
  EXPECT_EQ(decoded({0x66, 0x0F, 0xAC, 0xD0, 0x10}, Cpu::i386), "shrd eax, edx, 16; 5");
  for (const int modrm : {0xCB, 0xD3, 0xDB, 0xF3}) {  // ROR, RCL, RCR, /6
    expect_all({0xD1, to_byte(modrm)}, no_form);
  }
  expect_all({0xD3, 0xE3}, no_form);
}

TEST(Decode, Prefixes) {
  for (const int other : {0x26, 0x36, 0x3E, 0xF0, 0xF2, 0xF3}) {
    expect_all({to_byte(other), 0x8B, 0x07}, no_prefix);
  }
  expect_each({0xF1, 0x01, 0xC8}, no_prefix, no_form, no_form);
  expect_each({0x64, 0x8B, 0x07}, no_form, no_form, no_prefix);
  expect_all({0x2E, 0x8B, 0x07}, "mov ax, [cs:bx]; 3");
  expect_all({0x2E, 0x01, 0xC8}, no_prefix);
  expect_all({0x2E, 0x50}, no_prefix);
  expect_all({0x2E, 0x2E, 0x8B, 0x07}, no_prefix);
  expect_each({0x66, 0x01, 0xC8}, no_form, no_form, "add eax, ecx; 3");
  expect_each({0x66, 0x66, 0x01, 0xC8}, no_form, no_form, no_prefix);
  expect_each({0x67, 0x01, 0xC8}, no_form, no_form, no_prefix);
  expect_each({0x66, 0xE8, 0, 0}, no_form, no_form, no_prefix);
  expect_each({0x66, 0x2E, 0x8B, 0x17}, no_form, no_form, "mov edx, [cs:bx]; 4");
  expect_each({0x2E, 0x66, 0x8B, 0x17}, no_form, no_form, "mov edx, [cs:bx]; 4");
}

TEST(Decode, ControlFlow) {
  const auto jump = [](const Bytes& bytes) {
    const auto result = x86model::decode(bytes, Cpu::i8088);
    const auto& whole = std::get<x86model::Decoded>(result);
    EXPECT_EQ(whole.length, bytes.size());
    return fmt::format("{} {}", x86model::name_of(whole.instruction.mnemonic),
                       whole.instruction.operands[0].value);
  };
  EXPECT_EQ(jump({0x74, 0x05}), "jz 5");
  EXPECT_EQ(jump({0x75, 0xFE}), "jnz -2");
  EXPECT_EQ(jump({0x77, 0x80}), "ja -128");
  EXPECT_EQ(jump({0x78, 0x7F}), "js 127");
  EXPECT_EQ(jump({0x79, 0x00}), "jns 0");
  EXPECT_EQ(jump({0x7F, 0x01}), "jg 1");
  EXPECT_EQ(jump({0xE2, 0xF0}), "loop -16");
  EXPECT_EQ(jump({0xEB, 0x10}), "jmp 16");
  EXPECT_EQ(jump({0xE9, 0x00, 0x80}), "jmp -32768");
  EXPECT_EQ(jump({0xE8, 0x34, 0x12}), "call 4660");
  EXPECT_EQ(jump({0xC3}), "ret 0");
  expect_all({0xFF, 0xE3}, "jmp bx; 2");
  for (const int opcode :
       {0x70, 0x7E, 0x9A, 0xC2, 0xCA, 0xCB, 0xCC, 0xCD, 0xCE, 0xCF, 0xE0, 0xE1, 0xE3, 0xEA}) {
    expect_all({to_byte(opcode), 0}, no_form);
  }
  for (const int modrm : {0xD0, 0xD8, 0xE8}) expect_all({0xFF, to_byte(modrm)}, no_form);
  // An 8088 executes these as jumps and returns; its manual does not have them.
  for (const int opcode : {0x64, 0x78 - 0x10, 0xC0, 0xC1, 0xC8, 0xC9}) {
    EXPECT_EQ(decoded({to_byte(opcode), 0xE0, 1, 0}, Cpu::i8088), no_form);
  }
  expect_all({0x0F, 0x84, 0, 0}, no_form);
}

TEST(Decode, Memory) {
  expect_all({0x8B, 0x44, 0xFE}, "mov ax, [si-2]; 3");
  expect_all({0x89, 0x8D, 0x34, 0x12}, "mov [di+4660], cx; 4");
  expect_all({0x03, 0x56, 0x08}, "add dx, [bp+8]; 3");
  expect_all({0xF7, 0x37}, "div word [bx]; 2");
  expect_all({0xA1, 0x34, 0x12}, "mov ax, [4660]; 3");
  expect_all({0xA3, 0x34, 0x12}, "mov [4660], ax; 3");
  expect_all({0x8B, 0x1E, 0x34, 0x92}, "mov bx, [37428]; 4");
  for (const int modrm : {0x00, 0x41, 0x82, 0x03}) {
    expect_all({0x8B, to_byte(modrm), 0, 0}, no_addressing);
  }
  EXPECT_EQ(decoded({0x67, 0x66, 0x89, 0x87, 0, 1, 0, 0}, Cpu::i386), "mov [edi+256], eax; 8");
  EXPECT_EQ(decoded({0x67, 0x3B, 0x1C, 0x7D, 0, 5, 0, 0}, Cpu::i386),
            "cmp bx, [nosplit edi*2+1280]; 8");
  EXPECT_EQ(decoded({0x67, 0x8B, 0x05, 0, 0, 0, 0}, Cpu::i386), no_addressing);
  EXPECT_EQ(decoded({0x67, 0x8B, 0x04, 0x3D, 0, 0, 0, 0}, Cpu::i386), no_addressing);
  EXPECT_EQ(decoded({0x67, 0xA1, 0, 0, 0, 0}, Cpu::i386), no_addressing);
}

TEST(Decode, Stack) {
  expect_all({0x55}, "push bp; 1");
  expect_all({0x5F}, "pop di; 1");
  expect_all({0xFF, 0x74, 0x04}, "push word [si+4]; 3");
  expect_all({0x8F, 0x07}, "pop word [bx]; 2");
  expect_all({0x8F, 0xC8}, no_form);
  // An 8088 stores SP minus 2.
  expect_each({0x54}, no_form, "push sp; 1", "push sp; 1");
}

TEST(Decode, Bytes) {
  expect_all({0x8A, 0x87, 0x00, 0x01}, "mov al, [bx+256]; 4");
  expect_all({0x88, 0x05}, "mov [di], al; 2");
  expect_all({0xA0, 0x00, 0x01}, "mov al, [256]; 3");
  expect_all({0xAA}, "stosb; 1");
  expect_all({0xAB}, "stosw; 1");
  for (const int opcode : {0x00, 0x02, 0x04, 0x80, 0x82, 0xB0, 0xC6, 0xD0, 0xF6, 0xFE}) {
    expect_all({to_byte(opcode), 0xC0, 1}, no_form);
    expect_all({to_byte(opcode), 0x07, 1}, no_form);
  }
}

/// What the build assembles from each listing is decoded to the listing, instruction by
/// instruction, so no form, addressing mode or prefix of a listing is skipped.
void expect_listing(std::span<const std::uint8_t> code,
                    std::span<const x86model::Instruction> listing, Cpu cpu) {
  for (const x86model::Instruction& expected : listing) {
    const auto result = x86model::decode(code, cpu);
    ASSERT_TRUE(std::holds_alternative<x86model::Decoded>(result)) << x86model::text_of(expected);
    const auto& [instruction, length] = std::get<x86model::Decoded>(result);
    EXPECT_EQ(x86model::name_of(instruction.mnemonic), x86model::name_of(expected.mnemonic));
    EXPECT_EQ(length, static_cast<std::size_t>(x86model::encoding_of(expected).bytes()));
    EXPECT_EQ(x86model::form_text(instruction), x86model::form_text(expected));
    for (std::size_t i = 0; i < expected.operands.size(); ++i) {
      const x86model::Operand& a = instruction.operands.at(i);
      const x86model::Operand& b = expected.operands.at(i);
      EXPECT_EQ(a.addressing, b.addressing) << x86model::text_of(expected);
      EXPECT_EQ(a.segment, b.segment) << x86model::text_of(expected);
      if (b.addressing != x86model::Addressing::direct) {
        EXPECT_EQ(a.reg, b.reg) << x86model::text_of(expected);
      }
    }
    code = code.subspan(length);
  }
}

TEST(Decode, EveryInstructionOfTheListings) {
  for (const fixproof::machine_code::ProgramKey& key : fixproof::machine_code::all_programs()) {
    const auto code = fixproof::machine_code::machine_code(key);
    if (code.empty()) GTEST_SKIP() << fixproof::machine_code::machine_code_absence();
    const x86model::Program program = assemble(listing(key.routine, key.target), key.build);
    const bool i386 = key.target == x86model::Target::i386;
    if (!key.build.shl_as_printed || i386) {
      expect_listing(code, program.instructions(), i386 ? Cpu::i386 : Cpu::i8088);
    }
    if (!i386) expect_listing(code, program.instructions(), Cpu::i286);
  }
  for (const x86model::LoopForm& form_of_loop : x86model::all_loop_forms()) {
    const bool i386 = form_of_loop.target == x86model::Target::i386;
    expect_listing(fixproof::machine_code::machine_code(form_of_loop),
                   x86model::code_of(form_of_loop), i386 ? Cpu::i386 : Cpu::i8088);
  }
}

TEST(Decode, WhatNoListingHas) {
  for (const Bytes& bytes : {Bytes{0x09, 0xC8},
                             {0x0D, 0, 0},
                             {0x83, 0xC8, 1},
                             {0x06},
                             {0x27},
                             {0x3F},
                             {0x84, 0xC0},
                             {0x87, 0xC8},
                             {0x8E, 0xD8},
                             {0x90},
                             {0x98},
                             {0x9C},
                             {0xA4},
                             {0xA9, 0, 0},
                             {0xB8, 1, 0},
                             {0xC4, 0x07},
                             {0xC7, 0xC0, 1, 0},
                             {0xC7, 0xC8, 1, 0},
                             {0xD4, 10},
                             {0xE4, 0},
                             {0xF4},
                             {0xF7, 0xC0, 1, 0},
                             {0xF7, 0xD0},
                             {0xF8},
                             {0xFE, 0xD0},
                             {0xFF, 0xF8},
                             {0x0F, 0xAF, 0xC0},
                             {0x0F, 0xA5, 0xC2},
                             {0x31, 0xC0}}) {
    expect_all(bytes, no_form);
  }
}

TEST(Decode, EveryEndInsideIsRefused) {
  for (const Bytes& whole : {Bytes{0x66, 0x81, 0xC0, 1, 2, 3, 4},
                             {0x66, 0x0F, 0xA4, 0xC2, 1},
                             {0xC1, 0xE3, 2},
                             {0x3D, 1, 2},
                             {0xF7, 0xE3}}) {
    EXPECT_EQ(decoded(whole, Cpu::i386).find("cut off"), std::string::npos);
    for (std::size_t length = 0; length < whole.size(); ++length) {
      EXPECT_EQ(
          decoded({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)}, Cpu::i386),
          "cut off");
    }
  }
}

}  // namespace
