// Tests that the generated tests fail for each planted defect, in the streams that target it.
#include "judge/property/rapidcheck.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using fixproof::property::Subject;
using oracle::Rounding;

const check::Rules mul_half_up{.variant = {.operation = cases::Operation::mul},
                               .no_result = check::NoResult::any};
const check::Rules div_truncated{.variant = {.operation = cases::Operation::div},
                                 .rounding = Rounding::truncate};

std::set<std::string_view> streams_that_fail(const Subject& subject) {
  std::set<std::string_view> names;
  for (const auto& [stream, cases] :
       property::streams_of(subject.rules.variant.operation, subject.rules.variant.format)) {
    // A thousand cases suffice for the other streams; the lattice is enumerated in full.
    const auto few =
        stream == cases::Stream::lattice ? cases : std::min<std::uint64_t>(cases, 1000);
    if (!property::failures_in(subject, stream, few).empty()) names.insert(cases::name_of(stream));
  }
  return names;
}

std::int32_t low_word(std::int64_t value) { return static_cast<std::int32_t>(value); }

TEST(PropertySabotage, ATieThatGoesDown) {
  const auto subject = property::subject("down", mul_half_up, [](std::int32_t a, std::int32_t b) {
    return low_word((std::int64_t{a} * b + 0x7fff) >> 16);
  });
  const auto failed = streams_that_fail(subject);
  EXPECT_TRUE(failed.contains("product_ties"));
  EXPECT_TRUE(failed.contains("lattice"));
  EXPECT_FALSE(failed.contains("near_product_ties"));
}

TEST(PropertySabotage, ARoundingThatIsAUnitTooMuch) {
  const auto subject = property::subject("above", mul_half_up, [](std::int32_t a, std::int32_t b) {
    return low_word((std::int64_t{a} * b + 0x8001) >> 16);
  });
  const auto failed = streams_that_fail(subject);
  EXPECT_TRUE(failed.contains("near_product_ties"));
  EXPECT_FALSE(failed.contains("product_ties"));
}

TEST(PropertySabotage, AZeroDivisorIsAnError) {
  const auto subject = property::subject("zero", div_truncated, [](std::int32_t a, std::int32_t b) {
    return b == 0 ? 0 : low_word(std::int64_t{a} * 65536 / b);
  });
  EXPECT_TRUE(streams_that_fail(subject).contains("small_divisors"));
  EXPECT_FALSE(streams_that_fail(subject).contains("quotient_ties"));
}

TEST(PropertySabotage, RapidCheckFindsAndShrinks) {
  const auto floor = [](std::int32_t a, std::int32_t b) {
    return low_word(std::int64_t{a} * b >> 16);
  };
  testing::internal::CaptureStderr();
  const bool holds = property::property_holds(property::subject("floor", mul_half_up, floor));
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_FALSE(holds);
  EXPECT_NE(said.find("case 1 (RapidCheck): "), std::string::npos) << said;
  EXPECT_NE(said.find(" said; exact "), std::string::npos) << said;
}

TEST(PropertySabotage, WhatIsWrongIsSaid) {
  const auto subject =
      property::subject("none", mul_half_up, [](std::int32_t, std::int32_t) { return 1; });
  const std::string said = property::failures_in(subject, cases::Stream::product_ties, 10);
  EXPECT_EQ(said.rfind("10 of 10 cases are wrong:\ncase 1 (product_ties): ", 0), 0) << said;
}

/// A multiply that shifts without rounding.
TEST(PropertySabotage, AShiftInQ2_30) {
  const auto subject = property::subject<q2_30>(
      "shift", mul_half_up,
      [](std::int32_t a, std::int32_t b) { return low_word(std::int64_t{a} * b >> 30); });
  EXPECT_EQ(subject.rules.variant.format, cases::format_named("q2_30"));
  EXPECT_TRUE(streams_that_fail(subject).contains("product_ties"));
  testing::internal::CaptureStderr();
  EXPECT_FALSE(property::property_holds<q2_30>(subject));
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_NE(said.find(" expected, "), std::string::npos) << said;
}

TEST(PropertySabotage, A64BitProductThatLosesItsHighHalf) {
  const auto subject =
      property::subject<q32_32>("low", mul_half_up, [](std::int64_t a, std::int64_t b) {
        const auto low = static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b);
        return static_cast<std::int64_t>((low + (std::uint64_t{1} << 31U)) >> 32U);
      });
  EXPECT_TRUE(streams_that_fail(subject).contains("uniform"));
  // 1.0 * 1.0 loses all its bits.
  EXPECT_FALSE(property::holds(subject, std::array<std::uint64_t, 2>{0x100000000, 0x100000000}));
  // 2^-16 * 2^-16 is one ulp, and its low half has it.
  EXPECT_TRUE(property::holds(subject, std::array<std::uint64_t, 2>{0x10000, 0x10000}));
}

TEST(PropertySabotage, AnUnsignedProductJudgedAsSigned) {
  const auto product = [](std::uint16_t a, std::uint16_t b) {
    return static_cast<std::uint16_t>((int{static_cast<std::int16_t>(a)} * b + 128) >> 8);
  };
  const auto subject = property::subject<u8_8>("signed", mul_half_up, product);
  EXPECT_FALSE(streams_that_fail(subject).empty());
  const std::string said = property::failures_in(subject, cases::Stream::uniform, 1000);
  EXPECT_NE(said.find(" cases are wrong:\ncase "), std::string::npos) << said;
}

TEST(PropertyNames, OneTestForEachStream) {
  EXPECT_EQ(property::streams_of(cases::Operation::mul).size(), 5U);
  EXPECT_EQ(property::streams_of(cases::Operation::div).size(), 9U);
  EXPECT_EQ(property::streams_of(cases::Operation::sqrt).size(), 4U);
}

}  // namespace
