// Tests the decoder of --singlestep. The committed cases show that the processor decodes the
// encodings that are run in the same way.
#include "singlestep/decode.hpp"

#include <fmt/format.h>

#include "support/usage_error.hpp"
#include "tests/support/test.hpp"
#include "x86model/text.hpp"

namespace {

namespace ss = fixproof::singlestep;
using Bytes = std::vector<std::uint8_t>;
using x86model::Target;

std::uint8_t byte(int value) { return static_cast<std::uint8_t>(value); }

/// The instruction as text followed by its length, or the reason to skip it.
std::string decoded(const Bytes& bytes, Target cpu) {
  const auto result = ss::decode(bytes, cpu);
  if (const auto* reason = std::get_if<ss::Skip>(&result)) return std::string(ss::name_of(*reason));
  const auto& [instruction, length] = std::get<ss::Decoded>(result);
  return fmt::format("{}; {}", x86model::text_of(instruction), length);
}

void expect_both(const Bytes& bytes, std::string_view text) {
  EXPECT_EQ(decoded(bytes, Target::i8088), text);
  EXPECT_EQ(decoded(bytes, Target::i386), text);
}

void expect_each(const Bytes& bytes, std::string_view of_8088, std::string_view of_386) {
  EXPECT_EQ(decoded(bytes, Target::i8088), of_8088);
  EXPECT_EQ(decoded(bytes, Target::i386), of_386);
}

TEST(Decode, OperandsStandInTheirOrder) {
  expect_both({0x01, 0xC8}, "add ax, cx; 2");
  expect_both({0x03, 0xC8}, "add cx, ax; 2");
  expect_both({0x89, 0xE5}, "mov bp, sp; 2");
  expect_both({0x8B, 0xFE}, "mov di, si; 2");
  expect_both({0x88, 0xE0}, "mov al, ah; 2");
  expect_both({0x8A, 0xD6}, "mov dl, dh; 2");
  expect_both({0x88, 0xC7}, "mov bh, al; 2");
}

TEST(Decode, ImmediatesOfEachWidth) {
  expect_both({0x3D, 0x34, 0x92}, "cmp ax, 37428; 3");
  expect_both({0x81, 0xEB, 0x01, 0x80}, "sub bx, 32769; 4");
  expect_both({0x83, 0xDA, 0x7F}, "sbb dx, 127; 3");
  expect_both({0x83, 0xF2, 0x80}, "xor dx, -128; 3");
  EXPECT_EQ(decoded({0x66, 0x05, 1, 2, 3, 4}, Target::i386), "add eax, 67305985; 6");
  EXPECT_EQ(decoded({0x66, 0x83, 0xC6, 0xFF}, Target::i386), "add esi, -1; 4");
}

TEST(Decode, OneOperand) {
  expect_both({0x43}, "inc bx; 1");
  expect_both({0x4F}, "dec di; 1");
  expect_both({0xFF, 0xC9}, "dec cx; 2");
  expect_both({0xF7, 0xDA}, "neg dx; 2");
  expect_both({0xF7, 0xE3}, "mul bx; 2");
  expect_both({0xF7, 0xF6}, "div si; 2");
  EXPECT_EQ(decoded({0x66, 0xF7, 0xFB}, Target::i386), "idiv ebx; 3");
  expect_both({0xF7, 0xFB}, "not modelled");
}

TEST(Decode, Shifts) {
  expect_both({0xD1, 0xE3}, "shl bx, 1; 2");
  expect_both({0xD1, 0xEB}, "shr bx, 1; 2");
  expect_each({0xC1, 0xE3, 0x82}, "control flow", "shl bx, 130; 3");
  EXPECT_EQ(decoded({0x66, 0xC1, 0xC0, 0x10}, Target::i386), "rol eax, 16; 4");
  EXPECT_EQ(decoded({0x66, 0x0F, 0xA4, 0xC2, 0x10}, Target::i386), "shld edx, eax, 16; 5");
  EXPECT_EQ(decoded({0x66, 0x0F, 0xAC, 0xD0, 0x10}, Target::i386), "shrd eax, edx, 16; 5");
  for (const int modrm : {0xCB, 0xD3, 0xDB, 0xF3}) {  // ROR, RCL, RCR, /6
    expect_both({0xD1, byte(modrm)}, "not modelled");
  }
  expect_both({0xD3, 0xE3}, "not modelled");
}

TEST(Decode, Prefixes) {
  for (const int prefix : {0x26, 0x2E, 0x36, 0x3E, 0xF0, 0xF2, 0xF3}) {
    expect_both({byte(prefix), 0x01, 0xC8}, "prefix");
  }
  expect_each({0xF1, 0x01, 0xC8}, "prefix", "not modelled");
  expect_each({0x67, 0x01, 0xC8}, "control flow", "prefix");
  expect_each({0x66, 0x01, 0xC8}, "control flow", "add eax, ecx; 3");
  expect_each({0x66, 0x66, 0x01, 0xC8}, "control flow", "prefix");
}

TEST(Decode, ControlFlow) {
  for (const int opcode : {0x70, 0x7F, 0x9A, 0xC2, 0xC3, 0xCA, 0xCB, 0xCC, 0xCD, 0xCE, 0xCF, 0xE0,
                           0xE3, 0xE8, 0xE9, 0xEA, 0xEB}) {
    expect_both({byte(opcode), 0}, "control flow");
  }
  for (const int modrm : {0xD0, 0xD8, 0xE0, 0xE8}) {
    expect_both({0xFF, byte(modrm)}, "control flow");
  }
  expect_each({0x60}, "control flow", "not modelled");
  expect_each({0xC8, 0, 0, 0}, "control flow", "not modelled");
  expect_each({0x0F, 0x84, 0, 0}, "not modelled", "control flow");
}

TEST(Decode, BytesAndMemory) {
  for (const int opcode : {0x00, 0x02, 0x04, 0x80, 0x82, 0xA0, 0xA2, 0xB0, 0xB7, 0xD0, 0xFE}) {
    // /0 with a register and with memory; D0h is ROL, FEh is INC.
    expect_both({byte(opcode), 0xC0, 1}, "8-bit operand");
    expect_both({byte(opcode), 0x07, 1}, "8-bit operand");
  }
  expect_both({0xF6, 0xE3}, "8-bit operand");
  expect_both({0x88, 0x07}, "8-bit operand");
  expect_both({0x8A, 0x07}, "8-bit operand");
  for (const Bytes& bytes : {Bytes{0x01, 0x07},
                             {0x03, 0x47, 1},
                             {0x81, 0x06, 0, 0, 1, 2},
                             {0x83, 0x07, 1},
                             {0x89, 0x87},
                             {0x8B, 0x07},
                             {0xA1, 0, 0},
                             {0xA3, 0, 0},
                             {0xD1, 0x27},
                             {0xF7, 0x37},
                             {0xFF, 0x07},
                             {0x50},
                             {0x5F},
                             {0x8F, 0xC0},
                             {0xFF, 0xF0},
                             {0xFF, 0x37}}) {
    expect_both(bytes, "memory operand");
  }
  EXPECT_EQ(decoded({0x0F, 0xA4, 0x07, 1}, Target::i386), "memory operand");
}

TEST(Decode, WhatNoRoutineHas) {
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
    expect_both(bytes, "not modelled");
  }
}

TEST(Decode, EveryEndInsideIsRefused) {
  for (const Bytes& whole : {Bytes{0x66, 0x81, 0xC0, 1, 2, 3, 4},
                             {0x66, 0x0F, 0xA4, 0xC2, 1},
                             {0xC1, 0xE3, 2},
                             {0x3D, 1, 2},
                             {0xF7, 0xE3}}) {
    EXPECT_NO_THROW(ss::decode(whole, Target::i386));
    for (std::size_t length = 0; length < whole.size(); ++length) {
      EXPECT_THROW(ss::decode(std::span(whole).first(length), Target::i386),
                   fixproof::support::UsageError);
    }
  }
}

}  // namespace
