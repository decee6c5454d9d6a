// Reads the binary MOO format: the same cases as in JSON, and files that are damaged.
#include <fmt/format.h>

#include "support/file.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/vectors/capture.hpp"

namespace {

using vectors::chunk;
using vectors::Json;
using vectors::number;

Json moo_cases(std::string_view cpu) {
  Json cases = Json::array();
  for (const auto& capture : vectors::captures(cpu)) {
    cases.push_back(vectors::json_of(capture, cpu));
  }
  return cases;
}

TEST(Moo, HasTheSameVerdictsAsJson) {
  for (const std::string_view cpu : {"8088", "286", "386"}) {
    Json cases = moo_cases(cpu);
    const auto sound = vectors::judge_text(vectors::moo_of(cases, cpu), cpu);
    EXPECT_EQ(sound.out, vectors::judge(cases, cpu).out);
    EXPECT_EQ(sound.status, 0) << sound.out << sound.err;
    for (Json& c : cases) c["final"]["ram"].push_back({0x7FFFF, 1});
    const auto wrong = vectors::judge_text(vectors::moo_of(cases, cpu), cpu);
    EXPECT_EQ(wrong.out, vectors::judge(cases, cpu).out);
    EXPECT_EQ(wrong.status, 1);
  }
}

/// tests/verify/vectors/286.MOO is a file to try the command with, and a seed of the fuzzer.
TEST(Moo, TheCommittedFileHasTheCapturesOfThe286) {
  const std::string path = paths::source("tests/verify/vectors/286.MOO");
  EXPECT_EQ(fixproof::support::read_file(path), vectors::moo_of(moo_cases("286"), "286"));
}

void expect_moo_refused(const std::string& file, std::string_view message,
                        std::string_view cpu = "8088") {
  const auto run = vectors::judge_text(file, cpu);
  EXPECT_EQ(run.status, 2) << message << run.out;
  EXPECT_EQ(run.err, fmt::format("fixproof: FILE: {}\n", message));
}

std::string header(std::size_t cases, const std::string& id = "8088", int version = 1) {
  return chunk("MOO ", number(static_cast<std::size_t>(version), 4) + number(cases, 4) + id);
}

TEST(Moo, RefusesOtherProcessorsAndVersions) {
  const std::string file = vectors::moo_of(moo_cases("286"), "286");
  expect_moo_refused(file, "byte 20: captured on 'C286', not on a 8088; see --cpu");
  expect_moo_refused(header(1, "V20 "), "byte 20: captured on 'V20 ', not on a 8088; see --cpu");
  expect_moo_refused(header(1, "8088", 2), "byte 9: MOO version 2; this reads version 1");
  expect_moo_refused(chunk("MOO ", number(1, 1)),
                     "byte 9: cut short: the minor version has 1 bytes, 0 are left");
  expect_moo_refused(chunk("MOO ", number(1, 3)),
                     "byte 10: cut short: what is reserved has 2 bytes, 1 are left");
  expect_moo_refused(header(0), "the file has no cases");
}

TEST(Moo, RefusesDamagedChunksByTheirPlace) {
  const auto with = [](const std::string& rest) {
    return header(1) + chunk("TEST", number(0, 4) + rest);
  };
  const std::string code = chunk("BYTS", number(1, 4) + 'P');
  expect_moo_refused(with(""), "byte 28: case 0: no BYTS");
  expect_moo_refused(with(code), "byte 28: case 0: no INIT");
  expect_moo_refused(with(chunk("NAME", number(99, 4) + "x")),
                     "byte 44: cut short: NAME has 99 bytes, 1 are left");
  expect_moo_refused(with("BYTS" + number(0xFFFFFFFF, 4)),
                     "byte 40: cut short: chunk 'BYTS' has 4294967295 bytes, 0 are left");
  expect_moo_refused(with(chunk("INIT", chunk("REGS", number(0x4000, 2)))),
                     "byte 50: no such register");
  expect_moo_refused(with(chunk("INIT", chunk("REGS", number(3, 2) + "ab"))),
                     "byte 52: cut short: bx has 2 bytes, 0 are left");
  expect_moo_refused(with(chunk("INIT", chunk("RG32", number(0, 4)))),
                     "byte 48: registers RG32 are not those of the 8088");
  const std::string wide = chunk("RG32", number(1U << 10U, 4) + number(0x10000, 4));
  expect_moo_refused(header(1, "386E") + chunk("TEST", number(0, 4) + chunk("INIT", wide)),
                     "byte 56: 10000 is too large for cs", "386");
  expect_moo_refused(with(chunk("INIT", chunk("RAM ", number(0xFFFFFFFF, 4) + "abcde"))),
                     "byte 56: address 64636261 is too large for the 8088");
  expect_moo_refused(with(chunk("INIT", chunk("RAM ", number(2, 4) + number(1, 5)))),
                     "byte 57: cut short: an address has 4 bytes, 0 are left");
  expect_moo_refused(with(code + chunk("INIT", "") + chunk("FINA", "")),
                     "case 0: initial.regs.ax is missing");
  expect_moo_refused(with(std::string(5U << 20U, ' ')), "byte 28: case 0 is too long");
  expect_moo_refused(header(2) + chunk("TEST", ""),
                     "byte 28: cut short: the case's number has 4 bytes, 0 are left");
}

TEST(Moo, RefusesEveryLengthThatIsCutShort) {
  const Json cases = Json::array({vectors::json_of(vectors::captures("286")[0], "286")});
  const std::string whole = vectors::moo_of(cases, "286");
  for (std::size_t size = 0; size < whole.size(); size += size < 40 ? 1 : 7) {
    const auto run = vectors::judge_text(whole.substr(0, size), "286");
    EXPECT_EQ(run.status, 2) << size;
    EXPECT_EQ(run.err.rfind("fixproof: FILE: ", 0), 0) << run.err;
    if (size >= 4) {
      EXPECT_NE(run.err.find("byte "), std::string::npos) << run.err;
    }
  }
  // The end of a chunk is no end of the file.
  const std::string more = vectors::moo_of(Json::array({cases[0], cases[0]}), "286");
  const std::size_t one = whole.size();
  expect_moo_refused(more.substr(0, one),
                     fmt::format("byte {}: 1 cases, but the header says 2", one), "286");
}

TEST(Moo, AnyByteChangedCrashesNothing) {
  const Json cases = Json::array({vectors::json_of(vectors::captures("286")[0], "286")});
  const std::string whole = vectors::moo_of(cases, "286");
  for (std::size_t at = 0; at < whole.size(); at += 3) {
    std::string changed = whole;
    changed[at] = static_cast<char>(~changed[at]);
    const auto run = vectors::judge_text(changed, "286");
    EXPECT_GE(run.status, 0) << at;
    EXPECT_LE(run.status, 2) << at << run.err;
  }
}

}  // namespace
