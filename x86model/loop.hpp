/// @file
/// Which inner loops there are, in which forms, and their programs.
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

/// One loop in one of its forms. DepthTest is for the 386 only, and never unrolled; it alone can be
/// as printed. The forms for the 8088 are those of the source with the lower halves of its
/// registers.
struct LoopForm {
  Loop loop = Loop::gouraud_byte;
  Counting counting = Counting::loop;
  Target target = Target::i386;
  /// DepthTest with the SHRD that the source has in the place of SHLD.
  bool as_printed = false;

  friend bool operator==(const LoopForm&, const LoopForm&) = default;
};

/// Whether there is such a form.
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

/// How many pixels one turn of a loop draws.
constexpr std::uint32_t pixels_a_turn(Loop loop) { return loop == Loop::gouraud_word ? 2 : 1; }
/// How often an unrolled loop has its pixels.
constexpr std::uint32_t copies_of(Loop loop) { return loops::most_pixels / pixels_a_turn(loop); }

/// Every form there is.
std::vector<LoopForm> all_loop_forms();

/// "GouraudBytes", "GouraudWords", "DepthTest", "TextureSpan".
std::string_view name_of(Loop loop);

/// The code that runs: `program`, assembled from the listing of the form or a broken one, with the
/// copies of an unrolled loop.
std::vector<Instruction> code_of(const LoopForm& form, const Program& program);
std::vector<Instruction> code_of(const LoopForm& form);

/// Where an unrolled loop is entered to draw so many pixels, counted in bytes from its first
/// instruction: behind the jump and the copies that are left out.
/// @param pixels at most loops::most_pixels; for words an even number
std::uint32_t entry_of(const LoopForm& form, std::uint32_t pixels);

}  // namespace x86model
