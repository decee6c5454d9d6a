/// @file
/// The depth buffer: 16 bits for every pixel of a page.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "xsharp/raster/step.hpp"
#include "xsharp/surface.hpp"

namespace xsharp {

/// Depths of a page, and how a depth becomes the 16.8 word that the loops compare.
///
/// A buffer that is cleared before every picture holds minus infinity, the word 8000h, and a depth
/// is 0 to 32767, in 16.8. On the reversed axis it holds plus infinity, 7FFFh, and a depth is 0 to
/// -32767.
///
/// Without clearing it is 0 to 8191, and each of seven pictures begins 9216 above the one before:
/// whatever a picture left is farther than all of the next. That is right for any picture, also
/// where it leaves pixels alone, as long as no stepped depth is more than 512 out of its 8192;
/// those of vertices are in it, and 320 steps err by less than 3 (docs/interpolation.md). The price
/// is two bits of depth, and a clearing after seven pictures: then the range is used up.
/// Alternating between two halves of the range, with the test turned round each time, needs no
/// clearing at all, but is right only where every picture sets every pixel.
class DepthBuffer {
 public:
  explicit DepthBuffer(DepthBuffering mode) : mode_(mode) {}

  /// Before the first polygon of a picture.
  void begin(std::int32_t width, std::int32_t height) {
    if (mode_ == DepthBuffering::off) return;
    const auto depths = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const bool another_page = width_ != width || depths_.size() != depths;
    width_ = width;
    picture_ = another_page ? 0 : (picture_ + 1) % pictures;
    if (mode_ == DepthBuffering::no_clear && picture_ != 0) return;
    depths_.assign(depths, mode_ == DepthBuffering::reversed
                               ? std::numeric_limits<std::int16_t>::max()
                               : std::numeric_limits<std::int16_t>::min());
  }

  [[nodiscard]] bool reversed() const { return mode_ == DepthBuffering::reversed; }

  /// @pre the pixels are on the page
  [[nodiscard]] std::span<std::int16_t> pixels(std::int32_t y, std::int32_t left,
                                               std::size_t count) {
    const auto start = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(left);
    return std::span(depths_).subspan(start, count);
  }

  /// What a loop steps for depths from 0 to nearest_depth.
  template <Scalar N>
  [[nodiscard]] StepWords words(const Step<N>& depth) const {
    StepWords words =
        words_of(depth, mode_ == DepthBuffering::no_clear ? dropped_bits + 2 : dropped_bits);
    if (reversed()) words = {0U - words.start, 0U - words.step};
    if (mode_ == DepthBuffering::no_clear) words.start += (picture_ * apart + lowest) << 8U;
    return words;
  }

 private:
  static constexpr std::uint32_t pictures = 7;
  /// From one picture's depth 0 to that of the next, of 2^16 in all.
  static constexpr std::uint32_t apart = 8192 + 2 * 512;
  /// The first picture's depth 0: -32768, as a cleared buffer has, and 512 more.
  static constexpr std::uint32_t lowest = 512U - 32768U;

  DepthBuffering mode_;
  std::int32_t width_ = 0;
  std::uint32_t picture_ = 0;
  std::vector<std::int16_t> depths_{};
};

}  // namespace xsharp
