/// @file
/// The options that select a variant, shared by the commands.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cases/variant.hpp"

namespace fixproof::cli {

/// The error for --repaired with an operation or target that has no repaired form.
inline constexpr const char* only_repaired =
    "--repaired is for concat --target i8088: no other routine loses a carry";

/// The error for VariantOptions::has_printed_shift().
inline constexpr const char* no_printed_shift =
    "cossin as printed has 'shl bx, 2', which an 8088 does not have and no party models; "
    "without --as-printed it shifts twice by one (docs/findings.md, 8)";

/// The variant options of a command line. Options that were not given are empty.
struct VariantOptions {
  std::vector<cases::Target> targets;
  std::optional<bool> mul_round;
  std::optional<bool> div_round;
  bool chapter_52 = false;
  bool as_printed = false;
  bool repaired = false;

  /// Adds --target, --round, --mul-round, --div-round, --as-printed, --chapter and --repaired to a
  /// command.
  /// @param of_rows whether the command chooses rows of the verification table; then the target may
  ///        also be both processors, or the rules of the type
  void add_to(CLI::App& command, bool of_rows = false);

  /// The build that the options select for a target. Both roundings default to on. With
  /// --as-printed, the roundings are settings of the printed switches and default to the printed
  /// ones; see cases::printed_build().
  [[nodiscard]] cases::Build build_for(cases::Target target) const;

  /// The variant of `operation` that the options select. The target defaults to i386.
  /// @throws UsageError for a combination that does not exist
  [[nodiscard]] cases::Variant choose(cases::Operation operation) const;

  /// Whether the options ask for the printed 8088 CosSin, whose SHL BX,2 only `list` and `trace`
  /// know.
  [[nodiscard]] bool has_printed_shift(const cases::Variant& variant) const;
};

}  // namespace fixproof::cli
