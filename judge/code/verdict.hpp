/// @file
/// Judges a user's routine on many cases.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "judge/check/cases.hpp"
#include "judge/check/judge.hpp"
#include "judge/code/kept_state.hpp"
#include "judge/code/runner.hpp"

namespace fixproof::judge {

struct VerdictOptions {
  check::Rules rules;             ///< what the routine should follow
  bool rounding_is_open = false;  ///< judge by the rounding that fits best
  check::CaseOptions cases{};
  std::size_t shown = 3;  ///< number of wrong results to keep
  std::function<void(std::uint64_t done, std::uint64_t all)> progress{};
};

/// A case in which something happened.
struct Incident {
  std::vector<std::uint32_t> words{};
  std::string operands{};  ///< the words as text
  Ending ending{};
  RegisterMask broken = 0;  ///< see Call::broken()
};

struct Verdict {
  On machine = On::processor;
  std::string note{};  ///< why the machine is not the processor; else empty
  std::uint64_t cases = 0;
  double seconds = 0;
  std::uint64_t on_both = 0;  ///< number of cases that both machines answered
  check::Rules rules;         ///< with the rounding that was found, if it was open
  std::optional<check::Judge> judge{};
  std::uint64_t divide_errors = 0;
  std::optional<Incident> first_divide_error{};
  std::optional<Incident> stuck{};          ///< a call that neither returned nor raised #DE
  std::optional<Incident> not_preserved{};  ///< the first case that breaks the convention
  std::uint64_t not_preserved_count = 0;
  std::optional<Incident> unsteady{};  ///< a case with another result in a second run
  /// Whether only Unicorn gives the unsteady case another result.
  bool is_steady_on_processor = false;
  std::optional<KeptState> state{};             ///< why the case is unsteady, if memory is why
  RegisterMask changed = 0;                     ///< see Call::changed()
  std::optional<check::JudgedCase> smallest{};  ///< the simplest case that is wrong when run again
  bool is_stopped = false;                      ///< by an interrupt, before the last case

  [[nodiscard]] bool is_right() const {
    return !stuck && !not_preserved && !unsteady && (!judge || judge->is_right());
  }
};

/// Judges an operation of check::is_judged(). Stops at the first call that neither returns nor
/// raises #DE.
/// @throws support::UsageError if no machine can run the routine
Verdict judge_routine(const Subject& subject, const VerdictOptions& options);

/// Returns a case and its result in the form that check judges.
check::JudgedCase judged_case(const cases::Variant& variant, std::span<const std::uint32_t> words,
                              const Answer& answer);

/// A rule that cos_sin or transform may follow.
struct Candidate {
  std::string name;
  std::function<void(std::span<const std::uint32_t> in, std::span<std::uint32_t> out)> results;
  std::uint64_t exceptions = 0;
  std::optional<Incident> first_exception{};
};

struct WholeVerdict {
  Verdict verdict;                      ///< without a judge
  std::vector<Candidate> candidates{};  ///< fewest exceptions first
};

/// Judges cossin or xformvec in 16.16, whose results have several words.
WholeVerdict judge_whole(const Subject& subject, const VerdictOptions& options);

}  // namespace fixproof::judge
