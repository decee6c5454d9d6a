// Tests that shards add up to the whole, and that duplicate or missing parts are reported.
#include "verify/merge.hpp"

#include "app/cli/table.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/engine/saboteur.hpp"
#include "verify/cases/plan.hpp"
#include "verify/report_json.hpp"

namespace fixproof {
namespace merge_test {

using Words = std::span<const std::uint32_t>;

const test::Saboteur& liar() {
  static const auto one =
      test::saboteur([](Words in, std::span<std::uint32_t> out, parties::Ending&) {
        if ((in[1] & 0xffU) == 0x7fU) ++out[0];
      });
  return one;
}

void run_rest(verify::Report& report) {
  verify::run(report, std::array<const parties::Party*, 2>{&liar(), &parties::party_named("fast")});
  report.seconds = 0;
}

verify::Report shard(cases::Shard which, std::uint64_t seed = 1) {
  verify::Report report(test::plan_against_fast({.operation = cases::Operation::div}, seed), which,
                        10);
  run_rest(report);
  return report;
}

std::vector<verify::NamedReport> shards(std::uint64_t count) {
  std::vector<verify::NamedReport> parts;
  for (std::uint64_t i = count; i >= 1; --i) {
    parts.push_back({"part " + std::to_string(i), shard({i, count})});
  }
  return parts;
}

TEST(Merging, TheSumOfAllShardsIsTheWhole) {
  const std::string whole = verify::to_json(shard({1, 1}));
  for (const std::uint64_t count : {1U, 2U, 3U, 5U, 7U, 200U}) {
    const auto parts = shards(count);
    const verify::Report sum = verify::merged(parts);
    EXPECT_EQ(verify::to_json(sum), whole) << count;
    EXPECT_EQ(verify::missing(sum, parts), "");
  }
}

TEST(Merging, APartGivenTwiceIsRefused) {
  auto parts = shards(3);
  parts.push_back(parts[0]);
  EXPECT_THROW(verify::merged(parts), std::runtime_error);
  const std::vector<verify::NamedReport> mixed{{"a", shard({1, 2})}, {"b", shard({1, 3})}};
  EXPECT_THROW(verify::merged(mixed), std::runtime_error);
}

TEST(Merging, PartsOfAnotherVerificationAreRefused) {
  const std::vector<verify::NamedReport> parts{{"a", shard({1, 2})}, {"b", shard({2, 2}, 9)}};
  try {
    verify::merged(parts);
    FAIL() << "merged";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "b belongs to another verification than a: seed 9, not 1");
  }
}

TEST(Merging, PartsOfAnotherBuildAreRefusedUnlessAccepted) {
  auto parts = shards(2);
  const auto refused = [&](auto change, const std::string& wanted) {
    auto changed = parts;
    verify::Maker& maker = changed[1].report.makers.at(0);
    change(maker);
    try {
      verify::merged(changed);
      ADD_FAILURE() << "merged";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(
          std::string(error.what()),
          "part 1 is from another build: " + wanted +
              "; run all parts with one build and the same parties, or give --accept-other-builds");
    }
    const verify::Report sum = verify::from_json(verify::to_json(verify::merged(changed, true)));
    ASSERT_EQ(sum.makers.size(), 2U);
    EXPECT_EQ(sum.makers[0], parts[0].report.makers[0]);
    EXPECT_EQ(sum.makers[1], maker);
    EXPECT_NE(cli::table(sum).find("2 builds answered"), std::string::npos);
  };
  const verify::Maker here = parts[0].report.makers.at(0);
  refused([](verify::Maker& m) { m.version = "0.0.9"; }, "version 0.0.9, not " + here.version);
  refused([](verify::Maker& m) { m.executable = "12ab"; },
          "executable 12ab, not " + here.executable);
  refused([](verify::Maker& m) { m.commit = "34cd"; }, "commit 34cd, not " + here.commit);
  refused([](verify::Maker& m) { m.parties["saboteur"] = "another"; },
          "saboteur another, not a saboteur");
  EXPECT_EQ(cli::table(verify::merged(parts)).find("builds"), std::string::npos);

  // All parts are of one build, but not of the one that merges.
  for (verify::NamedReport& part : parts) part.report.makers.at(0).executable = "56ef";
  EXPECT_THROW(verify::merged(parts), std::runtime_error);
  // It asks no party.
  parts = shards(2);
  for (auto& part : parts) part.report.makers.at(0).parties["saboteur"] = "another";
  EXPECT_EQ(verify::merged(parts).makers.size(), 1U);
}

TEST(Merging, WhatIsMissingIsNamed) {
  auto parts = shards(3);
  parts.erase(parts.begin() + 1);
  EXPECT_EQ(verify::missing(verify::merged(parts), parts), "missing: shard 2/3");

  // Only one chunk of this shard is done.
  parts.push_back({"stopped", shard({2, 60})});
  parts.erase(parts.begin(), parts.begin() + 2);
  EXPECT_EQ(verify::missing(verify::merged(parts), parts).substr(0, 43),
            "missing: shard 1/60, shard 3/60, shard 4/60");
}

TEST(Merging, AnIncompleteSumCanBeFinished) {
  auto parts = shards(4);
  parts.pop_back();
  verify::Report sum = verify::from_json(verify::to_json(verify::merged(parts)));
  EXPECT_FALSE(sum.complete());
  run_rest(sum);
  EXPECT_EQ(verify::to_json(sum), verify::to_json(shard({1, 1})));
}

}  // namespace merge_test
}  // namespace fixproof
