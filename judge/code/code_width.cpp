#include "judge/code/code_width.hpp"

#include <algorithm>
#include <array>

#include "judge/code/listing.hpp"

namespace fixproof::judge {

namespace {

/// MOVSXD, which is ARPL in other code. Programs have no use for ARPL.
constexpr std::uint8_t movsxd = 0x63;
/// ADD, SUB, CMP, TEST, MOV, LEA, CDQE, CQO, shifts, IMUL, IDIV; 0F AF is IMUL.
constexpr std::array<std::uint8_t, 18> common{0x01, 0x03, 0x29, 0x2B, 0x39, 0x3B, 0x85, 0x89, 0x8B,
                                              0x8D, 0x98, 0x99, 0xC1, 0xD1, 0xD3, 0xF7, 0x83, 0x0F};

}  // namespace

bool looks_like_64_bits(const Image& image) {
  Listing listing(image);
  int seen = 0;
  for (const Line& line : reachable(image, listing)) {
    const std::uint32_t linear = image.code_at(line.at);
    const std::uint32_t at = image.index_of(linear);
    if (linear + 1 >= image.end || (image.memory[at] & 0xF8U) != 0x48) continue;
    const std::uint8_t next = image.memory[at + 1];
    if (next == movsxd) return true;
    if (std::ranges::find(common, next) != common.end()) ++seen;
  }
  return seen >= 2;
}

}  // namespace fixproof::judge
