/// @file
/// Clocks per pixel of every inner loop, and the claims of the source about them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "measure/clocks/bounds.hpp"
#include "x86model/clocks.hpp"
#include "x86model/loop.hpp"

namespace fixproof::measure {

/// Only the depth test has hidden pixels.
enum class Pixels { drawn, hidden };

/// The processors in every table of inner loops.
inline constexpr std::array loop_processors{x86model::Cpu::i8088, x86model::Cpu::i286,
                                            x86model::Cpu::i386, x86model::Cpu::i486};

/// The clocks per pixel of one form in a long span, without entering and leaving the loop. Empty
/// for a processor that cannot run the form.
struct LoopClocks {
  x86model::LoopForm form;
  Pixels pixels{};
  std::array<std::optional<Clocks>, loop_processors.size()> on;
};

/// The clocks of every form; the depth test appears twice.
std::vector<LoopClocks> loop_clocks();

/// @return nothing if the processor cannot run the form
std::optional<Clocks> pixel_clocks(const x86model::LoopForm& form, Pixels pixels,
                                   x86model::Cpu cpu);

/// `depth-test hidden`, `texture as printed`
std::string name_of(const x86model::LoopForm& form, Pixels pixels);
/// `i386` or `i8088`
std::string_view target_name(const x86model::LoopForm& form);

/// The ratio of the clocks of two ways to draw on one processor. An 8088 has two gains: by the
/// table, and by the larger of table and bus time.
struct LoopGain {
  std::string where;  ///< which loops and processor
  double min = 0;
  double max = 0;
};
/// A claim of the source that there is a gain.
struct LoopClaim {
  std::string text;
  std::string place;  ///< where it is printed
  std::vector<LoopGain> gains;
};
/// The claims about two pixels per store, DEC and JNZ instead of LOOP, and unrolling.
std::vector<LoopClaim> loop_claims();

}  // namespace fixproof::measure
