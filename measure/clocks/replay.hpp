/// @file
/// Runs recorded calls of the listings again, with clock counters.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "verify/cases/variant.hpp"
#include "x86model/count_clocks.hpp"

namespace fixproof::measure {

struct ReplayedCall {
  std::span<const std::uint32_t> in;
  std::span<const std::uint32_t> out;
  x86model::Ending ending;
  std::span<const x86model::ClockCounter> counters;  ///< one for each processor
};

/// Runs the routine of a variant on the interpreter for the operands of `words`, case by case.
/// @param visit called after each call; returns whether to go on
/// @return for each instruction of the program, whether it was executed
/// @throws std::invalid_argument if one of `cpus` cannot run the listing
std::vector<bool> replay_calls(const cases::Variant& variant, std::span<const std::uint32_t> words,
                               std::span<const x86model::Cpu> cpus,
                               const std::function<bool(const ReplayedCall&)>& visit);

}  // namespace fixproof::measure
