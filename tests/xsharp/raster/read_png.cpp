#include "tests/xsharp/raster/read_png.hpp"

#include <png.h>
#include <zlib.h>

#include <cstdlib>
#include <stdexcept>

namespace read_png {

namespace {

using Bytes = std::vector<unsigned char>;

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

std::uint32_t number(const Bytes& bytes, std::size_t at, std::size_t count = 4) {
  std::uint32_t result = 0;
  for (std::size_t i = 0; i < count; ++i) result = result << 8U | bytes.at(at + i);
  return result;
}

struct Header {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  bool indexed = false;

  [[nodiscard]] std::size_t pixel_bytes() const { return indexed ? 1 : 3; }
};

Bytes inflated(const Bytes& compressed, std::size_t size) {
  Bytes result(size + 1);
  uLongf length = result.size();
  require(uncompress(result.data(), &length, compressed.data(), compressed.size()) == Z_OK,
          "pixels that do not inflate");
  require(length == size, "pixels of another size");
  result.resize(size);
  return result;
}

int paeth(int a, int b, int c) {
  const int estimate = a + b - c;
  const int off_a = std::abs(estimate - a);
  const int off_b = std::abs(estimate - b);
  const int off_c = std::abs(estimate - c);
  if (off_a <= off_b && off_a <= off_c) return a;
  return off_b <= off_c ? b : c;
}

/// Undoes the row filters; a filter byte precedes each row.
Bytes unfiltered(const Bytes& rows, const Header& header) {
  const std::size_t step = header.pixel_bytes();
  const std::size_t length = header.width * step;
  Bytes result(header.height * length);
  for (std::size_t y = 0; y < header.height; ++y) {
    const int filter = rows.at(y * (length + 1));
    for (std::size_t x = 0; x < length; ++x) {
      const std::size_t at = y * length + x;
      const int a = x < step ? 0 : result.at(at - step);
      const int b = y == 0 ? 0 : result.at(at - length);
      const int c = x < step || y == 0 ? 0 : result.at(at - length - step);
      int predicted = 0;
      switch (filter) {
        case 0:
          break;
        case 1:
          predicted = a;
          break;
        case 2:
          predicted = b;
          break;
        case 3:
          predicted = (a + b) / 2;
          break;
        case 4:
          predicted = paeth(a, b, c);
          break;
        default:
          throw std::runtime_error("a filter that does not exist");
      }
      result.at(at) = static_cast<unsigned char>(rows.at(y * (length + 1) + 1 + x) + predicted);
    }
  }
  return result;
}

xsharp::Page<std::uint32_t> page_of(const Bytes& compressed, const Header& header,
                                    const Bytes& palette) {
  const std::size_t size = header.height * (1 + header.width * header.pixel_bytes());
  const Bytes bytes = unfiltered(inflated(compressed, size), header);
  xsharp::Page<std::uint32_t> page(static_cast<std::int32_t>(header.width),
                                   static_cast<std::int32_t>(header.height));
  for (std::size_t i = 0; i < page.pixels().size(); ++i) {
    page.pixels()[i] =
        header.indexed ? number(palette, bytes.at(i) * 3U, 3) : number(bytes, i * 3, 3);
  }
  return page;
}

class Reader {
 public:
  void chunk(const std::string& type, const Bytes& data) {
    require(!ended_, "a chunk after IEND");
    require(type == "IHDR" || header_.width != 0, "a chunk before IHDR");
    if (type == "IHDR") {
      header_ = {number(data, 0), number(data, 4), data.at(9) == 3};
      require(data.at(8) == 8 && (data.at(9) == 2 || data.at(9) == 3), "another kind of pixels");
    } else if (type == "PLTE") {
      palette_ = data;
    } else if (type == "acTL") {
      require(pixels_.empty() && data.size() == 8, "acTL");
      animation_.announced = number(data, 0);
      animation_.plays = number(data, 4);
    } else if (type == "fcTL") {
      frame_ends();
      control(data);
    } else if (type == "IDAT") {
      require(animation_.times.size() == 1, "IDAT without fcTL, or after the first frame");
      pixels_.insert(pixels_.end(), data.begin(), data.end());
    } else if (type == "fdAT") {
      require(animation_.times.size() > 1, "fdAT in the first frame");
      require(number(data, 0) == sequence_++, "fdAT out of sequence");
      pixels_.insert(pixels_.end(), data.begin() + 4, data.end());
    } else if (type == "IEND") {
      frame_ends();
      ended_ = true;
    }
  }

  Animation ended() {
    require(ended_, "no IEND");
    return animation_;
  }

 private:
  void control(const Bytes& data) {
    require(data.size() == 26, "fcTL of another length");
    require(number(data, 0) == sequence_++, "fcTL out of sequence");
    require(number(data, 4) == header_.width && number(data, 8) == header_.height,
            "a frame of another size");
    require(number(data, 12) == 0 && number(data, 16) == 0, "a frame at another place");
    require(data.at(24) == 0 && data.at(25) == 0, "a frame that does not replace the last");
    animation_.times.push_back(std::to_string(number(data, 20, 2)) + "/" +
                               std::to_string(number(data, 22, 2)));
  }

  void frame_ends() {
    require(pixels_.empty() == animation_.times.empty(), "fcTL without pixels");
    if (!pixels_.empty()) animation_.frames.push_back(page_of(pixels_, header_, palette_));
    pixels_.clear();
  }

  Header header_{};
  Bytes palette_{};
  Bytes pixels_{};
  std::uint32_t sequence_ = 0;
  bool ended_ = false;
  Animation animation_{};
};

}  // namespace

xsharp::Page<std::uint32_t> by_libpng(std::string_view png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, png.data(), png.size()) == 0) {
    throw std::runtime_error(image.message);
  }
  image.format = PNG_FORMAT_RGB;
  std::vector<png_byte> bytes(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) == 0) {
    throw std::runtime_error(image.message);
  }
  xsharp::Page<std::uint32_t> page(static_cast<std::int32_t>(image.width),
                                   static_cast<std::int32_t>(image.height));
  for (std::size_t i = 0; i < page.pixels().size(); ++i) {
    page.pixels()[i] = number(bytes, i * 3, 3);
  }
  return page;
}

Animation by_chunks(std::string_view apng) {
  const Bytes bytes(apng.begin(), apng.end());
  require(apng.starts_with("\x89PNG\r\n\x1a\n"), "no signature");
  Reader reader;
  for (std::size_t at = 8; at < bytes.size();) {
    const std::size_t length = number(bytes, at);
    const std::string type(apng.substr(at + 4, 4));
    require(length <= bytes.size() && at + 12 + length <= bytes.size(), type + " ends early");
    const auto checksum = crc32(0, &bytes.at(at + 4), static_cast<uInt>(length + 4));
    require(checksum == number(bytes, at + 8 + length), type + " with a wrong checksum");
    const auto data = bytes.begin() + static_cast<std::ptrdiff_t>(at + 8);
    reader.chunk(type, Bytes(data, data + static_cast<std::ptrdiff_t>(length)));
    at += 12 + length;
  }
  return reader.ended();
}

}  // namespace read_png
