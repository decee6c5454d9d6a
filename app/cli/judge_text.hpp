/// @file
/// The verdict of `judge` as text.
#pragma once

#include <optional>
#include <string>

#include "judge/code/clocks.hpp"
#include "judge/code/inspection.hpp"
#include "judge/code/prove.hpp"
#include "judge/code/verdict.hpp"

namespace fixproof::cli {

/// Returns two lines: the routine and the rules.
std::string heading_text(const judge::Subject& subject, const std::string& file,
                         const std::string& rules);

/// Returns where the cases ran and how the calls ended, without a judgement of the results.
std::string calls_text(const judge::Subject& subject, const judge::Verdict& verdict);

/// Returns the verdict with the counts, the rules and what the wrong cases have in common.
std::string verdict_text(const judge::Subject& subject, const judge::Verdict& verdict);

/// Returns the line AGREES or WRONG, the smallest wrong case, the counts and the rules.
std::string judgement_text(const check::Judge& judge,
                           const std::optional<check::JudgedCase>& smallest);

/// Returns the verdict on results of several words.
std::string whole_text(const judge::Subject& subject, const judge::WholeVerdict& whole);

/// Returns what the step-by-step calls show.
/// @param is_x86 whether what flags instructions read was looked at
std::string inspection_text(const judge::Inspection& inspection, const judge::Image& image);
/// Returns the least, the most and the mean number of instructions, as a line.
std::string instructions_text(const judge::Inspection& inspection);

/// Returns the clocks of each processor, or the instructions without a figure.
std::string clocks_text(const judge::RoutineClocks& clocks);

/// Returns the outcome of a proof.
std::string proof_text(const judge::RoutineProof& proof, const check::Rules& rules,
                       const std::string& solver);

/// Returns how a call ended, and where.
std::string text_of(const judge::Ending& ending, const judge::Image& image);

/// Returns `32-bit code`, or `ARM code` and the like.
std::string code_text(const judge::Image& image);

/// Returns what ran the cases, such as `this processor`.
std::string machine_name(const judge::Verdict& verdict, const judge::Image& image);

/// Returns what a call breaks, such as `does not keep si and leaves the direction flag set`.
std::string broken_text(judge::RegisterMask broken, const judge::Image& image);

/// Returns the names of the registers in a mask, such as `bx, si`.
std::string register_names(judge::RegisterMask mask, const judge::Image& image);

}  // namespace fixproof::cli
