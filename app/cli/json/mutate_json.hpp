/// @file
/// The result of `fixproof mutate` as JSON.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/cli/json/proof_json.hpp"
#include "support/json.hpp"
#include "verify/proof/kill.hpp"

namespace fixproof::cli {

/// What became of the mutants of one program, or of all.
struct MutantScore {
  std::string name;
  std::size_t mutants = 0;
  std::size_t killed = 0;
  std::size_t equivalent = 0;
  std::size_t gaps = 0;
  std::uint64_t slowest = 0;  ///< the most cases up to a kill

  void add(const proof::MutantResult& result) {
    ++mutants;
    ++(result.fate == proof::Fate::killed       ? killed
       : result.fate == proof::Fate::equivalent ? equivalent
                                                : gaps);
    if (result.fate == proof::Fate::killed) slowest = std::max(slowest, result.cases);
  }
};

/// A mutant that is worth a line.
struct NotableMutant {
  std::string program;
  std::size_t number = 0;
  std::string change;
  std::string fate;
};

struct MutationReport {
  SolverUse solver;
  std::uint64_t seed = 0;
  std::vector<MutantScore> programs;
  MutantScore all{"all"};
  std::vector<NotableMutant> notable;
  std::size_t left = 0;  ///< mutants that are not judged, after an interrupt
  double seconds = 0;
};

support::Json mutate_json(const MutationReport& report);

}  // namespace fixproof::cli
