// The clocks of a user's routine, beside those of the model for our listings, and beside sums by
// hand.
#include "judge/code/clocks.hpp"

#include "judge/check/cases.hpp"
#include "judge/code/inspection.hpp"
#include "judge/code/load.hpp"
#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "x86model/count_clocks.hpp"
#include "x86model/text.hpp"
#include "x86model/with_routine.hpp"

namespace {

using namespace fixproof;
using judge::RoutineClocks;
using judge::Spread;

bool unicorn_is_missing() { return !judge::absence_on_unicorn().empty(); }

RoutineClocks clocks_of(const std::string& source, const std::string& frame,
                        const cases::Variant& variant, int bits = 16) {
  const ScratchFolder folder;
  const judge::Image image = judge::load(folder.write("code.asm", source), {.bits = bits});
  return judge::count_clocks({image, judge::frame_named(frame, bits, variant), variant});
}

void expect_equal(const Spread& one, const Spread& other, const std::string& what) {
  EXPECT_EQ(one.least(), other.least()) << what;
  EXPECT_EQ(one.most(), other.most()) << what;
  EXPECT_EQ(one.mean_min(), other.mean_min()) << what;
  EXPECT_EQ(one.mean_max(), other.mean_max()) << what;
}

/// What the model counts for the same calls.
RoutineClocks clocks_of_model(const machine_code::ProgramKey& key, const cases::Variant& variant) {
  const x86model::Program program =
      x86model::assemble(x86model::listing(key.routine, key.target), key.build);
  RoutineClocks clocks;
  check::GeneratedCases cases(variant, {.cases = judge::calls_to_inspect});
  std::vector<std::uint32_t> words(words_in(variant));
  while (cases.next(words)) {
    for (std::size_t i = 0; i < clocks.on.size(); ++i) {
      const auto cpu = static_cast<x86model::Cpu>(i);
      if (key.target == x86model::Target::i386 && cpu < x86model::Cpu::i386) continue;
      const auto call = x86model::with_routine(key.routine, [&]<x86model::Routine routine>() {
        return x86model::count_clocks<routine>(program.instructions(), words, cpu);
      });
      if (call.ending.outcome != x86model::Outcome::returned) continue;
      clocks.on.at(i).clocks.add(call.clocks);
      if (cpu != x86model::Cpu::i8088) continue;
      clocks.instructions.add({call.ending.steps, call.ending.steps});
      clocks.code_bytes.add({call.bus.code, call.bus.code});
      clocks.data_bytes.add({call.bus.data, call.bus.data});
    }
  }
  return clocks;
}

TEST(JudgeClocks, OurListingsTakeWhatTheModelCounts) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  using enum x86model::Routine;
  for (const machine_code::ProgramKey& key : machine_code::all_programs()) {
    if (key.routine == concat || key.build.endif_as_scanned) continue;
    const std::string name = machine_code::name_of(key);
    const auto operation = key.routine == mul      ? cases::Operation::mul
                           : key.routine == div    ? cases::Operation::div
                           : key.routine == cossin ? cases::Operation::cossin
                                                   : cases::Operation::xformvec;
    cases::Variant variant = cases::variant_of(operation, cases::q16_16);
    if (operation == cases::Operation::cossin) variant.build.target = cases::Target::i386;
    const auto found =
        clocks_of(x86model::nasm_source(key.routine, key.target, key.build), "c", variant);
    const auto expected = clocks_of_model(key, variant);
    EXPECT_GT(found.calls, 10U) << name;
    for (std::size_t i = 0; i < found.on.size(); ++i) {
      const auto cpu = static_cast<x86model::Cpu>(i);
      const bool has_none = key.target == x86model::Target::i386 && cpu < x86model::Cpu::i386;
      EXPECT_EQ(found.on.at(i).without.empty(), !has_none) << name;
      expect_equal(found.on.at(i).clocks, expected.on.at(i).clocks,
                   name + " on " + std::string(x86model::name_of(cpu)));
    }
    if (key.target == x86model::Target::i386) continue;
    expect_equal(found.instructions, expected.instructions, name);
    expect_equal(found.code_bytes, expected.code_bytes, name);
    expect_equal(found.data_bytes, expected.data_bytes, name);
  }
}

/// A number of clocks, or its bounds.
struct Clocks : x86model::Range {
  Clocks(std::uint64_t n) : Range{n, n} {}  // NOLINT(google-explicit-constructor)
  Clocks(std::uint64_t least, std::uint64_t most) : Range{least, most} {}
};
struct Expected {
  std::optional<Clocks> i8088;  ///< nothing: it lacks an instruction
  std::optional<Clocks> i286;
  Clocks i386;
  Clocks i486;
};

