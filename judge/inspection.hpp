/// @file
/// Looks at single calls of a routine, step by step.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "judge/listing.hpp"
#include "judge/runner.hpp"

namespace fixproof::judge {

/// The calls that are looked at step by step.
inline constexpr std::uint64_t calls_to_inspect = 40;

/// What results do not show. Each finding is the first of its kind.
struct Inspection {
  struct Finding {
    std::string operands{};     ///< of the case
    Line line{};                ///< the instruction
    std::uint32_t address = 0;  ///< of the memory, linear
    bool is_write = false;
    unsigned flags = 0;  ///< that are read
  };
  std::uint64_t calls = 0;
  std::optional<Finding> undefined_flag{};    ///< reads a flag that Intel leaves undefined
  std::optional<Finding> foreign_memory{};    ///< uses memory outside its file and its stack
  std::optional<Finding> changes_own_code{};  ///< writes to an instruction that runs

  [[nodiscard]] bool is_clean() const {
    return !undefined_flag && !foreign_memory && !changes_own_code;
  }
};

/// Traces evenly spread cases of a verification on Unicorn, which must be there.
/// @throws support::UsageError if ndisasm cannot be run; proof::Stopped
Inspection inspect(const Subject& subject);

/// Returns the steps of one call as text: each instruction with the registers that it changes, then
/// the result.
std::string trace_text(const Subject& subject, std::span<const std::uint32_t> words);

}  // namespace fixproof::judge
