/// @file
/// `judge --against-listing`: is a listing of the model in a user's file?
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/options.hpp"

namespace fixproof::cli {

struct ListingOptions {
  std::vector<std::string> routines;  ///< empty unless --against-listing is given
  VariantOptions variant;

  /// Adds --against-listing and the options that choose its build.
  void add_to(CLI::App& command);
};

/// Prints for each listing where it is in the file, or the first instruction that differs.
/// @param at the offset in the file, a range in which to search, or empty for the whole file
/// @return the exit status
/// @throws support::UsageError
int judge_against_listings(const std::string& file, const std::string& at,
                           const ListingOptions& options);

}  // namespace fixproof::cli
