// Tests verifications in every format: ties are ties by exact arithmetic, parties agree, and a
// report of a wrong party is read back.
#include "verify/cases/format.hpp"

#include <fmt/format.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <fstream>
#include <set>
#include <sstream>

#include "oracle/format.hpp"
#include "support/usage_error.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/engine/saboteur.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/streams.hpp"
#include "verify/cases/words.hpp"
#include "verify/merge.hpp"
#include "verify/parties/answer.hpp"
#include "verify/replay.hpp"
#include "verify/report_json.hpp"

namespace fixproof {
namespace format_test {

using Integer = boost::multiprecision::cpp_int;
using cases::Operation;
using cases::Stream;

cases::Variant in_format(Operation operation, const cases::Format& format) {
  return {.operation = operation, .build = {.target = cases::Target::standard}, .format = format};
}

/// Every named format, and formats of all bits before or after the point that have no name.
std::vector<cases::Format> formats() {
  std::vector<cases::Format> all(cases::named_formats().begin(), cases::named_formats().end());
  for (const int bits : {8, 16, 32, 64}) {
    for (const int fraction : {0, 1, bits - 2, bits - 1, bits}) {
      for (const bool is_signed : {false, true}) all.push_back({bits, fraction, is_signed});
    }
  }
  return all;
}

Integer value_of(std::span<const std::uint32_t> words, const cases::Format& format) {
  Integer value = words[0];
  if (words.size() == 2) value += Integer(words[1]) << 32U;
  const Integer modulus = Integer(1) << format.word_bits;
  EXPECT_LT(value, modulus);
  return format.is_signed && value >= modulus / 2 ? Integer(value - modulus) : value;
}

/// Returns the operands of a stream's first cases, in units.
std::vector<std::vector<Integer>> made(Stream stream, const cases::Variant& v) {
  constexpr std::size_t sample = 1000;
  const std::size_t size = cases::words_in(v);
  const std::size_t each = cases::words_per_number(v.format);
  std::vector<std::uint32_t> words(sample * size);
  cases::make_cases(stream, v, 7, 0, words);
  std::vector<std::vector<Integer>> all(sample);
  for (std::size_t i = 0; i < words.size(); i += each) {
    all[i / size].push_back(value_of(std::span(words).subspan(i, each), v.format));
  }
  return all;
}

bool has(Stream stream, const cases::Variant& v) {
  const cases::Plan plan(1, 1, {{v, {"a", "b"}}});
  return std::any_of(plan.jobs().begin(), plan.jobs().end(),
                     [&](const cases::Job& job) { return job.stream == stream; });
}

/// Twice the distance of n / d from the nearest multiple of one half that is not whole, times d.
Integer from_tie(const Integer& n, const Integer& d) {
  const Integer modulus = abs(d);
  const Integer rest = abs(n) % modulus;
  return abs(2 * rest - modulus);
}

TEST(VerifyFormats, ProductTiesAreTies) {
  for (const cases::Format& format : formats()) {
    const cases::Variant v = in_format(Operation::mul, format);
    const Integer one = Integer(1) << format.fraction_bits;
    EXPECT_EQ(has(Stream::product_ties, v), format.fraction_bits > 0) << name_of(format);
    if (format.fraction_bits == 0) continue;
    for (const auto& c : made(Stream::product_ties, v)) {
      EXPECT_EQ(from_tie(c[0] * c[1], one), 0) << name_of(format) << ' ' << c[0] << ' ' << c[1];
    }
    std::size_t above = 0;
    const auto near = made(Stream::near_product_ties, v);
    for (const auto& c : near) {
      EXPECT_LE(from_tie(c[0] * c[1], one), 2) << name_of(format) << ' ' << c[0] << ' ' << c[1];
      const Integer rest = c[0] * c[1] % one;
      if (2 * (rest < 0 ? rest + one : rest) > one) ++above;
    }
    if (format.fraction_bits == 1) continue;  // the words beside a tie
    EXPECT_GT(above, near.size() / 4) << name_of(format);
    EXPECT_LT(above, near.size() * 3 / 4) << name_of(format);
  }
}

TEST(VerifyFormats, QuotientTiesAreTies) {
  for (const cases::Format& format : formats()) {
    const cases::Variant v = in_format(Operation::div, format);
    const Integer one = Integer(1) << format.fraction_bits;
    if (has(Stream::quotient_ties, v)) {
      for (const auto& c : made(Stream::quotient_ties, v)) {
        ASSERT_NE(c[1], 0);
        EXPECT_EQ(from_tie(c[0] * one, c[1]), 0) << name_of(format) << ' ' << c[0] << ' ' << c[1];
      }
    } else {
      // A tie needs a divisor that 2^(F+1) divides.
      EXPECT_GE(format.fraction_bits + 1, format.word_bits - (format.is_signed ? 1 : 0));
    }
    for (const auto& c : made(Stream::near_quotient_ties, v)) {
      ASSERT_NE(c[1], 0);
      EXPECT_EQ(from_tie(c[0] * one, c[1]), 1) << name_of(format) << ' ' << c[0] << ' ' << c[1];
    }
  }
}

// Up to 1.0, whose root is exact, the roots lie closer together than the operands, so few operands
// are that near.
TEST(VerifyFormats, RootTiesAbove1AreBesideAHalf) {
  for (const cases::Format& format : formats()) {
    const int bits = format.word_bits - (format.is_signed ? 1 : 0);
    const Integer one = Integer(1) << format.fraction_bits;
    std::size_t below = 0;
    std::size_t above = 0;
    std::size_t upper_half = 0;
    for (const auto& c : made(Stream::root_ties, in_format(Operation::sqrt, format))) {
      ASSERT_GE(c[0], 0) << name_of(format);
      upper_half += (c[0] >> (bits - 1)) != 0 ? 1U : 0U;
      if (c[0] <= one) continue;
      const Integer radicand = c[0] * one;
      const Integer root = sqrt(radicand);
      // Roots above the half have a positive rest. The operands next to the half are one unit
      // apart.
      const Integer rest = radicand - root * root - root;
      EXPECT_TRUE(rest > -one && rest <= one) << name_of(format) << ' ' << c[0];
      ++(rest > 0 ? above : below);
    }
    // The streams of the routines' formats stay as they were, and 64 bits leave no room for the
    // largest root of an odd number of fraction bits.
    const bool reaches_the_end = !has_routine_format(in_format(Operation::sqrt, format)) &&
                                 (bits < 64 || format.fraction_bits % 2 == 0);
    EXPECT_EQ(upper_half > 0, reaches_the_end) << name_of(format);
    if (bits < format.fraction_bits + 2) continue;  // no or few operands above 1.0
    EXPECT_GT(below, 0U) << name_of(format);
    EXPECT_GT(above, 0U) << name_of(format);
  }
}

TEST(VerifyFormats, AreThoseOfTheType) {
  std::ifstream file(paths::source("fixed/formats.hpp"));
  std::stringstream text;
  text << file.rdbuf();
  std::set<std::string> aliases{"q8_8", "q16_16"};  // of fixed/number.hpp
  std::string line;
  while (std::getline(text, line)) {
    std::array<char, 16> name{};
    if (std::sscanf(line.c_str(), "using %15[qu0-9_] = number<", name.data()) == 1) {
      aliases.insert(name.data());
    }
  }
  std::set<std::string> names;
  for (const cases::Format& format : cases::named_formats()) {
    EXPECT_TRUE(names.insert(name_of(format)).second) << name_of(format);
    EXPECT_EQ(cases::format_named(name_of(format)), format);
    EXPECT_TRUE(parties::party_named("type").answers(in_format(Operation::mul, format)));
  }
  EXPECT_EQ(names, aliases);
  EXPECT_FALSE(parties::party_named("type").answers(in_format(Operation::mul, {32, 5, true})));
}

TEST(VerifyFormats, PartiesAgreeOnEveryOperation) {
  constexpr std::array names{"oracle", "fast", "type"};
  for (const cases::Format& format : formats()) {
    for (const Operation operation :
         {Operation::add, Operation::sub, Operation::mul, Operation::div, Operation::sqrt,
          Operation::decimal, Operation::binary64, Operation::log, Operation::tan, Operation::pow,
          Operation::fmod, Operation::remainder, Operation::mul_div, Operation::hypot3}) {
      const cases::Variant v = in_format(operation, format);
      for (const Stream stream : {Stream::uniform, Stream::scaled}) {
        std::vector<std::uint32_t> words(200 * cases::words_in(v));
        cases::make_cases(stream, v, 3, 0, words);
        for (std::size_t i = 0; i < words.size(); i += cases::words_in(v)) {
          const auto one = std::span(words).subspan(i, cases::words_in(v));
          std::vector<parties::Answer> answers;
          for (const char* name : names) {
            const parties::Party& party = parties::party_named(name);
            if (party.answers(v)) answers.push_back(parties::ask(party, v, one));
          }
          if (answers.empty()) continue;  // functions of 64 bits, unsigned remainder
          ASSERT_TRUE(parties::agree(answers))
              << cases::name_of(v) << ' ' << cases::hex_words(one, format.word_bits);
        }
      }
    }
  }
}

// Where a plan has no ties of quotients, no pair of words has one, but for the most negative
// divisor.
TEST(VerifyFormats, BytesWithoutQuotientTiesHaveNone) {
  for (const char* name : {"q2_6", "q1_7", "q0_8", "u1_7", "u0_8", "q3_5", "u4_4"}) {
    const cases::Format format = cases::format_named(name);
    const Integer one = Integer(1) << format.fraction_bits;
    const auto exact = format.as<oracle::Format>();
    bool found = false;
    for (std::uint64_t n = 0; n < 256; ++n) {
      for (std::uint64_t d = 1; d < 256; ++d) {
        const Integer divisor = oracle::ulps(d, exact);
        if (divisor == -128) continue;
        found = found || from_tie(Integer(oracle::ulps(n, exact)) * one, divisor) == 0;
      }
    }
    EXPECT_EQ(found, has(Stream::quotient_ties, in_format(Operation::div, format))) << name;
  }
}

TEST(VerifyFormats, HaveNoOtherNames) {
  for (const char* name : {"", "q", "q16", "q16_", "_16", "q16_17", "q016_16", "Q16_16", "s16_16",
                           "q16_16 ", "q-1_9", "q8_8_8", "q100_28", "q1.5_2"}) {
    EXPECT_THROW(static_cast<void>(cases::format_named(name)), support::UsageError) << name;
  }
}

TEST(VerifyFormats, LevelThreeTriesWhatCanBeTried) {
  const auto tried = [](cases::Operation operation, const char* format) {
    return cases::can_be_exhausted(in_format(operation, cases::format_named(format)));
  };
  EXPECT_TRUE(tried(cases::Operation::mul, "q4_4"));
  EXPECT_TRUE(tried(cases::Operation::mul, "q4_12"));
  EXPECT_FALSE(tried(cases::Operation::mul, "q16_16"));
  EXPECT_TRUE(tried(cases::Operation::sqrt, "u0_32"));
  EXPECT_FALSE(tried(cases::Operation::sqrt, "q32_32"));
  const cases::Plan plan(
      3, 1, {{in_format(cases::Operation::mul, cases::format_named("u4_4")), {"a", "b"}}});
  EXPECT_EQ(plan.cases(), 65'536U);
  EXPECT_TRUE(tried(cases::Operation::remainder, "q8_8"));
  EXPECT_TRUE(tried(cases::Operation::mul_div, "q4_4"));
  EXPECT_FALSE(tried(cases::Operation::mul_div, "q8_8"));
}

struct Known {
  const char* format;
  Operation operation;
  const char* operands;
  const char* answer;
};
// GoogleTest puts this into the name of the test.
void PrintTo(const Known& known, std::ostream* out) {
  *out << known.format << ' ' << cases::name_of(known.operation) << ' ' << known.operands;
}

// By Python's fractions and integers, rounded to nearest with ties up, modulo the word.
class KnownAnswers : public testing::TestWithParam<Known> {};
TEST_P(KnownAnswers, ComeFromEveryParty) {
  const Known& known = GetParam();
  const cases::Variant v = in_format(known.operation, cases::format_named(known.format));
  std::vector<std::uint32_t> words(cases::words_in(v));
  cases::parse_words(known.operands, v, words);
  for (const char* name : {"oracle", "fast", "type"}) {
    const parties::Party& party = parties::party_named(name);
    if (!party.answers(v)) continue;
    EXPECT_EQ(parties::ask(party, v, words).text(v.format.word_bits), known.answer) << name;
  }
  EXPECT_EQ(cases::hex_words(words, v.format.word_bits), known.operands);
}
INSTANTIATE_TEST_SUITE_P(
    Formats, KnownAnswers,
    testing::Values(
        Known{"q2_30", Operation::mul, "60000000 20000000", "30000000"},
        Known{"q2_30", Operation::mul, "80000000 80000000", "00000000"},
        Known{"q2_30", Operation::div, "40000000 60000000", "2aaaaaab"},
        Known{"q2_30", Operation::sqrt, "7fffffff", "5a82799a"},
        Known{"u8_8", Operation::mul, "0181 0180", "0242"},
        Known{"u8_8", Operation::sub, "0000 0001", "ffff"},
        Known{"u8_8", Operation::div, "ffff 0003", "5500"},
        Known{"u8_8", Operation::div, "0001 0000", "DE"},
        Known{"q1_15", Operation::mul, "8000 8000", "8000"},
        Known{"q1_15", Operation::mul, "8001 4000", "c001"},
        Known{"q4_4", Operation::mul, "f8 01", "00"}, Known{"q4_4", Operation::mul, "08 01", "01"},
        Known{"u0_8", Operation::sqrt, "ff", "ff"}, Known{"q8_0", Operation::div, "07 fe", "fd"},
        Known{"q8_0", Operation::div, "f9 fe", "04"},
        Known{"q32_32", Operation::mul, "0000000180000000 ffffffff40000000", "fffffffee0000000"},
        Known{"q32_32", Operation::div, "0000000100000000 0000000300000000", "0000000055555555"},
        Known{"q32_32", Operation::sqrt, "0000000200000000", "000000016a09e668"},
        Known{"q32_32", Operation::sqrt, "ffffffff00000000", "0000000000000000"},
        Known{"q32_32", Operation::add, "7fffffffffffffff 0000000000000001", "8000000000000000"},
        Known{"u0_64", Operation::mul, "ffffffffffffffff ffffffffffffffff", "fffffffffffffffe"},
        Known{"u0_64", Operation::div, "8000000000000000 c000000000000000", "aaaaaaaaaaaaaaab"},
        Known{"u0_64", Operation::sqrt, "ffffffffffffffff", "ffffffffffffffff"},
        Known{"q1_63", Operation::mul, "8000000000000000 8000000000000000", "8000000000000000"},
        Known{"u32_32", Operation::sub, "0000000000000000 0000000100000001", "fffffffeffffffff"},
        Known{"q2_62", Operation::binary64, "2000000000000001", "2000000000000000"},
        Known{"q2_62", Operation::decimal, "dfffffffffffffff", "dfffffffffffffff"},
        Known{"u48_16", Operation::binary64, "fffffffffffffbff", "fffffffffffff800"},
        Known{"u48_16", Operation::div, "123456789abcdef0 0000000000010001", "1234444456788877"},
        Known{"u0_32", Operation::mul, "ffffffff ffffffff", "fffffffe"},
        Known{"q16_16", Operation::fmod, "00058000 00020000", "00018000"},
        Known{"q16_16", Operation::fmod, "fffa8000 00020000", "fffe8000"},
        Known{"q16_16", Operation::fmod, "80000000 ffffffff", "00000000"},
        Known{"q16_16", Operation::fmod, "00010000 00000000", "DE"},
        Known{"u8_8", Operation::fmod, "ffff 8001", "7ffe"},
        Known{"u32_32", Operation::fmod, "ffffffffffffffff 8000000000000003", "7ffffffffffffffc"},
        Known{"q16_16", Operation::remainder, "00098000 00020000", "ffff8000"},
        Known{"q16_16", Operation::remainder, "00030000 00020000", "ffff0000"},
        Known{"q16_16", Operation::remainder, "00050000 00020000", "00010000"},
        Known{"q16_16", Operation::remainder, "80000000 7fffffff", "ffffffff"},
        Known{"q4_4", Operation::remainder, "80 80", "00"},
        Known{"q32_32", Operation::remainder, "8000000000000000 7fffffffffffffff",
              "ffffffffffffffff"},
        Known{"q1_15", Operation::remainder, "ffff 0000", "DE"},
        Known{"q16_16", Operation::mul_div, "75300000 4e200000 61a80000", "5dc00000"},
        Known{"q16_16", Operation::mul_div, "00000007 00000003 fffffffa", "fffffffd"},
        Known{"q16_16", Operation::mul_div, "80000000 80000000 ffffffff", "00000000"},
        Known{"q16_16", Operation::mul_div, "80000000 00000001 ffffffff", "80000000"},
        Known{"q16_16", Operation::mul_div, "00000000 00000000 00000000", "DE"},
        Known{"u0_64", Operation::mul_div, "ffffffffffffffff ffffffffffffffff fffffffffffffffe",
              "0000000000000000"},
        Known{"q32_32", Operation::mul_div, "8000000000000000 8000000000000000 8000000000000001",
              "7fffffffffffffff"},
        Known{"q16_16", Operation::hypot3, "00020000 fffd0000 00060000", "00070000"},
        Known{"q16_16", Operation::hypot3, "80000000 80000000 80000000", "7fffffff"},
        Known{"q16_16", Operation::hypot3, "00000001 00000000 00000001", "00000001"},
        Known{"u0_32", Operation::hypot3, "90000000 70000000 60000000", "ce2544b5"},
        Known{"q4_4", Operation::hypot3, "80 00 00", "7f"}));

TEST(VerifyFormats, OperandsInDecimalAreExact) {
  const auto text = [](const char* format, const char* hex) {
    const cases::Variant v = in_format(Operation::sqrt, cases::format_named(format));
    std::vector<std::uint32_t> words(cases::words_in(v));
    cases::parse_words(hex, v, words);
    return cases::decimal_words(v, words);
  };
  EXPECT_EQ(text("u8_8", "ff80"), "255.5");
  EXPECT_EQ(text("q4_4", "f8"), "-0.5");
  EXPECT_EQ(text("q2_30", "80000000"), "-2");
  EXPECT_EQ(text("q32_32", "ffffffffc0000000"), "-0.25");
  EXPECT_EQ(text("u0_64", "c000000000000000"), "0.75");
  EXPECT_EQ(text("q1_63", "8000000000000000"), "-1");
  EXPECT_EQ(text("q64_0", "8000000000000000"), "-9223372036854775808");
  EXPECT_THROW(text("u8_8", "ff8"), support::UsageError);
  EXPECT_THROW(text("q32_32", "c0000000"), support::UsageError);
}

/// A wrong multiply in words of 64 and of 8 bits.
class WrongParty : public testing::TestWithParam<const char*> {
 protected:
  static cases::Variant variant() {
    return in_format(Operation::mul, cases::format_named(GetParam()));
  }
  static const test::Saboteur& liar() {
    static const test::Saboteur one(
        "saboteur", parties::party_named("oracle"),
        [](std::span<const std::uint32_t> in, std::span<std::uint32_t> out, parties::Ending&) {
          if ((in.back() & 7U) == 5U) out.back() ^= 1U;
        });
    return one;
  }
  static verify::Report finished(cases::Shard shard = {}) {
    verify::Report report(cases::Plan(1, 5, {{variant(), {"saboteur", "type"}}}), shard, 3);
    const std::array<const parties::Party*, 2> both{&liar(), &parties::party_named("type")};
    verify::run(report, both);
    report.seconds = 0;
    return report;
  }
};

TEST_P(WrongParty, IsFoundAndTheReportIsReadBack) {
  const verify::Report report = finished();
  EXPECT_GT(report.mismatches(), 1000U);
  ASSERT_EQ(report.findings[0].shown.size(), 3U);
  const verify::Mismatch& shown = report.findings[0].shown[0];
  EXPECT_FALSE(shown.smallest.empty());
  EXPECT_NE(shown.said[0].second, shown.said[1].second);
  const verify::Replay again = verify::replay(report.plan.rows()[0], shown);
  EXPECT_NE(again.verify.find(fmt::format("verify mul --format {} --case", GetParam())),
            std::string::npos);
  EXPECT_TRUE(again.verify.ends_with(" --by saboteur --against type")) << again.verify;
  const std::string text = verify::to_json(report);
  EXPECT_NE(text.find(fmt::format("\"format\": \"{}\"", GetParam())), std::string::npos);
  const verify::Report back = verify::from_json(text);
  EXPECT_EQ(back.plan.rows(), report.plan.rows());
  EXPECT_EQ(back.findings, report.findings);
}

TEST_P(WrongParty, ShardsMergeToTheWhole) {
  std::vector<verify::NamedReport> parts;
  for (const std::uint64_t i : {1U, 2U}) {
    parts.push_back({fmt::format("{}.json", i), finished({i, 2})});
  }
  // The saboteur belongs to no build.
  const verify::Report merged = verify::merged(parts, true);
  EXPECT_TRUE(merged.complete());
  EXPECT_EQ(merged.findings, finished().findings);
}
INSTANTIATE_TEST_SUITE_P(Formats, WrongParty, testing::Values("q32_32", "u8_8", "q4_4"));

}  // namespace format_test
}  // namespace fixproof
