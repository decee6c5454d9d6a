/// @file
/// Runs `fixproof judge` on the routines of this suite.
#pragma once

#include <string>
#include <vector>

#include "tests/cli/command.hpp"
#include "tests/support/test.hpp"

namespace judged {

/// Runs judge on a file. The words of `options` are separated by `|`, because frames have spaces.
inline command::Run judge(const std::string& file, const std::string& options) {
  std::vector<std::string> words{FIXPROOF_COMMAND, "judge", file};
  for (const std::string& word : command::split(options, '|')) words.push_back(word);
  return command::run(words);
}

inline std::string routine(const std::string& name) { return JUDGE_ROUTINES + name + ".asm"; }

/// The options for a 32-bit multiply of eax and ebx.
inline const std::string in_registers = "--bits|32|--frame|eax, ebx -> eax|--as|mul";

/// Expects a status and parts of the output.
inline void expect(const command::Run& run, int status, const std::vector<std::string>& parts) {
  EXPECT_EQ(run.status, status) << run.out << run.err;
  for (const std::string& part : parts) command::expect_contains(run.out, part);
}

}  // namespace judged
