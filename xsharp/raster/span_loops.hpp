/// @file
/// The inner loops: a value stepped along a row of pixels by one addition a pixel.
///
/// Words are those that the published loops hold in 32-bit registers, and wrap as these do. What a
/// value is before it becomes a word is in step.hpp.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <span>

namespace xsharp {

/// Pixels that one call draws at most: an unrolled loop has so many copies of its body. Longer rows
/// are drawn in pieces, each with a start of its own.
inline constexpr std::size_t longest_span = 320;

/// Texels of a bitmap: 256 rows of 256.
inline constexpr std::size_t bitmap_texels = 65536;

/// The loops that one party has. No call draws more than longest_span pixels, and every one may
/// draw none.
class SpanLoops : private boost::noncopyable {
 public:
  SpanLoops() = default;
  virtual ~SpanLoops() = default;

  /// Intensity in 8.8: bits 15 to 8 are drawn, then the step is added, modulo 2^16.
  virtual void gouraud(std::span<std::uint8_t> out, std::uint16_t start,
                       std::uint16_t step) const = 0;

  /// Intensity in 16.16: bits 23 to 16 are drawn, then the step is added, modulo 2^32.
  virtual void gouraud_wide(std::span<std::uint8_t> out, std::uint32_t start,
                            std::uint32_t step) const = 0;

  /// Depth in 16.8, greater is nearer: bits 23 to 8, as a signed number, are compared with the
  /// buffer; where they are greater, `pixel` and they themselves are written. Then the step is
  /// added, modulo 2^32.
  /// @pre buffer has the size of out
  virtual void depth(std::span<std::uint8_t> out, std::span<std::int16_t> buffer,
                     std::uint8_t pixel, std::uint32_t start, std::uint32_t step) const = 0;

  /// Two coordinates in 8.8: the texel drawn is that of row v (bits 15 to 8) and column u (bits 15
  /// to 8); then the steps are added, modulo 2^32.
  /// @pre bitmap has bitmap_texels texels, row by row
  virtual void texture(std::span<std::uint8_t> out, std::span<const std::uint8_t> bitmap,
                       std::uint32_t u, std::uint32_t du, std::uint32_t v,
                       std::uint32_t dv) const = 0;
};

/// In C++, on unsigned words.
class PlainLoops final : public SpanLoops {
 public:
  void gouraud(std::span<std::uint8_t> out, std::uint16_t start,
               std::uint16_t step) const override {
    std::uint32_t value = start;
    for (std::uint8_t& pixel : out) {
      pixel = static_cast<std::uint8_t>(value >> 8U);
      value += step;
    }
  }

  void gouraud_wide(std::span<std::uint8_t> out, std::uint32_t start,
                    std::uint32_t step) const override {
    for (std::uint8_t& pixel : out) {
      pixel = static_cast<std::uint8_t>(start >> 16U);
      start += step;
    }
  }

  void depth(std::span<std::uint8_t> out, std::span<std::int16_t> buffer, std::uint8_t pixel,
             std::uint32_t start, std::uint32_t step) const override {
    for (std::size_t i = 0; i < out.size(); ++i) {
      const auto depth = static_cast<std::int16_t>(start >> 8U);
      if (depth > buffer[i]) {
        out[i] = pixel;
        buffer[i] = depth;
      }
      start += step;
    }
  }

  void texture(std::span<std::uint8_t> out, std::span<const std::uint8_t> bitmap, std::uint32_t u,
               std::uint32_t du, std::uint32_t v, std::uint32_t dv) const override {
    for (std::uint8_t& pixel : out) {
      pixel = bitmap[(v & 0xFF00U) | (u >> 8U & 0xFFU)];
      u += du;
      v += dv;
    }
  }
};

}  // namespace xsharp
