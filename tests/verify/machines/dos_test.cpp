// Tests that the programs of `fixproof dos` give the model's answers in DOSBox.
#include <fmt/format.h>

#include <filesystem>

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"
#include "verify/cases/streams.hpp"
#include "verify/machine_code/machine_code.hpp"

namespace {

using namespace fixproof;

std::string arguments_of(const machine_code::ProgramKey& key) {
  const std::string name = machine_code::name_of(key);
  std::string arguments = name.substr(0, name.find('-'));
  arguments += key.target == x86model::Target::i386 ? " --target i386" : " --target i8088";
  if (name.find("-off") != std::string::npos) arguments += " --round off";
  if (key.build.chapter_52) arguments += " --chapter 52";
  if (key.build.repaired) arguments += " --repaired";
  return arguments;
}

/// Operand lines for a program from streams of each kind, in the format of `fixproof eval`.
std::string lines_for(const machine_code::ProgramKey& key) {
  const cases::Variant v{.operation = static_cast<cases::Operation>(key.routine)};
  const std::size_t in = cases::words_in(v.operation);
  const int digits = v.operation == cases::Operation::cossin ? 4 : 8;
  std::string lines;
  const auto add = [&](cases::Stream stream, std::uint64_t first, std::size_t cases) {
    std::vector<std::uint32_t> words(cases * in);
    cases::make_cases(stream, v, 1981, first, words);
    for (std::size_t i = 0; i < words.size(); ++i) {
      lines += fmt::format("{:0{}x}{}", words[i], digits, (i + 1) % in == 0 ? '\n' : ' ');
    }
  };
  if (v.operation == cases::Operation::cossin) {
    for (std::uint64_t angle = 0; angle < 0x10000; angle += 31) add(cases::Stream::every, angle, 1);
  } else if (in == 2) {
    // 25 shares no divisor with the lattice's width, so every value occurs.
    for (std::uint64_t i = 0; i < *cases::size_of(cases::Stream::lattice, v); i += 25)
      add(cases::Stream::lattice, i, 1);
    add(cases::Stream::scaled, 0, 1000);
  } else {
    add(cases::Stream::lattice_words, 0, 200);
    add(cases::Stream::scaled, 0, 200);
  }
  return lines;
}

class Dos : public testing::Test {
 protected:
  void SetUp() override {
    if (!machine_code::machine_code_absence().empty())
      GTEST_SKIP() << machine_code::machine_code_absence();
  }

  /// Writes a program under a valid DOS name. CON.COM, for example, is a device.
  void make(const std::string& name, std::string_view arguments) const {
    const auto run = command::fixproof(fmt::format("dos {} -o {}", arguments, folder_.path(name)));
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(run.out + run.err, "");
  }

  void in_dosbox(const std::string& commands) const {
    folder_.write("dosbox.cfg",
                  "[cpu]\ncore=normal\ncycles=max\n[mixer]\nnosound=true\n[autoexec]\n@echo off\n"
                  "mount c " +
                      folder_.path() + "\nc:\n" + commands + "exit\n");
    const auto run = command::run({"env", "HOME=" + folder_.path(), "SDL_VIDEODRIVER=dummy",
                                   "SDL_AUDIODRIVER=dummy", "timeout", "200", "dosbox", "-conf",
                                   folder_.path("dosbox.cfg")});
    ASSERT_EQ(run.status, 0) << run.err;
  }

  const ScratchFolder folder_;
};

std::string without_cr(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '\r'), text.end());
  return text;
}

