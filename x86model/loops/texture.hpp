/// @file
/// A span of a bitmap 256 pixels wide; both coordinates are 8.8 and stepped by one addition each.
///
/// DX is the column, BP its step, SI the row, ES:DI the first pixel, CX the count, and IncJ in
/// memory the step of the row. If unrolled, BX is the jump target and CX the step of the row.
#pragma once

#include "x86model/loops/counting.hpp"

namespace x86model::loops {

/// Six instructions per pixel, plus counting. The 386 steps 32 bits and uses 16 of them.
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
