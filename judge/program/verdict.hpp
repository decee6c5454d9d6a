/// @file
/// Judges a program that reads cases and writes results.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "judge/check/cases.hpp"
#include "judge/check/judge.hpp"
#include "judge/program/relay.hpp"

namespace fixproof::program {

struct VerdictOptions {
  std::string command;            ///< for /bin/sh
  check::Rules rules;             ///< what the results should follow
  bool rounding_is_open = false;  ///< judge by the rounding that fits best
  check::CaseOptions cases{};
  std::size_t shown = 3;                      ///< number of wrong results to keep
  std::optional<std::size_t> processes{};     ///< by default as many as pay
  std::chrono::milliseconds silence{60'000};  ///< see RelayOptions
  std::function<void(std::uint64_t done, std::uint64_t all)> progress{};
};

/// Why the results of a program cannot be judged.
struct Failure {
  std::optional<Fault> fault{};           ///< empty if a result is none
  std::string defect{};                   ///< what is wrong with the result that is none
  std::string said{};                     ///< that result
  std::optional<check::JudgedCase> at{};  ///< the case; empty after the last one
  bool is_alone = false;                  ///< the program fails on this case even alone
  std::uint64_t results = 0;              ///< before it
};

struct Verdict {
  check::Rules rules;  ///< with the rounding that was found, if it was open
  std::optional<check::Judge> judge{};
  std::uint64_t cases = 0;  ///< all of them
  double seconds = 0;       ///< of the run that is judged
  std::size_t processes = 1;
  std::optional<check::JudgedCase> smallest{};  ///< the wrong case with the smallest operands
  std::optional<check::JudgedCase> unsteady{};  ///< the first with another result in a second run
  std::optional<Failure> failure{};
  bool is_stopped = false;  ///< Interrupt::flag() was set

  [[nodiscard]] bool is_right() const {
    return !failure && !unsteady && (!judge || judge->is_right());
  }
};

/// Judges an operation of check::is_judged(). A first run of about check::cases_for_guess cases
/// finds the rounding, most failures, and whether several processes pay.
/// @throws support::UsageError for an invalid shard; std::system_error if no process can be started
Verdict judge_program(const VerdictOptions& options);

}  // namespace fixproof::program
