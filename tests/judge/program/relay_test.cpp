// Tests `program::Relay` on commands whose results are known: most write their input again.
#include "judge/program/relay.hpp"

#include <fmt/format.h>

#include "tests/support/test.hpp"

namespace {

using fixproof::program::Fault;
using fixproof::program::NextCase;
using fixproof::program::Relay;
using Kind = Fault::Kind;

struct Relayed {
  std::vector<std::string> results;
  std::optional<Fault> fault;
};

/// Cases are their numbers, from 0.
NextCase numbers(std::size_t count) {
  return [count, i = std::size_t{0}](std::string& text) mutable {
    if (i == count) return false;
    text += fmt::format("{}\n", i++);
    return true;
  };
}

Relayed relayed(const std::string& command, std::size_t cases, std::size_t processes = 1,
                std::chrono::milliseconds silence = std::chrono::seconds(60)) {
  Relay relay({.command = command, .processes = processes, .silence = silence}, numbers(cases));
  Relayed all;
  while (const auto line = relay.next()) all.results.emplace_back(*line);
  all.fault = relay.fault();
  return all;
}

std::vector<std::string> numbers_to(std::size_t count) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < count; ++i) all.push_back(fmt::format("{}", i));
  return all;
}

void expect_echo(const std::string& command, std::size_t cases, std::size_t processes) {
  const Relayed all = relayed(command, cases, processes);
  EXPECT_FALSE(all.fault) << command;
  EXPECT_EQ(all.results, numbers_to(cases)) << command;
}

// More than all pipes hold.
TEST(ProgramRelay, ResultsInTheOrderOfTheCases) {
  for (const std::size_t processes : {1U, 3U}) {
    expect_echo("cat", 50'000, processes);
    expect_echo("all=$(cat); echo \"$all\"", 50'000, processes);
    expect_echo("while read -r x; do echo \"$x\"; done", 1000, processes);
  }
}

TEST(ProgramRelay, NoCases) { EXPECT_FALSE(relayed("cat", 0).fault); }

TEST(ProgramRelay, LinesAsPeopleWriteThem) {
  for (const char* command :
       {"sed 's/$/\\r/'", "sed 's/^/# a comment\\n/'", "cat; echo", "printf '# hello\\n'; cat",
        "x=$(cat); printf %s \"$x\"", "cat; exit 3", "cat; sleep 30 & exit 0"}) {
    expect_echo(command, 1000, 1);
  }
}

TEST(ProgramRelay, ErrorsThatNobodyReadsDoNotBlock) {
  expect_echo("head -c 300000 /dev/zero >&2; cat", 100, 1);
}

TEST(ProgramRelay, BlankLinesAreResultsUnlessTheyAreLast) {
  const Relayed all = relayed("sed 's/^1$//'", 3);
  EXPECT_EQ(all.results, (std::vector<std::string>{"0", "", "2"}));
}

TEST(ProgramRelay, AProgramThatEnds) {
  const Relayed all = relayed("head -n 3; echo why >&2; echo more >&2; exit 4", 1000);
  EXPECT_EQ(all.results, numbers_to(3));
  ASSERT_TRUE(all.fault && all.fault->ending);
  EXPECT_EQ(all.fault->kind, Kind::ends);
  EXPECT_EQ(all.fault->ending->status, 4);
  EXPECT_EQ(all.fault->ending->signal, 0);
  EXPECT_EQ(all.fault->error, "why");
}

TEST(ProgramRelay, AProgramThatASignalEnds) {
  for (const char* command : {"kill -8 $$", "sh -c 'kill -8 $$'; exit $?"}) {
    const Relayed all = relayed(command, 10);
    ASSERT_TRUE(all.fault && all.fault->ending) << command;
    EXPECT_EQ(all.fault->ending->signal, 8) << command;
  }
}

TEST(ProgramRelay, AChildThatKeepsThePipeOpen) {
  const Relayed all = relayed("head -n 3; sleep 30 & exit 5", 1000);
  ASSERT_TRUE(all.fault && all.fault->ending);
  EXPECT_EQ(all.fault->kind, Kind::ends);
  EXPECT_EQ(all.fault->ending->status, 5);
}

TEST(ProgramRelay, TooManyLines) {
  const Relayed all = relayed("sed p", 3);
  ASSERT_TRUE(all.fault);
  EXPECT_EQ(all.fault->kind, Kind::too_many);
  EXPECT_EQ(all.fault->said, "1");
  EXPECT_EQ(relayed("yes", 1000).fault->kind, Kind::too_many);
}

TEST(ProgramRelay, AProgramThatHangs) {
  const std::chrono::milliseconds silence{200};
  EXPECT_EQ(relayed("exec sleep 60", 100'000, 1, silence).fault->kind, Kind::silent);
  EXPECT_EQ(relayed("head -n 5; exec sleep 60", 1000, 1, silence).fault->kind, Kind::silent);
  EXPECT_EQ(relayed("cat; exec sleep 60", 1000, 1, silence).fault->kind, Kind::never_ends);
  EXPECT_EQ(relayed("cat; exec >&-; sleep 60", 1000, 1, silence).fault->kind, Kind::never_ends);
}

TEST(ProgramRelay, ALineWithoutEnd) {
  const Relayed all = relayed("head -c 100000 /dev/zero | tr '\\0' x; cat", 10);
  ASSERT_EQ(all.results.size(), 1U);
  EXPECT_GT(all.results.front().size(), 4096U);
}

TEST(ProgramRelay, AProgramThatStopsReading) {
  const Relayed all = relayed("exec <&-; exec echo 0", 100'000);
  EXPECT_EQ(all.results, numbers_to(1));
  ASSERT_TRUE(all.fault);
  EXPECT_EQ(all.fault->kind, Kind::ends);
}

}  // namespace
