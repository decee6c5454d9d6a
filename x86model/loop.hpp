/// @file
/// The inner loops, their forms and their programs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "x86model/loops/depth_test.hpp"
#include "x86model/loops/gouraud.hpp"
#include "x86model/loops/texture.hpp"

namespace x86model {

enum class Loop : std::uint8_t { gouraud_byte, gouraud_word, depth_test, texture };
inline constexpr int loop_count = 4;

/// A form of a loop. DepthTest exists only for the 386, never unrolled, and is the only one with an
/// as-printed form. The forms for the 8088 use the lower halves of the source's registers.
struct LoopForm {
  Loop loop = Loop::gouraud_byte;
  Counting counting = Counting::loop;
  Target target = Target::i386;
  /// DepthTest with SHRD, as in the source, instead of SHLD.
  bool as_printed = false;

  friend bool operator==(const LoopForm&, const LoopForm&) = default;
};

/// Whether the form exists.
constexpr bool exists(const LoopForm& form) {
  if (form.loop != Loop::depth_test) return !form.as_printed;
  return form.target == Target::i386 && form.counting != Counting::unrolled;
}

constexpr Listing listing(const LoopForm& form) {
  switch (form.loop) {
    case Loop::gouraud_byte:
      return loops::gouraud_byte(form.counting, form.target);
    case Loop::gouraud_word:
      return loops::gouraud_word(form.counting, form.target);
    case Loop::depth_test:
      return loops::depth_test(form.counting, form.as_printed);
    case Loop::texture:
      break;
  }
  return loops::texture(form.counting, form.target);
}

/// The pixels drawn per iteration.
constexpr std::uint32_t pixels_per_iteration(Loop loop) {
  return loop == Loop::gouraud_word ? 2 : 1;
}
/// The number of copies in an unrolled loop.
constexpr std::uint32_t copies_of(Loop loop) {
  return loops::max_pixels / pixels_per_iteration(loop);
}

/// All forms that exist.
std::vector<LoopForm> all_loop_forms();

/// "GouraudBytes", "GouraudWords", "DepthTest", "TextureSpan".
std::string_view name_of(Loop loop);

/// The executable code: `program`, assembled from the form's listing or a mutant, with the copies
/// of an unrolled loop.
std::vector<Instruction> code_of(const LoopForm& form, const Program& program);
std::vector<Instruction> code_of(const LoopForm& form);

/// The entry point of an unrolled loop for a number of pixels, in bytes from its first instruction:
/// it skips the jump and the unneeded copies.
/// @param pixels at most loops::max_pixels; even for words
std::uint32_t entry_of(const LoopForm& form, std::uint32_t pixels);

}  // namespace x86model
