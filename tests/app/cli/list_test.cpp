// Tests that the output of `fixproof list` assembles to the right bytes for its processor.
#include <fmt/format.h>

#include "tests/support/command.hpp"
#include "tests/support/test.hpp"

namespace {

using command::assemble;
using command::hex;

std::string list(std::string_view arguments) {
  return command::output_of(fmt::format("list {}", arguments));
}

TEST(List, EveryVariantAssembles) {
  if (!command::has("nasm")) GTEST_SKIP() << "nasm is not installed";
  for (const std::string_view routine : {"mul", "div", "cossin", "xformvec", "concat"}) {
    for (const std::string_view target : {"i386", "i8088"}) {
      for (const std::string_view round : {"on", "off"}) {
        const auto arguments = fmt::format("{} --target {} --round {}", routine, target, round);
        const std::string source = list(arguments);
        const auto cpu = fmt::format("cpu {}\n", target == "i386" ? "386" : "8086");
        EXPECT_NE(source.find(cpu), std::string::npos) << arguments;
        // push bp, mov bp,sp … ret
        const std::string code = assemble(source);
        EXPECT_EQ(hex(code.substr(0, 3)), "55 89 e5 ") << arguments;
        EXPECT_NE(code.find('\xc3'), std::string::npos) << arguments;
      }
    }
    if (routine != "cossin" && routine != "xformvec") {
      EXPECT_NE(assemble(list(fmt::format("{} --chapter 52", routine))), "");
    }
  }
  EXPECT_NE(assemble(list("div --target i8088 --round off --as-scanned")), "");
  EXPECT_NE(assemble(list("cossin --target i8088 --as-printed")), "");
}

// ADD BP,[SI+d] is 03 6c d, ADC 13 6c d.
TEST(List, TheRepairedConcatAddsThreeCarries) {
  if (!command::has("nasm")) GTEST_SKIP() << "nasm is not installed";
  const std::string printed = assemble(list("concat --target i8088"));
  const std::string repaired = assemble(list("concat --target i8088 --repaired"));
  ASSERT_EQ(printed.size(), repaired.size());
  int changed = 0;
  for (std::size_t i = 0; i < printed.size(); ++i) {
    if (printed[i] == repaired[i]) continue;
    EXPECT_EQ(hex(printed.substr(i, 2)) + "-> " + hex(repaired.substr(i, 2)), "03 6c -> 13 6c ");
    ++changed;
  }
  EXPECT_EQ(changed, 3);
}

TEST(List, MultiplyFor386IsThisMachineCode) {
  if (!command::has("nasm")) GTEST_SKIP() << "nasm is not installed";
  EXPECT_EQ(hex(assemble(list("mul --target i386"))),
            "55 "                 // push bp
            "89 e5 "              // mov  bp, sp
            "66 8b 46 04 "        // mov  eax, [bp+4]
            "66 f7 6e 08 "        // imul dword [bp+8]
            "66 05 00 80 00 00 "  // add  eax, 8000h
            "66 83 d2 00 "        // adc  edx, 0
            "66 c1 e8 10 "        // shr  eax, 16
            "5d "                 // pop  bp
            "c3 ");               // ret
}

TEST(List, MultiplyFor8088BeginsWithThisMachineCode) {
  if (!command::has("nasm")) GTEST_SKIP() << "nasm is not installed";
  const std::string expected =
      "55 "        // push bp
      "89 e5 "     // mov  bp, sp
      "56 "        // push si
      "57 "        // push di
      "29 c9 "     // sub  cx, cx
      "8b 46 06 "  // mov  ax, [bp+6]
      "8b 76 04 "  // mov  si, [bp+4]
      "21 c0 "     // and  ax, ax
      "79 08 "     // jns  over the next four
      "f7 d8 "     // neg  ax
      "f7 de "     // neg  si
      "83 d8 00 "  // sbb  ax, 0
      "41 "        // inc  cx
      "8b 5e 0a "  // mov  bx, [bp+10]
      "8b 7e 08 "  // mov  di, [bp+8]
      "21 db "     // and  bx, bx
      "79 0a "     // jns  over the next four
      "f7 db "     // neg  bx
      "f7 df "     // neg  di
      "83 db 00 "  // sbb  bx, 0
      "83 f1 01 "  // xor  cx, 1
      "51 "        // push cx
      "50 "        // push ax
      "f7 e3 ";    // mul  bx
  EXPECT_EQ(hex(assemble(list("mul --target i8088"))).substr(0, expected.size()), expected);
}

TEST(List, CosSinBringsItsTable) {
  if (!command::has("nasm")) GTEST_SKIP() << "nasm is not installed";
  const std::string code = assemble(list("cossin --target i8088"));
  // 901 doublewords, from cos 0 = 1.0 to cos 90 = 0.
  ASSERT_GT(code.size(), 4 * 901);
  const std::string table = code.substr(code.size() - std::size_t{4} * 901);
  EXPECT_EQ(hex(table.substr(0, 4)), "00 00 01 00 ");
  EXPECT_EQ(hex(table.substr(std::size_t{4} * 600, 4)), "00 80 00 00 ");
  EXPECT_EQ(hex(table.substr(std::size_t{4} * 900)), "00 00 00 00 ");
}

TEST(List, BeginsWithSourceAndDigest) {
  const auto expect = [](std::string_view arguments, std::string_view source,
                         std::string_view digest) {
    command::expect_contains(list(arguments),
                             fmt::format("\n; source: {}\n; digest: {}", source, digest));
  };
  expect("mul --target i386", "listing 54.1",
         "3713cdcf6f7c0b06873a2fefe0c65b83e6611d5678414a2a0318476d80011023, the author's, 9 ");
  // The rounding of multiplies does not affect the divide.
  expect("div --target i386 --mul-round off --div-round on", "listing 54.1",
         "b54df775097e980339366294cc1a9365398e170ad1ddd9634cd77a368bfcf6ba, the author's, 29 ");
  expect("div --target i8088 --mul-round on --div-round off", "listing 54.1",
         "480e1206c81b88eafdebbc988d0683f1d184494cb261159ad38472dce6d6e0de, the author's, 32 ");
  expect("cossin --target i8088 --as-printed", "listing 54.1",
         "73e3cabcad47252fd65ae28d64ca4a92e8c80986ca0178501f90b6d3d563dc66, the author's, 72 ");
  expect("cossin --target i8088", "listing 54.1, but each SHL BX,2 is two shifts by one",
         "39f11737eba35c94059943c69a65960f0f6b662204c62397c227463f4bfcf951, ours, 76 ");
  // With rounding, the program as scanned is the same.
  expect("div --target i8088 --round on --as-scanned", "listing 54.1",
         "d7e871bb696cc0dfb39ec7d2d16e7d48a0ce5d8dfccbbfd456f17609d0ba1892, the author's, 38 ");
  expect("div --target i8088 --round off --as-scanned",
         "listing 54.1 as scanned, which is not the author's code", "none recorded\n");
  expect("div --chapter 52", "listing 52.9", "none recorded\n");
  expect("concat --chapter 52", "listing 52.4, which is C; the assembly is ours",
         "none recorded\n");
}

TEST(List, RoundingIsARow) {
  EXPECT_NE(list("mul --round on").find("add eax, 0x8000"), std::string::npos);
  EXPECT_EQ(list("mul --round off").find("add eax, 0x8000"), std::string::npos);
}

}  // namespace
