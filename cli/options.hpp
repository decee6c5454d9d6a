/// @file
/// The options that name a variant, shared by the commands.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cases/variant.hpp"

namespace fixproof::cli {

/// Why --repaired is refused.
inline constexpr const char* only_repaired =
    "--repaired is for concat --target i8088: no other routine loses a carry";

/// Why CosSin for the 8088 is refused as printed.
inline constexpr const char* no_printed_shift =
    "cossin as printed has 'shl bx, 2', which an 8088 does not have and no party models; "
    "without --as-printed it shifts twice by one (docs/findings.md, 8)";

/// What was given on the command line to choose a variant; what was not given is empty.
struct VariantOptions {
  std::vector<cases::Target> targets;
  std::optional<bool> mul_round;
  std::optional<bool> div_round;
  bool chapter_52 = false;
  bool as_printed = false;
  bool repaired = false;

  /// Adds --target, --round, --mul-round, --div-round, --as-printed, --chapter and --repaired to a
  /// command.
  /// `of_rows`: whether rows are chosen, so that the target may be both processors too, or the
  /// rules of the type.
  void add_to(CLI::App& command, bool of_rows = false);

  /// The variant of `operation` that was chosen. The target defaults to i386; both roundings to on,
  /// or with --as-printed to what the listings print (multiply on, divide off).
  /// @throws UsageError for a combination that does not exist
  [[nodiscard]] cases::Variant choose(cases::Operation operation) const;

  /// What the divide code of `target` does when its printed switch reads `printed`: the 8088 divide
  /// tests it the wrong way round.
  static bool div_round_as_printed(cases::Target target, bool printed) {
    return target == cases::Target::i8088 ? !printed : printed;
  }
};

}  // namespace fixproof::cli
