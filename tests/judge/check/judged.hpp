/// @file
/// Judges a function by the cases of level 1, for tests that plant a defect in it.
#pragma once

#include <functional>
#include <limits>
#include <span>

#include "judge/check/cases.hpp"
#include "judge/check/judge.hpp"
#include "tests/support/test.hpp"

namespace subjects {

using fixproof::check::Judge;
using fixproof::check::Rules;
using fixproof::check::Said;
using SubjectFunction = std::function<Said(std::int64_t, std::int64_t)>;

inline constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
inline constexpr std::int64_t least = std::numeric_limits<std::int32_t>::min();

inline Said word(std::int64_t ulps) { return static_cast<std::uint32_t>(ulps); }

inline Judge judged(const Rules& rules, const SubjectFunction& subject) {
  fixproof::check::CaseOptions options;
  options.cases = 60'000;
  fixproof::check::GeneratedCases cases(rules.variant, options);
  Judge judge(rules, 3);
  fixproof::check::JudgedCase one;
  const auto words = std::span(one.words).first(fixproof::cases::words_in(rules.variant.operation));
  std::array<std::uint32_t, 2> parts{};
  while (cases.next(std::span(parts).first(words.size()))) {
    fixproof::check::join_words(parts, rules.variant.format, words);
    ++one.number;
    one.origin = "stream";
    one.said =
        subject(static_cast<std::int32_t>(one.words[0]), static_cast<std::int32_t>(one.words[1]));
    judge.add(one);
  }
  EXPECT_EQ(judge.cases(), *cases.count());
  return judge;
}

inline const Rules mul_half_up{.variant = {.operation = fixproof::cases::Operation::mul},
                               .rounding = oracle::Rounding::half_up};
inline const Rules div_truncated{.variant = {.operation = fixproof::cases::Operation::div},
                                 .rounding = oracle::Rounding::truncate};

inline std::int64_t half_up(std::int64_t product) { return (product + 32768) >> 16; }

inline Said truncated_quotient(std::int64_t a, std::int64_t b) {
  return b == 0 ? Said() : word(a * 65536 / b);
}

}  // namespace subjects
