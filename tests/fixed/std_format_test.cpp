/// Tests fmt fields when fmt is included after the umbrella header.
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"
// The order matters: the test needs fmt after fixed, so do not sort the includes.
#include <fmt/format.h>

#include "fixed/std_format.hpp"

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

TEST(Format, SignAndZeros) {
  const q16_16 x(2.5);
  EXPECT_EQ(fmt::format("{:+}|{: }|{:-}|{:+}|{:+}", x, x, x, -x, q16_16()),
            "+2.5| 2.5|2.5|-2.5|+0");
  EXPECT_EQ(fmt::format("{:06}|{:06}|{:+06}|{:<06}|{:*^+7}", x, -x, x, x, x),
            "0002.5|-002.5|+002.5|2.5   |*+2.5**");
  EXPECT_EQ(fmt::format("{:#}|{:#}|{:#.0f}|{:#.0e}", x, q16_16(3), x, x), "2.5|3.|2.|2.e+00");
}

TEST(Format, FixedAndScientific) {
  const q16_16 x(-1234.625);
  EXPECT_EQ(fmt::format("{:f}|{:.2}|{:.2f}|{:.0f}|{:.1f}", x, x, x, x, x),
            "-1234.625000|-1234.62|-1234.62|-1235|-1234.6");
  EXPECT_EQ(fmt::format("{:e}|{:.2e}|{:.0e}|{:.9e}", x, x, x, x),
            "-1.234625e+03|-1.23e+03|-1e+03|-1.234625000e+03");
  EXPECT_EQ(fmt::format("{:e}|{:.0e}|{:.1f}", q16_16(), q16_16(), q16_16()),
            "0.000000e+00|0e+00|0.0");
  EXPECT_EQ(fmt::format("{:.1e}|{:.0f}|{:.1f}|{:.0f}", q16_16(9.96875), q16_16(999.5),
                        q16_16(99.96875), q16_16(-0.25)),
            "1.0e+01|1000|100.0|-0");
  EXPECT_EQ(fmt::format("{:+010.2f}|{:>10.1e}", q16_16(2.625), q16_16(0.015625)),
            "+000002.62|   1.6e-02");
}

TEST(Format, HexadecimalAndBinary) {
  const q16_16 x(-1.5);
  EXPECT_EQ(fmt::format("{:x}|{:#x}|{:#X}|{:b}|{:#b}", x, x, x, x, x),
            "-1.8|-0x1.8|-0X1.8|-1.1|-0b1.1");
  const q16_16 y = q16_16::from_raw(0x2abcdef1);
  EXPECT_EQ(fmt::format("{:x}|{:X}|{:+#012x}", y, y, q16_16(10.5)),
            "2abc.def1|2ABC.DEF1|+0x000000a.8");
  EXPECT_EQ(fmt::format("{:x}|{:x}|{:b}", std::numeric_limits<q16_16>::lowest(), q16_16(),
                        q16_16::from_raw(3)),
            "-8000|0|0.0000000000000011");
}

/// As for double, whose text is the same where it is exact.
TEST(Format, WidthAndPrecisionOfOtherArguments) {
  const q16_16 x(-1234.625);
  const double d = -1234.625;
  EXPECT_EQ(fmt::format("{:.{}f}", x, 2), "-1234.62");
  EXPECT_EQ(fmt::format("{:{}}|{:<{}}|{:0{}}", x, 11, x, 11, x, 11),
            "  -1234.625|-1234.625  |-001234.625");
  EXPECT_EQ(fmt::format("{:*^{}.{}f}|{}", x, 12, 1, 7), "**-1234.6***|7");
  EXPECT_EQ(fmt::format("{:*^{}.{}f}|{}", x, 12, 1, 7), fmt::format("{:*^{}.{}f}|{}", d, 12, 1, 7));
  EXPECT_EQ(fmt::format("{2:{0}.{1}e}", 12, 2, x), fmt::format("{2:{0}.{1}e}", 12, 2, d));
  EXPECT_EQ(fmt::format("{0:.{10}f}", x, 1, 2, 3, 4, 5, 6, 7, 8, 9, 3), "-1234.625");
  EXPECT_EQ(fmt::format("{:{wide}.{digits}f}", x, fmt::arg("digits", 1), fmt::arg("wide", 9)),
            "  -1234.6");
  EXPECT_EQ(fmt::format("{:.{}f}|{:.{}f}|{:.{}f}|{:{}}", x, 0L, x, 1ULL, x, short{2}, x, 0U),
            "-1235|-1234.6|-1234.62|-1234.625");
  EXPECT_EQ(fmt::format("{:#{}x}", q16_16(1.5), 8), "   0x1.8");
}

