/// @file
/// The result of a command for a program to read. docs/json.md has the members.
#pragma once

#include <CLI/CLI.hpp>
#include <boost/noncopyable.hpp>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "support/json.hpp"
#include "support/output_file.hpp"

namespace fixproof::cli {

/// Returns a document: the version, the command, the exit status as a word, and `members`.
support::Json result_json(std::string_view command, int status, const support::Json& members);

/// The file of --json. A command that ends with an error writes nothing to it.
class ResultFile : private boost::noncopyable {
 public:
  /// Adds --json to a command, which must not outlive this object.
  void add_to(CLI::App& command);

  [[nodiscard]] bool is_wanted() const { return !path_.empty(); }

  /// Returns `; FILE is not written` if --json is given, to end the line of a stopped run.
  [[nodiscard]] std::string loss_text() const;

  /// Locks the file, if --json is given. Call it before the work, whose result would be lost.
  /// @param others files that the command also reads or writes
  /// @param whose  what these files are of, for the error
  /// @throws support::UsageError if the file is one of them
  /// @throws std::runtime_error if it cannot be written
  void open(const std::vector<std::string>& others = {}, std::string_view whose = "the command");

  /// Writes the result, if --json is given, and returns `status`. @throws std::runtime_error
  int write(int status, const std::function<support::Json()>& members);

 private:
  std::string command_;
  std::string path_;
  std::unique_ptr<support::OutputFile> file_;
};

}  // namespace fixproof::cli
