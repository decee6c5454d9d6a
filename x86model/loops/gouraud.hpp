/// @file
/// Gouraud shading of a span: an intensity in 8.8, stepped by one addition per pixel; its integer
/// part is the pixel. One version writes bytes, one words of two pixels.
///
/// DX is the intensity, BP its step, ES:DI the first pixel, and CX the count; if unrolled, BX is
/// the jump target.
#pragma once

#include "x86model/loops/counting.hpp"

namespace x86model::loops {

/// Three instructions per pixel. The sum has 16 bits on both processors.
constexpr Listing gouraud_byte(Counting counting, Target target) {
  using namespace notation;
  return counted(counting, target, {mov(al, dh), add(dx, bp), stosb()});
}

/// Five instructions per two pixels. CX is an even number of pixels. The words are aligned if the
/// first pixel has an even address. On the 386 the sums have 32 bits, and DH uses 16 of them.
constexpr Listing gouraud_word(Counting counting, Target target) {
  using namespace notation;
  const Registers r = registers_of(target);
  const Listing pair{
      mov(al, dh), add(r.value, r.step), mov(ah, dh), stosw(), add(r.value, r.step),
  };
  // Unrolled, the count register holds the jump target.
  if (counting == Counting::unrolled) return counted(counting, target, pair);
  Listing all{shr(r.count, 1)};
  all += counted(counting, target, pair);
  return all;
}

}  // namespace x86model::loops
