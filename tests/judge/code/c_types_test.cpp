// Frames that name types of C; results of another format, promises and odd widths for machine code.
#include "judge/code/c_types.hpp"

#include <fmt/format.h>

#include "judge/code/call_operands.hpp"
#include "support/usage_error.hpp"
#include "tests/judge/code/judged.hpp"
#include "tests/judge/code/other_processors.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace c_types_test {

namespace {

using namespace fixproof;
using judged::expect;
using judged::judge;
using other_processors::Code;

const cases::Variant product{};

std::string file_of(const ScratchFolder& folder, const Code& code, std::string_view hex) {
  return folder.write("f.elf", other_processors::linked(code, hex));
}

/// Judges a routine of NASM source.
command::Run judge_code(const std::string& source, const std::string& options) {
  const ScratchFolder folder;
  return judge(folder.write("f.asm", source), options);
}

TEST(CTypes, ArraysAndCountsOnEveryProcessor) {
  const ScratchFolder folder;
  for (const Code& code : other_processors::present()) {
    SCOPED_TRACE(code.name);
    expect(judge(file_of(folder, code, code.behind),
                 "--as|mul|--format|q1_15|--to|q2_30|--cases|1000|--frame|"
                 "int16_t*, const short*, int32_t*, 1 -> int"),
           0, {"AGREES on 1,000 cases\n", "no foreign memory is used"});
  }
}

TEST(CTypes, ALongHasTheBitsOfTheProcessor) {
  const ScratchFolder folder;
  for (const Code& code : other_processors::present()) {
    SCOPED_TRACE(code.name);
    expect(judge(file_of(folder, code, code.scaled),
                 "--as|mul|--overflow|wrap|--cases|1000|--frame|long, long -> long"),
           0, {"half-up, the rounding that fits best", "AGREES on 1,000 cases\n"});
    if (code.name != "AArch64") continue;
    expect(judge(file_of(folder, code, code.scaled), "--as|mul|--cases|1000"), 1,
           {"that its caller does not set; if it takes types of 64 bits, name them, as in --frame "
            "'long, long -> long'\n"});
  }
}

TEST(CTypes, AnArrayHasTheNextOperands) {
  const ScratchFolder folder;
  for (const Code& code : other_processors::present()) {
    SCOPED_TRACE(code.name);
    expect(judge(file_of(folder, code, code.pair),
                 "--as|add|--to|q48_16|--cases|1000|--frame|int32_t[2] -> long long"),
           0, {"add q16_16 to q48_16", "AGREES on 1,000 cases\n"});
  }
}

TEST(CTypes, OnX86) {
  const std::string on_stack =
      "bits 32\nmov eax, [esp+4]\nimul dword [esp+8]\nadd eax, 0x8000\nadc edx, 0\n"
      "shrd eax, edx, 16\nret\n";
  expect(judge_code(on_stack, "--as|mul|--cases|1000|--frame|long, int -> long"), 0,
         {"frame long, int -> long\n", "half-up, the rounding that fits best", "AGREES on 1,000"});
  const std::string whole = "bits 64\nimul rdi, rsi\nlea rax, [rdi+0x8000]\nsar rax, 16\nret\n";
  expect(judge_code(whole, "--as|mul|--cases|1000|--frame|long, long -> long"), 0,
         {"AGREES on 1,000"});
  expect(judge_code(whole, "--as|mul|--cases|1000"), 1, {"UNSTEADY", "name them"});
  // The last of six registers, and a constant in the one before it.
  const std::string last = "bits 64\nlea eax, [rdi+r9]\nsub r8d, 4\nadd eax, r8d\nret\n";
  const std::string six =
      "--as|add|--overflow|wrap|--cases|1000|--frame|int, 1, 2, 3, 4, int -> int";
  expect(judge_code(last, six), 0, {"AGREES on 1,000"});
  command::expect_usage_error(judge_code(last, "--as|add|--frame|int, 1, 2, 3, 4, 5, int -> int"),
                              "there are registers for 6 parameters, not for 7");
  expect(judge_code(on_stack, "--as|mul|--cases|500|--prove|--frame|long, long -> long"), 0,
         {"PROVEN for all operands"});
  expect(judge_code(whole, "--as|mul|--cases|500|--prove|--frame|long, long -> long"), 0,
         {"NOT PROVEN, only judged by cases: only mul, div"});
}

TEST(CTypes, AResultThatIsNotWrittenForOneCaseIsUnsteady) {
  const std::string all_but_zeros =
      "bits 64\nmov eax, edi\nor eax, esi\njz .out\nlea eax, [rdi+rsi]\nmov [rdx], eax\n.out: "
      "ret\n";
  expect(judge_code(all_but_zeros, "--as|add|--cases|20000|--frame|int, int, int* -> int"), 1,
         {"UNSTEADY: for 00000000 00000000 (0 0)", "WRONG in"});
}

TEST(CTypes, WidthsAndSigns) {
  const auto bits = [](const std::string& text, int code_bits) {
    const std::string frame = "long long, long long -> " + text;
    const cases::Variant tiny = cases::variant_of(cases::Operation::mul, {8, 4});
    return judge::signature_in_c(*judge::frame_text(frame), tiny, code_bits)->result_bits;
  };
  EXPECT_EQ(bits("char", 64), 8);
  EXPECT_EQ(bits("unsigned short", 32), 16);
  EXPECT_EQ(bits("int", 16), 16);
  EXPECT_EQ(bits("unsigned", 32), 32);
  EXPECT_EQ(bits("long", 16), 32);
  EXPECT_EQ(bits("long", 32), 32);
  EXPECT_EQ(bits("signed long", 64), 64);
  EXPECT_EQ(bits("uint64_t", 32), 64);
  EXPECT_EQ(bits("long unsigned int", 64), 64);
  EXPECT_EQ(bits("short int", 64), 16);
  EXPECT_EQ(bits("std::uint16_t", 64), 16);
  EXPECT_FALSE(judge::signature_in_c(*judge::frame_text("r0, r1 -> r0"), product, 32));
}

TEST(CTypes, AnOperandIsExtendedByItsType) {
  const cases::Variant small = cases::variant_of(cases::Operation::mul, cases::q8_8);
  const auto signature =
      *judge::signature_in_c(*judge::frame_text("uint16_t, -2, int -> int"), small, 32);
  const judge::Image image;
  const judge::CallOperands operands(image, signature, small);
  const std::array<std::uint32_t, 2> words{0xFFFF, 0xFFFF};
  EXPECT_EQ(operands.value(0, words), 0xFFFFU);
  EXPECT_EQ(operands.value(1, words), ~std::uint64_t{1});
  EXPECT_EQ(operands.value(2, words), ~std::uint64_t{0});
}

TEST(CTypes, ParametersMayHaveNames) {
  const std::string behind =
      "bits 64\nmovsxd rax, [rdi]\nmovsxd rcx, [rsi]\nimul rax, rcx\nsar rax, 16\n"
      "mov [rdx], eax\nret\n";
  for (const std::string frame :
       {"const int32_t *a, int32_t const* b, std::int32_t r[1] ->",
        "int *restrict a, volatile int * b, long int32 [1] ->", "int* const a, int *b, int* ->"}) {
    expect(judge_code(behind, "--as|mul|--cases|1000|--frame|" + frame), 0,
           {"frame " + frame + "\n", "AGREES on 1,000 cases\n"});
  }
  const std::string value = "bits 64\nlea eax, [rdi+rsi]\nret\n";
  for (const std::string frame : {"int32_t a, int32_t b -> int32_t", "unsigned a, int b -> signed"})
    expect(judge_code(value, "--as|add|--overflow|wrap|--cases|1000|--frame|" + frame), 0,
           {"AGREES on 1,000 cases\n"});
}

TEST(CTypes, AWildPointerIsAnsweredWithTheFrameOfPointers) {
  const std::string reads = "bits 64\nshl rdi, 32\nmov eax, [rdi]\nret\n";
  const std::string hint = "; if it takes pointers, name its types, as in --frame '";
  expect(judge_code(reads, "--as|mul|--cases|1000"), 1,
         {"BROKEN: for ", hint + "int32_t*, int32_t*, int32_t* ->'\n"});
  expect(judge_code(reads, "--as|sqrt|--format|u8_8|--to|u0_32|--cases|1000"), 1,
         {hint + "uint16_t*, uint32_t* ->'\n"});
  expect(judge_code(reads, "--as|dot|--terms|3|--format|q1_15|--frame|sysv|--cases|1000"), 1,
         {hint + "int16_t[3], int16_t[3], int16_t* ->'\n"});
  const auto named = judge_code(reads, "--as|mul|--cases|1000|--frame|int32_t, int32_t -> int32_t");
  EXPECT_EQ(named.status, 1);
  EXPECT_EQ(named.out.find(hint), std::string::npos) << named.out;
}

TEST(CTypes, MistakesAreNamed) {
  const std::string routine = "bits 64\nmov eax, edi\nret\n";
  for (const auto& [frame, part] :
       {std::pair{"fix, int -> int",
                  "'fix' is no type that judge knows; write one such as int32_t"},
        {"int, [rdi] -> int", "'rdi' is no type that judge knows"},
        {"int, int[0] -> int", "'int[0]' is no type that judge knows"},
        {"signed int32_t, int -> int", "'signed int32_t' is no type that judge knows"},
        {"int, short -> int", "'short' has 16 bits, and a number of q16_16 has 32"},
        {"int, int -> char", "'char' has 8 bits, and a number of q16_16 has 32"},
        {"int -> int", "mul takes 2 operands and gives 1 result; write their types"},
        {"int, int, int -> int", "mul takes 2 operands"},
        {"int[3] -> int", "mul takes 2 operands"},
        {"int, int ->", "mul takes 2 operands"},
        {"int, int -> int*", "mul takes 2 operands"},
        {"int, int -> 1", "mul takes 2 operands"},
        {"int, int, int*, int* ->", "mul takes 2 operands"},
        {"signed unsigned, int -> int", "'signed unsigned' is no type that judge knows"},
        {"int**, int -> int", "'int**' is no type that judge knows"},
        {"int *a b, int -> int", "'int *a b' is no type that judge knows"},
        {"fixed, fixed -> fixed",
         "'fixed' is not a register for operands; choose one such as eax, bx or dl, or types of C "
         "such as int32_t, for a typedef the type that it stands for"},
        {"int, int",
         "'int, int': there is no -> between operands and result; write 'int, int -> "
         "int'"},
        {"int*, int*, int*", "write 'int*, int*, int* ->'"},
        {"int, int => int", "write 'int, int -> int'"},
        {"int mul(int a, int b)", "write 'int a, int b -> int'"},
        {"void mul(int *a, int *r)", "write 'int *a, int *r ->'"}}) {
    command::expect_usage_error(judge_code(routine, std::string("--as|mul|--frame|") + frame),
                                part);
  }
}

TEST(JudgeFormats, SumsOfProductsAndConversions) {
  const std::string dot =
      "bits 64\nxor eax, eax\n.next: movsx r8, word [rdi]\nmovsx r9, word [rsi]\nimul r8, r9\n"
      "add rax, r8\nadd rdi, 2\nadd rsi, 2\ndec edx\njnz .next\nmov [rcx], rax\nret\n";
  const auto frame = [](int terms) {
    return fmt::format(
        "--as|dot|--format|q1_15|--to|q34_30|--cases|1000|--terms|{0}|--frame|"
        "int16_t[{0}], int16_t[{0}], {0}, int64_t* ->",
        terms);
  };
  expect(judge_code(dot, frame(3)), 0, {"dot q1_15 to q34_30", "AGREES on 1,000 cases\n"});
  command::expect_usage_error(judge_code(dot, frame(33)),
                              "what the pointers point to takes 152 bytes, and there are 128; take "
                              "fewer terms");
  const std::string narrow = "bits 64\nlea eax, [rdi+0x80]\nsar eax, 8\nret\n";
  expect(judge_code(narrow, "--as|convert|--to|q8_8|--overflow|wrap|--cases|1000"), 0,
         {"convert q16_16 to q8_8: half-up", "AGREES on 1,000 cases\n"});
}

TEST(JudgeFormats, AWordIsStoredWithItsSign) {
  const std::string add = "bits 64\nlea eax, [rdi+rsi]\n";
  const std::string options = "--as|add|--format|q2_16|--overflow|wrap|--cases|1000";
  expect(judge_code(add + "ret\n", options), 1, {"WRONG in", "overflow         no known rule"});
  expect(judge_code(add + "shl eax, 14\nsar eax, 14\nret\n", options), 0,
         {"add q2_16: exact; overflow wrap", "AGREES on 1,000 cases\n"});
}

TEST(JudgeFormats, Promises) {
  const std::string floors =
      "bits 64\nmovsxd rax, edi\nmovsxd rcx, esi\nimul rax, rcx\nsar rax, 16\nret\n";
  expect(judge_code(floors, "--as|mul|--within|1|--cases|1000"), 0,
         {"mul q16_16: within 1 ulp", "AGREES on 1,000 cases\n"});
  expect(judge_code(floors, "--as|mul|--within|0.5|--cases|1000"), 1, {"WRONG in"});
  expect(judge_code(floors, "--as|mul|--rounding|faithful|--cases|1000"), 0, {"AGREES on 1,000"});
  // Every result is near enough, but results fall where those of exp2 rise.
  const std::string falls = "bits 64\nmov eax, edi\nneg eax\nret\n";
  expect(judge_code(falls, "--as|exp2|--format|q8_8|--within|100000|--cases|1000"), 1,
         {"are in the wrong order"});
}

TEST(JudgeFormats, WhatTheLinkerMakesIsNotMissing) {
  if (!command::has("m68k-linux-gnu-gcc")) GTEST_SKIP() << "no m68k-linux-gnu-gcc";
  // Position-independent code reaches `half` through the table of offsets that the linker makes.
  // The variable is no function that judge could mean.
  const ScratchFolder folder;
  const std::string source = folder.write(
      "f.c",
      "int half = 0x8000;\nint f(int a, int b) { return (a * (long long)b + half) >> 16; }\n");
  const auto run = command::run({"env", "CC=m68k-linux-gnu-gcc -m68020 -fPIC", paths::command(),
                                 "judge", source, "--as", "mul", "--cases", "500"});
  expect(run, 0, {"half-up, the rounding that fits best", "AGREES on 500 cases\n"});
}

}  // namespace

}  // namespace c_types_test
