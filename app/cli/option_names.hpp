/// @file
/// The order in which help and errors name options. CLI11 names those that an option needs or
/// excludes by their addresses, so the same command could print different texts.
#pragma once

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string>

namespace fixproof::cli {

/// Writes help as CLI11 does, with the names of needed and excluded options in alphabetical order,
/// and descriptions in lines that fit the terminal.
class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_option_desc(const CLI::Option* option) const override;
  std::string make_subcommand(const CLI::App* command) const override;
};

/// Describes the first pair of given options that exclude each other: `--a excludes --b`.
/// @param app it has parsed arguments and thrown CLI::ExcludesError
std::string exclusion_in(const CLI::App& app);

/// Shows options of a command under a heading of its help.
void put_under(CLI::App& command, const char* heading, std::initializer_list<const char*> names);

}  // namespace fixproof::cli
