// Tests the command line: bad usage gives exit status 2 and one line on stderr.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <string_view>

#include "tests/cli/command.hpp"

namespace {

void expect_usage_error(std::string_view arguments, std::string_view part) {
  SCOPED_TRACE(arguments);
  const auto run = command::fixproof(arguments, "00018000 00028000\n");
  EXPECT_EQ(run.out, "");
  command::expect_usage_error(run, part);
}

TEST(Usage, NoCommand) { expect_usage_error("", "no command given"); }

TEST(Usage, UnknownCommand) { expect_usage_error("evaluate mul", "unknown command: evaluate"); }

TEST(Usage, MissingOperation) {
  expect_usage_error("eval", "operation");
  expect_usage_error("trace", "routine");
  expect_usage_error("list", "routine");
}

TEST(Usage, UnknownOperation) {
  expect_usage_error("eval add", "add");
  expect_usage_error("eval MUL", "MUL");
  expect_usage_error("trace add 00000000", "add");
  expect_usage_error("list add", "add");
}

TEST(Usage, OperationsThatAreNoRoutines) {
  for (const std::string_view name : {"sqrt", "sin", "cos", "decimal", "binary64"}) {
    for (const std::string_view command : {"list ", "trace "}) {
      expect_usage_error(std::string(command) + std::string(name), name);
    }
    for (const std::string_view option : {"--target i386", "--round on", "--chapter 52"}) {
      expect_usage_error(fmt::format("eval {} {}", name, option), "is not a routine");
    }
    expect_usage_error(fmt::format("eval {} --by model", name), "model does not answer");
  }
}

TEST(Usage, WhatTakesRoutinesNamesTheRoutines) {
  for (const std::string_view command : {"list ", "trace ", "dos ", "prove ", "mutate "}) {
    for (const std::string_view name : {"add", "sqrt"}) {
      expect_usage_error(std::string(command) + std::string(name),
                         "choose one of mul, div, cossin, xformvec, concat\n");
    }
  }
}

TEST(Usage, RoundingsThatMayContradictEachOther) {
  for (const std::string_view command : {"eval", "list", "trace", "dos", "prove", "mutate"}) {
    for (const std::string_view one : {"--mul-round", "--div-round"}) {
      expect_usage_error(fmt::format("{} mul --round on {} off", command, one), "excludes");
      expect_usage_error(fmt::format("{} mul {} off --round on", command, one), "excludes");
    }
  }
}

TEST(Usage, UnknownParty) {
  expect_usage_error("eval mul --by chance", "'chance'");
  expect_usage_error("eval mul --by chance",
                     "model, interpreter, oracle, fast, type, batch, batch-portable, batch-neon, "
                     "batch-avx2, batch-avx512, silicon, unicorn");
}

TEST(Usage, PartyWithoutAnAnswer) {
  expect_usage_error("eval cossin --by fast", "fast does not answer");
}

TEST(Usage, UnknownOption) {
  expect_usage_error("eval mul --rounding on", "--rounding");
  expect_usage_error("step --target i386", "--target");
  expect_usage_error("eval mul div", "div");
}

TEST(Usage, UnknownValues) {
  expect_usage_error("eval mul --target i486", "i486");
  expect_usage_error("eval mul --round yes", "yes");
  expect_usage_error("eval mul --mul-round 1", "1");
  expect_usage_error("eval mul --chapter 53", "53");
  expect_usage_error("list cossin --chapter 52", "--chapter 52 has only");
  expect_usage_error("eval cossin --target i8088 --as-printed", "an 8088 does not have");
  expect_usage_error("dos cossin --target i8088 --as-printed", "shl bx, 2");
  expect_usage_error("trace cossin 0000 --target i8088 --as-printed --mutant 1", "--as-printed");
  expect_usage_error("eval xformvec --by oracle --chapter 52", "--chapter 52 has only");
  expect_usage_error("list mul --target i8088 --round off --as-scanned", "--as-scanned");
  expect_usage_error("list div --round off --as-scanned", "--as-scanned");
  expect_usage_error("step --cpu 286", "286");
  expect_usage_error("eval mul --target", "--target");
}

TEST(Usage, OnlyThe8088ConcatIsRepaired) {
  constexpr std::string_view only = "--repaired is for concat --target i8088";
  for (const std::string_view command :
       {"eval concat", "eval concat --target i386", "eval mul --target i8088", "eval sqrt",
        "list xformvec --target i8088", "list gouraud-byte --target i8088",
        "dos div --target i8088", "trace mul 00018000 00028000 --target i8088", "verify mul",
        "verify concat mul", "verify concat --target i386", "verify concat --target standard",
        "prove xformvec", "prove depth", "mutate concat --target i386"}) {
    expect_usage_error(fmt::format("{} --repaired", command), only);
  }
  expect_usage_error("eval concat --target i8088 --repaired --chapter 54", "excludes");
  expect_usage_error("eval concat --target i8088 --repaired --as-printed", "excludes");
}

TEST(Usage, NumbersAreDecimal) {
  // In octal, 010 would be 8, 09 invalid and 064 chapter 52.
  for (const std::string_view number : {"010", "10"}) {
    const auto run =
        command::fixproof("trace mul 00018000 00028000 --mutant " + std::string(number));
    EXPECT_EQ(run.out.rfind("mutant 10: ", 0), 0U) << run.out;
  }
  const auto heading = [](std::string_view options) {
    const std::string out = command::fixproof("verify cossin " + std::string(options)).out;
    return out.substr(0, out.find(':'));
  };
  EXPECT_EQ(heading("--seed 09 --threads 01 --level 01"), "Level 1, seed 9, 1 thread");
  EXPECT_EQ(heading("--seed 010 --threads 002"), "Level 1, seed 10, 2 threads");
  expect_usage_error("eval mul --chapter 064", "064");
  for (const std::string_view wrong : {"0x10", "-1", "+1", "1.0", "1e1", "0", "100001"}) {
    expect_usage_error(fmt::format("trace mul 00018000 00028000 --mutant={}", wrong), "--mutant");
    expect_usage_error(fmt::format("prove mul --timeout={}", wrong), "--timeout");
    expect_usage_error(fmt::format("mutate mul --threads={}", wrong), "--threads");
  }
  expect_usage_error("mutate mul --seed=-1", "--seed");
}

TEST(Usage, HelpIsNoError) {
  for (const std::string_view arguments :
       {"--help", "verify --help", "merge --help", "eval --help", "step --help", "trace --help",
        "list --help", "prove --help", "mutate --help", "dos --help", "render --help",
        "drift --help", "measure --help", "--version"}) {
    const auto run = command::fixproof(arguments);
    EXPECT_EQ(run.status, 0) << arguments;
    EXPECT_NE(run.out, "") << arguments;
    // Help must not contain identifiers of the program.
    EXPECT_FALSE(std::regex_search(run.out, std::regex("[A-Z][a-z]+Options"))) << arguments;
    EXPECT_EQ(run.err, "") << arguments;
  }
}

TEST(Usage, OutputThatCannotBeWritten) {
  for (const std::string_view arguments : {"list mul", "trace mul 00018000 00028000", "--help"}) {
    for (const command::Output output :
         {command::Output::full_device, command::Output::reader_gone}) {
      const auto run = command::fixproof(arguments, "", output);
      EXPECT_EQ(run.status, 2) << arguments;
      EXPECT_EQ(run.err, "fixproof: cannot write standard output\n") << arguments;
    }
  }
}

}  // namespace
