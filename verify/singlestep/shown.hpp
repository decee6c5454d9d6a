/// @file
/// The registers and flags in the order in which every command prints them.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "x86model/flags.hpp"
#include "x86model/instruction.hpp"

namespace fixproof::singlestep {

inline constexpr std::array shown_registers{
    x86model::Register::ax, x86model::Register::bx, x86model::Register::cx, x86model::Register::dx,
    x86model::Register::si, x86model::Register::di, x86model::Register::bp, x86model::Register::sp};

inline constexpr std::array<std::pair<x86model::Flag, std::string_view>, 6> shown_flags{
    {{x86model::CF, "CF"},
     {x86model::PF, "PF"},
     {x86model::AF, "AF"},
     {x86model::ZF, "ZF"},
     {x86model::SF, "SF"},
     {x86model::OF, "OF"}}};

/// The six flags as 0, 1 or, if undefined, ?, three characters per flag.
inline std::string flag_columns(const x86model::Flags& f) {
  std::string columns;
  for (const auto& [flag, name] : shown_flags) {
    const char* set = (f.value & flag) != 0 ? "  1" : "  0";
    columns += (f.undefined & flag) != 0 ? "  ?" : set;
  }
  return columns;
}

}  // namespace fixproof::singlestep
