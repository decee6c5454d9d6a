/// @file
/// Records every state of a run of the model.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "x86model/clocks.hpp"
#include "x86model/routine.hpp"
#include "x86model/run.hpp"

namespace fixproof::web {

/// The machine after an instruction.
struct Snapshot {
  std::size_t position = 0;  ///< of the instruction; 0 in the first snapshot, which has none
  std::array<std::uint32_t, x86model::register_count> registers{};
  x86model::Flags flags{};
  std::vector<std::uint16_t> memory{};  ///< words from address 0
  x86model::Range clocks{};             ///< since the routine's first instruction
};

struct Run {
  std::string name;
  x86model::Target target{};
  x86model::Program program{};
  std::vector<Snapshot> snapshots{};  ///< the first is the state on entry
  x86model::Ending ending{};
  /// Whether the record ends at ending.position because the processor lacks that instruction.
  bool lacks_instruction = false;
  std::vector<std::uint32_t> result{};  ///< empty unless the routine returned
};

/// Returns the builds of a routine: `i386-on`, `i386-off`, `i8088-on`, `i8088-off`, and `i386-52`,
/// `i8088-on-repaired` and `i8088-off-scanned` where they exist. Those of cossin are `i386`,
/// `i8088` and `i8088-printed`.
std::vector<std::string> builds_of(x86model::Routine routine);

/// Runs one of builds_of(routine) and records every state.
/// @param in as many words as the routine takes
Run record(x86model::Routine routine, std::string_view build, std::span<const std::uint32_t> in);

/// Returns the number of instructions after which the runs first differ, in the last instruction or
/// in the state of the machine. Returns 0 if they do not differ.
std::size_t first_difference(const Run& a, const Run& b);

}  // namespace fixproof::web
