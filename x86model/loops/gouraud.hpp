/// @file
/// Gouraud shading of a span: an intensity in 8.8, stepped by one addition a pixel; its integer
/// part is the pixel. By bytes, and by words of two pixels.
///
/// DX intensity, BP its step, ES:DI the first pixel, CX how many; unrolled, BX where to jump to.
#pragma once

#include "x86model/loops/counting.hpp"

namespace x86model::loops {

/// Three instructions a pixel. The sum is one of 16 bits on both processors.
constexpr Listing gouraud_byte(Counting counting, Target target) {
  using namespace notation;
  return counted(counting, target, {mov(al, dh), add(dx, bp), stosb()});
}

/// Five instructions for two pixels. CX pixels, an even number; the words are aligned where the
/// first pixel has an even address. On the 386 the sums are of 32 bits, of which DH sees 16.
constexpr Listing gouraud_word(Counting counting, Target target) {
  using namespace notation;
  const Registers r = registers_of(target);
  const Listing pair{
      mov(al, dh), add(r.value, r.step), mov(ah, dh), stosw(), add(r.value, r.step),
  };
  // Unrolled, the count is in the place of the jump.
  if (counting == Counting::unrolled) return counted(counting, target, pair);
  Listing all{shr(r.count, 1)};
  all += counted(counting, target, pair);
  return all;
}

}  // namespace x86model::loops
