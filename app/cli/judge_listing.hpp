/// @file
/// `judge --against-listing`, which tells whether listings of the model are in a user's file.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/cli/json/result_file.hpp"
#include "app/cli/options.hpp"

namespace fixproof::cli {

struct ListingOptions {
  std::vector<std::string> routines;  ///< empty unless --against-listing is given
  VariantOptions variant;

  /// Adds --against-listing and the options that choose the build of the listings.
  void add_to(CLI::App& command);
};

/// Prints where each listing is in the file, or the first instruction that differs, and writes
/// `result`.
/// @param at an offset in the file, a range to search, or empty to search the whole file
/// @return the exit status: 0 if all listings are confirmed, else 1
/// @throws support::UsageError for a wrong option, or if the file or a program cannot be used
/// @throws support::Stopped if the user interrupts the search
int judge_against_listings(const std::string& file, const std::string& at,
                           const ListingOptions& options, ResultFile& result);

}  // namespace fixproof::cli
