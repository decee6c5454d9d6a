/// @file
/// The rules that results should follow, from options.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "judge/check/rules.hpp"

namespace fixproof::cli {

struct RuleOptions {
  std::string rule;
  std::string rounding;
  std::string within;
  std::string overflow;
  std::string divide_by_zero = "de";
  std::string negative_root = "de";
  std::string not_finite = "de";
  std::string outside_domain = "de";
};

/// Returns the rounding of a name, which is neither `faithful` nor `best`.
/// @throws UsageError for any other text, with the roundings that there are
oracle::Rounding rounding_named(std::string_view text);

/// Returns the bound of --within: a number of ulps, or a percentage of the exact result.
/// @throws UsageError for any other text
check::Within within_of(std::string_view text);

/// Adds --rounding, --within, --overflow, --rule and the options for operands without a result.
/// `options` must outlive the command.
void add_rule_options(CLI::App& command, RuleOptions& options);

/// The text of --rounding for the rounding that fits best, which rules_of() leaves open.
inline constexpr std::string_view best_rounding = "best";

/// The option for operands without a result.
std::string_view no_result_option(cases::Operation operation);

/// @throws UsageError for an option that is missing, that does not apply, or that names no rule
check::Rules rules_of(const CLI::App& command, const RuleOptions& options,
                      const cases::Variant& variant);

}  // namespace fixproof::cli
