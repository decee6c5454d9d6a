/// @file
/// The files that frames are drawn into.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "player/canvas.hpp"
#include "player/picture_digest.hpp"
#include "support/part_file.hpp"
#include "xsharp/files/animation_png.hpp"
#include "xsharp/player.hpp"

namespace fixproof::player {

/// Where frames are to go; an empty name is none.
struct OutputNames {
  std::string folder;     ///< for a PNG of every frame
  std::string animation;  ///< an animated PNG
  std::string dump;       ///< dump_frame() of every frame
  std::string digests;    ///< DigestLines of the frames
  std::string beside;     ///< written by BesideExact; here so that it clashes with nothing
};

/// @throws UsageError if `file`, which `option` says is to be written, is one of `inputs`
void refuse_inputs(std::string_view option, const std::filesystem::path& file,
                   const std::vector<std::filesystem::path>& inputs);

/// Files for frames. None is there, or changed, before it is complete.
class Outputs {
 public:
  /// @param inputs files that must not be written
  /// @throws UsageError if an output is another output or an input, or the folder cannot be made
  /// @throws std::runtime_error naming what cannot be written
  Outputs(const OutputNames& names, const std::vector<std::filesystem::path>& inputs,
          double frames_per_second);

  /// Frames come in order, from 0.
  void add(const Canvas& canvas, const xsharp::Player& player, std::uint64_t frame);

  /// Without frames, what was there before stays.
  void finish(std::uint64_t frames);

  /// The first picture of an earlier, longer run that is still in the folder; empty if there is
  /// none.
  [[nodiscard]] std::string older_frame(std::uint64_t frames) const;

 private:
  [[nodiscard]] std::string frame_file(std::uint64_t frame) const;

  std::string folder_;
  std::unique_ptr<xsharp::AnimationPng> animation_;
  std::unique_ptr<support::PartFile> dump_;
  std::unique_ptr<support::PartFile> digests_;
  DigestLines digest_lines_;
};

}  // namespace fixproof::player
