/// @file
/// Commands that answer one line for each line they read.
#pragma once

#include <functional>
#include <istream>
#include <ostream>
#include <string>
#include <string_view>

namespace fixproof::cli {

/// Reads `in` line by line and appends what `answer(line, output)` gives to `out`. Blank lines and
/// lines that start with # are passed over; the CR of a CR LF is dropped. Output is written before
/// more input is waited for, so that another program can ask and read in turn.
/// @throws UsageError naming the line where `answer` throws one, after everything answered so far
/// is written; also where `out` takes no more
void answer_lines(std::istream& in, std::ostream& out,
                  const std::function<void(std::string_view line, std::string& output)>& answer);

}  // namespace fixproof::cli
