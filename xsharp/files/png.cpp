#include "xsharp/files/png.hpp"

#include <png.h>

#include <cstddef>
#include <stdexcept>
#include <vector>

namespace xsharp {

namespace {

constexpr std::uint8_t red_of(std::uint32_t pixel) {
  return static_cast<std::uint8_t>(pixel >> 16U & 255U);
}
constexpr std::uint8_t green_of(std::uint32_t pixel) {
  return static_cast<std::uint8_t>(pixel >> 8U & 255U);
}
constexpr std::uint8_t blue_of(std::uint32_t pixel) {
  return static_cast<std::uint8_t>(pixel & 255U);
}

/// Uses libpng's simplified interface, which returns errors instead of jumping over C++ frames.
std::string encode(png_image image, const std::vector<std::uint8_t>& pixels,
                   const std::vector<std::uint8_t>& colormap) {
  image.version = PNG_IMAGE_VERSION;
  // Flat polygons compress well without filters, in a fraction of the time.
  image.flags = PNG_IMAGE_FLAG_FAST;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  const bool done = png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0,
                                              colormap.data()) != 0;
  const std::string message = image.message;
  png_image_free(&image);
  if (!done) throw std::runtime_error("cannot encode a PNG: " + message);
  bytes.resize(size);
  return bytes;
}

template <PixelType Pixel>
png_image image_of(const Page<Pixel>& page, png_uint_32 format) {
  png_image image{};
  image.width = static_cast<png_uint_32>(page.width());
  image.height = static_cast<png_uint_32>(page.height());
  image.format = format;
  return image;
}

}  // namespace

std::string encode_png(const Page<std::uint8_t>& page, const Palette& palette) {
  png_image image = image_of(page, PNG_FORMAT_RGB_COLORMAP);
  image.colormap_entries = static_cast<png_uint_32>(palette.size());
  std::vector<std::uint8_t> colormap;
  colormap.reserve(palette.size() * 3);
  for (const Color& color : palette) {
    colormap.insert(colormap.end(), {color.red, color.green, color.blue});
  }
  return encode(image, {page.pixels().begin(), page.pixels().end()}, colormap);
}

std::string encode_png(const Page<std::uint32_t>& page) {
  std::vector<std::uint8_t> components;
  components.reserve(page.pixels().size() * 3);
  for (const std::uint32_t pixel : page.pixels()) {
    components.insert(components.end(), {red_of(pixel), green_of(pixel), blue_of(pixel)});
  }
  return encode(image_of(page, PNG_FORMAT_RGB), components, {});
}

}  // namespace xsharp
