/// @file
/// The machine that executes single instructions: registers and flags only.
#pragma once

#include <cstdint>

#include "x86model/machine.hpp"

namespace fixproof::singlestep {

/// Reads fail and writes are discarded.
struct NoMemory {
  static bool read(std::uint32_t /*address*/, std::uint32_t& /*value*/) { return false; }
  static bool write(std::uint32_t /*address*/, std::uint32_t /*value*/) { return true; }
  static bool read_byte(std::uint32_t /*address*/, std::uint32_t& /*value*/) { return false; }
  static bool write_byte(std::uint32_t /*address*/, std::uint32_t /*value*/) { return true; }
  static bool write_extra_byte(std::uint32_t /*place*/, std::uint32_t /*value*/) { return true; }
  static bool write_extra_word(std::uint32_t /*place*/, std::uint32_t /*value*/) { return true; }
};

using StepMachine = x86model::Machine<16, NoMemory>;

}  // namespace fixproof::singlestep
