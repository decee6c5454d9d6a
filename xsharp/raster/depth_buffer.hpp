/// @file
/// The depth buffer: 16 bits per pixel of a page.
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

/// The depths of a page, and the conversion of a depth to the 16.8 word that the loops compare.
///
/// A buffer that is cleared before every picture is filled with minus infinity, the word 8000h, and
/// depths are 0 to 32767, in 16.8. On the reversed axis it is filled with plus infinity, 7FFFh, and
/// depths are 0 to -32767.
///
/// Without clearing, depths are 0 to 8191, and each of seven pictures starts 9216 above the
/// previous one, so that all old depths are farther than all new ones. This is correct for any
/// picture, even if it leaves pixels unset, as long as no stepped depth is more than 512 outside
/// its 8192. Those of vertices are inside, and 320 steps err by less than 3
/// (docs/interpolation.md). The price is two bits of depth, and a clear after seven pictures, when
/// the range is used up. Alternating between two halves of the range, with the test reversed each
/// time, would need no clearing, but is correct only if every picture sets every pixel.
class DepthBuffer {
 public:
  explicit DepthBuffer(DepthBuffering mode) : mode_(mode) {}

  /// Called before the first polygon of a picture.
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

  /// The words for a loop that steps depths from 0 to nearest_depth.
  template <Scalar N>
  [[nodiscard]] StepWords words(const Step<N>& depth) const {
    StepWords words =
        words_of(depth, mode_ == DepthBuffering::no_clear ? dropped_bits + 2 : dropped_bits);
    if (reversed()) words = {0U - words.start, 0U - words.step};
    if (mode_ == DepthBuffering::no_clear)
      words.start += (picture_ * picture_spacing + lowest) << 8U;
    return words;
  }

 private:
  static constexpr std::uint32_t pictures = 7;
  /// The distance between the zero depths of two pictures, out of 2^16.
  static constexpr std::uint32_t picture_spacing = 8192 + 2 * 512;
  /// The zero depth of the first picture: 512 above -32768, the value of a cleared buffer.
  static constexpr std::uint32_t lowest = 512U - 32768U;

  DepthBuffering mode_;
  std::int32_t width_ = 0;
  std::uint32_t picture_ = 0;
  std::vector<std::int16_t> depths_{};
};

}  // namespace xsharp