TEST(Format, RefusesOtherArgumentsAsWidthOrPrecision) {
  const q16_16 x(1);
  const double d = 1;
  const auto expect_refused = [&](const char* field, const auto& size) {
    EXPECT_THROW(static_cast<void>(fmt::format(fmt::runtime(field), d, size)), fmt::format_error);
    EXPECT_THROW(static_cast<void>(fmt::format(fmt::runtime(field), x, size)), fmt::format_error)
        << field;
  };
  for (const char* field : {"{:{}}", "{:.{}f}", "{0:{1}}", "{0:.{1}}"}) {
    expect_refused(field, -1);
    expect_refused(field, 1.5);
    expect_refused(field, true);
    expect_refused(field, '1');
    expect_refused(field, "1");
    expect_refused(field, 3'000'000'000U);
  }
  for (const char* field :
       {"{:{2}}", "{:{}.{}f}", "{0:{}}", "{:{0}}", "{:{", "{:{1", "{:{name}}", "{:{-1}}", "{:{01}}",
        "{:{1x}}", "{:{ }}", "{:.{}", "{:.{}x", "{0:{99999999999999999999}}"}) {
    expect_refused(field, 1);
  }
  EXPECT_THROW(static_cast<void>(fmt::format(fmt::runtime("{:{}}"), x, 1'000'001)),
               fmt::format_error);
  EXPECT_THROW(static_cast<void>(fmt::format(fmt::runtime("{:.{}x}"), x, 1)), fmt::format_error);
}

#if defined(__cpp_lib_format)
TEST(Format, StandardWidthAndPrecisionOfOtherArguments) {
  const q16_16 x(-1234.625);
  EXPECT_EQ(std::format("{:.{}f}", x, 2), "-1234.62");
  EXPECT_EQ(std::format("{:*^{}.{}f}|{}", x, 12, 1, 7), "**-1234.6***|7");
  EXPECT_EQ(std::format("{2:{0}.{1}f}", 9, 1, x), "  -1234.6");
  for (const char* field : {"{:{}}", "{:.{}f}", "{0:{1}}", "{:{name}}"}) {
    const double size = 1;
    EXPECT_THROW(static_cast<void>(std::vformat(field, std::make_format_args(x, size))),
                 std::format_error)
        << field;
  }
}
#endif

TEST(Format, RefusesWhatItDoesNotKnow) {
  const q16_16 x(1);
  for (const char* field :
       {"{:g}", "{:d}", "{:.}", "{:.f}", "{:.2x}", "{:.2X}", "{:.0b}", "{:++}", "{:#+}", "{:0+}",
        "{:6fe}", "{:E}", "{:<<<}", "{:99999999999999999999999}", "{:.99999999999999999999999}",
        "{:1000001}", "{:.1000001}", "{:*}", "{:L}"}) {
    EXPECT_THROW(static_cast<void>(fmt::format(fmt::runtime(field), x)), fmt::format_error)
        << field;
  }
  try {
    static_cast<void>(fmt::format(fmt::runtime("{:g}"), x));
  } catch (const fmt::format_error& error) {
    EXPECT_NE(std::string(error.what()).find("[[fill]align][sign][#][0][width][.precision][type]"),
              std::string::npos);
  }
}

}  // namespace
