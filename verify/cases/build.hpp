/// @file
/// The builds of FIXED.ASM and the other sets of rules that an operation can follow.
#pragma once

#include <array>
#include <cstdint>

namespace fixproof::cases {

enum class Target : std::uint8_t {
  i386,
  i8088,
  standard,  ///< the rules of fixproof::q16_16: rounds half up and wraps; #DE only for a zero
             ///< divisor
};

/// One set of rules. `mul_round` and `div_round` tell whether the code rounds. The printed switches
/// can differ from them: see printed_build().
struct Build {
  Target target = Target::i386;
  bool mul_round = true;
  bool div_round = true;
  /// Selects the routines of chapter 52 (386, rounded) instead of those of chapter 54.
  bool chapter_52 = false;
  /// Selects the 8088 ConcatXforms that keeps the carry its listing loses: docs/findings.md, 18.
  bool repaired = false;

  friend constexpr bool operator==(const Build&, const Build&) = default;
};

/// Returns the build that the switches of chapter 54 select. The listings print the multiply switch
/// on and the divide switch off. The 8088 divide inverts its switch.
constexpr Build printed_build(Target target, bool mul_switch = true, bool div_switch = false) {
  const bool inverted = target == Target::i8088;
  return {
      .target = target, .mul_round = mul_switch, .div_round = inverted ? !div_switch : div_switch};
}

/// The builds of chapter 54 that round both operations or neither.
inline constexpr std::array<Build, 4> uniform_builds{{{Target::i386, true, true},
                                                      {Target::i386, false, false},
                                                      {Target::i8088, true, true},
                                                      {Target::i8088, false, false}}};

}  // namespace fixproof::cases
