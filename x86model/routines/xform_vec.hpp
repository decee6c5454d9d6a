/// @file
/// XformVec: a 3x4 transform times a point. Listings 53.1 and 54.1.
#pragma once

#include "x86model/routines/fixed_mul.hpp"
#include "x86model/routines/sum_of_products.hpp"

namespace x86model::routines {

namespace detail {
/// Offsets of XformVec's arguments from BP; near pointers.
inline constexpr int WorkingXform = 4;
inline constexpr int SourceVec = 6;
inline constexpr int DestVec = 8;
}  // namespace detail

inline constexpr Listing xform_vec_i386 = [] {
  using namespace notation;
  using namespace detail;
  Listing listing{
      proc("XformVec"),
      push(bp),
      mov(bp, sp),
      push(si),
      push(di),
      mov(si, word[bp + WorkingXform]),
      mov(bx, word[bp + SourceVec]),
      mov(di, word[bp + DestVec]),
  };
  for (int row = 0; row < 3; ++row) {
    const int soff = 16 * row;
    const int doff = 4 * row;
    listing += sum_of_products_i386(soff, 0, 4);
    listing += {
        add(ecx, dword[si + soff + 12]),
        mov(dword[di + doff], ecx),
    };
  }
  listing += {pop(di), pop(si), pop(bp), ret()};
  return listing;
}();

/// Calls FixedMul, which follows it.
inline constexpr Listing xform_vec_i8088 = [] {
  using namespace notation;
  using namespace detail;
  Listing listing{
      proc("XformVec"),
      push(bp),
      mov(bp, sp),
      push(si),
      push(di),
      mov(si, word[bp + WorkingXform]),
      mov(di, word[bp + SourceVec]),
      mov(bx, word[bp + DestVec]),
      push(bp),
  };
  for (int row = 0; row < 3; ++row) {
    const int soff = 16 * row;
    const int doff = 4 * row;
    listing += {push(bx)};
    listing += sum_of_products_i8088(soff, 0, 4);
    listing += {
        add(cx, word[si + soff + 12]), adc(bp, word[si + soff + 12 + 2]), pop(bx),
        mov(word[bx + doff], cx),      mov(word[bx + doff + 2], bp),
    };
  }
  listing += {pop(bp), pop(di), pop(si), pop(bp), ret()};
  listing += fixed_mul_i8088;
  return listing;
}();

}  // namespace x86model::routines
