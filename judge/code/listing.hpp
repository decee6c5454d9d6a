/// @file
/// The instructions of an image as text, from NASM's disassembler.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "judge/code/decoded.hpp"
#include "judge/code/image.hpp"
#include "judge/code/ndisasm.hpp"

namespace fixproof::judge {

/// Disassembles on demand. Needs ndisasm on the PATH.
class Listing {
 public:
  explicit Listing(const Image& image) : image_(image) {}

  /// Returns the instruction that starts at an offset, even if it lies within another one.
  /// @throws support::UsageError if ndisasm cannot be run
  const Line& at(std::uint32_t offset);

  /// Decodes the instruction at an offset. Zydis knows opcodes that NASM writes as bytes, so the
  /// length may differ from that of at().
  [[nodiscard]] Decoded decoded_at(std::uint32_t offset) const;

 private:
  const Image& image_;
  std::map<std::uint32_t, Line> lines_;
};

/// Returns the instructions that the image's entry can reach, in the order of their offsets. Does
/// not follow targets in registers and memory.
std::vector<Line> reachable(const Image& image, Listing& listing);

/// Returns the routine as NASM source. NASM assembles it to confirm that the bytes are the same. An
/// instruction that NASM would encode differently is written as bytes.
/// @throws support::UsageError if nasm or ndisasm cannot be run
std::string source_of(const Image& image);

}  // namespace fixproof::judge
