/// @file
/// A span of a bitmap 256 pixels wide, its two coordinates in 8.8 stepped by an addition each.
///
/// DX column, BP its step, SI row, ES:DI the first pixel, CX how many and IncJ in memory the step
/// of the row; unrolled, BX where to jump to and CX the step of the row.
#pragma once

#include "x86model/loops/counting.hpp"

namespace x86model::loops {

/// Six instructions a pixel, and the counting. The 386 steps 32 bits, of which 16 are looked at.
constexpr Listing texture(Counting counting, Target target) {
  using namespace notation;
  const Registers r = registers_of(target);
  const Operand row_step = counting == Counting::unrolled ? r.count
                           : r.count.size == Size::dword  ? dword[IncJ]
                                                          : word[IncJ];
  return counted(counting, target,
                 {mov(bx, si), mov(bl, dh), mov(al, byte[Texture + bx]), stosb(),
                  add(r.value, r.step), add(r.row, row_step)});
}

}  // namespace x86model::loops
