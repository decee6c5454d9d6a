#include "oracle/exact.hpp"
#include "tests/oracle/rules.hpp"
#include "tests/support/test.hpp"

namespace oracle {
namespace {

using Vector = std::array<Word, 3>;
using Transform = std::array<Word, 12>;

template <std::size_t N>
std::array<Word, N> whole(std::array<Word, N> numbers, int fraction_bits) {
  for (Word& number : numbers) number <<= fraction_bits;
  return numbers;
}

constexpr Transform kCounting{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

TEST(OracleXformVec, TakesTheMatrixRowByRow) {
  for (const int fraction_bits : {8, 16}) {
    for (const Rounding rule : test::kRoundings) {
      EXPECT_EQ(xform_vec(whole(kCounting, fraction_bits), whole<3>({1, 2, 3}, fraction_bits), rule,
                          fraction_bits),
                whole<3>({18, 46, 74}, fraction_bits));
    }
  }
}

TEST(OracleXformVec, RoundsEveryProductOnItsOwn) {
  constexpr Word half = 0x8000;
  const Transform m{half, half, half, 5, half, half, 0, 5, half, 0, 0, 5};
  const Vector one{1, 1, 1};
  EXPECT_EQ(xform_vec(m, one, Rounding::half_up, 16), (Vector{8, 7, 6}));
  EXPECT_EQ(xform_vec(m, one, Rounding::half_away, 16), (Vector{8, 7, 6}));
  EXPECT_EQ(xform_vec(m, one, Rounding::floor, 16), (Vector{5, 5, 5}));
  EXPECT_EQ(xform_vec(m, one, Rounding::truncate, 16), (Vector{5, 5, 5}));
  const Vector minus_one{0xffffffff, 0xffffffff, 0xffffffff};
  EXPECT_EQ(xform_vec(m, minus_one, Rounding::half_up, 16), (Vector{5, 5, 5}));
  EXPECT_EQ(xform_vec(m, minus_one, Rounding::half_away, 16), (Vector{2, 3, 4}));
  EXPECT_EQ(xform_vec(m, minus_one, Rounding::floor, 16), (Vector{2, 3, 4}));
  EXPECT_EQ(xform_vec(m, minus_one, Rounding::truncate, 16), (Vector{5, 5, 5}));
}

TEST(OracleXformVec, SumsWrap) {
  const Transform m{0x10000, 0, 0, 0x7fffffff, 0, 0x10000, 0, 0, 0x10000, 0, 0, 0x80000000};
  EXPECT_EQ(xform_vec(m, Vector{1, 0x80000000, 0}, Rounding::floor, 16),
            (Vector{0x80000000, 0x80000000, 0x80000001}));
}

TEST(OracleConcat, AddsTheFirstTranslationWhereItIsTold) {
  const Transform second{1, 0, 2, 1, 0, 1, 0, 2, 3, 0, 1, 3};
  for (const int fraction_bits : {8, 16}) {
    const Transform a = whole(kCounting, fraction_bits);
    const Transform b = whole(second, fraction_bits);
    for (const Rounding rule : test::kRoundings) {
      EXPECT_EQ(concat(a, b, rule, TranslationRule::fourth, fraction_bits),
                whole(Transform{10, 2, 5, 18, 26, 6, 17, 46, 42, 10, 29, 74}, fraction_bits));
      EXPECT_EQ(concat(a, b, rule, TranslationRule::every, fraction_bits),
                whole(Transform{14, 6, 9, 18, 34, 14, 25, 46, 54, 22, 41, 74}, fraction_bits));
    }
  }
}

TEST(OracleConcat, RoundsEveryProductOnItsOwn) {
  constexpr Word minus_half = 0xffff8000;
  const Transform first{minus_half, minus_half, minus_half, 9, 0, 0, 0, 0, 0, 0, 0, 0};
  const Transform second{1, 0, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1};
  const auto row = [&](Rounding rule) {
    const Transform product = concat(first, second, rule, TranslationRule::fourth, 16);
    return std::array{product[0], product[1], product[2], product[3]};
  };
  using Row = std::array<Word, 4>;
  EXPECT_EQ(row(Rounding::half_up), (Row{0, 0, 0, 9}));
  EXPECT_EQ(row(Rounding::half_away), (Row{0xfffffffd, 0xfffffffe, 0, 6}));
  EXPECT_EQ(row(Rounding::floor), (Row{0xfffffffd, 0xfffffffe, 0, 6}));
  EXPECT_EQ(row(Rounding::truncate), (Row{0, 0, 0, 9}));
}

// Worked by hand: each product is exact, 2^46 or -2^46 + 2^15 ulps.
TEST(OracleConcat, HoldsTheLargestSums) {
  constexpr Word least = 0x80000000;
  Transform all_least{};
  all_least.fill(least);
  Transform all_most{};
  all_most.fill(0x7fffffff);
  for (const Rounding rule : test::kRoundings) {
    for (const auto translation : {TranslationRule::fourth, TranslationRule::fourth_in_parts}) {
      EXPECT_EQ(concat(all_least, all_least, rule, translation, 16),
                (Transform{0, 0, 0, least, 0, 0, 0, least, 0, 0, 0, least}));
    }
    Transform expected{};
    expected.fill(0x80018000);
    EXPECT_EQ(concat(all_least, all_most, rule, TranslationRule::every, 16), expected);
    EXPECT_EQ(xform_vec(all_least, Vector{least, least, least}, rule, 16),
              (Vector{least, least, least}));
  }
}

// Worked by hand: the identity with the second translation, then with the first.
TEST(OracleConcat, InPartsLosesTheCarryOfTheFractions) {
  struct Case {
    int fraction_bits;
    Word second, first, whole, in_parts;
  };
  constexpr std::array cases{
      Case{16, 0x00008000, 0x00008000, 0x00010000, 0x00000000},  // 0.5 + 0.5
      Case{16, 0x00018000, 0x00008000, 0x00020000, 0x00010000},  // 1.5 + 0.5
      Case{16, 0x00008000, 0x00007fff, 0x0000ffff, 0x0000ffff},  // no carry: one unit below 1.0
      Case{16, 0xffffffff, 0x00000001, 0x00000000, 0xffff0000},  // -2^-16 is -1 plus a fraction
      Case{16, 0xffff8000, 0xffff8000, 0xffff0000, 0xfffe0000},  // -0.5 + -0.5
      Case{16, 0x7fff8000, 0x00008000, 0x80000000,
           0x7fff0000},  // the lost carry brings it into range
      Case{16, 0x80008000, 0x80008000, 0x00010000, 0x00000000},  // modulo 2^32
      Case{16, 0x80000000, 0xffff0000, 0x7fff0000, 0x7fff0000},  // whole numbers have no fraction
      Case{8, 0x0080, 0x0080, 0x0100, 0x0000},
      Case{8, 0x00ff, 0x0001, 0x0100, 0x0000},
      Case{8, 0x007f, 0x0080, 0x00ff, 0x00ff},
  };
  for (const Case& c : cases) {
    const Word one = Word{1} << c.fraction_bits;
    for (std::size_t row = 0; row < 3; ++row) {
      Transform first{one, 0, 0, 0, 0, one, 0, 0, 0, 0, one, 0};
      Transform second = first;
      Transform whole = first;
      Transform in_parts = first;
      first.at(4 * row + 3) = c.first;
      second.at(4 * row + 3) = c.second;
      whole.at(4 * row + 3) = c.whole;
      in_parts.at(4 * row + 3) = c.in_parts;
      for (const Rounding rule : test::kRoundings) {
        EXPECT_EQ(concat(first, second, rule, TranslationRule::fourth, c.fraction_bits), whole);
        EXPECT_EQ(concat(first, second, rule, TranslationRule::fourth_in_parts, c.fraction_bits),
                  in_parts);
      }
    }
  }
}

}  // namespace
}  // namespace oracle
