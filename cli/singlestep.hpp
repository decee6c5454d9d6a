/// @file
/// Files of single-step cases, judged: what `fixproof step --singlestep` does.
#pragma once

#include <string>
#include <vector>

#include "x86model/routine.hpp"

namespace fixproof::cli {

/// Judges the cases of every file; writes what differs and a line for each file to standard output,
/// what is wrong with a file to standard error.
/// @return the exit status: 1 where a case differs, else 2 where a file is bad or had no case that
/// could be run, else 0
int judge_files(const std::vector<std::string>& files, x86model::Target cpu);

}  // namespace fixproof::cli
