/// @file
/// A parabola stepped along a row by two additions per pixel; no published listing does this.
#pragma once

#include <cstdint>
#include <span>

#include "xsharp/arithmetic.hpp"
#include "xsharp/ratio.hpp"

namespace xsharp {

/// A parabola in 8.24 words: the first value, its first difference and its second difference.
struct Parabola {
  std::uint32_t start = 0;
  std::uint32_t step = 0;
  std::uint32_t second = 0;
};

/// Draws the whole part, bits 31 to 24; two additions per pixel.
inline void quadratic(std::span<std::uint8_t> out, Parabola p) {
  for (std::uint8_t& pixel : out) {
    pixel = static_cast<std::uint8_t>(p.start >> 24U);
    p.start += p.step;
    p.step += p.second;
  }
}

/// n / d with 24 bits after the point, modulo 2^32. Doubles n up to eight times, while it is below
/// 8191, before it divides by d, `times` times.
template <Scalar N>
std::uint32_t fine_ratio(N n, N d, int times) {
  const N most = from_whole<N>(8191);
  unsigned doublings = 0;
  for (; doublings < 8 && -most < n && n < most; ++doublings) n = n + n;
  for (int i = 0; i < times; ++i) n = ratio(n, d);
  return static_cast<std::uint32_t>(Arithmetic<N>::raw(n)) << (8 - doublings);
}

/// The parabola through the values at the first pixel, half way, and at the last, `last` pixels
/// further. With L for `last` it is first + b x + c x^2, where b = (4 middle - 3 first - end) / L
/// and c = 2 (first - 2 middle + end) / L^2.
///
/// The words of b and c are within 2^-20 of these, and within 2^-24 if the divide rounds and the
/// doublings fit (a second difference below 32 levels). At the last of 320 pixels the stepped value
/// is then within 0.01 levels of the parabola.
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
