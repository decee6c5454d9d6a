/// @file
/// Calling conventions of processors other than x86, by their row in the table.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "judge/code/architecture.hpp"
#include "judge/code/parameter.hpp"

namespace fixproof::judge {

struct FrameText;

/// A register, or bytes on the stack.
struct Part {
  bool is_register = true;
  std::size_t at = 0;  ///< the register's number in its file, or bytes above the stack pointer
};

/// Where a number or a pointer is.
struct Passing {
  std::vector<Part> parts;  ///< the lowest bits first, one word of the processor each
  bool is_pointer = false;
};

struct Convention {
  std::vector<Passing> in{};
  std::vector<Passing> out{};
  std::uint64_t kept = 0;         ///< bit r for the register of that number
  std::uint32_t stack_bytes = 0;  ///< of the arguments there, with what is below them
};

/// Returns the convention of C, which is that of the processor's ABI.
/// @param result_bits of the value that the routine returns; 0 if it returns none
/// @throws support::UsageError if it returns no number of so many bits
Convention convention_of_c(const Architecture& architecture, std::span<const Parameter> parameters,
                           int result_bits);

/// Returns the convention that a user wrote as registers.
/// @throws support::UsageError naming a register or place that does not fit
Convention convention_of_registers(const Architecture& architecture, const FrameText& text,
                                   std::span<const Parameter> parameters, int result_bits);

}  // namespace fixproof::judge