TEST_F(Dos, EveryProgramAnswersAsTheModel) {
  if (!command::has("dosbox")) GTEST_SKIP() << "dosbox is not installed";
  std::vector<machine_code::ProgramKey> keys;
  for (const machine_code::ProgramKey& key : machine_code::all_programs()) {
    if (!key.build.endif_as_scanned) keys.push_back(key);
  }
  std::string commands;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    make(fmt::format("P{}.COM", i), arguments_of(keys[i]));
    folder_.write(fmt::format("P{}.IN", i), lines_for(keys[i]));
    commands += fmt::format("P{0}.COM < P{0}.IN > P{0}.OUT\n", i);
  }
  in_dosbox(commands);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto model = command::fixproof("eval " + arguments_of(keys[i]), lines_for(keys[i]));
    ASSERT_EQ(model.status, 0) << model.err;
    // EXPECT_EQ would print thousands of lines.
    const auto said = command::split(without_cr(folder_.read(fmt::format("P{}.OUT", i))), '\n');
    const auto expected = command::split(model.out, '\n');
    ASSERT_EQ(said.size(), expected.size()) << machine_code::name_of(keys[i]);
    const auto [other, wanted] = std::mismatch(said.begin(), said.end(), expected.begin());
    if (other == said.end()) continue;
    ADD_FAILURE() << machine_code::name_of(keys[i]) << ", line " << other - said.begin() + 1 << ": "
                  << *other << ", not " << *wanted;
  }
}

TEST_F(Dos, AProgramReadsPlainLinesAsEvalDoes) {
  if (!command::has("dosbox")) GTEST_SKIP() << "dosbox is not installed";
  make("DIV.COM", "div --target i8088");
  const std::string good = "# a comment\n\n \t\n00010000 00000000\r\n00030000 00020000";
  // eval takes the first three, as people write them.
  constexpr std::size_t loose = 3;
  const std::vector<std::string> bad{
      "00030000  00020000",  "00030000 00020000 ", "00030000 0002000A",
      "0003000 00020000",    "00030000",           "00030000 00020000 1",
      std::string(300, '0'), "0003000g 00020000",  "/0030000 00020000"};
  folder_.write("GOOD.IN", good);
  std::string commands = "DIV.COM < GOOD.IN > GOOD.OUT\nif not errorlevel 1 echo 0 > GOOD.ST\n";
  for (std::size_t i = 0; i < bad.size(); ++i) {
    folder_.write(fmt::format("BAD{}.IN", i),
                  "00030000 00020000\n" + bad[i] + "\n00030000 00020000\n");
    commands +=
        fmt::format("DIV.COM < BAD{0}.IN > BAD{0}.OUT\nif errorlevel 2 echo 2 > BAD{0}.ST\n", i);
  }
  in_dosbox(commands);
  EXPECT_EQ(folder_.read("GOOD.OUT"), "DE\r\n00018000\r\n");
  EXPECT_TRUE(std::filesystem::exists(folder_.path("GOOD.ST")));
  for (std::size_t i = 0; i < bad.size(); ++i) {
    EXPECT_EQ(folder_.read(fmt::format("BAD{}.OUT", i)), "00018000\r\n") << bad[i];
    EXPECT_TRUE(std::filesystem::exists(folder_.path(fmt::format("BAD{}.ST", i)))) << bad[i];
    EXPECT_EQ(command::fixproof("eval div --target i8088", bad[i] + "\n").status, i < loose ? 0 : 2)
        << bad[i];
  }
}

TEST_F(Dos, WritesTheSameToAFileAndToAPipe) {
  make("MUL.COM", "mul");
  const auto run = command::fixproof("dos mul");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.out, folder_.read("MUL.COM"));
  EXPECT_NE(command::fixproof("dos mul --round off").out, run.out);
  EXPECT_NE(command::fixproof("dos div --target i8088 --round off --as-scanned").out,
            command::fixproof("dos div --target i8088 --round off").out);
}

TEST_F(Dos, WritesNothingToATerminal) {
  if (!command::has("script")) GTEST_SKIP() << "script(1) is not installed";
  const auto run = command::run({"script", "-qec", paths::command() + " dos mul", "/dev/null"});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.out.find("does not write a program to a terminal"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find('\xE8'), std::string::npos);
}

TEST_F(Dos, RefusesWhatItCannotWrite) {
  for (const std::string_view arguments :
       {"dos", "dos sqrt", "dos mul -o", "dos mul -o /nowhere/at/all.com",
        "dos mul --as-scanned"}) {
    command::expect_refused(arguments, "");
  }
}

}  // namespace
