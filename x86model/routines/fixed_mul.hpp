/// @file
/// FixedMul: the product of two 16.16 values, in DX:AX. Listings 52.9, 53.1 and 54.1.
#pragma once

#include "x86model/assemble.hpp"
#include "x86model/notation.hpp"

namespace x86model::routines {

namespace detail {
/// Offsets of FixedMul's arguments from BP, above the pushed BP and the return address.
inline constexpr int M1 = 4;
inline constexpr int M2 = 8;
}  // namespace detail

/// One signed multiply; adds half an ulp and shifts the product down.
inline constexpr Listing fixed_mul_i386 = [] {
  using namespace notation;
  using namespace detail;
  return Listing{
      proc("FixedMul"),
      push(bp),
      mov(bp, sp),
      mov(eax, dword[bp + M1]),
      imul(dword[bp + M2]),
      if_(mul_rounding_on),
      add(eax, half_unit),
      adc(edx, 0),
      endif(),
      shr(eax, word_bits),
      pop(bp),
      ret(),
  };
}();

/// Multiplies magnitudes: sums four partial products in CX:BX and restores the sign.
inline constexpr Listing fixed_mul_i8088 = [] {
  using namespace notation;
  using namespace detail;
  return Listing{
      proc("FixedMul"),
      push(bp),
      mov(bp, sp),
      push(si),
      push(di),
      // signs: CX is 1 if exactly one operand is negative
      sub(cx, cx),
      mov(ax, word[bp + M1 + 2]),
      mov(si, word[bp + M1]),
      and_(ax, ax),
      jns("CheckSecondOperand"),
      neg(ax),
      neg(si),
      sbb(ax, 0),
      inc(cx),
      label("CheckSecondOperand"),
      mov(bx, word[bp + M2 + 2]),
      mov(di, word[bp + M2]),
      and_(bx, bx),
      jns("SaveSignStatus"),
      neg(bx),
      neg(di),
      sbb(bx, 0),
      xor_(cx, 1),
      label("SaveSignStatus"),
      push(cx),
      push(ax),
      // high times high: only its low word affects the result
      mul(bx),
      mov(cx, ax),
      // low times high
      mov(ax, si),
      mul(bx),
      mov(bx, ax),
      add(cx, dx),
      // high times low
      pop(ax),
      mul(di),
      add(bx, ax),
      adc(cx, dx),
      // low times low
      mov(ax, si),
      mul(di),
      if_(mul_rounding_on),
      add(ax, half_unit),
      adc(bx, dx),
      else_(),
      add(bx, dx),
      endif(),
      adc(cx, 0),
      mov(dx, cx),
      mov(ax, bx),
      pop(cx),
      and_(cx, cx),
      jz("FixedMulDone"),
      neg(dx),
      neg(ax),
      sbb(dx, 0),
      label("FixedMulDone"),
      pop(di),
      pop(si),
      pop(bp),
      ret(),
  };
}();

}  // namespace x86model::routines
