/// @file
/// Reads the results of a subject, one per line.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>

#include "judge/check/word.hpp"

namespace fixproof::check {

/// Results in input order. It skips lines that start with #, and blank lines at the end. A blank
/// line before a result is an error, because it would shift all later results to the wrong cases.
class Results {
 public:
  /// @param name the name of the stream in errors
  /// @param decimal results are decimal numbers, not words
  Results(std::istream& in, std::string name, const cases::Format& format, bool decimal = false)
      : in_(in), name_(std::move(name)), format_(format), decimal_(decimal) {}

  /// Returns the next result; empty at the end.
  /// @throws UsageError naming the line
  std::optional<Said> next();
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The last result as it stands on its line.
  [[nodiscard]] const std::string& text() const { return text_; }
  /// The line number of the last result, from 1.
  [[nodiscard]] std::uint64_t line() const { return line_; }

 private:
  std::istream& in_;
  std::string name_;
  cases::Format format_;
  bool decimal_;
  std::string text_;
  std::uint64_t line_ = 0;
};

}  // namespace fixproof::check
