/// @file
/// What a pixel of every inner loop takes by Intel's tables, and what its source says of that.
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

/// What happens to the pixels of a span. Only the depth test has hidden ones.
enum class Pixels { drawn, hidden };

/// The processors of every table of inner loops.
inline constexpr std::array loop_processors{x86model::Cpu::i8088, x86model::Cpu::i286,
                                            x86model::Cpu::i386, x86model::Cpu::i486};

/// The clocks per pixel of one form within a long span, without entering and leaving the loop.
/// Nothing for a processor that cannot run the form.
struct LoopClocks {
  x86model::LoopForm form;
  Pixels pixels{};
  std::array<std::optional<Clocks>, loop_processors.size()> on;
};

/// Every form; the depth test twice.
std::vector<LoopClocks> loop_clocks();

/// @return nothing if the processor cannot run the form
std::optional<Clocks> pixel_clocks(const x86model::LoopForm& form, Pixels pixels,
                                   x86model::Cpu cpu);

/// `depth-test hidden`, `texture as printed`
std::string name_of(const x86model::LoopForm& form, Pixels pixels);
/// `i386` or `i8088`
std::string_view target_name(const x86model::LoopForm& form);

/// How many times as many clocks one way to draw takes as another, on one processor. An 8088 has
/// two gains: one by the table, one by the larger of table and bus time.
struct LoopGain {
  std::string where;  ///< which loops and processor
  double min = 0;
  double max = 0;
};
/// A statement of the source: that there is a gain.
struct LoopClaim {
  std::string text;
  std::string place;  ///< where it is printed
  std::vector<LoopGain> gains;
};
/// Two pixels a store, DEC and JNZ in place of LOOP, unrolling.
std::vector<LoopClaim> loop_claims();

}  // namespace fixproof::measure
