/// @file
/// CosSin: cosine and sine of an angle in tenths of a degree, from a table. Listings 53.1 and 54.1.
/// The table is in the code segment, so each access has a CS: override.
#pragma once

#include "x86model/assemble.hpp"
#include "x86model/notation.hpp"

namespace x86model::routines {

namespace detail {
/// Offsets of CosSin's arguments from BP, above the pushed BP and the return address.
inline constexpr int Angle = 4;
inline constexpr int Cos = 6;
inline constexpr int Sin = 8;

/// The distance in bytes from the cosine of 0 to that of 90 degrees: sin(x) = cos(90 - x).
inline constexpr int quarter_turn = 90 * 10 * 4;

/// The common start of both versions: reduces the angle in BX to 0 ... 3600.
constexpr Listing angle_in_range() {
  using namespace notation;
  return Listing{
      proc("CosSin"),        push(bp),
      mov(bp, sp),           mov(bx, word[bp + Angle]),
      and_(bx, bx),          jns("CheckInRange"),
      label("MakePos"),      add(bx, 360 * 10),
      js("MakePos"),         jmp("CheckInRange"),
      label("MakeInRange"),  sub(bx, 360 * 10),
      label("CheckInRange"), cmp(bx, 360 * 10),
      jg("MakeInRange"),     cmp(bx, 180 * 10),
      ja("BottomHalf"),      cmp(bx, 90 * 10),
      ja("Quadrant1"),
  };
}
}  // namespace detail

/// Keeps the cosine in EAX and the sine in EDX.
inline constexpr Listing cos_sin_i386 = [] {
  using namespace notation;
  using namespace detail;
  Listing listing = angle_in_range();
  listing += {
      shl(bx, 2),
      mov(eax, dword[cs(CosTable + bx)]),
      neg(bx),
      mov(edx, dword[cs(CosTable + bx + quarter_turn)]),
      jmp("CSDone"),

      label("Quadrant1"),
      neg(bx),
      add(bx, 180 * 10),
      shl(bx, 2),
      mov(eax, dword[cs(CosTable + bx)]),
      neg(eax),
      neg(bx),
      mov(edx, dword[cs(CosTable + bx + quarter_turn)]),
      jmp("CSDone"),

      label("BottomHalf"),
      neg(bx),
      add(bx, 360 * 10),
      cmp(bx, 90 * 10),
      ja("Quadrant2"),
      shl(bx, 2),
      mov(eax, dword[cs(CosTable + bx)]),
      neg(bx),
      mov(edx, dword[cs(CosTable + bx + quarter_turn)]),
      neg(edx),
      jmp("CSDone"),

      label("Quadrant2"),
      neg(bx),
      add(bx, 180 * 10),
      shl(bx, 2),
      mov(eax, dword[cs(CosTable + bx)]),
      neg(eax),
      neg(bx),
      mov(edx, dword[cs(CosTable + bx + quarter_turn)]),
      neg(edx),

      label("CSDone"),
      mov(bx, word[bp + Cos]),
      mov(dword[bx], eax),
      mov(bx, word[bp + Sin]),
      mov(dword[bx], edx),
      pop(bp),
      ret(),
  };
  return listing;
}();

/// Keeps the cosine in DX:AX and the sine in CX:BX. The listing uses SHL BX,2, which the 8088
/// cannot execute; without `shl_as_printed` there are two shifts by one.
inline constexpr Listing cos_sin_i8088 = [] {
  using namespace notation;
  using namespace detail;
  Listing listing = angle_in_range();
  listing += {
      if_(shl_as_printed),
      shl(bx, 2),
      else_(),
      shl(bx, 1),
      shl(bx, 1),
      endif(),
      mov(ax, word[cs(CosTable + bx)]),
      mov(dx, word[cs(CosTable + bx + 2)]),
      neg(bx),
      mov(cx, word[cs(CosTable + bx + quarter_turn + 2)]),
      mov(bx, word[cs(CosTable + bx + quarter_turn)]),
      jmp_near("CSDone"),

      label("Quadrant1"),
      neg(bx),
      add(bx, 180 * 10),
      if_(shl_as_printed),
      shl(bx, 2),
      else_(),
      shl(bx, 1),
      shl(bx, 1),
      endif(),
      mov(ax, word[cs(CosTable + bx)]),
      mov(dx, word[cs(CosTable + bx + 2)]),
      neg(dx),
      neg(ax),
      sbb(dx, 0),
      neg(bx),
      mov(cx, word[cs(CosTable + bx + quarter_turn + 2)]),
      mov(bx, word[cs(CosTable + bx + quarter_turn)]),
      jmp("CSDone"),

      label("BottomHalf"),
      neg(bx),
      add(bx, 360 * 10),
      cmp(bx, 90 * 10),
      ja("Quadrant2"),
      if_(shl_as_printed),
      shl(bx, 2),
      else_(),
      shl(bx, 1),
      shl(bx, 1),
      endif(),
      mov(ax, word[cs(CosTable + bx)]),
      mov(dx, word[cs(CosTable + bx + 2)]),
      neg(bx),
      mov(cx, word[cs(CosTable + bx + quarter_turn + 2)]),
      mov(bx, word[cs(CosTable + bx + quarter_turn)]),
      neg(cx),
      neg(bx),
      sbb(cx, 0),
      jmp("CSDone"),

      label("Quadrant2"),
      neg(bx),
      add(bx, 180 * 10),
      if_(shl_as_printed),
      shl(bx, 2),
      else_(),
      shl(bx, 1),
      shl(bx, 1),
      endif(),
      mov(ax, word[cs(CosTable + bx)]),
      mov(dx, word[cs(CosTable + bx + 2)]),
      neg(dx),
      neg(ax),
      sbb(dx, 0),
      neg(bx),
      mov(cx, word[cs(CosTable + bx + quarter_turn + 2)]),
      mov(bx, word[cs(CosTable + bx + quarter_turn)]),
      neg(cx),
      neg(bx),
      sbb(cx, 0),

      label("CSDone"),
      push(bx),
      mov(bx, word[bp + Cos]),
      mov(word[bx], ax),
      mov(word[bx + 2], dx),
      mov(bx, word[bp + Sin]),
      pop(ax),
      mov(word[bx], ax),
      mov(word[bx + 2], cx),
      pop(bp),
      ret(),
  };
  return listing;
}();

}  // namespace x86model::routines
