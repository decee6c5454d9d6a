/// @file
/// Judges files of single-step cases for `fixproof step --singlestep`.
#pragma once

#include <string>
#include <vector>

#include "x86model/routine.hpp"

namespace fixproof::cli {

/// Judges all cases. Prints mismatches and one summary line per file to standard output, and file
/// errors to standard error.
/// @return the exit status: 1 if a case differs, else 2 if a file is bad or none of its cases can
///         run, else 0
int judge_files(const std::vector<std::string>& files, x86model::Target cpu);

}  // namespace fixproof::cli
