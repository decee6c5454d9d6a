// Tests the position of exact results between ulps, worked by hand.
#include "judge/check/exact_place.hpp"

#include "tests/support/test.hpp"

namespace {

using fixproof::cases::Operation;
using fixproof::cases::q16_16;
using fixproof::cases::variant_of;
using fixproof::check::CaseKind;
using Operands = std::vector<std::uint64_t>;

void expect_place(Operation operation, const Operands& words, CaseKind kind,
                  const std::string& text, bool negative) {
  const auto place = fixproof::check::exact_place(variant_of(operation, q16_16), words);
  EXPECT_EQ(place.kind(false), kind) << text;
  EXPECT_EQ(fixproof::check::exact_text(variant_of(operation, q16_16), words), text);
  EXPECT_EQ(place.negative, negative) << text;
}

TEST(CheckPlace, OfProducts) {
  expect_place(Operation::mul, {0x18000, 0x28000}, CaseKind::exact, "245760", false);
  expect_place(Operation::mul, {1, 0x8000}, CaseKind::tie, "0 + 1/2", false);
  expect_place(Operation::mul, {0xffffffff, 0x8000}, CaseKind::tie, "-1 + 1/2", true);
  expect_place(Operation::mul, {1, 0x8001}, CaseKind::near_tie, "0 + 32769/65536", false);
  expect_place(Operation::mul, {1, 0x803f}, CaseKind::near_tie, "0 + 32831/65536", false);
  expect_place(Operation::mul, {1, 0x8040}, CaseKind::between, "0 + 513/1024", false);
  expect_place(Operation::mul, {1, 0x4000}, CaseKind::between, "0 + 1/4", false);
  expect_place(Operation::mul, {0, 0xffffffff}, CaseKind::exact, "0", false);
}

TEST(CheckPlace, OfSumsAndDifferences) {
  expect_place(Operation::add, {0x7fffffff, 1}, CaseKind::exact, "2147483648", false);
  expect_place(Operation::add, {0xffffffff, 0}, CaseKind::exact, "-1", true);
  expect_place(Operation::sub, {0x80000000, 1}, CaseKind::exact, "-2147483649", true);
}

TEST(CheckPlace, OfQuotients) {
  // 2 / 3 is 43690 2/3 ulps.
  expect_place(Operation::div, {0x20000, 0x30000}, CaseKind::between, "43690 + 2/3", false);
  expect_place(Operation::div, {0x20000, 0xfffd0000}, CaseKind::between, "-43691 + 1/3", true);
  expect_place(Operation::div, {0xfffe0000, 0xfffd0000}, CaseKind::between, "43690 + 2/3", false);
  expect_place(Operation::div, {1, 0x20000}, CaseKind::tie, "0 + 1/2", false);
  expect_place(Operation::div, {0xffffffff, 0x20000}, CaseKind::tie, "-1 + 1/2", true);
  expect_place(Operation::div, {1, 0x20001}, CaseKind::near_tie, "0 + 65536/131073", false);
  expect_place(Operation::div, {0x10000, 0x20000}, CaseKind::exact, "32768", false);
}

TEST(CheckPlace, OfRoots) {
  expect_place(Operation::sqrt, {0x40000}, CaseKind::exact, "131072", false);
  // 92681.900024; 207243.03
  expect_place(Operation::sqrt, {0x20000}, CaseKind::between, "92681 + 0.90002", false);
  // The largest root is 11863283.203.
  expect_place(Operation::sqrt, {0x7fffffff}, CaseKind::between, "11863283 + 0.20027", false);
}

TEST(CheckPlace, WithoutAResult) {
  const auto zero =
      fixproof::check::exact_place(variant_of(Operation::div, q16_16), Operands{0xffff0000, 0});
  EXPECT_EQ(zero.kind(false), CaseKind::no_result);
  EXPECT_TRUE(zero.negative);
  EXPECT_EQ(fixproof::check::exact_place(variant_of(Operation::sqrt, q16_16), Operands{0x80000000})
                .kind(false),
            CaseKind::no_result);
}

TEST(CheckPlace, OverflowIsAKindOfItsOwn) {
  const auto place = fixproof::check::exact_place(variant_of(Operation::mul, q16_16),
                                                  Operands{0x1000000, 0x800000});
  EXPECT_EQ(place.kind(true), CaseKind::overflow);
}

}  // namespace
