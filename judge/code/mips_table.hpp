/// @file
/// The table of offsets of a linked file for MIPS.
#pragma once

#include <cstdint>
#include <optional>

#include "judge/code/elf_file.hpp"

namespace fixproof::judge::elf {

/// Where position-independent code finds addresses. No relocation names the entries: first come
/// addresses in the file, then those of the last symbols of the dynamic table, in its order (System
/// V ABI, MIPS Processor Supplement, 5).
struct MipsTable {
  std::uint32_t address = 0;       ///< in the file
  std::uint32_t own = 0;           ///< entries with addresses in the file
  std::uint32_t first_symbol = 0;  ///< the one of the first entry after these
  std::uint32_t symbols = 0;       ///< of the dynamic table

  [[nodiscard]] std::uint32_t entries() const { return own + symbols - first_symbol; }
};

/// Returns the table of a file; nothing for one that is not linked dynamically.
/// @throws support::UsageError if the file is damaged
std::optional<MipsTable> mips_table(const File& file, bool is_big_endian);

}  // namespace fixproof::judge::elf
