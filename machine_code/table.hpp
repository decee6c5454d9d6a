/// @file
/// The table that NASM's output is turned into when this is built.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace fixproof::machine_code {

/// The bytes of one program.
struct Assembled {
  std::string_view name;                  ///< see name_of() of programs.hpp
  std::span<const std::uint8_t> code;     ///< as it stands at code_origin
  std::span<const std::uint8_t> command;  ///< a DOS .COM file that calls it; none for a loop
};

/// All programs; none where there was no assembler.
std::span<const Assembled> assembled_programs();

}  // namespace fixproof::machine_code
