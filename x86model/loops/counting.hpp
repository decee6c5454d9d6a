/// @file
/// How the inner loops count their pixels, and the rows that do it.
#pragma once

#include <cstdint>

#include "x86model/assemble.hpp"
#include "x86model/notation.hpp"

namespace x86model {

/// The three ways that the source gives to come to the next pixel.
enum class Counting : std::uint8_t {
  loop,      ///< LOOP
  dec_jnz,   ///< DEC of the count, and JNZ
  unrolled,  ///< the pixel again and again, entered so many copies before the end
};

namespace loops {

/// The pixels of a span at most: an unrolled loop has a copy for each, or for two.
inline constexpr std::uint32_t most_pixels = 320;

/// The registers of a loop: on the 8088 the lower halves of those that the 386 uses.
struct Registers {
  Operand count, value, step, row;
};
constexpr Registers registers_of(Target target) {
  using namespace notation;
  if (target == Target::i8088) return {cx, dx, bp, si};
  return {ecx, edx, ebp, esi};
}

/// Back to the label while there are pixels left. LOOP counts in CX, as it does in 16-bit code, on
/// both processors.
constexpr Listing next_pixel(Counting counting, Target target, const char* label) {
  using namespace notation;
  if (counting == Counting::loop) return {loop(label)};
  return {dec(registers_of(target).count), jnz(label)};
}

/// A pixel, or two, as a whole procedure: counted; or unrolled, BX being where to jump to. What
/// stands between the first row and the last of an unrolled loop is there many times, see
/// code_of().
constexpr Listing counted(Counting counting, Target target, const Listing& pixel) {
  using namespace notation;
  Listing all;
  if (counting == Counting::unrolled) {
    all += {jmp(bx)};
    all += pixel;
  } else {
    all += {label("Pixel")};
    all += pixel;
    all += next_pixel(counting, target, "Pixel");
  }
  all += {ret()};
  return all;
}

}  // namespace loops
}  // namespace x86model
