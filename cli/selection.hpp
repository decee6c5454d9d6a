/// @file
/// From what was asked on the command line to the rows of a plan.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/plan.hpp"
#include "cli/options.hpp"
#include "parties/party.hpp"
#include "x86model/loop.hpp"

namespace fixproof::cli {

/// Which rows of the verification table are asked for, and who is to answer.
struct Selection {
  std::vector<std::string> operations;  ///< none: all
  VariantOptions variant;
  bool chapter_given = false;
  bool half_width = false;
  int level = 1;
  std::string by;                    ///< empty: model
  std::vector<std::string> against;  ///< none: the usual ones of the level
};

/// The parties, the judged one first, no one twice.
/// @throws std::invalid_argument for a name that no party has; UsageError if there is only one
std::vector<const parties::Party*> chosen_parties(const Selection& selection);

/// The variants asked for, in the order of the verification table, at full width.
/// @throws std::invalid_argument for a name that no operation has
std::vector<cases::Variant> chosen_variants(const Selection& selection);

/// Of these the ones that have a program; CosSin, which has no switch, once for each target.
/// @throws UsageError if there is none; std::invalid_argument for a name that no routine has
std::vector<cases::Variant> chosen_routines(const Selection& selection);

/// The same with inner loops among the names: `routines` as chosen_routines() chooses them, empty
/// where loops alone are named; `loops` in every form there is for the target, all of them where
/// nothing is named, and none where a rounding, a chapter or --repaired is given without a name.
struct Programs {
  std::vector<cases::Variant> routines;
  std::vector<x86model::LoopForm> loops;
};
/// @throws as chosen_routines(); UsageError for a loop with a rounding or a chapter
Programs chosen_programs(const Selection& selection);

/// The rows, in the order of the verification table. Parties that nobody has named are left out of
/// rows that they do not answer.
/// @throws UsageError if none fits, or a party that was named does not answer one;
/// std::invalid_argument for a name that no operation has
std::vector<cases::Row> chosen_rows(const Selection& selection,
                                    std::span<const parties::Party* const> parties);

}  // namespace fixproof::cli
