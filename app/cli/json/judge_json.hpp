/// @file
/// The results of `fixproof judge` as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "judge/code/clocks.hpp"
#include "judge/code/inspection.hpp"
#include "judge/code/prove.hpp"
#include "judge/code/verdict.hpp"
#include "judge/program/verdict.hpp"
#include "support/json.hpp"

namespace fixproof::cli {

/// What was found out about a routine.
struct RoutineFindings {
  std::string rules{};                            ///< the line of the text
  std::optional<judge::Verdict> of_numbers{};     ///< of results of one word
  std::optional<judge::WholeVerdict> of_whole{};  ///< of results of several words
  std::optional<judge::Inspection> inspection{};
  std::optional<judge::RoutineClocks> clocks{};
  std::optional<judge::RoutineProof> proof{};
  std::string solver{};  ///< of the proof

  /// Precondition: there is one.
  [[nodiscard]] const judge::Verdict& verdict() const {
    return of_whole ? of_whole->verdict : *of_numbers;
  }
};

support::Json routine_json(const judge::Subject& subject, const std::string& file,
                           const RoutineFindings& found);

/// @param rules   the line of the text
/// @param failure the line of the text, or empty
support::Json program_json(const std::string& command, const program::Verdict& verdict,
                           const std::string& rules, const std::string& failure);

/// A listing that was looked for in a file.
struct ListingResult {
  std::string name;
  bool is_confirmed = false;
  std::vector<std::uint32_t> places;  ///< offsets of equal code
  std::string text;                   ///< what is printed
};
support::Json listings_json(const std::string& file, const std::vector<ListingResult>& listings);

}  // namespace fixproof::cli
