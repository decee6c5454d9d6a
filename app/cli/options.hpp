/// @file
/// Options that select a variant.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "verify/cases/variant.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::cli {

/// The error message for --repaired if the operation or target has no repaired form.
inline constexpr const char* only_repaired =
    "--repaired is for concat --target i8088: only that routine loses a carry";

/// The error message of commands that do not support VariantOptions::has_printed_shift().
inline constexpr const char* no_printed_shift =
    "cossin as printed has 'shl bx, 2', which an 8088 does not have and no party models; leave out "
    "--as-printed to shift twice by one (docs/findings.md, 8)";

/// The processors whose clocks are known, by the names that options accept.
// NOLINTNEXTLINE(cert-err58-cpp): without memory for it, no command can run
inline const std::map<std::string, x86model::Cpu> cpu_names{{"8088", x86model::Cpu::i8088},
                                                            {"286", x86model::Cpu::i286},
                                                            {"386", x86model::Cpu::i386},
                                                            {"486", x86model::Cpu::i486}};

/// Adds --round, --mul-round and --div-round. The two flags must outlive the command.
void add_rounding_options(CLI::App& command, std::optional<bool>& mul_round,
                          std::optional<bool>& div_round);

/// The variant options of a command line. Options that are not given are empty.
struct VariantOptions {
  std::vector<cases::Target> targets;
  std::optional<bool> mul_round;
  std::optional<bool> div_round;
  std::optional<bool> chapter_52;  ///< whether --chapter is 52
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
