/// @file
/// The sum of three products, used by XformVec and ConcatXforms.
#pragma once

#include "x86model/assemble.hpp"
#include "x86model/notation.hpp"

namespace x86model::routines::detail {

/// ECX = the sum of three rounded products of dwords from [SI + first ...] and [BX + second ...].
/// @param first   offset of the first factor; the others follow 4 bytes apart (a row)
/// @param second  offset of the second factor
/// @param stride  bytes between the second factors: 4 along a vector, 16 down a column
constexpr Listing sum_of_products_i386(int first, int second, int stride) {
  using namespace notation;
  Listing listing;
  for (int i = 0; i < 3; ++i) {
    listing += {
        mov(eax, dword[si + first + 4 * i]),
        imul(dword[bx + second + stride * i]),
        if_(mul_rounding_on),
        add(eax, half_unit),
        adc(edx, 0),
        endif(),
        shrd(eax, edx, word_bits),
        i == 0 ? mov(ecx, eax) : add(ecx, eax),
    };
  }
  return listing;
}

/// BP:CX = the sum of three FixedMul products of dwords from [SI + first ...] and [DI + second
/// ...]; offsets as above. FixedMul destroys CX and preserves BP, so the low word of the running
/// sum is kept on the stack.
constexpr Listing sum_of_products_i8088(int first, int second, int stride) {
  using namespace notation;
  Listing listing;
  for (int i = 0; i < 3; ++i) {
    if (i > 0) listing += {push(cx)};
    listing += {
        push(word[si + first + 4 * i + 2]),
        push(word[si + first + 4 * i]),
        push(word[di + second + stride * i + 2]),
        push(word[di + second + stride * i]),
        call("FixedMul"),
        add(sp, bytes(8)),
    };
    if (i == 0) {
      listing += {mov(cx, ax), mov(bp, dx)};
    } else {
      listing += {pop(cx), add(cx, ax), adc(bp, dx)};
    }
  }
  return listing;
}

}  // namespace x86model::routines::detail
