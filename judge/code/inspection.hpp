/// @file
/// Looks at single calls of a routine, step by step.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "judge/code/listing.hpp"
#include "judge/code/runner.hpp"

namespace fixproof::judge {

/// The number of calls that are looked at step by step.
inline constexpr std::uint64_t calls_to_inspect = 40;

/// Defects that results do not show. Each finding is the first of its kind.
struct Inspection {
  struct Finding {
    std::string operands{};     ///< the case
    Line line{};                ///< the instruction
    std::uint64_t address = 0;  ///< linear, of the memory
    bool is_write = false;
    unsigned flags = 0;  ///< the undefined flags that it reads
  };
  std::uint64_t calls = 0;
  std::uint64_t instructions = 0;  ///< of all calls
  std::uint64_t least_instructions = ~std::uint64_t{0};
  std::uint64_t most_instructions = 0;
  std::optional<Finding> undefined_flag{};    ///< reads a flag that Intel leaves undefined
  std::optional<Finding> foreign_memory{};    ///< uses memory outside its file, stack and operands
  std::optional<Finding> changes_own_code{};  ///< writes to an instruction that the call runs
  /// In 64-bit code, runs what only the operating system may. Unicorn runs it, too.
  std::optional<Finding> privileged{};

  [[nodiscard]] bool is_clean() const {
    return !undefined_flag && !foreign_memory && !changes_own_code && !privileged;
  }
};

/// Traces 40 evenly spread cases on Unicorn, which must be installed.
/// @throws support::UsageError if ndisasm cannot be run; support::Stopped
Inspection inspect(const Subject& subject);

/// One call as text, and how it ended.
struct TraceText {
  std::string steps;  ///< each instruction with the registers that it changes, then the result
  Ending ending;
};
TraceText trace_text(const Subject& subject, std::span<const std::uint32_t> words);

}  // namespace fixproof::judge