void expect_clocks(const std::string& source, const Expected& expected) {
  SCOPED_TRACE(source);
  const cases::Variant variant =
      cases::variant_of(cases::Operation::add, cases::format_named("q8_8"));
  const RoutineClocks found = clocks_of(source, "ax, bx -> ax", variant);
  EXPECT_EQ(found.calls, judge::calls_to_inspect);
  const std::array<std::optional<Clocks>, 4> all{expected.i8088, expected.i286, expected.i386,
                                                 expected.i486};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& wanted = all.at(i);
    EXPECT_EQ(found.on.at(i).without.empty(), wanted.has_value()) << i;
    if (!wanted) continue;
    EXPECT_EQ(found.on.at(i).clocks.least(), wanted->min) << i;
    EXPECT_EQ(found.on.at(i).clocks.most(), wanted->max) << i;
  }
}

TEST(JudgeClocks, FormsThatNoListingHas) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  // In the order of the instructions; RET is 16 + 4, 11 + 3, 10 + 3 and 5.
  expect_clocks(
      "mov cx, 5\npush ax\nmov bp, sp\nadd [bp+0], bx\npop ax\nmov cl, 3\nshl ax, cl\n"
      "xchg ax, bx\ncwd\nnop\nret",
      {4 + 15 + 2 + (16 + 9 + 8) + 12 + 4 + (8 + 3 * 4) + 3 + 5 + 3 + 20,
       2 + 3 + 2 + 7 + 5 + 2 + (5 + 3) + 3 + 2 + 3 + 14,
       2 + 2 + 2 + 7 + 4 + 2 + 3 + 3 + 2 + 3 + 13,
       // ADD waits for BP, and POP takes 1 to 4.
       {1 + 1 + 1 + (3 + 1) + 1 + 1 + 3 + 3 + 3 + 1 + 5,
        1 + 1 + 1 + (3 + 1) + 4 + 1 + 3 + 3 + 3 + 1 + 5}});
  // An address of two registers and a displacement, then AX at a fixed address.
  expect_clocks("mov si, 0\nmov bx, 0x100\nmov cx, [bx+si+2]\nmov ax, [0x100]\nret",
                {4 + 4 + (8 + 11 + 4) + 14 + 20,
                 2 + 2 + (5 + 1) + 5 + 14,
                 2 + 2 + (4 + 1) + 4 + 13,
                 {1 + 1 + (1 + 1) + 1 + 5, 1 + 1 + (1 + 1 + 1) + 1 + 5}});
}

TEST(JudgeClocks, JumpsTakenAndNot) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  // The length of the instruction at the target counts on a 286 and a 386: here 1, then 4 bytes or
  // 3 components.
  expect_clocks("stc\njc .end\nnop\n.end: ret", {2 + 16 + 20, 2 + 8 + 14, 2 + 8 + 13, {10, 10}});
  expect_clocks("stc\njc .end\nnop\n.end: and dx, 0x1234\nret",
                {2 + 16 + 4 + 20, 2 + (7 + 4) + 3 + 14, 2 + (7 + 3) + 2 + 13, {11, 11}});
  expect_clocks("clc\njc .end\nnop\n.end: ret",
                {2 + 4 + 3 + 20, 2 + 3 + 3 + 14, 2 + 3 + 3 + 13, {9, 9}});
}

TEST(JudgeClocks, AJumpToTheNextInstruction) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  expect_clocks("stc\njc .end\n.end: ret", {2 + 16 + 20, 2 + 8 + 14, 2 + 8 + 13, 2 + 3 + 5});
  expect_clocks("clc\njc .end\n.end: ret", {2 + 4 + 20, 2 + 3 + 14, 2 + 3 + 13, 2 + 1 + 5});
  expect_clocks("mov cx, 1\ncmp cx, 2\njg .end\n.end: ret",
                {4 + 4 + 4 + 20, 2 + 3 + 3 + 14, 2 + 2 + 3 + 13, 1 + 1 + 1 + 5});
  expect_clocks("mov cx, 1\nloop .end\n.end: ret",
                {4 + 5 + 20, 2 + 4 + 14, 2 + 12 + 13, 1 + 6 + 5});
  expect_clocks("mov cx, 2\nloop .end\n.end: ret",
                {4 + 17 + 20, 2 + 9 + 14, 2 + 12 + 13, 1 + 7 + 5});
}

