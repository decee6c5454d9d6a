/// @file
/// Calls NASM's disassembler.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fixproof::judge {

struct Line {
  std::uint32_t at = 0;  ///< offset in the code segment
  std::uint32_t bytes = 0;
  std::string text{};  ///< in NASM syntax, with numbers as 0x...
};

/// Tells whether a mnemonic is a jump, LOOP or CALL.
bool is_jump(std::string_view mnemonic);

/// The longest instruction, in bytes.
inline constexpr std::uint32_t longest_instruction = 15;

/// Disassembles bytes from the first one on. Needs ndisasm on the PATH.
/// @param bits   16 or 32
/// @param origin the offset of the first byte
/// @throws support::UsageError if ndisasm cannot be run
std::vector<Line> disassembled(int bits, std::uint32_t origin, const std::string& bytes);

}  // namespace fixproof::judge
