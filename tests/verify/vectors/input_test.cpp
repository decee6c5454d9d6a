// Tests that an invalid file gives one line that names the position, and exit status 2.
#include <fmt/format.h>
#include <zlib.h>

#include "support/file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/vectors/cases.hpp"

namespace {

using vectors::Json;

void expect_refused(const std::string& text, std::string_view message,
                    std::string_view cpu = "8088") {
  const auto run = vectors::judge_text(text, cpu);
  EXPECT_EQ(run.status, 2) << message;
  EXPECT_EQ(run.err, fmt::format("fixproof: FILE: {}\n", message));
}

Json sound() { return vectors::load(vectors::committed[0])[0]; }

/// A file with a valid case, then the case that `change` makes of it.
template <class Change>
void expect_refused_case(Change change, std::string_view message) {
  Json bad = sound();
  bad["name"] = "bad";
  change(bad);
  expect_refused(Json::array({sound(), bad}).dump(), fmt::format("case 1 'bad': {}", message));
}

TEST(SinglestepInput, RefusesWhatIsNoArrayOfCases) {
  expect_refused("", "empty");
  expect_refused("[]", "the array has no cases");
  expect_refused("null", "not an array of cases");
  expect_refused("3", "not an array of cases");
  expect_refused(sound().dump(), "not an array of cases");
  expect_refused("[1]", "case 0 is not an object");
  expect_refused("[[]]", "case 0 is not an object");
  expect_refused("[{}]", "case 0: name is missing");
  expect_refused(R"([{"name":1}])", "case 0: name is number instead of string");
}

TEST(SinglestepInput, RefusesDamagedJson) {
  const std::string whole = Json::array({sound()}).dump();
  const auto refused_at = [](const std::string& text, int cases) {
    const auto run = vectors::judge_text(text, "8088");
    EXPECT_EQ(run.status, 2);
    EXPECT_EQ(run.err.rfind("fixproof: FILE: not JSON, or cut short, at byte ", 0), 0) << run.err;
    EXPECT_NE(run.err.find(fmt::format(", after {} cases\n", cases)), std::string::npos) << run.err;
  };
  refused_at("noise", 0);
  refused_at(whole.substr(0, whole.size() / 2), 0);
  refused_at(whole.substr(0, whole.size() - 1), 1);
  refused_at(whole + ']', 1);
  refused_at(whole + std::string(1, '\0') + ']', 1);
  refused_at(R"([{"cycles":[1}])", 0);
  refused_at(R"([{"cycles":["\")", 0);
  refused_at("[\"\xff\"]", 0);
  expect_refused(R"([{"name":"x","bytes":[1e999]}])",
                 "case 0 'x': a number is too large for any field");
}

TEST(SinglestepInput, RefusesMissingFields) {
  for (const char* name : {"bytes", "initial", "final"}) {
    expect_refused_case([&](Json& c) { c.erase(name); }, fmt::format("{} is missing", name));
  }
  for (const char* state : {"initial", "final"}) {
    for (const char* name : {"regs", "ram"}) {
      expect_refused_case([&](Json& c) { c[state].erase(name); },
                          fmt::format("{}.{} is missing", state, name));
    }
  }
  for (const char* name :
       {"ax", "bx", "cx", "dx", "cs", "ss", "ds", "es", "sp", "bp", "si", "di", "ip", "flags"}) {
    expect_refused_case([&](Json& c) { c["initial"]["regs"].erase(name); },
                        fmt::format("initial.regs.{} is missing", name));
  }
}

TEST(SinglestepInput, RefusesWhatOccursTwice) {
  const auto refused = [](const std::string& from, const std::string& to,
                          std::string_view message) {
    std::string text = Json::array({sound()}).dump();
    const auto place = text.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    expect_refused(text.replace(place, from.size(), to), message);
  };
  const std::string name = sound()["name"];
  refused(R"("ax":)", R"("ax":1,"ax":)",
          fmt::format("case 0 '{}': the key \"ax\" occurs twice in one object", name));
  refused(R"("ax":)", R"("a\u0078":1,"ax":)",
          fmt::format("case 0 '{}': the key \"ax\" occurs twice in one object", name));
  refused(R"("initial":)", R"("initial":{},"initial":)", "case 0: \"initial\" occurs twice");
  refused(R"("name":)", R"("name":"","name":)", "case 0: \"name\" occurs twice");
}

TEST(SinglestepInput, RefusesOtherTypes) {
  expect_refused_case([](Json& c) { c["bytes"] = "01c8"; }, "bytes is string instead of array");
  expect_refused_case([](Json& c) { c["initial"] = 1; }, "initial is number instead of object");
  expect_refused_case([](Json& c) { c["final"]["regs"] = Json::array(); },
                      "final.regs is array instead of object");
  expect_refused_case([](Json& c) { c["final"]["ram"] = Json::object(); },
                      "final.ram is object instead of array");
  expect_refused_case([](Json& c) { c["final"]["ram"] = {1}; },
                      "final.ram[0] is not an address and a byte");
}

TEST(SinglestepInput, RefusesNumbersOutOfRange) {
  const auto expect_bad = [](auto change, std::string_view place, std::uint32_t most) {
    expect_refused_case(change, fmt::format("{} is not a number from 0 to {}", place, most));
  };
  expect_bad([](Json& c) { c["bytes"][1] = 256; }, "bytes[1]", 255);
  expect_bad([](Json& c) { c["bytes"][1] = 1.5; }, "bytes[1]", 255);
  expect_bad([](Json& c) { c["initial"]["regs"]["ax"] = 65536; }, "initial.regs.ax", 65535);
  expect_bad([](Json& c) { c["final"]["regs"]["ip"] = -3; }, "final.regs.ip", 65535);
  expect_bad([](Json& c) { c["final"]["regs"]["ax"] = "1"; }, "final.regs.ax", 65535);
  expect_bad([](Json& c) { c["initial"]["ram"][0][0] = 1048576; }, "initial.ram[0][0]", 1048575);
  expect_bad([](Json& c) { c["initial"]["ram"][0][1] = 256; }, "initial.ram[0][1]", 255);
}

TEST(SinglestepInput, RefusesBytesThatAreNotOneInstruction) {
  expect_refused_case([](Json& c) { c["bytes"] = Json::array(); },
                      "bytes end before the instruction does");
  expect_refused_case([](Json& c) { c["bytes"].erase(1); },
                      "bytes end before the instruction does");
  expect_refused_case([](Json& c) { c["bytes"].push_back(0x90); },
                      "there are 3 bytes, but the instruction has 2");
  // Only the 386 sets end with a HLT.
  expect_refused_case([](Json& c) { c["bytes"].push_back(0xF4); },
                      "there are 3 bytes, but the instruction has 2");
}

TEST(SinglestepInput, RefusesTheSetOfTheOtherProcessor) {
  Json c = sound();
  c["name"] = "add";
  expect_refused(Json::array({c}).dump(),
                 "case 0 'add': initial.regs: 'ax' is not a register of the 386", "386");
  c["initial"]["regs"]["fs"] = 0;
  expect_refused(Json::array({c}).dump(),
                 "case 0 'add': initial.regs: 'fs' is not a register of the 8088");
}

TEST(SinglestepInput, RefusesEndlessCases) {
  std::string deep = R"([{"name":"x","cycles":)";
  deep.append(1'000'000, '[');
  expect_refused(deep, "case 0 is nested too deeply");
  std::string shallow = R"([{"name":"x","cycles":[1)";
  for (int i = 0; i < 2'200'000; ++i) shallow += ",1";
  expect_refused(shallow + "]}]", "case 0 is too long");
}

TEST(SinglestepInput, WhatRanNothingIsNoSuccess) {
  Json skipped = Json::array();
  for (const Json& c : vectors::load(vectors::committed[0])) {
    if (!vectors::is_run(c)) skipped.push_back(c);
  }
  const auto run = vectors::judge(skipped, "8088");
  EXPECT_EQ(
      run.out,
      "FILE: 6 cases, 0 run, 0 equal, 0 differing; 6 skipped: 1 prefix in no listing, 5 form in "
      "no listing\n");
  EXPECT_EQ(run.err, "fixproof: none of the cases can be run\n");
  EXPECT_EQ(run.status, 2);
}

TEST(SinglestepInput, RefusesDamagedGzip) {
  const std::string whole = fixproof::support::read_file(vectors::path_of(vectors::committed[2]));
  for (const std::size_t size : {std::size_t{2}, whole.size() / 2, whole.size() - 1}) {
    expect_refused(whole.substr(0, size), fmt::format("gzip data cut short at byte {}", size),
                   "386");
  }
  expect_refused(whole + "more", fmt::format("damaged gzip data at byte {}", whole.size() + 2),
                 "386");
  std::string wrong = whole;
  wrong[whole.size() - 6] = static_cast<char>(wrong[whole.size() - 6] ^ 1);  // in the checksum
  expect_refused(wrong, fmt::format("damaged gzip data at byte {}", whole.size() - 4), "386");
  // The first bytes select gzip, not the file name. Several members form one file.
  EXPECT_EQ(vectors::judge_text(whole, "386").status, 0);
  const auto twice = vectors::judge_text(whole + whole, "386");
  EXPECT_NE(twice.err.find(", after 23 cases\n"), std::string::npos) << twice.err;
}

TEST(SinglestepInput, RefusesWhatIsSmallOnlyWhileCompressed) {
  const ScratchFolder folder;
  const std::string path = folder.path("spaces.gz");
  const std::string spaces = std::string(1U << 20U, ' ');
  auto* const out = gzopen(path.c_str(), "wb9");
  ASSERT_EQ(gzwrite(out, spaces.data(), 1U << 20U), 1 << 20);
  ASSERT_EQ(gzclose(out), Z_OK);
  const std::string mebibyte = fixproof::support::read_file(path);
  std::string bomb;
  for (int i = 0; i < 257; ++i) bomb += mebibyte;
  ASSERT_LT(bomb.size(), 1U << 20U);
  expect_refused(bomb, "more than 256 MiB when decompressed");
}

TEST(SinglestepInput, GoesOnAfterABadFileAndForgetsNoMismatch) {
  const std::string good = vectors::path_of(vectors::committed[0]);
  auto run = command::fixproof(fmt::format("step --cpu 8088 --singlestep /nonexistent {}", good));
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, fmt::format("{0}: {1}\ntotal: {1}\n", good, vectors::committed[0].summary));
  EXPECT_EQ(run.err, "fixproof: cannot read /nonexistent: No such file or directory\n");

  Json wrong = sound();
  wrong["final"]["regs"]["es"] = wrong["initial"]["regs"]["es"].get<unsigned>() ^ 1U;
  run = vectors::judge_text('[' + wrong.dump() + ",1]", "8088");
  EXPECT_EQ(run.status, 1) << "a mismatch before the damage";
  EXPECT_EQ(run.err, "fixproof: FILE: case 1 is not an object\n");
}

}  // namespace
