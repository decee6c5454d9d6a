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

/// The bytes of hex digits with single spaces between.
Bytes hex(const std::string& text) {
  Bytes bytes;
  for (std::size_t at = 0; at < text.size(); at += 3) {
    bytes.push_back(byte(std::stoi(text.substr(at, 2), nullptr, 16)));
  }
  return bytes;
}

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
  for (const std::string bytes :
       {"01 07", "03 47 01", "81 06 00 00 01 02", "83 07 01", "89 87", "8B 07", "A1 00 00",
        "A3 00 00", "D1 27", "F7 37", "FF 07", "50", "5F", "8F C0", "FF F0", "FF 37"}) {
    expect_both(hex(bytes), "memory operand");
  }
  EXPECT_EQ(decoded({0x0F, 0xA4, 0x07, 1}, Target::i386), "memory operand");
}

TEST(Decode, WhatNoRoutineHas) {
  for (const std::string bytes :
       {"09 C8", "0D 00 00", "83 C8 01", "06",          "27",          "3F",
        "84 C0", "87 C8",    "8E D8",    "90",          "98",          "9C",
        "A4",    "A9 00 00", "B8 01 00", "C4 07",       "C7 C0 01 00", "C7 C8 01 00",
        "D4 0A", "E4 00",    "F4",       "F7 C0 01 00", "F7 D0",       "F8",
        "FE D0", "FF F8",    "0F AF C0", "0F A5 C2",    "31 C0"}) {
    expect_both(hex(bytes), "not modelled");
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
