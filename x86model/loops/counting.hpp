/// @file
/// How the inner loops count pixels, and the rows that do it.
#pragma once

#include <cstdint>

#include "x86model/assemble.hpp"
#include "x86model/notation.hpp"

namespace x86model {

/// The three ways of counting in the source.
enum class Counting : std::uint8_t {
  loop,      ///< LOOP
  dec_jnz,   ///< DEC of the count and JNZ
  unrolled,  ///< one copy per pixel, entered that many copies before the end
};

namespace loops {

/// The maximum number of pixels in a span: an unrolled loop has one copy per pixel or per two
/// pixels.
inline constexpr std::uint32_t max_pixels = 320;

/// The registers of a loop; the 8088 uses the lower halves of the 386's.
struct Registers {
  Operand count, value, step, row;
};
constexpr Registers registers_of(Target target) {
  using namespace notation;
  if (target == Target::i8088) return {cx, dx, bp, si};
  return {ecx, edx, ebp, esi};
}

/// Jumps back to the label while pixels are left. LOOP counts in CX, as in 16-bit code, on both
/// processors.
constexpr Listing next_pixel(Counting counting, Target target, const char* label) {
  using namespace notation;
  if (counting == Counting::loop) return {loop(label)};
  return {dec(registers_of(target).count), jnz(label)};
}

/// Wraps the code for one or two pixels in a procedure: counted, or unrolled with the jump target
/// in BX. code_of() repeats everything between the first and the last row of an unrolled loop.
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
