/// @file
/// The loop of commands that write one line per input line.
#pragma once

#include <functional>
#include <istream>
#include <ostream>
#include <string>
#include <string_view>

namespace fixproof::cli {

/// Calls `answer(line, output)` for each line of `in` and writes `output` to `out`. It skips blank
/// lines and lines that start with #, and drops the CR of a CR LF. It writes all pending output
/// before it waits for input, so that another program can alternate between writing and reading.
/// @throws UsageError with the line number if `answer` throws one, after writing all earlier
///         answers, which it also writes before any other exception of `answer`
/// @throws OutputLost if `out` cannot be written
void answer_lines(std::istream& in, std::ostream& out,
                  const std::function<void(std::string_view line, std::string& output)>& answer);

}  // namespace fixproof::cli
