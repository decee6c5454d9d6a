/// @file
/// The way from 64-bit code into a 16-bit segment and back.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fixproof::machine_code {

/// What the way back needs, at an address below 4 GiB: the 16-bit code can jump no further.
struct Landing {
  std::uint64_t stack;   ///< RSP of the 64-bit side
  std::uint64_t resume;  ///< where fixproof_enter_segment() goes on
};

/// Everything a call takes and gives. The assembler code knows the offsets.
struct SegmentCall {
  std::uint32_t registers[8];  ///< in the order of their encoding; NOLINT(*-c-arrays)
  std::uint32_t flags;
  std::uint32_t entry;  ///< offset and selector, as the far jump reads them
  std::uint16_t code_selector;
  std::uint16_t data_selector;
  std::uint32_t reserved;
  Landing* landing;
};
static_assert(offsetof(SegmentCall, flags) == 32 && offsetof(SegmentCall, entry) == 36 &&
              offsetof(SegmentCall, code_selector) == 40 &&
              offsetof(SegmentCall, data_selector) == 42 && offsetof(SegmentCall, landing) == 48);
static_assert(offsetof(Landing, resume) == 8);

/// Where a Landing stands relative to the code that uses it.
inline constexpr std::size_t landing_distance = 0x1000;

extern "C" {
/// Loads the registers, flags and segments of a call and jumps to its entry; returns when the code
/// there has jumped to a copy of the landing code. All registers that a C++ caller keeps are kept.
void fixproof_enter_segment(fixproof::machine_code::SegmentCall* call) noexcept;
/// The landing code, for a page landing_distance before a Landing, and its end.
extern const std::uint8_t fixproof_landing[];      // NOLINT(*-c-arrays)
extern const std::uint8_t fixproof_landing_end[];  // NOLINT(*-c-arrays)
}

}  // namespace fixproof::machine_code
