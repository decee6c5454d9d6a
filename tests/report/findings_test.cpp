// The findings as the report computes them are those of docs/findings.md.
#include "cli/report/findings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "support/file.hpp"
#include "support/json.hpp"

namespace {

using fixproof::cli::computed_findings;

std::string answer(const fixproof::support::Json& findings, std::size_t number, std::size_t place) {
  for (const auto& finding : findings) {
    if (finding.at("number") != number) continue;
    return finding.at("cases").at(place).at("answer").get<std::string>();
  }
  return "no such finding";
}

TEST(ReportFindings, AreThoseOfThePage) {
  const std::string page = fixproof::support::read_file(FINDINGS);
  const auto findings = fixproof::cli::computed_findings();
  std::size_t headings = 0;
  for (std::size_t at = page.find("\n## "); at != std::string::npos;
       at = page.find("\n## ", at + 1)) {
    ++headings;
  }
  EXPECT_EQ(findings.size(), headings);
  for (const auto& finding : findings) {
    const std::string heading =
        fmt::format("\n## {}. {}\n\n`{}`.", finding.at("number").get<int>(),
                    finding.at("title").get<std::string>(), finding.at("test").get<std::string>());
    EXPECT_NE(page.find(heading), std::string::npos) << heading;
  }
}

// The page shows what the commands print, and is compared with them by a test of its own.
TEST(ReportFindings, AnswersOfCommandsStandOnThePage) {
  const std::string page = fixproof::support::read_file(FINDINGS);
  for (const auto& finding : fixproof::cli::computed_findings()) {
    if (finding.at("number") == 9) continue;  // shown there as a trace
    for (const auto& c : finding.at("cases")) {
      if (c.at("asked").get<std::string>().find("fixproof ") == std::string::npos) continue;
      const auto said = c.at("answer").get<std::string>();
      EXPECT_FALSE(said.empty());
      EXPECT_NE(page.find("\n" + said + "\n"), std::string::npos) << finding.at("title") << said;
    }
  }
}

TEST(ReportFindings, AnswersThatNoCommandGives) {
  const auto findings = fixproof::cli::computed_findings();
  EXPECT_EQ(answer(findings, 2, 4), "00000000");  // halves up: -1/2 unit to 0
  EXPECT_EQ(answer(findings, 3, 2), "7fffffff");  // the largest
  EXPECT_EQ(answer(findings, 5, 0), "ffff0001");
  EXPECT_EQ(answer(findings, 5, 1), "ffff0000");
  EXPECT_EQ(answer(findings, 7, 0), "stored");
  EXPECT_EQ(answer(findings, 7, 1), "no such place");
  EXPECT_EQ(answer(findings, 8, 0), "executes it");
  EXPECT_EQ(answer(findings, 8, 1), "does not have it");
  EXPECT_EQ(answer(findings, 9, 0), "00020000 00010000 00030000");
  EXPECT_EQ(answer(findings, 9, 1), "00020000 00020000 00030000");
  EXPECT_EQ(answer(findings, 9, 2), "00020000 00020000 00030000");
  EXPECT_EQ(answer(findings, 14, 0), "65,536 pixels");
  EXPECT_EQ(answer(findings, 14, 1), "no end within a million instructions");
  EXPECT_EQ(answer(findings, 14, 2), "0 pixels");
  EXPECT_EQ(answer(findings, 15, 0), "6 pixels");
  EXPECT_EQ(answer(findings, 15, 1), "65,536 pixels");
  EXPECT_EQ(answer(findings, 17, 0), "tested");
  EXPECT_EQ(answer(findings, 17, 1), "beyond its segment");
  EXPECT_EQ(answer(findings, 19, 0), "2.7 to 4.2 degrees off");
  EXPECT_EQ(answer(findings, 20, 2), "160 pixels from the middle");
  EXPECT_EQ(answer(findings, 20, 3), "80 pixels from the middle");
  EXPECT_EQ(answer(findings, 21, 0), "1 2 3");
  EXPECT_EQ(answer(findings, 21, 1), "2 3 4");
}

}  // namespace
