/// @file
/// The six arithmetic flags, each 0, 1 or undefined.
#pragma once

#include <cstdint>

#include "x86model/inline.hpp"

namespace x86model {

/// Bit positions in the FLAGS register (Intel SDM volume 1, figure 3-8).
enum Flag : std::uint16_t {
  CF = 0x001,
  PF = 0x004,
  AF = 0x010,
  ZF = 0x040,
  SF = 0x080,
  OF = 0x800,
};

inline constexpr std::uint16_t arithmetic_flags = CF | PF | AF | ZF | SF | OF;

/// A set of flags. `value` has the bits of the defined flags and 0 for undefined ones, which
/// `undefined` marks.
struct Flags {
  std::uint16_t value = 0;
  std::uint16_t undefined = 0;

  friend constexpr bool operator==(const Flags&, const Flags&) = default;

  /// Whether all of these flags are defined.
  [[nodiscard]] X86MODEL_INLINE bool are_defined(std::uint16_t flags) const noexcept {
    return (undefined & flags) == 0;
  }
  /// A defined flag.
  [[nodiscard]] X86MODEL_INLINE bool get(Flag flag) const noexcept { return (value & flag) != 0; }
  /// Member by member: as a whole, g++ stores two halves on the stack and waits to load them as
  /// one.
  X86MODEL_INLINE void set(Flags flags) noexcept {
    value = flags.value;
    undefined = flags.undefined;
  }
  /// These flags, with those in `keep` replaced by the ones of `before`.
  [[nodiscard]] X86MODEL_INLINE Flags keeping(std::uint16_t keep, Flags before) const noexcept {
    const auto change = static_cast<std::uint16_t>(~keep);
    return {static_cast<std::uint16_t>((value & change) | (before.value & keep)),
            static_cast<std::uint16_t>((undefined & change) | (before.undefined & keep))};
  }
};

/// What an instruction does to the arithmetic flags, as sets of Flag. A flag in neither of the last
/// two keeps its value.
struct FlagUse {
  std::uint16_t reads = 0;
  std::uint16_t sets = 0;
  std::uint16_t leaves_undefined = 0;
};

/// The flags on entry to a routine, which may assume nothing about them.
inline constexpr Flags all_undefined{0, arithmetic_flags};

}  // namespace x86model
