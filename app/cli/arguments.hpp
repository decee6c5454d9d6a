/// @file
/// Validators for option values.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fixproof::cli {

/// Accepts a decimal integer from `first` to `last`. Pass it to transform(), which replaces the
/// text: CLI11 itself reads -1 as the largest unsigned number and 010 as octal.
CLI::Validator whole_number(std::uint64_t first, std::uint64_t last);

/// Adds --seed, with the current value of `seed` as default. `seed` must outlive the command.
void add_seed(CLI::App& command, std::uint64_t& seed);

/// Accepts one of these words, and answers a slip with the one that was meant.
CLI::Validator one_of(const std::vector<std::string>& words);

/// Returns the names of a map, in its order.
template <class Map>
std::vector<std::string> names_of(const Map& map) {
  std::vector<std::string> names;
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

/// Rejects an empty value, which a script may pass by way of an unset variable.
CLI::Validator not_empty();

/// Accepts the name of a file that the command writes, and `-` for standard output. What the
/// command prints as text then goes to standard error. Pass it to transform().
CLI::Validator output_file();

/// Accepts the name of a picture file, unless it ends as the name of another kind of picture or
/// film does. `ending` is that of the files written, such as ".png".
CLI::Validator picture_file(std::string_view ending);

}  // namespace fixproof::cli
