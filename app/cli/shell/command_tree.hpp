/// @file
/// The commands and options of the command line as data, for completions and manual pages.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace fixproof::cli::shell {

struct OptionEntry {
  /// As they are given: `-o`, `--output`. A positional has one name, without a hyphen.
  std::vector<std::string> names;
  /// What follows the name in the help, such as `TEXT REQUIRED`; empty for a flag.
  std::string value;
  std::string description;
  /// The heading of the help above it.
  std::string heading;
  bool is_positional;
};

struct CommandEntry {
  std::string name;
  std::string description;
  /// The heading of the list of commands above it.
  std::string heading;
  std::vector<OptionEntry> options;
  /// What the help says below the options: notes, exit status, examples.
  std::string footer;
};

/// The entry of an application or a command, with its options in the order of the help.
CommandEntry entry_of(const CLI::App& app);

/// The entries of all commands of an application that its help shows, in that order.
std::vector<CommandEntry> commands_of(const CLI::App& app);

/// The words that a value of an option or positional can be, where there is a list of them.
std::vector<std::string> words_for(const OptionEntry& option);

}  // namespace fixproof::cli::shell
