/// @file
/// The files that receive drawn frames.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "measure/player/canvas.hpp"
#include "measure/player/picture_digest.hpp"
#include "support/folder_lock.hpp"
#include "support/output_file.hpp"
#include "xsharp/files/animation_png.hpp"
#include "xsharp/player.hpp"

namespace fixproof::player {

/// The names of the outputs; an empty name disables an output.
struct OutputNames {
  std::string folder;     ///< folder for a PNG of every frame
  std::string animation;  ///< an animated PNG
  std::string dump;       ///< dump_frame() of every frame
  std::string digests;    ///< DigestLines of the frames
  std::string beside;     ///< written by BesideExact; listed here to detect name clashes
};

/// Locks `file`, the output of `option`, until it is written. An empty name is no output: null.
/// @throws UsageError if the file is one of `inputs`, std::runtime_error if it cannot be written or
/// another run is writing it
std::unique_ptr<support::OutputFile> open_output(std::string_view option,
                                                 const std::filesystem::path& file,
                                                 const std::vector<std::string>& inputs);

/// Does the same, but releases the lock. Only for files in a folder that the run has locked.
void check_output(std::string_view option, const std::filesystem::path& file,
                  const std::vector<std::string>& inputs);

/// Output files for frames, locked against another run. A file appears or changes only when it is
/// complete.
class Outputs {
 public:
  /// @param inputs files that must not be written
  /// @throws UsageError if an output is another output or an input, the folder cannot be made, or
  /// another run is writing there
  /// @throws std::runtime_error naming the file that cannot be written, or that another run writes
  Outputs(const OutputNames& names, const std::vector<std::string>& inputs,
          double frames_per_second);

  /// Adds a frame. Frames come in order, from 0.
  void add(const Canvas& canvas, const xsharp::Player& player, std::uint64_t frame);

  /// Completes the files. Without frames, existing files stay unchanged.
  void finish(std::uint64_t frames);

  /// Returns the first picture that an earlier, longer run left in the folder; empty without one.
  [[nodiscard]] std::string older_frame(std::uint64_t frames) const;

 private:
  [[nodiscard]] std::string frame_file(std::uint64_t frame) const;

  std::string folder_;
  std::unique_ptr<support::FolderLock> lock_;  ///< of the folder
  std::unique_ptr<xsharp::AnimationPng> animation_;
  std::unique_ptr<support::OutputFile> dump_;
  std::unique_ptr<support::OutputFile> digests_;
  DigestLines digest_lines_;
};

}  // namespace fixproof::player