TEST(JudgeClocks, AnExtensionDoesNotWriteTheStringRegisters) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  expect_clocks("mov di, 0x100\nnop\nmovsx cx, al\nmov dx, [di]\nret",
                {{}, {}, 2 + 3 + 3 + 4 + 13, 1 + 1 + 3 + 1 + 5});
  expect_clocks("mov di, 0x100\nnop\nmovsx di, al\nmov dx, [di+0x100]\nret",
                {{}, {}, 2 + 3 + 3 + 4 + 13, 1 + 1 + 3 + (1 + 1) + 5});
}

// The figures are those of the published tables in x86model/clock_rows.hpp. RET: 20, 14, 13, 5.
TEST(JudgeClocks, TheSourcesDifferOnSubtractAndOrWithMemoryOnA386) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  expect_clocks("push ax\nmov bp, sp\nnop\nsub ax, [bp+0]\nor [bp+0], bl\npop ax\nret",
                {15 + 2 + 3 + (9 + 9 + 4) + (16 + 9) + 12 + 20,
                 3 + 2 + 3 + 7 + 7 + 5 + 14,
                 {2 + 2 + 3 + 6 + 6 + 4 + 13, 2 + 2 + 3 + 7 + 7 + 4 + 13},
                 {1 + 1 + 1 + 2 + 3 + 1 + 5, 1 + 1 + 1 + 2 + 3 + 4 + 5}});
  expect_clocks("or ax, [0x100]\nsbb ax, [0x100]\nxor ax, [0x100]\nret",
                {3 * (9 + 6 + 4) + 20, 3 * 7 + 14, {3 * 6 + 13, 3 * 7 + 13}, 3 * 2 + 5});
  expect_clocks("push ax\nmov bp, sp\nnop\nand ax, [bp+0]\nadc [bp+0], bl\npop ax\nret",
                {15 + 2 + 3 + (9 + 9 + 4) + (16 + 9) + 12 + 20,
                 3 + 2 + 3 + 7 + 7 + 5 + 14,
                 2 + 2 + 3 + 6 + 7 + 4 + 13,
                 {1 + 1 + 1 + 2 + 3 + 1 + 5, 1 + 1 + 1 + 2 + 3 + 4 + 5}});
}

TEST(JudgeClocks, FlagsTablesAndStringsOfTheCommonKind) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  expect_clocks("pushf\npopf\nret", {14 + 12 + 20, 3 + 5 + 14, 4 + 5 + 13, 4 + 9 + 5});
  expect_clocks("lahf\nsahf\ncbw\ncwd\nret",
                {4 + 4 + 2 + 5 + 20, 2 + 2 + 2 + 2 + 14, 2 + 3 + 3 + 2 + 13, 3 + 2 + 3 + 3 + 5});
  expect_clocks("mov bx, 0x100\nnop\nxlatb\nret",
                {4 + 3 + 11 + 20, 2 + 3 + 5 + 14, 2 + 3 + 5 + 13, 1 + 1 + 4 + 5});
  expect_clocks("mov al, 57\naam\naad\nret",
                {4 + 83 + 60 + 20, 2 + 16 + 14 + 14, 2 + 17 + 19 + 13, 1 + 15 + 14 + 5});
  expect_clocks("pusha\nnop\npopa\nret", {{}, 17 + 3 + 19 + 14, 18 + 3 + 24 + 13, 11 + 1 + 9 + 5});
  expect_clocks("mov si, 0x100\nmov di, 0x180\ncmpsb\ncmpsw\nscasb\nscasw\nret",
                {4 + 4 + 22 + 30 + 15 + 19 + 20, 2 + 2 + 8 + 8 + 7 + 7 + 14,
                 2 + 2 + 10 + 10 + 7 + 7 + 13, 1 + 1 + 8 + 8 + 6 + 6 + 5});
  // A prefix of a 486 costs a clock, or is hidden.
  expect_clocks("mov si, 0x100\nmov di, 0x180\nlodsd\nstosd\nmovsd\nret",
                {{}, {}, 2 + 2 + 5 + 4 + 7 + 13, {1 + 1 + 5 + 5 + 7 + 5, 1 + 1 + 6 + 6 + 8 + 5}});
  expect_clocks("setc al\nsetnz byte [0x100]\nret", {{}, {}, 4 + 5 + 13, {3 + 3 + 5, 4 + 4 + 5}});
}

