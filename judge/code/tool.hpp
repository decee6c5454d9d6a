/// @file
/// Runs NASM's programs on what may be hostile.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "support/descriptor.hpp"
#include "verify/proof/process.hpp"

namespace fixproof::judge {

/// A file in memory, for what a program reads or writes.
class ToolFile {
 public:
  /// @throws std::system_error if the system refuses the file
  explicit ToolFile(std::string_view contents = {});

  /// Returns the name that the program knows.
  [[nodiscard]] std::string name() const;
  [[nodiscard]] int number() const { return file_.number(); }
  /// @throws support::UsageError if it has more than `most` bytes
  [[nodiscard]] std::string contents(std::size_t most) const;

 private:
  support::Descriptor file_;
};

/// Tells whether this system keeps a program from the files that it may not use: with Landlock, in
/// Linux since 5.13.
bool confines_tools();

/// Runs a program of NASM with `input` on standard input: with limits of memory, output and time,
/// and no environment variables. It ends with this process. Where confines_tools(), it may read the
/// libraries of the system and the files below `folder`, if one is named, and read and write
/// `files`.
/// @throws support::UsageError if it cannot be run or exceeds a limit; support::Stopped
proof::Output run_tool(const std::vector<std::string>& arguments, const std::string& input,
                       const std::string& folder = {},
                       const std::vector<const ToolFile*>& files = {});

}  // namespace fixproof::judge
