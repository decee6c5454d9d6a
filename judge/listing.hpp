/// @file
/// The instructions of an image as text, by NASM's disassembler.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "judge/image.hpp"

namespace fixproof::judge {

struct Line {
  std::uint32_t at = 0;  ///< offset in the code segment
  std::uint32_t bytes = 0;
  std::string text{};  ///< in NASM syntax; numbers are 0x...
};

/// Disassembles on demand. Needs ndisasm on the PATH.
class Listing {
 public:
  explicit Listing(const Image& image) : image_(image) {}

  /// Returns the instruction that starts at an offset, whatever starts before it.
  /// @throws support::UsageError if ndisasm cannot be run
  const Line& at(std::uint32_t offset);

 private:
  const Image& image_;
  std::map<std::uint32_t, Line> lines_;
};

/// Returns the offset to which a jump or call with a fixed target goes; 0xFFFFFFFF for any other
/// instruction.
std::uint32_t target_of(const Line& line);
/// Tells whether the next instruction in memory does not follow: a jump, a return or HLT.
bool ends_flow(const Line& line);
/// The first word of the text, without prefixes such as REP.
std::string mnemonic_of(const Line& line);

/// Returns the instructions that can run from the image's entry, by offset. Targets in registers
/// and memory are not followed.
std::vector<Line> reachable(const Image& image, Listing& listing);

/// Returns the routine as NASM source that assembles to the same bytes; nasm is asked to show it.
/// Instructions that it would encode in another way are written as bytes.
/// @throws support::UsageError if nasm or ndisasm cannot be run
std::string source_of(const Image& image);

}  // namespace fixproof::judge
