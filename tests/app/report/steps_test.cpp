// Tests the list of steps, their command lines, and the message when a step ends the report.
#include "app/cli/report/steps.hpp"

#include "tests/support/test.hpp"

namespace fixproof {
namespace {

cli::ReportStep step(const std::string& name) { return {name, "", {}, {}}; }

TEST(ReportSteps, OnlyMismatchesAreStatusOne) {
  EXPECT_TRUE(cli::shows_on_page(step("host"), 0));
  EXPECT_TRUE(cli::shows_on_page(step("verify"), 1));
  EXPECT_FALSE(cli::shows_on_page(step("verify"), 2));
  EXPECT_FALSE(cli::shows_on_page(step("host"), 1));
  EXPECT_EQ(cli::report_status(1), 2);
  EXPECT_EQ(cli::report_status(2), 2);
  EXPECT_EQ(cli::report_status(130), 130);
}

TEST(ReportSteps, SayWhereAndWhyTheReportEnds) {
  const auto says = [](const char* name, int status, const char* text) {
    return cli::stopped_text(step(name), status, 3, 9).find(text) != std::string::npos;
  };
  EXPECT_TRUE(says("host", 130, "STOPPED after 3 of 9 steps"));
  EXPECT_FALSE(says("host", 130, "rule"));
  EXPECT_TRUE(says("host", 1, "breaks its own rounding rule"));
  EXPECT_TRUE(says("stepping", 1, "exceeds its bound"));
}

TEST(ReportSteps, QuoteWhatAShellWouldSplit) {
  const std::vector<xsharp::Scene> scenes(1);
  cli::ReportRequest request;
  request.scenes = {"a b's.json"};
  request.folder = "out";
  const auto steps = cli::report_steps(request, scenes);
  ASSERT_EQ(steps.size(), 7U);
  EXPECT_EQ(
      steps[5].command,
      "fixproof drift 'a b'\\''s.json' --json out/data/drift.json --strip out/data/drift.svg");
}

}  // namespace
}  // namespace fixproof