TEST(JudgeClocks, A486WaitsForTheStackPointer) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  expect_clocks(
      "mov cx, sp\nmov sp, cx\npushf\npopf\nret",
      {2 + 2 + 14 + 12 + 20, 2 + 2 + 3 + 5 + 14, 2 + 2 + 4 + 5 + 13, 1 + 1 + (4 + 1) + 9 + 5});
  expect_clocks("push cs\nmov cx, sp\nnop\npop dx\nmov sp, cx\npush dx\npop dx\nadd sp, 2\nret",
                {14 + 2 + 3 + 12 + 2 + 15 + 12 + 4 + 20,
                 3 + 2 + 3 + 5 + 2 + 3 + 5 + 3 + 14,
                 2 + 2 + 3 + 4 + 2 + 2 + 4 + 2 + 13,
                 {3 + 1 + 1 + 1 + 1 + (1 + 1) + 1 + 1 + (5 + 1),
                  3 + 1 + 1 + 4 + 1 + (1 + 1) + 4 + 1 + (5 + 1)}});
}

TEST(JudgeClocks, TestOfMemoryByAConstant) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  expect_clocks("test word [0x100], 3\nret", {11 + 6 + 4 + 20, 6 + 14, 5 + 13, 2 + 5});
  expect_clocks("test byte [0x100], 3\nret", {11 + 6 + 20, 6 + 14, 5 + 13, 2 + 5});
}

TEST(JudgeClocks, TheSourcesDifferOnMemoryToASegmentRegisterOnA486) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  expect_clocks("mov es, [0x100]\nret", {8 + 6 + 4 + 20, 5 + 14, 5 + 13, {3 + 5, 9 + 5}});
  expect_clocks("mov es, ax\nret", {2 + 20, 2 + 14, 2 + 13, 3 + 5});
}

TEST(JudgeClocks, A386MultipliesByAByteInFewerClocks) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  expect_clocks("imul ax, bx, 5\nret", {{}, 21 + 14, {9 + 13, 14 + 13}, {13 + 5, 26 + 5}});
  expect_clocks("imul ax, bx, 500\nret", {{}, 21 + 14, {9 + 13, 22 + 13}, {13 + 5, 26 + 5}});
  expect_clocks("imul ax, [0x100], 5\nret", {{}, 24 + 14, {12 + 13, 17 + 13}, {13 + 5, 26 + 5}});
}

TEST(JudgeClocks, AnAddressOfTwoRegistersAndASegmentOverride) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  expect_clocks("mov bx, 0x100\nmov si, 0\nnop\nmov cx, [bx+si]\nret",
                {4 + 4 + 3 + (8 + 7 + 4) + 20,
                 2 + 2 + 3 + 5 + 14,
                 {2 + 2 + 3 + 4 + 13, 2 + 2 + 3 + 5 + 13},
                 {1 + 1 + 1 + 1 + 5, 1 + 1 + 1 + 2 + 5}});
  expect_clocks(
      "mov si, 0\nnop\nes lodsb\nret",
      {4 + 3 + (12 + 2) + 20, 2 + 3 + 5 + 14, 2 + 3 + 5 + 13, {1 + 1 + 5 + 5, 1 + 1 + 6 + 5}});
}

TEST(JudgeClocks, SomeInstructionsOfA386HaveNo32BitOperand) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  expect_clocks("mov cx, fs\nret", {{}, {}, 2 + 13, 3 + 5});
  expect_clocks("stc\njnc near .end\nnop\n.end: ret", {{}, {}, 2 + 3 + 3 + 13, 2 + 1 + 1 + 5});
  expect_clocks("mov ecx, 1\njecxz .end\nnop\n.end: ret",
                {{}, {}, 2 + 5 + 3 + 13, {1 + 5 + 1 + 5, 2 + 6 + 1 + 5}});
}

TEST(JudgeClocks, AFixedAddressOf32Bits) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  const RoutineClocks found =
      clocks_of("mov ecx, [0x100]\nadd ecx, [0x100]\nret", "eax, ebx -> eax",
                cases::variant_of(cases::Operation::add, cases::q16_16), 32);
  EXPECT_EQ(found.on.at(2).clocks.least(), 4U + 6U + 13U);
  EXPECT_EQ(found.on.at(3).clocks.least(), 1U + 2U + 5U);
}

TEST(JudgeClocks, AnInstructionWithoutAFigureIsNamed) {
  if (unicorn_is_missing()) GTEST_SKIP() << judge::absence_on_unicorn();
  const ScratchFolder folder;
  const auto file = folder.write("bsf.asm", "imul ebx\nbsf ecx, eax\nshrd eax, edx, 16\nret");
  judged::expect(
      judged::judge(file, judged::in_registers + "|--cases|5000|--clocks"), 0,
      {"clocks of 40 calls by Intel's tables:",
       "  bytes fetched        10              10.0       10\n",
       "  486           no figure for bsf ecx,eax at 0002h\n", "; 32 bits need a 386\n"});
}

}  // namespace
