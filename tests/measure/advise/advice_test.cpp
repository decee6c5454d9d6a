// Tests which of the tried choices the advice takes.
#include "measure/trade/advice/advice.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "app/cli/advice_text.hpp"
#include "tests/support/test.hpp"
#include "verify/parties/machines.hpp"

namespace fixproof {
namespace {

trade::Tried tried(double clocks, double pixels) {
  trade::Tried t;
  t.cost = {clocks, clocks, clocks};
  t.error.pixels = pixels;
  t.error.over = 7;
  return t;
}

TEST(Advice, IsTheCheapestWithinTheBudget) {
  std::vector<trade::Tried> all{tried(400, 0.1), tried(100, 9), tried(200, 4), tried(300, 0.5)};
  trade::sort_by_cost(all);
  const trade::Advice advice = trade::advise(all, 0.5);
  ASSERT_TRUE(advice.take && advice.runner_up && advice.next_cheaper);
  EXPECT_EQ(all[*advice.take].cost.least, 300);
  EXPECT_EQ(all[*advice.runner_up].cost.least, 400);
  EXPECT_EQ(all[*advice.next_cheaper].cost.least, 200);
  EXPECT_EQ(all[advice.nearest].cost.least, 400);
}

TEST(Advice, HasNothingCheaperThanTheCheapest) {
  std::vector<trade::Tried> all{tried(100, 0.4), tried(200, 4)};
  const trade::Advice advice = trade::advise(all, 0.5);
  EXPECT_EQ(advice.take, 0U);
  EXPECT_FALSE(advice.runner_up);
  EXPECT_FALSE(advice.next_cheaper);
}

TEST(Advice, OfTheSameCostTakesTheMoreAccurate) {
  std::vector<trade::Tried> all{tried(100, 0.4), tried(100, 0.3)};
  trade::sort_by_cost(all);
  EXPECT_EQ(all.at(*trade::advise(all, 0.5).take).error.pixels, 0.3);
}

trade::Tried timed(double median, double spread, double pixels) {
  trade::Tried t = tried(median, pixels);
  t.cost.spread = spread;
  return t;
}

// 200, 200.5 and 204 differ by at most their spread of 5. 209 is dearer; 201 exceeds the budget.
TEST(Advice, WithinTheSpreadTakesTheMoreExact) {
  std::vector<trade::Tried> all{timed(209, 50, 0.1),   timed(200, 5, 0.4), timed(204, 5, 0.3),
                                timed(200.5, 5, 0.45), timed(201, 5, 9),   timed(150, 5, 8)};
  trade::sort_by_cost(all);
  const trade::Advice advice = trade::advise(all, 0.5);
  ASSERT_TRUE(advice.take && advice.runner_up && advice.next_cheaper);
  EXPECT_EQ(all[*advice.take].cost.ranked, 204);
  EXPECT_EQ(all[*advice.runner_up].cost.ranked, 200);
  EXPECT_EQ(all[*advice.next_cheaper].cost.ranked, 150);
  EXPECT_EQ(advice.equal_cost_count, 2U);
}

TEST(Advice, SaysWhatCostsTheSame) {
  trade::AdviceReport report{
      .scene = "a scene", .budget = 0.5, .tried = {timed(200, 5, 0.4), timed(204, 5, 0.3)}};
  EXPECT_NE(cli::sentences_of(report).find("1 other choice within the budget costs the same"),
            std::string::npos)
      << cli::sentences_of(report);
  EXPECT_NE(cli::sentences_of(report).find("which costs the same, at most 0.400"),
            std::string::npos);
  report.tried = {timed(200, 1, 0.4), timed(204, 1, 0.3)};
  EXPECT_EQ(cli::sentences_of(report).find("the same"), std::string::npos)
      << cli::sentences_of(report);
}

TEST(Advice, AsJsonSaysWhatMadeItAndHasNullForInfinity) {
  trade::AdviceReport report{
      .scene = "a scene",
      .budget = 0.5,
      .tried = {timed(100, 0, std::numeric_limits<double>::infinity()), timed(200, 5, 0.25)}};
  // Compares text because infinity becomes null only there.
  const auto json = support::Json::parse(support::json_text(report));
  EXPECT_EQ(json.at("made").at("command"), "advise");
  EXPECT_EQ(json.at("made").at("processor"), parties::processor_name());
  EXPECT_FALSE(json.at("made").contains("seed"));
  EXPECT_TRUE(json.at("variants").at(0).at("worst_pixels").is_null());
  EXPECT_EQ(json.at("variants").at(1).at("worst_pixels"), 0.25);
  EXPECT_EQ(json.at("variants").at(1).at("cost_spread"), 5);
  report.cpu = x86model::Cpu::i386;
  EXPECT_TRUE(support::Json(report).at("made").at("processor").is_null());
}

TEST(Advice, IsNoneWhereNoneFits) {
  const trade::AdviceReport report{
      .scene = "a scene", .budget = 0.5, .tried = {tried(100, 9), tried(200, 0.75)}};
  const trade::Advice advice = trade::advise(report.tried, report.budget);
  EXPECT_FALSE(advice.take);
  EXPECT_FALSE(advice.runner_up);
  EXPECT_EQ(advice.nearest, 1U);
  EXPECT_EQ(cli::sentences_of(report).rfind("No choice stays within 0.5 pixels.", 0), 0U);
  EXPECT_NE(cli::sentences_of(report).find("0.750 pixels off"), std::string::npos);
}

// Clipped corners affect only drift.
TEST(Advice, NamesClippedCornersWhereDriftIsOverTheBudget) {
  trade::AdviceReport report{.scene = "a scene", .budget = 0.5, .tried = {tried(100, 0.25)}};
  const auto names_them = [&report](double pixels) {
    report.drift_pixels = pixels;
    return cli::sentences_of(report).find("clipped corners") != std::string::npos;
  };
  EXPECT_FALSE(names_them(0.5));
  EXPECT_TRUE(names_them(0.75));
}

RC_GTEST_PROP(Advice, IsNeverDearerForALargerBudget, ()) {
  std::vector<trade::Tried> all;
  for (const auto& [clocks, pixels] :
       *rc::gen::nonEmpty<std::vector<std::pair<std::uint8_t, std::uint8_t>>>()) {
    all.push_back(tried(clocks, pixels));
  }
  trade::sort_by_cost(all);
  const double small = *rc::gen::inRange(0, 256);
  const double large = small + *rc::gen::inRange(0, 100);
  const trade::Advice strict = trade::advise(all, small);
  const trade::Advice loose = trade::advise(all, large);
  if (!strict.take) return;
  RC_ASSERT(loose.take.has_value());
  RC_ASSERT(all[*loose.take].cost.ranked <= all[*strict.take].cost.ranked);
  RC_ASSERT(all[*strict.take].error.pixels <= small);
  for (const trade::Tried& t : all) {
    RC_ASSERT(t.cost.ranked >= all[*strict.take].cost.ranked || t.error.pixels > small);
  }
}

TEST(Choices, AreThoseThatTheProcessorRuns) {
  using enum x86model::Cpu;
  const auto runs_386_code = [](const trade::Choice& c) {
    return c.build.target == cases::Target::i386;
  };
  for (const auto cpu : {i8088, i286}) {
    EXPECT_EQ(trade::choices_on(cpu).size(), 4U * 6);
    EXPECT_TRUE(std::ranges::none_of(trade::choices_on(cpu), runs_386_code));
  }
  for (const std::optional<x86model::Cpu> cpu : {std::optional(i386), std::optional(i486), {}}) {
    const auto choices = trade::choices_on(cpu);
    EXPECT_EQ(choices.size(), 8U * 6);
    for (auto it = choices.begin(); it != choices.end(); ++it) {
      EXPECT_EQ(std::find(it + 1, choices.end(), *it), choices.end()) << trade::name_of(*it);
    }
  }
}

}  // namespace
}  // namespace fixproof
