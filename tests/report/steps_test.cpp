// What the steps of a report leave behind, and when it is kept.
#include "cli/report/steps.hpp"

#include <gtest/gtest.h>

#include <string>

namespace fixproof {
namespace {

cli::ReportStep step(const std::string& name) { return {name, {"measure", "--" + name}, {}}; }

TEST(ReportSteps, OnlyMismatchesAreStatusOne) {
  EXPECT_TRUE(cli::page_shows(step("host"), 0));
  EXPECT_TRUE(cli::page_shows(step("verify"), 1));
  EXPECT_FALSE(cli::page_shows(step("verify"), 2));
  EXPECT_FALSE(cli::page_shows(step("host"), 1));
  EXPECT_EQ(cli::report_status(1), 2);
  EXPECT_EQ(cli::report_status(2), 2);
  EXPECT_EQ(cli::report_status(130), 130);
}

TEST(ReportSteps, GoOnOnlyWhereTheyWereStopped) {
  const auto says = [](int status, const std::string& what) {
    return cli::stopped_text(step("host"), status, 3, 9).find(what) != std::string::npos;
  };
  EXPECT_TRUE(says(130, "STOPPED after 3 of 9 steps"));
  EXPECT_TRUE(says(130, "goes on"));
  EXPECT_FALSE(says(1, "goes on"));
  EXPECT_FALSE(says(2, "goes on"));
  EXPECT_TRUE(says(1, "breaks its own rule"));
  EXPECT_FALSE(says(2, "breaks its own rule"));
  EXPECT_TRUE(says(2, "fixproof measure --host"));
  EXPECT_NE(cli::stopped_text(step("stepping"), 1, 3, 9).find("beyond its bound"),
            std::string::npos);
}

TEST(ReportSteps, AreOfOneProcessor) {
  EXPECT_EQ(cli::fingerprint({}, "one"), cli::fingerprint({}, "one"));
  EXPECT_NE(cli::fingerprint({}, "one"), cli::fingerprint({}, "another"));
}

}  // namespace
}  // namespace fixproof
