#include "measure/player/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "measure/player/dump.hpp"
#include "support/file.hpp"
#include "support/file_lock.hpp"
#include "support/place.hpp"
#include "support/usage_error.hpp"

namespace fixproof::player {

namespace {

namespace fs = std::filesystem;

using Use = std::pair<std::string, fs::path>;

/// Tells whether `file` can be the name of a frame in `folder`.
bool is_frame_of(const fs::path& folder, const fs::path& file) {
  const auto place = support::find_place(file);
  return place && support::same_file(folder, place->folder_path()) &&
         place->name().starts_with("frame_") && place->name().ends_with(".png");
}

[[noreturn]] void refuse_use(std::string_view option, const fs::path& file, std::string_view use) {
  throw support::UsageError(
      fmt::format("{} {}: this is a file of {}; name another", option, file.string(), use));
}

void refuse_inputs(std::string_view option, const fs::path& file,
                   const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    if (support::same_file(file, input)) refuse_use(option, file, "the scene");
  }
}

void refuse_clashes(const OutputNames& names, const std::vector<std::string>& inputs) {
  std::vector<Use> outputs;
  if (!names.animation.empty()) outputs.emplace_back("--animate", names.animation);
  if (!names.dump.empty()) outputs.emplace_back("--dump", names.dump);
  if (!names.digests.empty()) outputs.emplace_back("--digests", names.digests);
  if (!names.beside.empty()) outputs.emplace_back("--beside", names.beside);
  std::vector<Use> others;
  for (const auto& [option, file] : outputs) {
    refuse_inputs(option, file, inputs);
    for (const auto& [other, other_file] : others) {
      if (support::same_file(file, other_file)) refuse_use(option, file, other);
    }
    others.emplace_back(option, file);
  }
  if (names.folder.empty()) return;
  for (const std::string& input : inputs) others.emplace_back("the scene", input);
  for (const auto& [other, file] : others) {
    if (is_frame_of(names.folder, file)) {
      throw support::UsageError(
          fmt::format("--out {}: a frame could replace {}, a file of {}; name another folder",
                      names.folder, file.string(), other));
    }
  }
}

}  // namespace

std::unique_ptr<support::OutputFile> open_output(std::string_view option, const fs::path& file,
                                                 const std::vector<std::string>& inputs) {
  if (file.empty()) return nullptr;
  refuse_inputs(option, file, inputs);
  return std::make_unique<support::OutputFile>(file.string());
}

void check_output(std::string_view option, const fs::path& file,
                  const std::vector<std::string>& inputs) {
  open_output(option, file, inputs);
}

Outputs::Outputs(const OutputNames& names, const std::vector<std::string>& inputs,
                 double frames_per_second)
    : folder_(names.folder) {
  if (!folder_.empty()) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error || !fs::is_directory(folder_)) {
      throw support::UsageError(fmt::format("--out {}: cannot create this folder: {}", folder_,
                                            error ? error.message() : "a file has that name"));
    }
  }
  // Names are compared by the folders they lie in, which exist now.
  refuse_clashes(names, inputs);
  if (!folder_.empty()) {
    lock_ = std::make_unique<support::FolderLock>("--out", folder_);
    support::remove_leftovers(folder_);
    check_output("--out", frame_file(0), {});
  }
  if (!names.animation.empty()) {
    animation_ = std::make_unique<xsharp::AnimationPng>(names.animation,
                                                        xsharp::frame_time(frames_per_second));
  }
  if (!names.dump.empty()) dump_ = std::make_unique<support::OutputFile>(names.dump);
  if (!names.digests.empty()) digests_ = std::make_unique<support::OutputFile>(names.digests);
}

void Outputs::add(const Canvas& canvas, const xsharp::Player& player, std::uint64_t frame) {
  if (animation_ || !folder_.empty()) {
    const std::string png = canvas.png();
    if (!folder_.empty()) {
      const std::string file = frame_file(frame);
      // Replaces a symbolic link itself, because its target is not a frame.
      if (fs::is_symlink(file)) fs::remove(file);
      support::replace_file(file, png);
    }
    if (animation_) animation_->add(png);
  }
  if (dump_) dump_->append(dump_frame(player, frame));
  if (digests_) digests_->append(digest_lines_.line_of(canvas.indices()));
}

void Outputs::finish(std::uint64_t frames) {
  if (frames == 0) return;
  if (animation_) animation_->finish();
  if (dump_) dump_->finish();
  if (digests_) digests_->finish();
}

std::string Outputs::older_frame(std::uint64_t frames) const {
  if (folder_.empty() || !fs::exists(frame_file(frames))) return "";
  return frame_file(frames);
}

std::string Outputs::frame_file(std::uint64_t frame) const {
  return fmt::format("{}/frame_{:06}.png", folder_, frame);
}

}  // namespace fixproof::player
