// Calling conventions as text.
#include "judge/code/frame.hpp"

#include "support/usage_error.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

TEST(Frame, RegistersInPairsAndPointers) {
  const judge::Frame frame = judge::frame_named("dx:ax, [bx] -> cl keeps si, di", 16, {});
  EXPECT_FALSE(frame.on_stack);
  ASSERT_EQ(frame.in.size(), 2U);
  ASSERT_EQ(frame.in[0].parts.size(), 2U);
  EXPECT_EQ(judge::name_of(frame.in[0].parts[0]), "dx");
  EXPECT_TRUE(frame.in[1].is_pointer);
  ASSERT_EQ(frame.out.size(), 1U);
  EXPECT_EQ(judge::name_of(frame.out[0].parts[0]), "cl");
  EXPECT_EQ(frame.kept.size(), 2U);
}

TEST(Frame, ConventionsOfTheStack) {
  EXPECT_TRUE(judge::frame_named("pascal-far", 16, {}).callee_pops);
  EXPECT_FALSE(judge::frame_named("pascal-far", 16, {}).first_is_top);
  EXPECT_TRUE(judge::frame_named("stdcall", 32, {}).first_is_top);
  EXPECT_EQ(judge::frame_named("c", 32, {}).kept.size(), 4U);
}

TEST(Frame, MistakesAreNamed) {
  for (const char* text :
       {"cdecl", "eax, ebz -> eax", "sp -> ax", "a:b:c -> ax", "[ax:bx] -> ax", "eax, eax -> eax",
        "dx:dx, cx:bx -> dx:ax", "eax, dx:ax -> eax", "ah, ax -> al", "eax, ebx -> ax:eax"}) {
    EXPECT_THROW(judge::frame_named(text, 32, {}), support::UsageError) << text;
  }
  EXPECT_THROW(judge::frame_named("c-far", 32, {}), support::UsageError);
  EXPECT_NO_THROW(judge::frame_named("ah:al, bh:bl -> ah:al", 16, {}));
  const cases::Variant mul;
  for (const char* text :
       {"eax -> eax", "ax, bx -> ax", "eax, ebx -> ax", "[si], ebx -> eax:edx"}) {
    EXPECT_NO_THROW((void)judge::frame_named(text, 16, {}));
  }
  EXPECT_THROW(judge::expect_fit(judge::frame_named("eax -> eax", 32, {}), mul, 32),
               support::UsageError);
  EXPECT_THROW(judge::expect_fit(judge::frame_named("ax, bx -> ax", 16, {}), mul, 16),
               support::UsageError);
}

}  // namespace
