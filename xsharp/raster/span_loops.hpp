/// @file
/// The inner loops: a value stepped along a row by one addition per pixel.
///
/// Words are those that the published loops hold in 32-bit registers, and wrap like them. step.hpp
/// converts values to words.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <span>

namespace xsharp {

/// The maximum number of pixels per call: an unrolled loop has this many copies of its body. Longer
/// rows are drawn in pieces, each with its own start.
inline constexpr std::size_t longest_span = 320;

/// The number of texels in a bitmap: 256 rows of 256.
inline constexpr std::size_t bitmap_texels = 65536;

/// The loops of one party. A call draws 0 to longest_span pixels.
class SpanLoops : private boost::noncopyable {
 public:
  SpanLoops() = default;
  virtual ~SpanLoops() = default;

  /// Intensity in 8.8: draws bits 15 to 8, then adds the step, modulo 2^16.
  virtual void gouraud(std::span<std::uint8_t> out, std::uint16_t start,
                       std::uint16_t step) const = 0;

  /// Intensity in 16.16: draws bits 23 to 16, then adds the step, modulo 2^32.
  virtual void gouraud_wide(std::span<std::uint8_t> out, std::uint32_t start,
                            std::uint32_t step) const = 0;

  /// Depth in 16.8, greater is nearer: compares bits 23 to 8, as a signed number, with the buffer;
  /// if greater, writes `pixel` and the depth. Then adds the step, modulo 2^32.
  /// @pre buffer has the size of out
  virtual void depth(std::span<std::uint8_t> out, std::span<std::int16_t> buffer,
                     std::uint8_t pixel, std::uint32_t start, std::uint32_t step) const = 0;

  /// Two coordinates in 8.8: draws the texel in row v (bits 15 to 8) and column u (bits 15 to 8),
  /// then adds the steps, modulo 2^32.
  /// @pre bitmap has bitmap_texels texels in row-major order
  virtual void texture(std::span<std::uint8_t> out, std::span<const std::uint8_t> bitmap,
                       std::uint32_t u, std::uint32_t du, std::uint32_t v,
                       std::uint32_t dv) const = 0;
};

/// The loops in C++, on unsigned words.
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
