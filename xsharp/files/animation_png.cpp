#include "xsharp/files/animation_png.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "xsharp/files/png_chunks.hpp"

namespace xsharp {

namespace {

constexpr std::uint32_t max_sequence = std::numeric_limits<std::int32_t>::max();

/// acTL follows the signature and the header chunk (13 bytes, plus 12 of framing).
constexpr auto control_offset = static_cast<std::uint32_t>(png_signature.size() + 13 + 12);

/// The repeat count of the animation: infinite.
constexpr std::uint32_t endless = 0;

std::string animation_control(std::uint32_t frames) {
  return png_chunk("acTL", png_number(frames) + png_number(endless));
}

std::string two_bytes(std::uint16_t number) { return png_number(number).substr(2); }

/// The pixels of a frame and the chunks before them.
struct Frame {
  std::string header;                    ///< all chunks before the first IDAT, unchanged
  std::vector<std::string_view> pixels;  ///< the data of each IDAT
};

Frame parse(std::string_view png) {
  Frame frame;
  for (const PngChunk& chunk : png_chunks(png)) {
    if (frame.header.empty() && (chunk.type != "IHDR" || chunk.data.size() != 13)) {
      throw std::invalid_argument("the PNG has no header");
    }
    if (chunk.type == "acTL") throw std::invalid_argument("the frame is an animation itself");
    if (chunk.type == "IDAT") {
      frame.pixels.push_back(chunk.data);
    } else if (frame.pixels.empty()) {
      frame.header += chunk.bytes;
    }
  }
  if (frame.pixels.empty()) throw std::invalid_argument("the PNG has no pixels");
  return frame;
}

}  // namespace

FrameTime frame_time(double frames_per_second) {
  constexpr double most = std::numeric_limits<std::uint16_t>::max();
  if (!(frames_per_second >= 1 / most && frames_per_second <= most)) {
    throw std::invalid_argument("frames per second must be from 1/65535 to 65535, not " +
                                std::to_string(frames_per_second));
  }
  const double time = 1 / frames_per_second;
  double best_error = std::numeric_limits<double>::infinity();
  FrameTime best;
  // The smallest denominator among the nearest fractions gives lowest terms.
  for (double denominator = 1; denominator <= most; ++denominator) {
    const double numerator = std::round(time * denominator);
    if (numerator > most) break;
    const double error = std::abs(numerator / denominator - time);
    if (numerator < 1 || error >= best_error) continue;
    best_error = error;
    best = {static_cast<std::uint16_t>(numerator), static_cast<std::uint16_t>(denominator)};
  }
  return best;
}

AnimationPng::AnimationPng(const std::string& path, FrameTime time)
    : file_(path, fixproof::support::OutputFile::Use::overwriting), time_(time) {}

std::string AnimationPng::frame_control(std::string_view header) {
  // Width and height are the first eight bytes of IHDR's data, after its length and type.
  return png_chunk("fcTL", png_number(sequence_++) + std::string(header.substr(8, 8)) +
                               png_number(0) + png_number(0) + two_bytes(time_.numerator) +
                               two_bytes(time_.denominator) + std::string(2, '\0'));
}

void AnimationPng::add(std::string_view png) {
  const Frame frame = parse(png);
  if (frames_ != 0 && frame.header != header_) {
    throw std::invalid_argument("the frame differs from the first in size, kind or palette");
  }
  if (frame.pixels.size() >= max_sequence - sequence_) {
    throw std::length_error("the animation has more frames than an APNG can have");
  }
  std::string bytes;
  if (frames_ == 0) {
    constexpr std::size_t first_chunk = 13 + 12;
    bytes += png_signature;
    bytes += frame.header.substr(0, first_chunk);
    bytes += animation_control(0);
    bytes += frame.header.substr(first_chunk);
    header_ = frame.header;
  }
  bytes += frame_control(header_);
  for (const std::string_view pixels : frame.pixels) {
    bytes += frames_ == 0 ? png_chunk("IDAT", pixels)
                          : png_chunk("fdAT", png_number(sequence_++) + std::string(pixels));
  }
  file_.append(bytes);
  ++frames_;
}

void AnimationPng::finish() {
  if (frames_ == 0) throw std::logic_error("the animation has no frame");
  file_.append(png_chunk("IEND", {}));
  file_.overwrite(control_offset, animation_control(frames_));
  file_.finish();
}

}  // namespace xsharp
