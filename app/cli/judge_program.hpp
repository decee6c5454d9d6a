/// @file
/// `judge --run`: judges a program.
#pragma once

#include "app/cli/json/result_file.hpp"
#include "app/cli/judge_options.hpp"

namespace fixproof::cli {

/// Prints the verdict on a program, writes `result` and returns the exit status.
/// @throws support::UsageError for options without effect, or if the program cannot be started
int judge_program(const JudgeOptions& options, const CLI::App& command, ResultFile& result);

}  // namespace fixproof::cli
