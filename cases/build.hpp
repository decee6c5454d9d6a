/// @file
/// Which build of FIXED.ASM, or which other set of rules, an operation follows.
#pragma once

#include <array>
#include <cstdint>

namespace fixproof::cases {

/// Whose rules apply.
enum class Target : std::uint8_t {
  i386,
  i8088,
  standard,  ///< the rules of fixed::q16_16: round to nearest, halves up; wrap; a divide error only
             ///< for a zero divisor
};

/// One set of rules. `mul_round` and `div_round` say what the code does, not how the printed
/// switches are set: see printed_build().
struct Build {
  Target target = Target::i386;
  bool mul_round = true;
  bool div_round = true;
  /// The routines of chapter 52 (386, rounded) instead of chapter 54; see ConcatXforms.
  bool chapter_52 = false;
  /// ConcatXforms for the 8088 with the carry that its listing loses: docs/findings.md, 18.
  bool repaired = false;

  friend constexpr bool operator==(const Build&, const Build&) = default;
};

/// The build that the switches of chapter 54 select. The listings print the multiply switch on and
/// the divide switch off. The 8088 divide tests its switch the wrong way round.
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
