// Tests that common idioms are recognised by their wrong results.
#include "judge/check/idioms.hpp"

#include <cmath>

#include "judge/check/guess_text.hpp"
#include "tests/judge/check/judged.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace subjects;
using fixproof::cases::Operation;

const Rules div_half_away{.variant = {.operation = Operation::div},
                          .rounding = oracle::Rounding::half_away};
const Rules root_nearest{.variant = {.operation = Operation::sqrt},
                         .no_result = fixproof::check::NoResult::any};

/// Expects the line that says what the subject looks like, without its number of cases.
void expect_idiom(const Rules& rules, const SubjectFunction& subject, std::string_view idiom) {
  const std::string text = fixproof::check::guess_text(judged(rules, subject));
  const std::string line = "  looks like       " + std::string(idiom) + ", on all ";
  EXPECT_NE(text.find(line), std::string::npos) << text;
}

/// A subject that says DE for a zero divisor.
SubjectFunction divider(const std::function<std::int64_t(std::int64_t, std::int64_t)>& quotient) {
  return [quotient](auto a, auto b) { return b == 0 ? Said() : word(quotient(a, b)); };
}

TEST(CheckIdioms, AShift) {
  expect_idiom(
      mul_half_up, [](auto a, auto b) { return word(a * b >> 16); }, "(int64_t)a * b >> 16");
}

TEST(CheckIdioms, ADivision) {
  expect_idiom(
      mul_half_up, [](auto a, auto b) { return word(a * b / 65536); }, "(int64_t)a * b / 65536");
  expect_idiom(div_half_away, divider([](auto a, auto b) { return a * 65536 / b; }),
               "(int64_t)a * 65536 / b");
}

TEST(CheckIdioms, AHalfAdded) {
  Rules away = mul_half_up;
  away.rounding = oracle::Rounding::half_away;
  expect_idiom(
      away, [](auto a, auto b) { return word((a * b + 0x8000) >> 16); },
      "((int64_t)a * b + 0x8000) >> 16");
  expect_idiom(div_half_away, divider([](auto a, auto b) { return (a * 65536 + b / 2) / b; }),
               "((int64_t)a * 65536 + b / 2) / b, which is off for operands of unlike signs");
}

TEST(CheckIdioms, AHalfAddedAndCut) {
  constexpr std::string_view idiom =
      "(int)(x * 65536 + 0.5), which cuts negative results toward zero";
  expect_idiom(
      mul_half_up, [](auto a, auto b) { return word((a * b + 32768) / 65536); }, idiom);
  const auto quotient = [](std::int64_t a, std::int64_t b) {
    return static_cast<std::int64_t>(static_cast<double>(a) * 65536 / static_cast<double>(b) + 0.5);
  };
  expect_idiom(div_half_away, divider(quotient), idiom);
}

TEST(CheckIdioms, RoundingTwice) {
  expect_idiom(
      mul_half_up,
      [](auto a, auto b) {
        const std::int64_t guarded = (a * b + 0x80) >> 8;
        return word((guarded + 0x80) >> 8);
      },
      "((((int64_t)a * b + 0x80) >> 8) + 0x80) >> 8, which rounds twice");
  expect_idiom(
      mul_half_up,
      [](auto a, auto b) {
        const std::int64_t halves = (a * b + 0x4000) >> 15;
        return word((halves + 1) >> 1);
      },
      "((((int64_t)a * b + 0x4000) >> 15) + 1) >> 1, which rounds twice");
}

TEST(CheckIdioms, ALostCarry) {
  expect_idiom(
      mul_half_up,
      [](auto a, auto b) {
        const std::int64_t floor = a * b >> 16;
        const bool up = (a * b & 0xffff) >= 0x8000;
        const bool carries = up && (floor & 0xffff) == 0xffff;
        return word(carries ? floor - 0xffff : floor + (up ? 1 : 0));
      },
      "half-up without the carry from the fraction to the integer part");
}

TEST(CheckIdioms, ALostCarryOfASum) {
  expect_idiom(
      {.variant = {.operation = Operation::add}},
      [](auto a, auto b) {
        const bool carries = (a & 0xffff) + (b & 0xffff) > 0xffff;
        return word(a + b - (carries ? 65536 : 0));
      },
      "sums of fractions and integer parts, without the carry between them");
}

