/// @file
/// Turns options into parties, variants and the rows of a plan.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/options.hpp"
#include "verify/cases/plan.hpp"
#include "verify/parties/party.hpp"
#include "x86model/loop.hpp"

namespace fixproof::cli {

/// The rows of the verification table and the parties that the command line selects.
struct Selection {
  std::vector<std::string> operations;  ///< all if empty
  VariantOptions variant;
  bool half_width = false;
  std::vector<std::string> formats;  ///< names of formats, or `all`; the routines' if empty
  std::string to;                    ///< format of the results; that of the words if empty
  int level = 1;
  std::string by;  ///< the judged party; if empty the model, or the oracle for a library's function
  std::vector<std::string> against;  ///< the default parties of the level if empty
};

/// Returns the operation, which `eval` computes.
/// @throws std::invalid_argument for an unknown operation, UsageError for a conversion
cases::Operation evaluated_operation_named(std::string_view name);
/// The same for an operation that parties answer: no sum.
cases::Operation answered_operation_named(std::string_view name);

/// Returns the operation, which parties answer in every format.
/// @throws std::invalid_argument for an unknown operation, UsageError for a conversion and for an
///         operation of 16.16 alone
cases::Operation format_operation_named(std::string_view name);

/// Tells whether operations are compared in the formats that are named, not as routines.
inline bool has_formats(const Selection& selection) {
  return !selection.formats.empty() || !selection.to.empty();
}

/// Returns the parties without duplicates, the judged one first.
/// @throws std::invalid_argument for an unknown party, UsageError if there is only one
std::vector<const parties::Party*> chosen_parties(const Selection& selection);

/// Returns the selected variants at full width, in the order of the verification table.
/// @throws std::invalid_argument for an unknown operation, UsageError if --repaired does not apply
std::vector<cases::Variant> chosen_variants(const Selection& selection);

/// Returns the variants that have a program. CosSin has no switch and appears once per target.
/// @throws std::invalid_argument for an unknown routine, UsageError if no variant is left
std::vector<cases::Variant> chosen_routines(const Selection& selection);

struct Programs {
  std::vector<cases::Variant> routines;   ///< see chosen_routines(); empty if only loops are named
  std::vector<x86model::LoopForm> loops;  ///< every form that exists for the target
};
/// Adds the options that chosen_programs() reads. `selection` must outlive the command.
void add_programs_to(CLI::App& command, Selection& selection);
/// Selects routines and inner loops by name. Without names it selects all routines and loops, but
/// no loops if a rounding, a chapter, --as-printed or --repaired is given.
/// @throws as chosen_routines(); UsageError if one of these options is given for a named loop
Programs chosen_programs(const Selection& selection);

/// Returns the rows in table order. A row omits default parties that cannot answer it.
/// @throws std::invalid_argument for an unknown operation, UsageError if no row matches, a named
///         party cannot answer a row, or a row has fewer than two parties
std::vector<cases::Row> chosen_rows(const Selection& selection,
                                    std::span<const parties::Party* const> parties);

}  // namespace fixproof::cli
