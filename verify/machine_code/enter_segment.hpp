/// @file
/// The switch from 64-bit code into a 16-bit segment and back.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fixproof::machine_code {

/// The state for the way back, below 4 GiB, the limit of a jump from 16-bit code.
struct Landing {
  std::uint64_t stack;   ///< RSP of the 64-bit side
  std::uint64_t resume;  ///< where fixproof_enter_segment() continues
};

/// The input and output of a call. The assembly code depends on the offsets.
struct SegmentCall {
  std::uint32_t registers[8];  ///< in the order of their encoding; NOLINT(*-c-arrays)
  std::uint32_t flags;
  std::uint32_t entry;  ///< offset and selector, in the layout of the far jump
  std::uint16_t code_selector;
  std::uint16_t data_selector;
  std::uint32_t hides_registers;  ///< what to clear before: 0 nothing, 1 SSE, 2 AVX too
  Landing* landing;
};
static_assert(offsetof(SegmentCall, flags) == 32 && offsetof(SegmentCall, entry) == 36 &&
              offsetof(SegmentCall, code_selector) == 40 &&
              offsetof(SegmentCall, data_selector) == 42 &&
              offsetof(SegmentCall, hides_registers) == 44 && offsetof(SegmentCall, landing) == 48);
static_assert(offsetof(Landing, resume) == 8);

/// The distance from the landing code to its Landing.
inline constexpr std::size_t landing_distance = 0x1000;

extern "C" {
/// Loads the registers, flags and segments of a call and jumps to its entry. Returns when that code
/// jumps to a copy of the landing code. Preserves all registers that a C++ caller relies on.
void fixproof_enter_segment(fixproof::machine_code::SegmentCall* call) noexcept;
/// The landing code and its end. A copy must be landing_distance before a Landing.
extern const std::uint8_t fixproof_landing[];      // NOLINT(*-c-arrays)
extern const std::uint8_t fixproof_landing_end[];  // NOLINT(*-c-arrays)
}

}  // namespace fixproof::machine_code
