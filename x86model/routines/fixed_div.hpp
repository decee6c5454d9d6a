/// @file
/// FixedDiv: the quotient of two 16.16 values, in DX:AX. Listings 52.9, 53.1 and 54.1.
#pragma once

#include "x86model/assemble.hpp"
#include "x86model/notation.hpp"

namespace x86model::routines {

namespace detail {
/// Offsets of FixedDiv's arguments from BP, above the pushed BP and the return address.
inline constexpr int Dividend = 4;
inline constexpr int Divisor = 8;
}  // namespace detail

/// Rounded: an unsigned 64/32 divide of the magnitudes; compares the remainder with half the
/// divisor and restores the sign. Unrounded: one IDIV.
inline constexpr Listing fixed_div_i386 = [] {
  using namespace notation;
  using namespace detail;
  return Listing{
      proc("FixedDiv"),
      push(bp),
      mov(bp, sp),
      if_(div_rounding_on),
      sub(cx, cx),
      mov(eax, dword[bp + Dividend]),
      and_(eax, eax),
      jns("FDP1"),
      inc(cx),
      neg(eax),
      label("FDP1"),
      // EDX:EAX = dividend shifted left by a word
      sub(edx, edx),
      rol(eax, word_bits),
      mov(dx, ax),
      sub(ax, ax),
      mov(ebx, dword[bp + Divisor]),
      and_(ebx, ebx),
      jns("FDP2"),
      dec(cx),
      neg(ebx),
      label("FDP2"),
      div(ebx),
      // (divisor + 1)/2 - 1 is below the remainder if and only if the remainder is half or more
      shr(ebx, 1),
      adc(ebx, 0),
      dec(ebx),
      cmp(ebx, edx),
      adc(eax, 0),
      and_(cx, cx),
      jz("FDP3"),
      neg(eax),
      label("FDP3"),
      else_(),
      mov(edx, dword[bp + Dividend]),
      sub(eax, eax),
      shrd(eax, edx, word_bits),
      sar(edx, word_bits),
      idiv(dword[bp + Divisor]),
      endif(),
      if_(chapter_52),
      mov(edx, eax),
      shr(edx, word_bits),
      else_(),
      shld(edx, eax, word_bits),
      endif(),
      pop(bp),
      ret(),
  };
}();

/// Two 32/16 divides by the whole part of the divisor. The first gives the whole part of the
/// quotient; its remainder joined to the dividend's fraction gives the fraction. Negates the low
/// words of the caller's arguments on the stack.
inline constexpr Listing fixed_div_i8088 = [] {
  using namespace notation;
  using namespace detail;
  return Listing{
      proc("FixedDiv"),
      push(bp),
      mov(bp, sp),
      // signs: CX is 1 if exactly one operand is negative
      sub(cx, cx),
      mov(ax, word[bp + Dividend + 2]),
      and_(ax, ax),
      jns("CheckSecondOperandD"),
      neg(ax),
      neg(word[bp + Dividend]),
      sbb(ax, 0),
      inc(cx),
      label("CheckSecondOperandD"),
      mov(bx, word[bp + Divisor + 2]),
      and_(bx, bx),
      jns("SaveSignStatusD"),
      neg(bx),
      neg(word[bp + Divisor]),
      sbb(bx, 0),
      xor_(cx, 1),
      label("SaveSignStatusD"),
      push(cx),
      sub(dx, dx),
      div(bx),
      mov(cx, ax),
      mov(ax, word[bp + Dividend]),
      div(bx),
      if_(div_rounding_on),
      shr(bx, 1),
      adc(bx, 0),
      dec(bx),
      cmp(bx, dx),
      adc(ax, 0),
      adc(cx, 0),
      else_(),
      if_(endif_as_scanned),
      adc(cx, 0),
      endif(),
      endif(),
      mov(dx, cx),
      pop(cx),
      and_(cx, cx),
      jz("FixedDivDone"),
      neg(dx),
      neg(ax),
      sbb(dx, 0),
      label("FixedDivDone"),
      pop(bp),
      ret(),
  };
}();

}  // namespace x86model::routines
