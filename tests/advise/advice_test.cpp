// Which choice is taken of those that were tried.
#include "verify/advise/advice.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "verify/advise/advice_text.hpp"

namespace fixproof {
namespace {

Tried tried(double clocks, double pixels) {
  Tried t;
  t.cost = {clocks, clocks, clocks};
  t.error.pixels = pixels;
  t.error.over = 7;
  return t;
}

TEST(Advice, IsTheCheapestWithinTheBudget) {
  std::vector<Tried> all{tried(400, 0.1), tried(100, 9), tried(200, 4), tried(300, 0.5)};
  sort_by_cost(all);
  const Advice advice = advise(all, 0.5);
  ASSERT_TRUE(advice.take && advice.runner_up && advice.next_cheaper);
  EXPECT_EQ(all[*advice.take].cost.least, 300);
  EXPECT_EQ(all[*advice.runner_up].cost.least, 400);
  EXPECT_EQ(all[*advice.next_cheaper].cost.least, 200);
  EXPECT_EQ(all[advice.nearest].cost.least, 400);
}

TEST(Advice, HasNothingCheaperThanTheCheapest) {
  std::vector<Tried> all{tried(100, 0.4), tried(200, 4)};
  const Advice advice = advise(all, 0.5);
  EXPECT_EQ(advice.take, 0U);
  EXPECT_FALSE(advice.runner_up);
  EXPECT_FALSE(advice.next_cheaper);
}

TEST(Advice, OfTheSameCostTakesTheMoreAccurate) {
  std::vector<Tried> all{tried(100, 0.4), tried(100, 0.3)};
  sort_by_cost(all);
  EXPECT_EQ(all.at(*advise(all, 0.5).take).error.pixels, 0.3);
}

TEST(Advice, IsNoneWhereNoneFits) {
  const AdviceReport report{
      .scene = "a scene", .budget = 0.5, .tried = {tried(100, 9), tried(200, 0.75)}};
  const Advice advice = advise(report.tried, report.budget);
  EXPECT_FALSE(advice.take);
  EXPECT_FALSE(advice.runner_up);
  EXPECT_EQ(advice.nearest, 1U);
  EXPECT_EQ(sentences_of(report).rfind("None stays within 0.5 pixels.", 0), 0U);
  EXPECT_NE(sentences_of(report).find("0.750 pixels off"), std::string::npos);
}

// Only drift has those.
TEST(Advice, NamesClippedCornersWhereDriftIsOverTheBudget) {
  AdviceReport report{.scene = "a scene", .budget = 0.5, .tried = {tried(100, 0.25)}};
  const auto names_them = [&report](double pixels) {
    report.drift_pixels = pixels;
    return sentences_of(report).find("corners that are clipped") != std::string::npos;
  };
  EXPECT_FALSE(names_them(0.5));
  EXPECT_TRUE(names_them(0.75));
}

RC_GTEST_PROP(Advice, IsNeverDearerForALargerBudget, ()) {
  std::vector<Tried> all;
  for (const auto& [clocks, pixels] :
       *rc::gen::nonEmpty<std::vector<std::pair<std::uint8_t, std::uint8_t>>>()) {
    all.push_back(tried(clocks, pixels));
  }
  sort_by_cost(all);
  const double small = *rc::gen::inRange(0, 256);
  const double large = small + *rc::gen::inRange(0, 100);
  const Advice strict = advise(all, small);
  const Advice loose = advise(all, large);
  if (!strict.take) return;
  RC_ASSERT(loose.take.has_value());
  RC_ASSERT(all[*loose.take].cost.ranked <= all[*strict.take].cost.ranked);
  // By definition: it fits, and whatever is cheaper does not.
  RC_ASSERT(all[*strict.take].error.pixels <= small);
  for (const Tried& t : all) {
    RC_ASSERT(t.cost.ranked >= all[*strict.take].cost.ranked || t.error.pixels > small);
  }
}

TEST(Choices, AreThoseThatTheProcessorRuns) {
  using enum x86model::Cpu;
  const auto runs_386_code = [](const Choice& c) { return c.target == Target::i386; };
  for (const auto cpu : {i8088, i286}) {
    EXPECT_EQ(choices_on(cpu).size(), 4U * 6);
    EXPECT_TRUE(std::ranges::none_of(choices_on(cpu), runs_386_code));
  }
  for (const std::optional<x86model::Cpu> cpu : {std::optional(i386), std::optional(i486), {}}) {
    const auto choices = choices_on(cpu);
    EXPECT_EQ(choices.size(), 8U * 6);
    for (auto it = choices.begin(); it != choices.end(); ++it) {
      EXPECT_EQ(std::find(it + 1, choices.end(), *it), choices.end()) << name_of(*it);
    }
  }
}

}  // namespace
}  // namespace fixproof
