/// @file
/// Assembly and registers that a person types in place of those of a routine.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "x86model/assemble.hpp"
#include "x86model/instruction.hpp"

namespace fixproof::web {

struct Edit {
  std::string error{};                        ///< what is wrong with the text; empty if it is right
  std::vector<x86model::Instruction> code{};  ///< empty: that of the build
  std::vector<std::string> names{};           ///< of the labels; the code points to them
  /// What registers hold on entry.
  std::vector<std::pair<x86model::Register, std::uint32_t>> registers{};
};

/// Reads instructions as x86model::text_of() writes them, with `label:` before an instruction.
/// @param registers such as `ax=1234 ebx=ffff8000`, in hexadecimal; any but SP
/// @param lines one instruction each; no lines mean the code of the build
Edit edit_of(std::string_view registers, std::span<const std::string_view> lines,
             x86model::Target target);

}  // namespace fixproof::web