TEST(CheckIdioms, LostBits) {
  expect_idiom(
      mul_half_up, [](auto a, auto b) { return word((a >> 8) * (b >> 8)); },
      "(a >> 8) * (b >> 8), which drops the low bytes");
  expect_idiom(
      mul_half_up, [](auto a, auto b) { return word(static_cast<std::int32_t>(a * b) >> 16); },
      "a * b >> 16 in 32 bits, which drops the high half of the product");
  expect_idiom(
      div_half_away, [](auto a, auto b) { return b >> 8 == 0 ? Said() : word(a * 256 / (b >> 8)); },
      "(int64_t)a * 256 / (b >> 8), which drops the low byte of b");
  expect_idiom(div_half_away,
               divider([](auto a, auto b) { return a * ((std::int64_t{1} << 32) / b) >> 16; }),
               "(int64_t)a * ((1LL << 32) / b) >> 16, which cuts the reciprocal");
}

TEST(CheckIdioms, OtherRemainders) {
  const auto away = [](std::int64_t a, std::int64_t b) {
    return (2 * std::abs(a) + std::abs(b)) / (2 * std::abs(b)) * ((a < 0) != (b < 0) ? -1 : 1);
  };
  const auto down = [](std::int64_t a, std::int64_t b) {
    return a / b - (a % b != 0 && (a < 0) != (b < 0) ? 1 : 0);
  };
  expect_idiom({.variant = {.operation = Operation::fmod}},
               divider([&](auto a, auto b) { return a - b * down(a, b); }),
               "a - b * floor(a / b), which has the sign of b");
  expect_idiom({.variant = {.operation = Operation::remainder}},
               divider([](auto a, auto b) { return a % b; }),
               "a % b, the remainder of the truncated quotient");
  expect_idiom({.variant = {.operation = Operation::remainder}},
               divider([&](auto a, auto b) { return a - b * away(a, b); }),
               "a - b * round(a / b), whose ties go away from zero");
}

TEST(CheckIdioms, SinglePrecision) {
  expect_idiom(
      mul_half_up,
      [](auto a, auto b) {
        const float product = static_cast<float>(a) * static_cast<float>(b);
        return word(static_cast<std::int64_t>(product / 65536));
      },
      "(int)((float)a * b / 65536), which has 24 bits");
  expect_idiom(div_half_away, divider([](auto a, auto b) {
                 const float quotient = static_cast<float>(a) / static_cast<float>(b);
                 return static_cast<std::int64_t>(quotient * 65536);
               }),
               "(int)((float)a / b * 65536), which has 24 bits");
  expect_idiom(
      root_nearest,
      [](auto a, auto) {
        if (a < 0) return Said();
        const float root = std::sqrt(static_cast<float>(a) / 65536);
        return word(static_cast<std::int64_t>(root * 65536));
      },
      "(int)(sqrtf(a / 65536.0f) * 65536), which has 24 bits");
}

TEST(CheckIdioms, ExceptionsAreCounted) {
  const Judge judge = judged(mul_half_up, [](auto a, auto b) {
    return word((a * b >> 16) + (a == 77 || b == -2 ? 1 : 0));
  });
  const std::string text = fixproof::check::guess_text(judge);
  EXPECT_NE(text.find("looks like       (int64_t)a * b >> 16, but for "), std::string::npos)
      << text;
}

TEST(CheckIdioms, NoneWithoutAWrongResult) {
  const Judge sound = judged(mul_half_up, [](auto a, auto b) { return word(half_up(a * b)); });
  EXPECT_FALSE(sound.idioms().likeness());
}

TEST(CheckIdioms, NoneForADefectOfItsOwn) {
  // Nearly sound arithmetic is not called by the name of sound arithmetic.
  const Judge judge =
      judged(mul_half_up, [](auto a, auto b) { return word(half_up(a * b) + (a == 77 ? 1 : 0)); });
  EXPECT_FALSE(judge.idioms().likeness());
}

TEST(CheckIdioms, EachIsNamedOnceForAnOperation) {
  std::set<std::pair<Operation, std::string_view>> names;
  for (const auto& idiom : fixproof::check::idioms()) names.emplace(idiom.operation, idiom.text);
  EXPECT_EQ(names.size(), fixproof::check::idiom_count);
}

}  // namespace
