/// @file
/// A span of one colour against a depth buffer of 16-bit words: draws where the depth is greater,
/// as a signed number. 386 only.
///
/// EDX is the depth in 16.8, EBP its step, AL the colour, EDI the pixel's index in screen and
/// buffer, and CX the count.
#pragma once

#include "x86model/loops/counting.hpp"

namespace x86model::loops {

/// @param as_printed uses SHRD as the source does, which does not compute the depth that its
/// comment describes; otherwise SHLD
constexpr Listing depth_test(Counting counting, bool as_printed) {
  using namespace notation;
  constexpr int fraction = 24;
  Listing all{
      label("Pixel"), as_printed ? shrd(ebx, edx, fraction) : shld(ebx, edx, fraction),
      add(edx, ebp),  cmp(bx, word[ZBuff + twice(edi)]),
      jg("PlotIt"),   inc(edi),
  };
  all += next_pixel(counting, Target::i386, "Pixel");
  all += {
      jmp("Done"), label("PlotIt"), mov(byte[Screen + edi], al), mov(word[ZBuff + twice(edi)], bx),
      inc(edi),
  };
  all += next_pixel(counting, Target::i386, "Pixel");
  all += {label("Done"), ret()};
  return all;
}

}  // namespace x86model::loops
