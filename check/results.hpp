/// @file
/// What a subject has written: one result a line.
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>

#include "check/rules.hpp"

namespace fixproof::check {

/// 8 lower-case hex digits, or DE for a divide error.
/// @throws UsageError saying what is wrong with it
Said parse_result(std::string_view line);

/// Results in their order. Lines that start with # are passed over, and blank ones at the end: one
/// before a result is an answer that was not given, and all that follow would be judged as those of
/// other cases.
class Results {
 public:
  /// @param name what the stream is called in errors
  Results(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {}

  /// The next one; nothing at the end.
  /// @throws UsageError naming the line
  std::optional<Said> next();
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Of the last result, from 1.
  [[nodiscard]] std::uint64_t line() const { return line_; }

 private:
  std::istream& in_;
  std::string name_;
  std::string text_;
  std::uint64_t line_ = 0;
};

}  // namespace fixproof::check
