/// @file
/// A rectangle of pixels in memory, which polygons are filled into.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace xsharp {

/// A palette index, or a colour as 0x00RRGGBB.
template <class T>
concept PixelType = std::same_as<T, std::uint8_t> || std::same_as<T, std::uint32_t>;

/// The maximum width and height of a page.
inline constexpr std::int32_t max_page_side = 16384;

/// Pixels in row-major order from the top left, without gaps.
template <PixelType Pixel>
class Page {
 public:
  /// A page with all pixels 0.
  /// @throws std::invalid_argument unless both sides are from 1 to max_page_side
  Page(std::int32_t width, std::int32_t height)
      : width_(checked(width, width, height)),
        height_(checked(height, width, height)),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  [[nodiscard]] std::int32_t width() const { return width_; }
  [[nodiscard]] std::int32_t height() const { return height_; }

  void clear(Pixel pixel) { std::fill(pixels_.begin(), pixels_.end(), pixel); }

  /// @throws std::out_of_range unless y is from 0 to height() - 1
  [[nodiscard]] std::span<Pixel> row(std::int32_t y) {
    return std::span(pixels_).subspan(start_of(y), row_length());
  }
  [[nodiscard]] std::span<const Pixel> row(std::int32_t y) const {
    return std::span(pixels_).subspan(start_of(y), row_length());
  }

  /// All pixels in row-major order.
  [[nodiscard]] std::span<Pixel> pixels() { return pixels_; }
  [[nodiscard]] std::span<const Pixel> pixels() const { return pixels_; }

  friend bool operator==(const Page&, const Page&) = default;

 private:
  static std::int32_t checked(std::int32_t side, std::int32_t width, std::int32_t height) {
    if (side >= 1 && side <= max_page_side) return side;
    throw std::invalid_argument("a page of " + std::to_string(width) + " x " +
                                std::to_string(height) + " pixels: a side is from 1 to " +
                                std::to_string(max_page_side));
  }

  [[nodiscard]] std::size_t row_length() const { return static_cast<std::size_t>(width_); }

  [[nodiscard]] std::size_t start_of(std::int32_t y) const {
    if (y < 0 || y >= height_) {
      throw std::out_of_range("row " + std::to_string(y) + " of a page of " +
                              std::to_string(height_) + " rows");
    }
    return static_cast<std::size_t>(y) * row_length();
  }

  std::int32_t width_;
  std::int32_t height_;
  std::vector<Pixel> pixels_;
};

}  // namespace xsharp
