/// @file
/// ConcatXforms: the product of two 3x4 transforms. Listings 53.1 and 54.1; 52.4 is C.
#pragma once

#include "x86model/routines/fixed_mul.hpp"
#include "x86model/routines/sum_of_products.hpp"

namespace x86model::routines {

namespace detail {
/// Offsets of ConcatXforms' arguments from BP; near pointers.
inline constexpr int SourceXform1 = 4;
inline constexpr int SourceXform2 = 6;
inline constexpr int DestXform = 8;
}  // namespace detail

/// Listing 52.4 is C and adds the first transform's translation in every column; the printed
/// assembly adds it only in the fourth. The rows for chapter 52 are ours: they give the result of
/// the C code, and no clocks are counted for them.
inline constexpr Listing concat_xforms_i386 = [] {
  using namespace notation;
  using namespace detail;
  Listing listing{
      proc("ConcatXforms"),
      push(bp),
      mov(bp, sp),
      push(si),
      push(di),
      mov(bx, word[bp + SourceXform2]),
      mov(si, word[bp + SourceXform1]),
      mov(di, word[bp + DestXform]),
  };
  for (int row = 0; row < 3; ++row) {
    const int roff = 16 * row;
    for (int column = 0; column < 4; ++column) {
      const int coff = 4 * column;
      const Instruction add_translation = add(ecx, dword[si + roff + 12]);
      listing += sum_of_products_i386(roff, coff, 16);
      if (column < 3) {
        listing += {if_(chapter_52), add_translation, endif()};
      } else {
        listing += {add_translation};
      }
      listing += {mov(dword[di + coff + roff], ecx)};
    }
  }
  listing += {pop(di), pop(si), pop(bp), ret()};
  return listing;
}();

/// Calls FixedMul, which follows it. The listing adds the high word of the translation with ADD,
/// which loses the carry of the low words: the high word of the result is one too low. With
/// `repaired` it uses ADC, as XformVec does.
inline constexpr Listing concat_xforms_i8088 = [] {
  using namespace notation;
  using namespace detail;
  Listing listing{
      proc("ConcatXforms"),
      push(bp),
      mov(bp, sp),
      push(si),
      push(di),
      mov(di, word[bp + SourceXform2]),
      mov(si, word[bp + SourceXform1]),
      mov(bx, word[bp + DestXform]),
      push(bp),
  };
  for (int row = 0; row < 3; ++row) {
    const int roff = 16 * row;
    for (int column = 0; column < 4; ++column) {
      const int coff = 4 * column;
      listing += {push(bx)};
      listing += sum_of_products_i8088(roff, coff, 16);
      if (column == 3) {
        const Operand high = word[si + roff + 12 + 2];
        listing += {
            add(cx, word[si + roff + 12]),
            if_(repaired),
            adc(bp, high),
            else_(),
            add(bp, high),
            endif(),
        };
      }
      listing += {
          pop(bx),
          mov(word[bx + coff + roff], cx),
          mov(word[bx + coff + roff + 2], bp),
      };
    }
  }
  listing += {pop(bp), pop(di), pop(si), pop(bp), ret()};
  listing += fixed_mul_i8088;
  return listing;
}();

}  // namespace x86model::routines
