/// @file
/// The table of assembled programs, which the build generates from NASM's output.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace fixproof::machine_code {

struct Assembled {
  std::string_view name;               ///< see name_of() of programs.hpp
  std::span<const std::uint8_t> code;  ///< assembled for code_origin
  std::span<const std::uint8_t>
      command;  ///< a DOS .COM file that calls the program; empty for a loop
};

/// All programs; empty if the build had no assembler.
std::span<const Assembled> assembled_programs();

}  // namespace fixproof::machine_code
