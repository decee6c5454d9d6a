// Tests `fixproof list` and `fixproof trace` of the inner loops against results worked out by hand.
#include <fmt/format.h>

#include "tests/support/command.hpp"
#include "tests/support/test.hpp"

namespace {

using command::expect_refused;

/// Assembles the output of `list` and returns the machine code in hex.
std::string loop_code(std::string_view arguments) {
  return command::hex(command::assemble(command::output_of(fmt::format("list {}", arguments))));
}

TEST(LoopCommands, AssembleToTheseBytes) {
  if (!command::has("nasm")) GTEST_SKIP() << "nasm is not installed";
  EXPECT_EQ(loop_code("gouraud-byte --target i8088"),
            "88 f0 "  // mov  al, dh
            "01 ea "  // add  dx, bp
            "aa "     // stosb
            "e2 f9 "  // loop to the first byte
            "c3 ");   // ret
  EXPECT_EQ(loop_code("gouraud-byte --loop dec-jnz"),
            "88 f0 "  // mov  al, dh
            "01 ea "  // add  dx, bp
            "aa "     // stosb
            "66 49 "  // dec  ecx
            "75 f7 "  // jnz  to the first byte
            "c3 ");   // ret
  const std::string depth = loop_code("depth --as-printed");
  EXPECT_EQ(depth.substr(0, 15), "66 0f ac d3 18 ") << "shrd ebx, edx, 24";
  EXPECT_EQ(loop_code("depth").substr(0, 15), "66 0f a4 d3 18 ") << "shld ebx, edx, 24";
  // A jump of two bytes, 320 pixels of five, and RET.
  EXPECT_EQ(loop_code("gouraud-byte --loop unrolled").size(), 3 * (2 + 320 * 5 + 1));
}

/// The lines of a trace without numbers and flags: "add dx, bp: edx=…".
std::vector<std::string> traced_loop(std::string_view arguments) {
  std::vector<std::string> lines;
  for (const std::string& line :
       command::split(command::output_of(fmt::format("trace {}", arguments)), '\n')) {
    if (line.size() < 36 || line.starts_with("   #")) continue;
    std::string text = line.substr(6, 30);
    text.erase(text.find_last_not_of(' ') + 1);
    const std::string changes = line.substr(std::min<std::size_t>(54, line.size()));
    lines.push_back(changes.empty() ? text : fmt::format("{}:{}", text, changes));
  }
  return lines;
}

TEST(LoopCommands, TracesOfTwoPixels) {
  // Starts at 20.80h with a step of 1.80h: the pixels are 20h and 22h.
  const std::vector<std::string> bytes{"mov al, dh:  eax=00000020",
                                       "add dx, bp:  edx=00002200",
                                       "stosb:  edi=00002801 [2800]=20",
                                       "loop .Pixel:  ecx=00000001",
                                       "mov al, dh:  eax=00000022",
                                       "add dx, bp:  edx=00002380",
                                       "stosb:  edi=00002802 [2801]=22",
                                       "loop .Pixel:  ecx=00000000",
                                       "ret:  esp=00000060"};
  EXPECT_EQ(traced_loop("gouraud-byte 00000002 00002080 00000180"), bytes);
  // Row 3 and column 32 select the texel.
  const auto texture =
      traced_loop("texture 00000001 00002000 00000000 00000300 00000000 --target i8088");
  ASSERT_EQ(texture.size(), 8U);
  EXPECT_EQ(texture[0], "mov bx, si:  bx=0300");
  EXPECT_EQ(texture[1], "mov bl, dh:  bx=0320");
  EXPECT_EQ(texture[2], "mov al, [Texture+bx]:  ax=0023");
  EXPECT_EQ(texture[3], "stosb:  di=2801 [2800]=23");
}

TEST(LoopCommands, FormsThatDoNotExistAreRefused) {
  expect_refused("list depth --loop unrolled", "depth needs --target i386");
  expect_refused("list depth --target i8088", "depth needs --target i386");
  expect_refused("list texture --as-printed", "only depth differs from its printed form");
  expect_refused("list gouraud-word --round on", "is an inner loop");
  expect_refused("list gouraud-word --chapter 52", "is an inner loop");
  expect_refused("list gouraud-word --chapter 54", "is an inner loop");
  expect_refused("list mul --loop dec-jnz", "--loop is for");
  expect_refused("list gouraud-byte --loop twice", "--loop");
  expect_refused("prove texture --round on", "is an inner loop");
  expect_refused("prove depth --target i8088", "depth exists only for i386");
  expect_refused("dos gouraud-byte -o loop.com", "gouraud-byte");
  expect_refused("eval gouraud-byte", "gouraud-byte");
}

TEST(LoopCommands, CallsThatNoLoopTakesAreRefused) {
  expect_refused("trace gouraud-byte 00000001 00000000", "takes 3 words, not 2");
  expect_refused("trace texture 00000001 00000000 00000000", "takes 5 words, not 3");
  expect_refused("trace gouraud-byte 00000000 00000000 00000000", "gouraud-byte: 0 pixels");
  expect_refused("trace gouraud-byte 00000141 00000000 00000000",
                 "gouraud-byte: 321 pixels; give 1 to 320");
  expect_refused("trace gouraud-word 00000003 00000000 00000000", "an even number");
  expect_refused("trace gouraud-byte 1.5 00000000 00000000", "'1.5' is not a whole number");
  expect_refused("trace gouraud-byte 00000001 00000000 00000000 --mutant 1", "for routines");
}

}  // namespace
