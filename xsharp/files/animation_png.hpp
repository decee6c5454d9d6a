/// @file
/// Animations as APNG files: PNG images that follow one another, for ever. A viewer that knows
/// nothing of animations shows the first.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "support/part_file.hpp"

namespace xsharp {

/// How long a frame is shown: numerator / denominator seconds. A denominator of 0 means 100.
struct FrameTime {
  std::uint16_t numerator = 1;
  std::uint16_t denominator = 60;

  friend bool operator==(const FrameTime&, const FrameTime&) = default;
};

/// The fraction nearest to the time of one of so many frames in a second, in lowest terms.
/// @throws std::invalid_argument if the rate is not from 1 / 65535 to 65535
FrameTime frame_time(double frames_per_second);

/// Writes frame by frame: memory does not grow with their number. The file appears at finish();
/// without it nothing is left behind.
class AnimationPng {
 public:
  /// @throws std::runtime_error naming the file and the reason
  AnimationPng(const std::string& path, FrameTime time);

  /// The next frame, a PNG as encode_png() makes it: of the first one's size, kind and palette.
  /// @throws std::invalid_argument for anything else; the animation is as before
  /// @throws std::length_error beyond 2^31 - 1 frames or pieces of frames
  /// @throws std::runtime_error naming the file and the reason
  void add(std::string_view png);

  /// Puts the file in its place.
  /// @throws std::logic_error if there is no frame
  /// @throws std::runtime_error naming the file and the reason
  void finish();

  [[nodiscard]] std::uint32_t frames() const { return frames_; }

 private:
  [[nodiscard]] std::string frame_control(std::string_view header);

  fixproof::support::PartFile file_;
  FrameTime time_;
  std::uint32_t frames_ = 0;
  std::uint32_t sequence_ = 0;  ///< number of the next fcTL or fdAT chunk
  std::string header_;          ///< of the first frame: all before its pixels
};

}  // namespace xsharp
