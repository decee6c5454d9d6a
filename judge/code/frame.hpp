/// @file
/// Calling conventions: where a routine finds its operands and leaves its results.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judge/code/convention.hpp"
#include "judge/code/image.hpp"
#include "judge/code/parameter.hpp"
#include "judge/code/register_name.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::judge {

/// A value, or a pointer to it, in registers.
struct Place {
  std::vector<RegisterName> parts;  ///< the highest bits first
  bool is_pointer = false;
};

/// The names in a place and in a frame of registers, as a user wrote them.
struct PlaceText {
  std::vector<std::string_view> parts{};  ///< the highest bits first
  bool is_pointer = false;
};
/// What a message offers for a word that is neither a register nor a type.
inline constexpr const char* types_instead =
    "types of C such as int32_t, for a typedef the type that it stands for";

struct FrameText {
  std::vector<PlaceText> in{};
  std::vector<PlaceText> out{};
  std::vector<std::string_view> kept{};
};
/// Takes a frame such as `dx:ax, cx:bx -> dx:ax keeps si` apart; nothing for one without an arrow.
/// @throws support::UsageError naming what is no place
/// @param most_parts of a number
/// @param of_pointer the most parts of a pointer
std::optional<FrameText> frame_text(std::string_view text, std::size_t most_parts = 2,
                                    std::size_t of_pointer = 1);

struct Frame {
  std::string text;                  ///< as the user wrote it
  bool on_stack = true;              ///< the operands are on the stack, not in registers
  bool is_far = false;               ///< the routine ends in RETF, and pointers have segments
  bool callee_pops = false;          ///< the routine removes its arguments from the stack
  bool first_is_top = true;          ///< the first argument is pushed last
  std::vector<Place> in{};           ///< operands; empty if they are on the stack
  std::vector<Place> out{};          ///< results; empty on the stack or if all are behind pointers
  std::vector<RegisterName> kept{};  ///< must be preserved, as must the stack pointer
  /// The places on a processor other than x86; then no member but `text` and the last counts.
  std::optional<Convention> elsewhere{};
  Signature signature{};  ///< what these places have
};

/// Returns the convention of 64-bit code, of Windows or of System V.
/// @throws support::UsageError for more parameters than there are registers for them
Frame convention_of_64_bits(bool is_windows, const Signature& signature);

/// Parses `c`, `c-far`, `pascal`, `pascal-far`, `stdcall`, or registers:
/// `eax, ebx -> eax`, `dx:ax, cx:bx -> dx:ax keeps si, di`, `[si], [bx], [di] ->`. In 64-bit code
/// `c` and `sysv` are the convention of System V, and `ms` is that of Windows. Types of C, as in
/// `long, long -> long`, are that of `c`.
/// @param bits 16, 32 or 64, the width of the code
/// @throws support::UsageError for any other text
Frame frame_named(std::string_view text, int bits, const cases::Variant& variant);

/// Returns the frame of an image's processor. That of another processor than x86 is `c`, types of C
/// or registers, and is known to fit.
/// @throws support::UsageError as frame_named()
Frame frame_for(const Image& image, std::string_view text, const cases::Variant& variant);

/// Checks that the frame has a place for each operand and each result of the operation.
/// @throws support::UsageError naming the place that is missing or too small
void expect_fit(const Frame& frame, const cases::Variant& variant, int bits);

}  // namespace fixproof::judge
