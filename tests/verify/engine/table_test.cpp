// Tests the tables that commands print.
#include "app/cli/table.hpp"

#include "app/cli/progress.hpp"
#include "support/plain_text.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/engine/saboteur.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/words.hpp"

namespace fixproof {
namespace table_test {

using Words = std::span<const std::uint32_t>;

constexpr cases::Variant mul{.operation = cases::Operation::mul};
constexpr cases::Variant cossin{.operation = cases::Operation::cossin};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++times;
  return times;
}

verify::Report report_of(const test::Saboteur& liar, std::size_t max_shown) {
  verify::Report report(cases::Plan(1, 1, {{mul, {"saboteur", "fast"}}, {cossin, {"saboteur"}}}),
                        cases::Shard{}, max_shown);
  const std::array<const parties::Party*, 2> parties{&liar, &parties::party_named("fast")};
  verify::run(report, parties);
  return report;
}

TEST(TableText, NumbersAreGrouped) {
  EXPECT_EQ(support::grouped(0), "0");
  EXPECT_EQ(support::grouped(999), "999");
  EXPECT_EQ(support::grouped(1000), "1,000");
  EXPECT_EQ(support::grouped(4294967296), "4,294,967,296");
}

TEST(TableText, DurationsAreAsPreciseAsServes) {
  EXPECT_EQ(support::duration(8.34), "8.3 s");
  EXPECT_EQ(support::duration(61), "1 min 01 s");
  EXPECT_EQ(support::duration(3 * 3600 + 61), "3 h 01 min");
}

TEST(TableText, OperandsInDecimal) {
  const std::array<std::uint32_t, 4> words{0x28000, 0xffff0000, 1, 0x80000000};
  EXPECT_EQ(cases::decimal_words(mul, words), "2.5 -1 0.00002 -32768");
  const std::array<std::uint32_t, 1> angle{0xffff};
  EXPECT_EQ(cases::decimal_words(cossin, angle), "-0.1 degrees");
  const std::array<std::uint32_t, 1> half{0x80ff};
  EXPECT_EQ(
      cases::decimal_words({.operation = cases::Operation::sqrt, .format = cases::q8_8}, half),
      "-127.00391");
}

TEST(Table, ShowsEachDistinctMismatchOnce) {
  const auto liar =
      test::saboteur([](Words in, std::span<std::uint32_t> out, parties::Ending& ending) {
        if (in[0] == 0x80000000U && in[1] == 0) out[0] = 7;
        if (in[0] == 0 && in[1] == 1) ending = parties::Ending::divide_error;
      });
  const std::string text = cli::table(report_of(liar, 1000));
  EXPECT_EQ(
      count(text, "mul i386 on: 80000000 00000000 (-32768 0): saboteur 00000007, fast 00000000"),
      1U);
  EXPECT_EQ(count(text, "mul i386 on: 00000000 00000001 (0 0.00002): saboteur DE, fast 00000000"),
            1U);
  EXPECT_EQ(count(text, "\n  replay: fixproof verify mul --target i386 "), 2U);
  EXPECT_EQ(count(text, " --by saboteur --against fast\n"), 2U);
  EXPECT_EQ(count(text, "trace: "), 0U);
  EXPECT_EQ(count(text, "DIFFER"), 2U);  // once in the row, once in the verdict
}

TEST(Table, CountsMismatchesBeyondTheCap) {
  const auto liar =
      test::saboteur([](Words, std::span<std::uint32_t> out, parties::Ending&) { ++out[0]; });
  const verify::Report report = report_of(liar, 10);
  const std::string text = cli::table(report);
  EXPECT_EQ(count(text, "replay: "), 1U);
  EXPECT_EQ(count(text, "10 cases shrink to it"), 1U);
  EXPECT_EQ(
      count(text, support::grouped(report.mismatches() - 10) + " more mismatches are not shown"),
      1U);
  EXPECT_EQ(count(text, support::grouped(report.mismatches()) + " cases DIFFER, in 1 row."), 1U);
}

TEST(Table, NeverPassesOverARowThatIsNotCompared) {
  const std::string text =
      cli::table(report_of(test::saboteur([](Words, auto, parties::Ending&) {}), 10));
  EXPECT_EQ(count(text, "not compared"), 1U);
  EXPECT_EQ(count(text, "1 row is NOT COMPARED"), 1U);
}

TEST(Table, CallsARowEqualOnlyWhenItIsFinished) {
  verify::Report report = report_of(test::saboteur([](Words, auto, parties::Ending&) {}), 10);
  EXPECT_EQ(count(cli::table(report), "  equal\n"), 1U);
  report.done.back() = false;
  const std::string text = cli::table(report);
  EXPECT_EQ(count(text, "  equal so far\n"), 1U);
  EXPECT_EQ(count(text, "INCOMPLETE"), 1U);
}

TEST(Table, IsNarrowerThanATerminal) {
  std::istringstream lines(
      cli::table(report_of(test::saboteur([](Words, auto, parties::Ending&) {}), 10)));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
}

TEST(Progress, EstimatesFromTheChunksOfThisRunAlone) {
  verify::Report report = report_of(test::saboteur([](Words, auto, parties::Ending&) {}), 10);
  const std::uint64_t half = report.chunks_done() / 2;
  report.done.back() = false;
  EXPECT_EQ(count(cli::progress_text(report, 0, 1), "left"), 0U);
  const std::string text = cli::progress_text(report, half, 10.0 * static_cast<double>(half));
  EXPECT_EQ(count(text, "about 10 s left: mul i386 on"), 1U) << text;
  EXPECT_LT(text.size(), 80U);
}

}  // namespace table_test
}  // namespace fixproof
