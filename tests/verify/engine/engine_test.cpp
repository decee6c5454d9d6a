// Tests that a party with one rare error is caught and that every wrong case counts once.
#include "verify/engine.hpp"

#include <atomic>
#include <new>

#include "tests/support/test.hpp"
#include "tests/verify/engine/saboteur.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/streams.hpp"
#include "verify/report_json.hpp"

namespace fixproof {
namespace engine_test {

using test::judge;
using test::Saboteur;
using test::saboteur;
using Words = std::span<const std::uint32_t>;

constexpr cases::Variant mul{.operation = cases::Operation::mul};
constexpr cases::Variant div{.operation = cases::Operation::div};
constexpr cases::Variant div_8088{.operation = cases::Operation::div,
                                  .build = {.target = cases::Target::i8088}};
constexpr cases::Variant concat{.operation = cases::Operation::concat};

std::int64_t value_of(std::uint32_t word) { return static_cast<std::int32_t>(word); }

/// Counts the cases of a variant's plan for which `wanted` holds, generating them again.
template <class Wanted>
std::uint64_t count_cases(const cases::Variant& variant, Wanted wanted) {
  const cases::Plan plan = test::plan_against_fast(variant);
  std::uint64_t count = 0;
  std::vector<std::uint32_t> words(cases::words_in(variant.operation));
  for (const cases::Job& job : plan.jobs()) {
    for (std::uint64_t i = 0; i < job.cases; ++i) {
      cases::make_cases(job.stream, variant, plan.seed(), i, words);
      if (wanted(Words(words))) ++count;
    }
  }
  return count;
}

TEST(Engine, HonestPartiesAgree) {
  const auto honest = saboteur([](Words, auto, parties::Ending&) {});
  const verify::Report report = judge(honest, mul);
  EXPECT_TRUE(report.complete());
  EXPECT_EQ(report.mismatches(), 0U);
  EXPECT_EQ(report.cases(), report.plan.cases());
  EXPECT_GT(report.cases(), 1'000'000U);
}

TEST(Engine, WrongRoundingAtTiesOnly) {
  const auto is_negative_tie = [](Words in) {
    const std::int64_t product = value_of(in[0]) * value_of(in[1]);
    return product < 0 && (product & 0xffff) == 0x8000;
  };
  const auto liar = saboteur([&](Words in, std::span<std::uint32_t> out, parties::Ending&) {
    if (is_negative_tie(in)) --out[0];
  });
  const verify::Report report = judge(liar, mul);
  EXPECT_GT(report.mismatches(), 100'000U);
  EXPECT_EQ(report.mismatches(), count_cases(mul, is_negative_tie));
}

TEST(Engine, DroppedFaults) {
  const auto liar = saboteur([](Words, std::span<std::uint32_t> out, parties::Ending& ending) {
    out[0] = 0;
    ending = parties::Ending::value;
  });
  EXPECT_GT(judge(liar, div_8088).mismatches(), 100'000U);

  // Drops the fault of 8088 divisors one unit below 1.0.
  std::atomic<std::uint64_t> dropped = 0;
  const auto edge = saboteur([&](Words in, std::span<std::uint32_t> out, parties::Ending& ending) {
    if (in[1] != 0xffff || ending != parties::Ending::divide_error) return;
    out[0] = in[0];
    ending = parties::Ending::value;
    ++dropped;
  });
  const verify::Report report = judge(edge, div_8088, {.threads = 1});
  ASSERT_GT(report.mismatches(), 0U);
  // Shrinking asks the party again, so it drops more faults than there are cases.
  EXPECT_LE(report.mismatches(), dropped);
  EXPECT_EQ(report.mismatches(), count_cases(div_8088, [](Words in) { return in[1] == 0xffff; }));
}

TEST(Engine, ExtraFault) {
  const auto liar = saboteur([](Words in, auto, parties::Ending& ending) {
    // One unit above the largest divisor that faults.
    const std::int64_t n = std::abs(value_of(in[0]));
    if (std::abs(value_of(in[1])) == (n >> 16) + 1) ending = parties::Ending::divide_error;
  });
  EXPECT_GT(judge(liar, div).mismatches(), 10'000U);
}

TEST(Engine, OneWrongWordOfTwelve) {
  for (std::size_t wrong = 0; wrong < 12; ++wrong) {
    const auto liar = saboteur([wrong](Words in, std::span<std::uint32_t> out, parties::Ending&) {
      // About one case in 4,096.
      if ((in[7] & 0xfffU) == 0x123U) out[wrong] ^= 1U;
    });
    EXPECT_GT(judge(liar, concat).mismatches(), 0U) << "word " << wrong;
  }
}

TEST(Engine, WrongAtOneLatticeValueOnly) {
  for (const std::uint32_t value : {0x80000000U, 0x7fffffffU, 0x8001U, 0xffff7fffU, 0x55555555U}) {
    const auto liar = saboteur([value](Words in, std::span<std::uint32_t> out, parties::Ending&) {
      if (in[0] == value && in[1] == 0x10001U) ++out[0];
    });
    EXPECT_GE(judge(liar, mul).mismatches(), 1U) << std::hex << value;
    EXPECT_GE(judge(liar, div).mismatches(), 1U) << std::hex << value;
  }
}

TEST(Engine, WrongForTheMostNegativeOnly) {
  const auto liar = saboteur([](Words in, std::span<std::uint32_t> out, parties::Ending&) {
    if (in[0] == 0x80000000U) out[0] = 0x7fffffffU;
  });
  const cases::Variant sqrt{.operation = cases::Operation::sqrt,
                            .build = {.target = cases::Target::standard}};
  EXPECT_GT(judge(liar, sqrt).mismatches(), 0U);
}

TEST(Engine, PartiesThatBreakAlikeAreNotEqual) {
  for (const parties::Ending ending : {parties::Ending::undefined_flag, parties::Ending::broken}) {
    const auto spoil = [ending](Words in, auto, parties::Ending& e) {
      if (in[0] == 3) e = ending;
    };
    const Saboteur one("one", parties::party_named("fast"), spoil);
    const Saboteur two("two", parties::party_named("fast"), spoil);
    const std::array<const parties::Party*, 2> both{&one, &two};
    const verify::Report report = verify::run(cases::Plan(1, 1, {{mul, {"one", "two"}}}), both);
    EXPECT_GT(report.mismatches(), 0U);
  }
}

TEST(Engine, ACaseIsCountedOnceHoweverManyDiffer) {
  const auto liar = saboteur([](Words in, std::span<std::uint32_t> out, parties::Ending&) {
    if (in[0] == 2) ++out[0];
  });
  const std::array<const parties::Party*, 3> three{&liar, &parties::party_named("fast"),
                                                   &parties::party_named("type")};
  const verify::Report report =
      verify::run(cases::Plan(1, 1, {{mul, {"saboteur", "fast", "type"}}}), three);
  EXPECT_EQ(report.mismatches(), judge(liar, mul).mismatches());
  EXPECT_EQ(report.cases(), report.plan.cases());
}

TEST(Engine, FaultsAreCounted) {
  const auto honest = saboteur([](Words, auto, parties::Ending&) {});
  const verify::Report report = judge(honest, div_8088);
  EXPECT_EQ(report.findings[0].faults,
            count_cases(div_8088, [](Words in) { return std::abs(value_of(in[1])) < 0x10000; }));
}

TEST(Engine, ThreadsDoNotChangeTheReport) {
  const auto liar = saboteur([](Words in, std::span<std::uint32_t> out, parties::Ending&) {
    if ((in[0] & 0xffU) == 0x42U) ++out[0];
  });
  verify::Report alone = judge(liar, mul, {.threads = 1});
  verify::Report many = judge(liar, mul, {.threads = 7});
  alone.seconds = many.seconds = 0;
  EXPECT_EQ(verify::to_json(alone), verify::to_json(many));
}

TEST(Engine, EndsHoweverSoonItsThreadsDo) {
  // A stop must end the threads while others are still starting.
  const std::atomic<bool> stop = true;
  const auto honest = saboteur([](Words, auto, parties::Ending&) {});
  for (int round = 0; round < 500; ++round) {
    ASSERT_EQ(judge(honest, mul, {.threads = 8, .stop = &stop}).cases(), 0U);
  }
}

TEST(Engine, KeepsOnlyTheFirstMismatches) {
  const auto liar =
      saboteur([](Words, std::span<std::uint32_t> out, parties::Ending&) { ++out[0]; });
  const std::array<const parties::Party*, 2> both{&liar, &parties::party_named("fast")};
  for (const std::size_t most : {0U, 1U, 3U}) {
    verify::Report report(test::plan_against_fast(mul), cases::Shard{}, most);
    verify::run(report, both);
    EXPECT_EQ(report.findings[0].shown.size(), most);
    for (std::size_t i = 0; i < most; ++i) {
      EXPECT_EQ(report.findings[0].shown[i].chunk, 0U);
      EXPECT_EQ(report.findings[0].shown[i].index, i);
    }
    EXPECT_EQ(report.mismatches(), report.plan.cases());
  }
}

/// What verify::run() says of a party that throws.
std::string failure_of(const Saboteur& party) {
  try {
    judge(party, mul);
  } catch (const parties::PartyFailure& failure) {
    return failure.what();
  }
  return "nothing";
}

TEST(Engine, APartyThatFailsIsNamedWithItsReason) {
  EXPECT_EQ(failure_of(saboteur([](Words in, auto, parties::Ending&) {
              if (in[0] == 3) throw std::domain_error("three");
            })),
            "party 'saboteur' failed: three");
  EXPECT_EQ(failure_of(saboteur([](Words in, auto, parties::Ending&) {
              if (in[0] == 3) throw std::bad_alloc();
            })),
            "party 'saboteur' failed: out of memory");
}

TEST(Engine, WhatWasComparedBeforeAPartyFailedIsKept) {
  std::atomic<bool> fails = true;
  std::atomic<std::uint64_t> asked = 0;
  const auto party = saboteur([&](Words, std::span<std::uint32_t> out, parties::Ending&) {
    constexpr std::uint64_t before = 300'000;
    if (fails && ++asked > before) throw std::runtime_error("tired");
    ++out[0];
  });
  const std::array<const parties::Party*, 2> both{&party, &parties::party_named("fast")};
  verify::Report report(test::plan_against_fast(mul), cases::Shard{}, 1);
  EXPECT_THROW(verify::run(report, both, {.threads = 2}), parties::PartyFailure);
  EXPECT_FALSE(report.complete());
  std::uint64_t cases = 0;
  for (std::uint64_t chunk = 0; chunk < report.done.size(); ++chunk) {
    if (report.done[chunk]) cases += report.plan.chunk(chunk).cases;
  }
  EXPECT_GT(cases, 0U);
  EXPECT_EQ(report.cases(), cases);
  EXPECT_EQ(report.mismatches(), cases);
  EXPECT_GT(report.seconds, 0);

  // Goes on from a file to the same end as a run without a failure.
  fails = false;
  verify::Report resumed = verify::from_json(verify::to_json(report));
  verify::run(resumed, both, {.threads = 2});
  EXPECT_TRUE(resumed.complete());
  EXPECT_EQ(resumed.mismatches(), resumed.plan.cases());
  ASSERT_EQ(resumed.findings[0].shown.size(), 1U);
  EXPECT_EQ(resumed.findings[0].shown[0].said.size(), 2U);
}

TEST(Engine, AMissingPartyIsRefused) {
  const std::array<const parties::Party*, 1> alone{&parties::party_named("fast")};
  EXPECT_THROW(verify::run(test::plan_against_fast(mul), alone), std::invalid_argument);
}

TEST(Engine, ARowWithOnePartyIsNotRun) {
  const std::array<const parties::Party*, 1> alone{&parties::party_named("fast")};
  const verify::Report report = verify::run(cases::Plan(1, 1, {{mul, {"fast"}}, {div, {}}}), alone);
  EXPECT_EQ(report.cases(), 0U);
  EXPECT_FALSE(report.plan.rows()[0].compared());
}

}  // namespace engine_test
}  // namespace fixproof
