/// @file
/// Runs `fixproof judge` on the routines of this suite.
#pragma once

#include <string>
#include <vector>

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"

namespace judged {

/// Runs judge on a file. The words of `options` are separated by `|`, because frames have spaces.
inline command::Run judge(const std::string& file, const std::string& options) {
  std::vector<std::string> words{paths::command(), "judge", file};
  for (const std::string& word : command::split(options, '|')) words.push_back(word);
  return command::run(words);
}

inline std::string routine(const std::string& name) {
  return paths::source("tests/judge/code/routines/" + name + ".asm");
}

/// The options for a 32-bit multiply of eax and ebx.
inline const std::string in_registers = "--bits|32|--frame|eax, ebx -> eax|--as|mul";

/// Expects a status and parts of the output.
inline void expect(const command::Run& run, int status, const std::vector<std::string>& parts) {
  EXPECT_EQ(run.status, status) << run.out << run.err;
  for (const std::string& part : parts) command::expect_contains(run.out, part);
}

inline std::string word(unsigned value) {
  return {static_cast<char>(value & 0xFFU), static_cast<char>(value >> 8U & 0xFFU)};
}

/// The bytes of the header of exe_of().
inline constexpr unsigned exe_header = 64;

/// An .EXE of code, with relocations at these offsets and the stack in a segment behind it.
inline std::string exe_of(const std::string& code, const std::vector<unsigned>& relocations) {
  const auto size = static_cast<unsigned>(exe_header + code.size());
  const auto paragraphs = static_cast<unsigned>((code.size() + 15) / 16);
  std::string exe = "MZ" + word(size % 512) + word((size + 511) / 512) +
                    word(static_cast<unsigned>(relocations.size())) + word(exe_header / 16) +
                    word(0x200) + word(0xFFFF) + word(paragraphs) + word(0x1000) + word(0) +
                    word(0) + word(0) + word(0x1C) + word(0);
  for (const unsigned at : relocations) exe += word(at % 16) + word(at / 16);
  exe.resize(exe_header);
  return exe + code;
}

}  // namespace judged
