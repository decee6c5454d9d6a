/// @file
/// Animations as APNG files: PNG images in an endless loop. A viewer without APNG support shows the
/// first.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "support/output_file.hpp"

namespace xsharp {

/// The display time of a frame: numerator / denominator seconds. A denominator of 0 means 100.
struct FrameTime {
  std::uint16_t numerator = 1;
  std::uint16_t denominator = 60;

  friend bool operator==(const FrameTime&, const FrameTime&) = default;
};

/// The fraction, in lowest terms, nearest to the frame time for a rate in frames per second.
/// @throws std::invalid_argument if the rate is not from 1 / 65535 to 65535
FrameTime frame_time(double frames_per_second);

/// Writes an animation frame by frame, in constant memory. The file appears at finish(); without
/// it, nothing remains.
class AnimationPng {
 public:
  /// @throws std::runtime_error with the file and the reason
  AnimationPng(const std::string& path, FrameTime time);

  /// Adds a frame, a PNG from encode_png() with the size, kind and palette of the first.
  /// @throws std::invalid_argument for anything else; the animation is unchanged
  /// @throws std::length_error beyond 2^31 - 1 frames or pieces of frames
  /// @throws std::runtime_error with the file and the reason
  void add(std::string_view png);

  /// Moves the file to its path.
  /// @throws std::logic_error if there is no frame
  /// @throws std::runtime_error with the file and the reason
  void finish();

  [[nodiscard]] std::uint32_t frames() const { return frames_; }

 private:
  [[nodiscard]] std::string frame_control(std::string_view header);

  fixproof::support::OutputFile file_;
  FrameTime time_;
  std::uint32_t frames_ = 0;
  std::uint32_t sequence_ = 0;  ///< number of the next fcTL or fdAT chunk
  std::string header_;          ///< chunks of the first frame before its pixels
};

}  // namespace xsharp
