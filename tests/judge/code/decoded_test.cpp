// What Zydis says of instructions, against Intel's Software Developer's Manual, volume 2.
#include "judge/code/decoded.hpp"

#include <fmt/format.h>

#include "tests/support/test.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "x86model/encoding.hpp"
#include "x86model/forms.hpp"
#include "x86model/loop.hpp"
#include "x86model/text.hpp"

namespace {

using fixproof::judge::decoded;
using fixproof::judge::Decoded;
using Bytes = std::vector<std::uint8_t>;

std::string letters(std::uint16_t flags) {
  std::string text;
  for (const auto& [flag, letter] :
       {std::pair{1, 'C'}, {4, 'P'}, {0x10, 'A'}, {0x40, 'Z'}, {0x80, 'S'}, {0x800, 'O'}}) {
    if ((flags & flag) != 0) text += letter;
  }
  return text.empty() ? "-" : text;
}

std::string flags_of(const Bytes& bytes) {
  const Decoded d = decoded(bytes, 0, 16);
  return fmt::format("{} {} {} {}", d.mnemonic, letters(d.flags.reads), letters(d.flags.sets),
                     letters(d.flags.leaves_undefined));
}

// The mnemonic, then the flags that it reads, defines and leaves undefined.
TEST(Decoded, FlagsAreIntels) {
  EXPECT_EQ(flags_of({0x01, 0xC8}), "add - CPAZSO -");
  EXPECT_EQ(flags_of({0x11, 0xC8}), "adc C CPAZSO -");
  EXPECT_EQ(flags_of({0x19, 0xC8}), "sbb C CPAZSO -");
  EXPECT_EQ(flags_of({0x39, 0xC8}), "cmp - CPAZSO -");
  EXPECT_EQ(flags_of({0xF7, 0xD8}), "neg - CPAZSO -");
  EXPECT_EQ(flags_of({0x40}), "inc - PAZSO -");
  EXPECT_EQ(flags_of({0x09, 0xC8}), "or - CPZSO A");
  EXPECT_EQ(flags_of({0x85, 0xC8}), "test - CPZSO A");
  EXPECT_EQ(flags_of({0xF7, 0xE3}), "mul - CO PAZS");
  EXPECT_EQ(flags_of({0xF7, 0xFB}), "idiv - - CPAZSO");
  EXPECT_EQ(flags_of({0x0F, 0xBC, 0xC1}), "bsf - Z CPASO");
  EXPECT_EQ(flags_of({0x0F, 0xA3, 0xC8}), "bt - C PASO");
  EXPECT_EQ(flags_of({0x27}), "daa CA CPAZS O");
  EXPECT_EQ(flags_of({0xF7, 0xD0}), "not - - -");
  EXPECT_EQ(flags_of({0x0F, 0x47, 0xC1}), "cmovnbe CZ - -");
  EXPECT_EQ(flags_of({0x7F, 0x00}), "jnle ZSO - -");
}

TEST(Decoded, PrivilegedInstructionsAreIntels) {
  const auto is_privileged = [](const Bytes& bytes) { return decoded(bytes, 0, 64).is_privileged; };
  const std::vector<Bytes> privileged{
      {0xFA},                    // CLI
      {0xFB},                    // STI
      {0xF4},                    // HLT
      {0x0F, 0x06},              // CLTS
      {0x0F, 0x09},              // WBINVD
      {0x0F, 0x22, 0xC0},        // MOV CR0
      {0x0F, 0x20, 0xD8},        // MOV from CR3
      {0x0F, 0x23, 0xF8},        // MOV DR7
      {0x0F, 0x30},              // WRMSR
      {0x0F, 0x32},              // RDMSR
      {0x0F, 0x01, 0xF8},        // SWAPGS
      {0x0F, 0x01, 0x14, 0x24},  // LGDT
      {0x0F, 0x01, 0x1C, 0x24},  // LIDT
      {0x0F, 0x00, 0xD8},        // LTR
  };
  for (const Bytes& bytes : privileged) EXPECT_TRUE(is_privileged(bytes)) << bytes.back();
  const std::vector<Bytes> others{
      {0x90},                          // NOP
      {0x9D},                          // POPF
      {0x0F, 0x05},                    // SYSCALL
      {0x0F, 0x31},                    // RDTSC
      {0x0F, 0xA2},                    // CPUID
      {0x0F, 0x01, 0x04, 0x24},        // SGDT
      {0x0F, 0x01, 0xD0},              // XGETBV
      {0xF3, 0x48, 0x0F, 0xAE, 0xD0},  // WRFSBASE
  };
  for (const Bytes& bytes : others) EXPECT_FALSE(is_privileged(bytes)) << bytes.back();
}

TEST(Decoded, AShiftByOneDefinesOverflow) {
  EXPECT_EQ(flags_of({0xD1, 0xE0}), "shl - CPZSO A");
  EXPECT_EQ(flags_of({0xC1, 0xE0, 0x01}), "shl - CPZSO A");
  EXPECT_EQ(flags_of({0xC1, 0xE0, 0x02}), "shl - CPZS AO");
  EXPECT_EQ(flags_of({0xD3, 0xE0}), "shl - CPZS AO");
  EXPECT_EQ(flags_of({0xD1, 0xC0}), "rol - CO -");
  EXPECT_EQ(flags_of({0x0F, 0xAC, 0xC8, 0x01}), "shrd - CPZSO A");
  EXPECT_EQ(flags_of({0x0F, 0xAC, 0xC8, 0x08}), "shrd - CPZS AO");
}

TEST(Decoded, CopiesOfFlagsAndRepeatedComparisonsReadNone) {
  EXPECT_EQ(flags_of({0x9C}), "pushf - - -");
  EXPECT_EQ(flags_of({0x9F}), "lahf - - -");
  EXPECT_EQ(flags_of({0xF3, 0xA6}), "cmpsb - CPAZSO -");
}

TEST(Decoded, TargetsWrapInTheirSegment) {
  EXPECT_EQ(decoded(Bytes{0xEB, 0xFE}, 0x1000, 16).target, 0x1000U);
  EXPECT_EQ(decoded(Bytes{0xE9, 0x00, 0x80}, 0x9000, 16).target, 0x1003U);
  EXPECT_EQ(decoded(Bytes{0xE8, 0xFB, 0xFF, 0xFF, 0xFF}, 0x9000, 32).target, 0x9000U);
  EXPECT_FALSE(decoded(Bytes{0xFF, 0xE3}, 0, 16).target);
  EXPECT_TRUE(is_conditional(decoded(Bytes{0x74, 0}, 0, 16)));
  EXPECT_FALSE(is_conditional(decoded(Bytes{0xE2, 0}, 0, 16)));
  EXPECT_FALSE(is_conditional(decoded(Bytes{0x0F, 0x94, 0xC0}, 0, 16)));
  EXPECT_TRUE(may_pass(decoded(Bytes{0xE3, 0}, 0, 16)));
  EXPECT_TRUE(ends_flow(decoded(Bytes{0xCB}, 0, 16)));
}

unsigned written_by(const Bytes& bytes) { return decoded(bytes, 0, 16).writes; }

// Bit 0 is AX, then CX, DX, BX, SP, BP, SI, DI.
TEST(Decoded, RegistersThatItWrites) {
  EXPECT_EQ(written_by({0x01, 0xC8}), 0x01U);
  EXPECT_EQ(written_by({0x39, 0xC8}), 0U);
  EXPECT_EQ(written_by({0x88, 0xC4}), 0x01U);  // AH is a part of AX
  EXPECT_EQ(written_by({0xF7, 0xE3}), 0x05U);
  EXPECT_EQ(written_by({0x91}), 0x03U);
  EXPECT_EQ(written_by({0x53}), 0U);  // PUSH moves SP, which does not count
  EXPECT_EQ(written_by({0x5C}), 0x10U);
  EXPECT_EQ(written_by({0x83, 0xC4, 0x04}), 0x10U);
  EXPECT_EQ(written_by({0xA5}), 0xC0U);
  EXPECT_EQ(written_by({0xE2, 0x00}), 0x02U);
  EXPECT_EQ(written_by({0xC9}), 0x20U);
}

// Every byte, but a displacement or an immediate as one.
TEST(Decoded, ComponentsAreThoseOfThe386Manual) {
  const auto components = [](const Bytes& bytes) { return decoded(bytes, 0, 16).components; };
  EXPECT_EQ(components({0xC3}), 1);
  EXPECT_EQ(components({0x8B, 0x46, 0x04}), 3);
  EXPECT_EQ(components({0x8B, 0x87, 0x00, 0x02}), 3);
  EXPECT_EQ(components({0x66, 0x05, 1, 2, 3, 4}), 3);
  EXPECT_EQ(components({0x66, 0x0F, 0xAC, 0xD0, 0x10}), 5);
  EXPECT_EQ(components({0x67, 0x3B, 0x1C, 0x7D, 0, 5, 0, 0}), 5);
  EXPECT_EQ(components({0x0F, 0x84, 0, 0}), 3);
}

TEST(Decoded, WhatIsNoInstructionHasNoName) {
  EXPECT_EQ(decoded(Bytes{0xFF, 0xFF}, 0, 16).mnemonic, "");
  EXPECT_EQ(decoded(Bytes{0x66}, 0, 16).mnemonic, "");
  EXPECT_EQ(decoded({}, 0, 16).mnemonic, "");
  EXPECT_TRUE(ends_flow(decoded(Bytes{0xFF, 0xFF}, 0, 16)));
}

/// Compares lengths and flags of a program's instructions with Zydis, which has them from Intel.
void expect_flags_of_zydis(std::span<const std::uint8_t> bytes,
                           std::span<const x86model::Instruction> instructions) {
  for (const x86model::Instruction& i : instructions) {
    const Decoded d = decoded(bytes, 0, 16);
    const x86model::FlagUse use = x86model::flag_use(i);
    ASSERT_EQ(d.bytes, static_cast<std::uint32_t>(x86model::encoding_of(i).bytes()))
        << x86model::text_of(i);
    EXPECT_EQ(letters(use.reads), letters(d.flags.reads)) << x86model::text_of(i);
    EXPECT_EQ(letters(use.sets), letters(d.flags.sets)) << x86model::text_of(i);
    EXPECT_EQ(letters(use.leaves_undefined), letters(d.flags.leaves_undefined))
        << x86model::text_of(i);
    bytes = bytes.subspan(d.bytes);
  }
}

TEST(Decoded, TheModelsFlagsAreThose) {
  namespace code = fixproof::machine_code;
  for (const code::ProgramKey& key : code::all_programs()) {
    const auto program = assemble(listing(key.routine, key.target), key.build);
    expect_flags_of_zydis(code::machine_code(key), program.instructions());
  }
  for (const x86model::LoopForm& form : x86model::all_loop_forms()) {
    expect_flags_of_zydis(code::machine_code(form), x86model::code_of(form));
  }
}

}  // namespace
