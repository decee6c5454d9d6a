// Tests the command line: bad usage gives exit status 2 and one line on stderr.
#include <fmt/format.h>

#include <regex>

#include "tests/support/command.hpp"
#include "tests/support/test.hpp"

namespace {

using command::expect_refused;

TEST(Usage, NamesWhatIsMissingOrUnknown) {
  for (const auto& [arguments, part] : std::initializer_list<std::array<std::string_view, 2>>{
           {"", "no command given"},
           {"evaluate mul", "unknown command: evaluate"},
           {"eval", "operation"},
           {"trace", "routine"},
           {"list", "routine"},
           {"eval abs", "abs"},
           {"eval MUL", "MUL"},
           {"trace add 00000000", "add"},
           {"list add", "add"},
           {"eval mul --by chance", "'chance'"},
           {"eval mul --by chance",
            "model, interpreter, oracle, fast, type, batch, batch-portable, batch-neon, "
            "batch-avx2, batch-avx512, silicon, unicorn"},
           {"eval cossin --by fast", "fast does not answer"},
           {"eval mul --rounding on", "--rounding"},
           {"step --target i386", "--target"},
           {"eval mul div", "div"},
           {"eval mul --target i486", "i486"},
           {"eval mul --round yes", "yes"},
           {"eval mul --mul-round 1", "1"},
           {"eval mul --chapter 53", "53"},
           {"list cossin --chapter 52", "--chapter 52 has only"},
           {"eval cossin --target i8088 --as-printed", "an 8088 does not have"},
           {"dos cossin --target i8088 --as-printed", "shl bx, 2"},
           {"trace cossin 0000 --target i8088 --as-printed --mutant 1", "--as-printed"},
           {"eval xformvec --by oracle --chapter 52", "--chapter 52 has only"},
           {"list mul --target i8088 --round off --as-scanned", "--as-scanned"},
           {"list div --round off --as-scanned", "--as-scanned"},
           {"step --cpu 286", "286"},
           {"eval mul --target", "--target"}}) {
    expect_refused(arguments, part, "00018000 00028000\n");
  }
}

TEST(Usage, OperationsThatAreNoRoutines) {
  for (const std::string_view name : {"sqrt", "add", "sin", "cos", "decimal", "binary64"}) {
    for (const std::string_view command : {"list ", "trace "}) {
      expect_refused(fmt::format("{}{}", command, name), name);
    }
    for (const std::string_view option :
         {"--target i386", "--round on", "--chapter 52", "--chapter 54"}) {
      expect_refused(fmt::format("eval {} {}", name, option), "is not a routine");
    }
    expect_refused(fmt::format("eval {} --by model", name), "model does not answer");
  }
}

TEST(Usage, VerifyHasSumsAndFunctionsOnlyInFormats) {
  for (const std::string_view name : {"add", "sub", "fmod", "mul_div", "hypot3"}) {
    expect_refused(
        fmt::format("verify {}", name),
        fmt::format("verify compares {} only in a format, such as --format q16_16", name));
    expect_refused(fmt::format("verify mul {}", name), "only in a format");
  }
}

TEST(Usage, WhatTakesRoutinesNamesTheRoutines) {
  for (const std::string_view command : {"list ", "trace ", "dos ", "prove ", "mutate "}) {
    for (const std::string_view name : {"add", "sqrt"}) {
      expect_refused(fmt::format("{}{}", command, name),
                     "choose one of mul, div, cossin, xformvec, concat\n");
    }
  }
}

TEST(Usage, NamesOperationsThatAreSpelledAlike) {
  expect_refused(
      "eval expp",
      "unknown operation 'expp' (did you mean exp2 or exp?); fixproof gen --help lists all");
  expect_refused("gen ecp", "(did you mean exp?)");
  expect_refused("eval sinn_of_degree", "(did you mean sin_of_degrees?)");
  expect_refused("eval x",
                 "unknown operation 'x'; choose mul, div or another: fixproof gen --help ");
  expect_refused("eval atangent", "unknown operation 'atangent' (did you mean atan?)");
  expect_refused("judge f.o --as multiply", "f.o: there is no such file");
  expect_refused("gen multiply", "unknown operation 'multiply' (did you mean mul?)");
  expect_refused("list mull", "unknown routine 'mull' (did you mean mul?)");
}

TEST(Usage, RoundingsThatMayContradictEachOther) {
  for (const std::string_view command : {"eval", "list", "trace", "dos", "prove", "mutate"}) {
    for (const std::string_view one : {"--mul-round", "--div-round"}) {
      expect_refused(fmt::format("{} mul --round on {} off", command, one), "excludes");
      expect_refused(fmt::format("{} mul {} off --round on", command, one), "excludes");
    }
  }
}

TEST(Usage, OnlyThe8088ConcatIsRepaired) {
  constexpr std::string_view only = "--repaired is for concat --target i8088";
  for (const std::string_view command :
       {"eval concat", "eval concat --target i386", "eval mul --target i8088", "eval sqrt",
        "list xformvec --target i8088", "list gouraud-byte --target i8088",
        "dos div --target i8088", "trace mul 00018000 00028000 --target i8088", "verify mul",
        "verify concat mul", "verify concat --target i386", "verify concat --target standard",
        "prove xformvec", "prove depth", "mutate concat --target i386"}) {
    expect_refused(fmt::format("{} --repaired", command), only);
  }
  expect_refused("eval concat --target i8088 --repaired --chapter 54", "excludes");
  expect_refused("eval concat --target i8088 --repaired --as-printed", "excludes");
}

TEST(Usage, NumbersAreDecimal) {
  // In octal, 010 would be 8, 09 invalid and 064 chapter 52.
  for (const std::string_view number : {"010", "10"}) {
    const auto run =
        command::fixproof(fmt::format("trace mul 00018000 00028000 --mutant {}", number));
    EXPECT_TRUE(run.out.starts_with("mutant 10: ")) << run.out;
  }
  const auto heading = [](std::string_view options) {
    const std::string out = command::fixproof("verify cossin " + std::string(options)).out;
    return out.substr(0, out.find(':'));
  };
  EXPECT_EQ(heading("--seed 09 --threads 01 --level 01"), "Level 1, seed 9, 1 thread");
  EXPECT_EQ(heading("--seed 010 --threads 002"), "Level 1, seed 10, 2 threads");
  expect_refused("eval mul --chapter 064", "064");
  for (const std::string_view wrong : {"0x10", "-1", "+1", "1.0", "1e1", "0", "100001"}) {
    expect_refused(fmt::format("trace mul 00018000 00028000 --mutant={}", wrong), "--mutant");
    expect_refused(fmt::format("prove mul --timeout={}", wrong), "--timeout");
    expect_refused(fmt::format("mutate mul --threads={}", wrong), "--threads");
    expect_refused(fmt::format("prove mul --threads={}", wrong), "--threads");
  }
  expect_refused("mutate mul --seed=-1", "--seed");
}

TEST(Usage, OptionsThatExcludeEachOtherAreNamedInOneOrder) {
  command::expect_contains(command::output_of("check --help"),
                           "--from TEXT Excludes: --cases --level --seed --shard\n");
  expect_refused("check add --from cases --shard 1/2 --seed 2 --cases 3",
                 "--from excludes --cases (see fixproof check --help)");
  expect_refused("verify mul --case '00010000 00010000' --shard 1/2 --report r",
                 "--shard excludes --case (see fixproof verify --help)");
}

TEST(Usage, ASlipIsAnsweredWithWhatWasMeant) {
  expect_refused("verfy", "unknown command: verfy; did you mean verify? (see fixproof --help)");
  expect_refused("--verison", "unknown option: --verison; did you mean --version?");
  expect_refused("eval mul --tarqet i386",
                 "unknown option: --tarqet; did you mean --target? (see fixproof eval --help)");
  expect_refused("eval", "(see fixproof eval --help)");
  for (const char* const far : {"zzzzzz", "v", "e", "--x"}) {
    const auto run = command::fixproof(far);
    EXPECT_EQ(run.err.find("did you mean"), std::string::npos) << run.err;
  }
}

TEST(Usage, ASlipInAValueIsAnsweredToo) {
  for (const auto& [arguments, part] : std::initializer_list<std::array<std::string_view, 2>>{
           {"eval mul --target i38", "i38 not in {i386,i8088}; did you mean i386? (see "},
           {"eval mul --by modl", "did you mean model?"},
           {"check mul --rounding flor", "did you mean floor?"},
           {"check mul --rule dom", "did you mean doom?"},
           {"prove mul --solver cvc", "did you mean cvc5?"},
           {"measure --accuracy --function atam2", "did you mean atan2?"},
           {"measure --acuracy", "unknown option: --acuracy; did you mean --accuracy? (see "},
           {"prove type --onyl x", "did you mean --only? (see fixproof prove type --help)"},
           {"eval mul --format q16.16", "q16.16 is not a format (did you mean q16_16?)"},
           {"eval mul --format Q15.16", "(did you mean q16_16?)"},
           {"eval mul --format UQ8.8", "(did you mean u8_8?)"},
           {"eval mul --format q31", "(did you mean q1_31?)"},
           {"verify mul --format Q1.14", "(did you mean q2_14?)"}}) {
    expect_refused(arguments, part);
  }
  for (const std::string_view format : {"q", "q16", "x16.16", "q99.99", "q16_", "fixed", "u31"}) {
    const auto run = command::fixproof(fmt::format("eval mul --format {}", format));
    EXPECT_EQ(run.err.find("did you mean"), std::string::npos) << run.err;
    EXPECT_EQ(run.status, 2);
  }
}

TEST(Usage, HelpIsACommandToo) {
  EXPECT_EQ(command::output_of("help"), command::output_of("--help"));
  const std::string help = command::output_of("eval --help");
  for (const std::string_view other : {"help eval", "eval help", "eval -h", "help eval -h"}) {
    EXPECT_EQ(command::output_of(other), help) << other;
  }
  EXPECT_EQ(command::output_of("help prove type"), command::output_of("prove type --help"));
  EXPECT_EQ(command::output_of("eval --version"), command::output_of("--version"));
  expect_refused("help evall", "unknown command: evall; did you mean eval?");
}

TEST(Usage, HelpBeginsWithExamples) {
  const std::string help = command::output_of("help");
  command::expect_contains(help, "\nStart here:\n  fixproof judge ");
  command::expect_contains(help, "\nJudge your own code:\n");
  EXPECT_EQ(command::output_of("eval mul --by oracle", "1.5 -0.25\n"), "ffffa000\n");
}

TEST(Usage, HelpIsNoError) {
  for (const std::string_view arguments :
       {"--help", "verify --help", "merge --help", "eval --help", "step --help", "trace --help",
        "list --help", "prove --help", "prove type --help", "mutate --help", "dos --help",
        "render --help", "drift --help", "measure --help", "--version"}) {
    const std::string help = command::output_of(arguments);
    EXPECT_NE(help, "") << arguments;
    // Help must not contain identifiers of the program.
    EXPECT_FALSE(std::regex_search(help, std::regex("[A-Z][a-z]+Options"))) << arguments;
  }
}

TEST(Usage, HelpHasEachCommandUnderOneQuestion) {
  const std::string all = command::output_of("--help");
  const std::string help = all.substr(0, all.find("Start here:"));
  std::string found;
  for (const std::string& line : command::split(help, '\n')) {
    if (line.ends_with(':') && line != "Options:") found += line;
    std::smatch name;
    if (std::regex_search(line, name, std::regex("^  ([a-z]+) "))) found += " " + name[1].str();
  }
  EXPECT_EQ(found,
            "Judge your own code: gen check judge desync"
            "Verify FIXED.ASM and the number type: verify merge prove mutate step"
            "Look inside: eval trace list dos"
            "Scenes and what they cost: render measure drift profile advise report"
            "Your shell: completion manual");
}

TEST(Usage, OutputThatCannotBeWritten) {
  for (const std::string_view arguments : {"list mul", "trace mul 00018000 00028000", "--help"}) {
    command::expect_output_needed(arguments);
  }
}

}  // namespace
