/// @file
/// Judges files of single-step cases for `fixproof step --singlestep`.
#pragma once

#include <string>
#include <vector>

#include "app/cli/json/result_file.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::cli {

/// Judges all cases, one file per thread at a time. Prints mismatches and one summary line per file
/// to standard output, in the order of the files, then the sum for several files; prints file
/// errors to standard error.
/// Writes `result`, too.
/// @return the exit status: 1 if a case differs, else 2 if a file is bad or no case at all can run,
///         else 0
int judge_files(const std::vector<std::string>& files, x86model::Cpu cpu, ResultFile& result);

}  // namespace fixproof::cli
