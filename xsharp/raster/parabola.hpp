/// @file
/// A parabola stepped along a row by two additions a pixel, as no published listing has it.
#pragma once

#include <cstdint>
#include <span>

#include "xsharp/arithmetic.hpp"
#include "xsharp/ratio.hpp"

namespace xsharp {

/// A parabola in 8.24 words: what it is at the first pixel, what is added for the next, and what is
/// added to that.
struct Parabola {
  std::uint32_t start = 0;
  std::uint32_t step = 0;
  std::uint32_t second = 0;
};

/// Two additions a pixel; the whole part, bits 31 to 24, is drawn.
inline void quadratic(std::span<std::uint8_t> out, Parabola p) {
  for (std::uint8_t& pixel : out) {
    pixel = static_cast<std::uint8_t>(p.start >> 24U);
    p.start += p.step;
    p.step += p.second;
  }
}

/// n / d with 24 bits after the point, modulo 2^32: n is doubled up to eight times, as long as it
/// is below 8191, before it is divided by d, `times` times.
template <Scalar N>
std::uint32_t fine_ratio(N n, N d, int times) {
  const N most = from_whole<N>(8191);
  unsigned doublings = 0;
  for (; doublings < 8 && -most < n && n < most; ++doublings) n = n + n;
  for (int i = 0; i < times; ++i) n = ratio(n, d);
  return static_cast<std::uint32_t>(Arithmetic<N>::raw(n)) << (8 - doublings);
}

/// The parabola through the values at the first pixel, half way, and at the last, `last` pixels
/// further: with L for `last`, first + b x + c x^2 where b = (4 middle - 3 first - end) / L and
/// c = 2 (first - 2 middle + end) / L^2.
///
/// The words of b and c are within 2^-20 and, the divides rounded, the doublings allowing (a second
/// difference below 32 levels), 2^-24 of these; so at the last of 320 pixels the stepped value is
/// within 0.01 levels of the parabola.
template <Scalar N>
Parabola parabola_through(N first, N middle, N end, std::int32_t last) {
  const auto start = static_cast<std::uint32_t>(Arithmetic<N>::raw(first)) << 8U;
  if (last <= 0) return {start, 0, 0};
  const N to_middle = middle - first;
  const N to_end = end - first;
  const N twice = to_middle + to_middle;
  const N bend = to_end - twice;
  const std::uint32_t b = fine_ratio(twice + twice - to_end, from_whole<N>(last), 1);
  const std::uint32_t c = fine_ratio(bend + bend, from_whole<N>(last), 2);
  return {start, b + c, c + c};
}

}  // namespace xsharp
