/// Tests fmt fields when fmt is included after the umbrella header.
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"
// The order matters: the test needs fmt after fixed, so do not sort the includes.
#include <fmt/format.h>

#include "fixed/format.hpp"

namespace {

using fixproof::q16_16;
using fixproof::q8_8_saturating;

TEST(Format, ExactValueInAField) {
  EXPECT_EQ(fmt::format("{}", q16_16(-1.5)), "-1.5");
  EXPECT_EQ(fmt::format("{}", q8_8_saturating(1000)), "127.99609375");
  EXPECT_EQ(fmt::format("{:}|{:1}", q16_16(2.5), q16_16(2.5)), "2.5|2.5");
  EXPECT_EQ(
      fmt::format("{:6}|{:<6}|{:^6}|{:>6}", q16_16(2.5), q16_16(2.5), q16_16(2.5), q16_16(-2.5)),
      "   2.5|2.5   | 2.5  |  -2.5");
  EXPECT_EQ(fmt::format("{:*<6}{:<^7}{:->12}", q16_16(1), q16_16(2), q16_16(3)),
            "1*****<<<2<<<-----------3");
}

TEST(Format, RefusesWhatItDoesNotKnow) {
  const q16_16 x(1);
  for (const char* field :
       {"{:x}", "{:.2}", "{:+}", "{:6f}", "{:<<<}", "{:99999999999999999999999}", "{:*}"}) {
    EXPECT_THROW(static_cast<void>(fmt::format(fmt::runtime(field), x)), fmt::format_error)
        << field;
  }
}

}  // namespace
