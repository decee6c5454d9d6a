/// @file
/// Options that select a variant.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cases/variant.hpp"

namespace fixproof::cli {

/// The error message for --repaired if the operation or target has no repaired form.
inline constexpr const char* only_repaired =
    "--repaired is for concat --target i8088: only that routine loses a carry";

/// The error message of commands that do not support VariantOptions::has_printed_shift().
inline constexpr const char* no_printed_shift =
    "cossin as printed has 'shl bx, 2', which an 8088 does not have and no party models; leave out "
    "--as-printed to shift twice by one (docs/findings.md, 8)";

/// The variant options of a command line. Options that are not given are empty.
struct VariantOptions {
  std::vector<cases::Target> targets;
  std::optional<bool> mul_round;
  std::optional<bool> div_round;
  bool chapter_52 = false;
  bool as_printed = false;
  bool repaired = false;

  /// Adds the options to a command, which must not outlive this object.
  /// @param of_rows whether the command selects rows of the verification table. If so, --target
  ///        also accepts both processors, or the rules of the type.
  void add_to(CLI::App& command, bool of_rows = false);

  /// Returns the build for a target. Both roundings default to on. With --as-printed, the options
  /// set the printed switches, which default as printed; see cases::printed_build().
  [[nodiscard]] cases::Build build_for(cases::Target target) const;

  /// Returns the variant of `operation`. The target defaults to i386.
  /// @throws UsageError if the combination of options does not exist
  [[nodiscard]] cases::Variant choose(cases::Operation operation) const;

  /// Whether this is the printed 8088 CosSin. Only `list` and `trace` support its SHL BX,2.
  [[nodiscard]] bool has_printed_shift(const cases::Variant& variant) const;
};

}  // namespace fixproof::cli
