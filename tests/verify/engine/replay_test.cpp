// Tests that a shell can run the command lines of a mismatch and that they repeat the case.
#include "verify/replay.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>

#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/streams.hpp"
#include "verify/engine.hpp"
#include "verify/parties/answer.hpp"

namespace fixproof {
namespace replay_test {

struct Shell {
  std::string out;
  int status = -1;
};

Shell shell(const std::string& line) {
  const std::string folder = std::filesystem::path(paths::command()).parent_path();
  const std::string with_path = "PATH='" + folder + "':$PATH; " + line;
  // Safe because the line comes only from this program.
  std::FILE* pipe = popen(with_path.c_str(), "r");  // NOLINT(cert-env33-c)
  Shell result;
  std::array<char, 256> buffer{};
  while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    result.out.append(buffer.data(), size);
  }
  const int status = pclose(pipe);
  if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
  return result;
}

/// A function of tests/verify/library that is wrong, for the signature of the variant.
std::string wrong_function(const cases::Variant& v) {
  switch (v.operation) {
    case cases::Operation::cossin:
      return paths::built("tests/verify/library/libjudged.so:cossin_wrong");
    case cases::Operation::xformvec:
    case cases::Operation::concat:
      return paths::built("tests/verify/library/libjudged.so:transform_wrong");
    default:
      return paths::built("tests/verify/library/libjudged.so:wrong");
  }
}

std::vector<std::uint32_t> case_of(const cases::Variant& v) {
  std::vector<std::uint32_t> words(cases::words_in(v));
  cases::make_cases(cases::Stream::scaled, v, 1, 3, words);
  return words;
}

/// The commands for a case, with what these parties said of it.
verify::Replay replay_of(const cases::Variant& v, std::span<const parties::Party* const> parties) {
  verify::Mismatch mismatch;
  mismatch.words = case_of(v);
  for (const parties::Party* party : parties) {
    mismatch.said.emplace_back(party->name(),
                               parties::ask(*party, v, mismatch.words).text(v.format.word_bits));
  }
  return verify::replay(parties::row_of(v, parties), mismatch);
}

std::vector<const parties::Party*> able_parties(const cases::Variant& v) {
  std::vector<const parties::Party*> able;
  for (const auto& party : parties::parties()) {
    if (party->answers(v) && party->absence().empty()) able.push_back(party.get());
  }
  return able;
}

std::size_t lines_in(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// Each line compares the wrong function with one other party, of this variant alone.
void expect_the_difference(const cases::Variant& v) {
  const parties::Party& wrong = parties::party_named(wrong_function(v));
  ASSERT_TRUE(wrong.answers(v)) << cases::name_of(v);
  std::vector<const parties::Party*> parties = able_parties(v);
  ASSERT_FALSE(parties.empty()) << cases::name_of(v);
  const parties::Party& honest = *parties.front();
  for (const bool is_judged : {true, false}) {
    parties.insert(is_judged ? parties.begin() : parties.end(), &wrong);
    const verify::Replay again = replay_of(v, parties);
    std::erase(parties, &wrong);
    EXPECT_TRUE(again.differs) << again.verify;
    const Shell result = shell(again.verify);
    EXPECT_EQ(result.status, 1) << again.verify << '\n' << result.out;
    EXPECT_EQ(lines_in(result.out), 1U) << again.verify << '\n' << result.out;
    EXPECT_TRUE(result.out.starts_with(cases::name_of(v) + ": ")) << result.out;
    const auto said = [&](const parties::Party& party) {
      return fmt::format("{} {}", party.name(),
                         parties::ask(party, v, case_of(v)).text(v.format.word_bits));
    };
    const std::string end = fmt::format("): {}, {}: DIFFER\n", said(is_judged ? wrong : honest),
                                        said(is_judged ? honest : wrong));
    EXPECT_TRUE(result.out.ends_with(end)) << result.out << end;

    const bool is_model = honest.name() == "model" && v.format == cases::q16_16 &&
                          v.build.target != cases::Target::standard;
    EXPECT_EQ(!again.trace.empty(), is_model) << again.verify;
    if (!is_model) continue;
    const Shell trace = shell(again.trace);
    EXPECT_EQ(trace.status, 0) << again.trace;
    EXPECT_GT(lines_in(trace.out), 4U) << again.trace;
  }
}

TEST(Replay, ShowsTheDifferenceForEveryVariant) {
  for (const cases::Variant& v : cases::all_variants()) expect_the_difference(v);
}

TEST(Replay, ShowsTheDifferenceInEveryFormat) {
  using cases::Operation;
  for (const char* format : {"q8_8", "q16_16", "q2_30", "u8_8", "u1_31", "q4_4", "q32_32"}) {
    for (const Operation operation :
         {Operation::add, Operation::sub, Operation::mul, Operation::div, Operation::sqrt,
          Operation::decimal, Operation::binary64, Operation::exp, Operation::sin, Operation::tan,
          Operation::pow, Operation::fmod, Operation::mul_div, Operation::hypot3}) {
      const cases::Variant v{.operation = operation,
                             .build = {.target = cases::Target::standard},
                             .format = cases::format_named(format)};
      if (cases::is_in_format(operation, v.format)) expect_the_difference(v);
    }
  }
}

TEST(Replay, SelectsTheVariantWhereAllAgree) {
  for (const cases::Variant& listed : cases::all_variants()) {
    for (const cases::Format& format : {cases::q16_16, cases::q8_8}) {
      cases::Variant v = listed;
      v.format = format;
      const std::vector<const parties::Party*> able = able_parties(v);
      if (able.size() < 2) continue;
      verify::Mismatch mismatch;
      mismatch.words = case_of(v);
      const verify::Replay again = verify::replay(parties::row_of(v, able), mismatch);
      EXPECT_FALSE(again.differs);
      const Shell result = shell(again.verify);
      EXPECT_EQ(result.status, 0) << again.verify << '\n' << result.out;
      EXPECT_EQ(lines_in(result.out), 1U) << again.verify;
      EXPECT_TRUE(result.out.starts_with(cases::name_of(v) + ": ")) << result.out;
      EXPECT_TRUE(result.out.ends_with(": equal\n")) << result.out;
    }
  }
}

constexpr cases::Variant half{.operation = cases::Operation::mul, .format = cases::q8_8};

TEST(Replay, NamesTheJudgedPartyAndTheFirstThatDiffers) {
  const cases::Row row{half, {"interpreter", "model", "oracle", "fast"}};
  verify::Mismatch mismatch;
  mismatch.words = {0x1234, 0x5678};
  mismatch.smallest = {0x0180, 0xff00};
  mismatch.said = {{"interpreter", "fe80"}, {"model", "fe80"}, {"oracle", "DE"}, {"fast", "fe81"}};
  const auto line = [](std::string_view parties) {
    return fmt::format(
        "fixproof verify mul --target i386 --round on --chapter 54 --width half --case '0180 ff00' "
        "--by {}",
        parties);
  };
  EXPECT_EQ(verify::replay(row, mismatch).verify, line("interpreter --against oracle"));
  // A broken run agrees with nothing.
  mismatch.said = {{"interpreter", "breaks down"}, {"model", "breaks down"}, {"oracle", "fe80"}};
  EXPECT_EQ(verify::replay(row, mismatch).verify, line("interpreter --against model"));
  // All of them where the answers are not known.
  mismatch.said.clear();
  EXPECT_EQ(verify::replay(row, mismatch).verify, line("interpreter --against model,oracle,fast"));
  EXPECT_EQ(verify::replay(row, mismatch).trace, "");
}

TEST(Replay, RunsTheWholeRowWhereTheCaseAloneShowsNoDifference) {
  const cases::Row row{half, {"interpreter", "model", "fast"}};
  verify::Mismatch mismatch;
  mismatch.words = {0x1234, 0x5678};
  mismatch.said = {{"interpreter", "DE"}, {"model", "DE"}, {"fast", "DE"}};
  const verify::Replay again = verify::replay(row, mismatch, {.level = 2, .seed = 77});
  EXPECT_FALSE(again.differs);
  EXPECT_EQ(again.verify,
            "fixproof verify mul --target i386 --round on --chapter 54 --width half --level 2 "
            "--seed 77 --by interpreter --against model,fast");
}

TEST(Replay, RunsAllFunctionsOfLibraries) {
  const cases::Row row{half, {"oracle", "fast", "type", "./a.so:mul", "./b.so:mul"}};
  verify::Mismatch mismatch;
  mismatch.words = {0x1234, 0x5678};
  // A function may spoil the answers of others, by a rounding mode for instance.
  mismatch.said = {{"oracle", "0001"},
                   {"fast", "0001"},
                   {"type", "0002"},
                   {"./a.so:mul", "0001"},
                   {"./b.so:mul", "0001"}};
  const std::string line = verify::replay(row, mismatch).verify;
  EXPECT_TRUE(line.ends_with(" --by oracle --against type,./a.so:mul,./b.so:mul")) << line;
}

TEST(Replay, QuotesTheNamesOfLibraries) {
  const auto line_of = [](const std::string& party) {
    verify::Mismatch mismatch;
    mismatch.words = {0x0180, 0xff00};
    return verify::replay({half, {party, "model"}}, mismatch).verify;
  };
  const auto ends = [](const std::string& line, const std::string& end) {
    EXPECT_TRUE(line.ends_with("--by " + end + " --against model")) << line;
  };
  ends(line_of("./libmine.so:mul"), "./libmine.so:mul");
  ends(line_of("./libmine.so:muls[]"), "'./libmine.so:muls[]'");
  ends(line_of("my $(libs)/it's.so:mul"), R"('my $(libs)/it'\''s.so:mul')");
  ends(line_of("a\x1b[2J.so:mul"), R"($'a\x1b\x5b2J.so:mul')");
}

}  // namespace replay_test
}  // namespace fixproof
