// Tests that any division of a plan covers its cases exactly once.
#include "verify/cases/plan.hpp"

#include "app/cli/selection.hpp"
#include "support/usage_error.hpp"
#include "tests/support/test.hpp"
#include "verify/report.hpp"

namespace fixproof {
namespace plan_test {

cases::Plan whole_plan(int level) {
  cli::Selection selection;
  selection.level = level;
  return {level, 1, cli::chosen_rows(selection, cli::chosen_parties(selection))};
}

TEST(Plan, ChunksCoverEveryJobWithoutGapOrOverlap) {
  for (const int level : {1, 2, 3}) {
    const cases::Plan plan = whole_plan(level);
    std::map<const cases::Job*, std::uint64_t> next;
    for (std::uint64_t number = 0; number < plan.chunks(); ++number) {
      const cases::Chunk chunk = plan.chunk(number);
      ASSERT_EQ(chunk.first, next[chunk.job]) << number;
      ASSERT_GT(chunk.cases, 0U);
      next[chunk.job] += chunk.cases;
    }
    ASSERT_EQ(next.size(), plan.jobs().size());
    for (const auto& [job, cases] : next) EXPECT_EQ(cases, job->cases);
  }
}

TEST(Plan, ShardsPartitionTheChunks) {
  const cases::Plan plan = whole_plan(1);
  for (std::uint64_t count = 1; count <= 7; ++count) {
    std::uint64_t sum = 0;
    for (std::uint64_t chunk = 0; chunk < plan.chunks(); ++chunk) {
      int owners = 0;
      for (std::uint64_t index = 1; index <= count; ++index) {
        owners += cases::Shard{index, count}.has(chunk) ? 1 : 0;
      }
      ASSERT_EQ(owners, 1) << chunk << " of " << count;
    }
    for (std::uint64_t index = 1; index <= count; ++index) {
      sum += verify::Report(plan, {index, count}, 10).chunks_in_shard();
    }
    EXPECT_EQ(sum, plan.chunks());
  }
  // With more shards than chunks, the last shards are empty.
  EXPECT_EQ(verify::Report(plan, {plan.chunks(), plan.chunks() + 5}, 10).chunks_in_shard(), 1U);
  EXPECT_EQ(verify::Report(plan, {plan.chunks() + 1, plan.chunks() + 5}, 10).chunks_in_shard(), 0U);
  EXPECT_TRUE(verify::Report(plan, {plan.chunks() + 5, plan.chunks() + 5}, 10).complete());
}

TEST(Plan, Levels1And2CompareEveryRowOfTheTable) {
  for (const int level : {1, 2}) {
    const cases::Plan plan = whole_plan(level);
    ASSERT_EQ(plan.rows().size(), cases::all_variants().size());
    for (std::size_t i = 0; i < plan.rows().size(); ++i) {
      EXPECT_EQ(plan.rows()[i].variant, cases::all_variants()[i]);
      EXPECT_TRUE(plan.rows()[i].compared());
    }
    EXPECT_GT(plan.cases(), 10'000'000U);
  }
}

TEST(Plan, Level3SamplesNothing) {
  const cases::Plan plan = whole_plan(3);
  std::map<cases::Operation, int> rows;
  for (const cases::Job& job : plan.jobs()) {
    EXPECT_EQ(job.stream, cases::Stream::every);
    const cases::Variant& v = plan.rows()[job.row].variant;
    EXPECT_EQ(job.cases, v.operation == cases::Operation::cossin ? 65536U : 1ULL << 32U);
    ++rows[v.operation];
  }
  // Both targets with both roundings, and the standard rules.
  EXPECT_EQ(rows[cases::Operation::mul], 5);
  EXPECT_EQ(rows[cases::Operation::div], 5);
  for (const cases::Operation o :
       {cases::Operation::sqrt, cases::Operation::sin, cases::Operation::cos,
        cases::Operation::decimal, cases::Operation::binary64}) {
    EXPECT_EQ(rows[o], 1);
  }
}

TEST(Plan, RefusesOtherLevels) {
  EXPECT_THROW(cases::Plan(0, 1, {}), std::invalid_argument);
  EXPECT_THROW(cases::Plan(4, 1, {}), std::invalid_argument);
}

std::vector<cases::Variant> divides(const cli::VariantOptions& options) {
  cli::Selection selection;
  selection.operations = {"div"};
  selection.variant = options;
  std::vector<cases::Variant> chosen;
  for (const cases::Row& row : cli::chosen_rows(selection, cli::chosen_parties(selection))) {
    if (row.variant.build.target != cases::Target::standard && !row.variant.build.chapter_52) {
      chosen.push_back(row.variant);
    }
  }
  return chosen;
}

TEST(Selection, PrintedSwitchesOfThe8088DivideAreInverted) {
  cli::VariantOptions options;
  options.div_round = true;
  for (const cases::Variant& v : divides(options)) EXPECT_TRUE(v.build.div_round);
  options.as_printed = true;
  const auto printed = divides(options);
  ASSERT_EQ(printed.size(), 2U);
  for (const cases::Variant& v : printed)
    EXPECT_EQ(v.build.div_round, v.build.target == cases::Target::i386);
}

TEST(Selection, APartyThatDoesNotAnswerIsLeftOut) {
  cli::Selection selection;
  selection.operations = {"sqrt"};
  const auto rows = cli::chosen_rows(selection, cli::chosen_parties(selection));
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].parties, (std::vector<std::string>{"oracle", "fast", "type"}));
}

TEST(Selection, TheRepairedConcatIsChosenByOneWord) {
  const auto chosen = [](bool repaired, bool as_printed, bool chapter_54) {
    cli::Selection selection;
    selection.operations = {"concat"};
    if (chapter_54) selection.variant.chapter_52 = false;
    selection.variant.targets = {cases::Target::i8088};
    selection.variant.repaired = repaired;
    selection.variant.as_printed = as_printed;
    std::vector<bool> forms;
    for (const cases::Variant& v : cli::chosen_variants(selection))
      forms.push_back(v.build.repaired);
    return forms;
  };
  EXPECT_EQ(chosen(false, false, false), (std::vector{false, false, true, true}));
  EXPECT_EQ(chosen(true, false, false), (std::vector{true, true}));
  EXPECT_EQ(chosen(false, true, false), (std::vector{false}));
  EXPECT_EQ(chosen(false, false, true), (std::vector{false, false}));

  cli::Selection refused;
  refused.variant.repaired = true;
  EXPECT_EQ(cli::chosen_variants(refused).size(), 2U);
  refused.operations = {"concat", "mul"};
  EXPECT_THROW(cli::chosen_variants(refused), support::UsageError);
  refused.operations = {"concat"};
  refused.variant.targets = {cases::Target::i386};
  EXPECT_THROW(cli::chosen_variants(refused), support::UsageError);
}

TEST(Selection, ReadsShards) {
  EXPECT_EQ(cases::parse_shard("2/7"), (cases::Shard{2, 7}));
  for (const char* text :
       {"0/3", "4/3", "x/y", "1", "1/", "/3", "1/3x", "-1/3", "1/-3", "", "1/0"}) {
    EXPECT_THROW(cases::parse_shard(text), support::UsageError) << text;
  }
}

}  // namespace plan_test
}  // namespace fixproof
