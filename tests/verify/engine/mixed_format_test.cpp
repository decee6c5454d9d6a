// Tests verifications whose results have a format of their own: known answers, parties that agree,
// and a report of a wrong party that is read back.
#include <fmt/format.h>

#include <array>

#include "tests/support/test.hpp"
#include "tests/verify/engine/saboteur.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/streams.hpp"
#include "verify/cases/words.hpp"
#include "verify/parties/answer.hpp"
#include "verify/replay.hpp"
#include "verify/report_json.hpp"

namespace fixproof::mixed_format_test {

using cases::Operation;

cases::Variant mixed(Operation operation, const char* operands, const char* results) {
  return cases::variant_of(operation, cases::format_named(operands), cases::format_named(results));
}

std::vector<parties::Answer> answers_to(const cases::Variant& v,
                                        std::span<const std::uint32_t> words) {
  std::vector<parties::Answer> answers;
  for (const char* name : {"oracle", "fast", "type"}) {
    const parties::Party& party = parties::party_named(name);
    if (party.answers(v)) answers.push_back(parties::ask(party, v, words));
  }
  return answers;
}

struct Known {
  const char* operands_format;
  const char* results_format;
  Operation operation;
  const char* operands;
  const char* answer;
};
// GoogleTest puts this into the name of the test.
void PrintTo(const Known& known, std::ostream* out) {
  *out << known.operands_format << " to " << known.results_format << ' '
       << cases::name_of(known.operation) << ' ' << known.operands;
}

// By Python's fractions, rounded to nearest with ties up, modulo the word; functions by mpmath, at
// the end of the range where they leave it.
class KnownMixedAnswers : public testing::TestWithParam<Known> {};
TEST_P(KnownMixedAnswers, ComeFromEveryParty) {
  const Known& known = GetParam();
  const cases::Variant v = mixed(known.operation, known.operands_format, known.results_format);
  std::vector<std::uint32_t> words(cases::words_in(v));
  cases::parse_words(known.operands, v, words);
  const auto answers = answers_to(v, words);
  EXPECT_FALSE(answers.empty());
  for (const parties::Answer& answer : answers) {
    EXPECT_EQ(answer.text(v.format.word_bits), known.answer);
  }
}
INSTANTIATE_TEST_SUITE_P(
    Formats, KnownMixedAnswers,
    testing::Values(
        Known{"q8_8", "q24_8", Operation::mul, "8000 8000", "00400000"},
        Known{"q8_8", "q24_8", Operation::mul, "ff01 0080", "ffffff81"},
        Known{"q2_30", "q16_16", Operation::mul, "7fffffff 7fffffff", "00040000"},
        Known{"q16_16", "q2_30", Operation::div, "00010000 00030000", "15555555"},
        Known{"q16_16", "q8_8", Operation::div, "ffff0000 00020000", "ff80"},
        Known{"u16_16", "q16_16", Operation::div, "00000001 00020000", "00000001"},
        Known{"q24_8", "q2_30", Operation::div, "00000001 00000000", "DE"},
        Known{"q32_32", "q16_16", Operation::div, "0000000100000000 0000000300000000", "00005555"},
        Known{"q16_16", "q8_8", Operation::add, "00008080 00000000", "0081"},
        Known{"q16_16", "q8_8", Operation::sub, "ffff7f80 00000000", "ff80"},
        Known{"q16_16", "q32_32", Operation::add, "7fffffff 7fffffff", "0000fffffffe0000"},
        Known{"q16_16", "q2_30", Operation::sqrt, "00020000", "5a82799a"},
        Known{"q16_16", "q8_8", Operation::sqrt, "00000240", "0018"},
        Known{"q16_16", "u16_16", Operation::sqrt, "ffff0000", "00000000"},
        Known{"q16_16", "q2_30", Operation::sin, "00640000", "df97b491"},
        Known{"q2_30", "q16_16", Operation::tan, "60000000", "000e19f7"},
        Known{"q16_16", "u16_16", Operation::sin, "ffff0000", "00000000"},
        Known{"q16_16", "q8_8", Operation::exp, "00100000", "7fff"},
        Known{"q16_16", "q2_30", Operation::log, "00000000", "80000000"},
        Known{"q8_8", "q24_8", Operation::hypot3, "8000 8000 8000", "0000ddb4"}));

TEST(MixedFormats, PartiesAgreeInEveryPair) {
  constexpr std::array formats{"q8_8", "q24_8", "q16_16", "q2_30", "u16_16"};
  for (const char* operands : formats) {
    for (const char* results : formats) {
      if (std::string_view(operands) == results) continue;
      for (const Operation operation :
           {Operation::add, Operation::sub, Operation::mul, Operation::div, Operation::sqrt,
            Operation::hypot, Operation::hypot3, Operation::tan, Operation::exp2, Operation::log,
            Operation::atan2, Operation::acos, Operation::sin_of_turns}) {
        const cases::Variant v = mixed(operation, operands, results);
        ASSERT_TRUE(parties::party_named("type").answers(v)) << cases::name_of(v);
        const cases::Plan plan(1, 1, {{v, {"oracle", "type"}}});
        for (const cases::Job& job : plan.jobs()) {
          std::vector<std::uint32_t> words(20 * cases::words_in(v));
          cases::make_cases(job.stream, v, 3, 0, words);
          for (std::size_t i = 0; i < words.size(); i += cases::words_in(v)) {
            const auto one = std::span(words).subspan(i, cases::words_in(v));
            ASSERT_TRUE(parties::agree(answers_to(v, one)))
                << cases::name_of(v) << ' ' << cases::hex_words(one, cases::operand_bits(v));
          }
        }
      }
    }
  }
}

TEST(MixedFormats, OnlyTheOracleAnswersWhatTheTypeLacks) {
  const auto answers = [](const char* party, const cases::Variant& v) {
    return parties::party_named(party).answers(v);
  };
  for (const cases::Variant& v :
       {mixed(Operation::cbrt, "q16_16", "q2_30"), mixed(Operation::mul, "q48_16", "q16_16"),
        mixed(Operation::mul_div, "q16_16", "q8_8")}) {
    EXPECT_TRUE(answers("oracle", v)) << cases::name_of(v);
    EXPECT_FALSE(answers("type", v)) << cases::name_of(v);
    EXPECT_FALSE(answers("fast", v)) << cases::name_of(v);
    EXPECT_FALSE(answers("model", v)) << cases::name_of(v);
    EXPECT_FALSE(answers("batch", v)) << cases::name_of(v);
  }
  EXPECT_FALSE(answers("oracle", mixed(Operation::decimal, "q16_16", "q8_8")));
}

TEST(MixedFormats, AWrongPartyIsFoundAndTheReportIsReadBack) {
  const test::Saboteur liar(
      "saboteur", parties::party_named("oracle"),
      [](std::span<const std::uint32_t> in, std::span<std::uint32_t> out, parties::Ending&) {
        if ((in.back() & 7U) == 5U) out.back() ^= 1U;
      });
  const std::array<const parties::Party*, 2> both{&liar, &parties::party_named("type")};
  for (const auto& [operands, results] :
       {std::pair("q8_8", "q24_8"), std::pair("q16_16", "q8_8"), std::pair("q2_30", "q16_16")}) {
    verify::Report report(
        cases::Plan(1, 5, {{mixed(Operation::mul, operands, results), {"saboteur", "type"}}}), {},
        3);
    verify::run(report, both);
    report.seconds = 0;
    EXPECT_GT(report.mismatches(), 1000U);
    ASSERT_EQ(report.findings[0].shown.size(), 3U);
    const verify::Replay again = verify::replay(report.plan.rows()[0], report.findings[0].shown[0]);
    EXPECT_NE(
        again.verify.find(fmt::format("verify mul --format {} --to {} --case", operands, results)),
        std::string::npos)
        << again.verify;
    EXPECT_TRUE(again.trace.empty());
    const verify::Report back = verify::from_json(verify::to_json(report));
    EXPECT_EQ(back.plan.rows(), report.plan.rows());
    EXPECT_EQ(back.findings, report.findings);
  }
}

}  // namespace fixproof::mixed_format_test
