/// @file
/// Tells why the results of a routine depend on earlier calls.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "judge/code/listing.hpp"
#include "judge/code/runner.hpp"

namespace fixproof::judge {

/// Memory that a call reads before it writes it, and that a call writes.
struct KeptState {
  std::uint64_t address = 0;  ///< linear
  Line reads{};               ///< the first instruction that reads it
  Line writes{};              ///< the first instruction that writes it
};

/// Looks for such memory outside the stack and the operands, in traces of a case and of those of
/// inspect(). Needs Unicorn and ndisasm.
/// @throws support::UsageError if ndisasm cannot be run; support::Stopped
std::optional<KeptState> find_kept_state(const Subject& subject,
                                         std::span<const std::uint32_t> words);

}  // namespace fixproof::judge
