/// @file
/// Reads the results of a subject, one per line.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>

#include "check/rules.hpp"

namespace fixproof::check {

/// Parses 8 lower-case hex digits, or DE for a divide error.
/// @throws UsageError describing the defect
Said parse_result(std::string_view line);

/// Results in input order. It skips lines that start with #, and blank lines at the end. A blank
/// line before a result is an error, because it would shift all later results to the wrong cases.
class Results {
 public:
  /// @param name the name of the stream in errors
  Results(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {}

  /// Returns the next result; empty at the end.
  /// @throws UsageError naming the line
  std::optional<Said> next();
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The line number of the last result, from 1.
  [[nodiscard]] std::uint64_t line() const { return line_; }

 private:
  std::istream& in_;
  std::string name_;
  std::string text_;
  std::uint64_t line_ = 0;
};

}  // namespace fixproof::check
