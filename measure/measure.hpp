/// @file
/// The options of a measurement, and how it reports progress.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/frame_progress.hpp"
#include "verify/cases/format.hpp"
#include "xsharp/scene.hpp"

namespace fixproof::measure {

/// The options of `fixproof measure`. Each measurement has its own default for `cases`.
struct MeasureRequest {
  std::vector<xsharp::Scene> scenes;   ///< whose operands are recorded
  cases::Format format;                ///< used by the accuracy in a format and of functions
  std::string function;                ///< of measure_function_accuracy(), or `all`
  std::uint64_t seed = 1994;           ///< seed of the random operands
  std::optional<std::uint64_t> cases;  ///< random cases of each kind
  std::uint64_t rounds = 101;          ///< each round times every loop once
};

/// Passed to a part of a measurement that runs to its end.
inline const std::atomic<bool> never_stop{false};

/// Counts the finished parts of a measurement, shows them on the terminal, and tells the
/// measurement when to stop. A measurement that stops early returns nothing.
class MeasureProgress {
 public:
  explicit MeasureProgress(const std::atomic<bool>& stop) : stop_(stop) {}

  /// @param unit the name of the parts, in the plural
  void begin(std::uint64_t all, std::string_view unit) {
    all_ = all;
    unit_ = unit;
    line_.emplace(all, unit);
  }
  void show(std::uint64_t done) { line_->show(done_ = done); }
  /// Any thread may call this.
  void add_part() {
    const std::lock_guard lock(mutex_);
    show(done_ + 1);
  }
  void end() { line_.reset(); }

  [[nodiscard]] const std::atomic<bool>& stop() const { return stop_; }
  [[nodiscard]] std::uint64_t done() const { return done_; }
  [[nodiscard]] std::uint64_t all() const { return all_; }
  [[nodiscard]] std::string_view unit() const { return unit_; }

 private:
  const std::atomic<bool>& stop_;
  std::mutex mutex_;
  std::uint64_t done_ = 0;
  std::uint64_t all_ = 0;
  std::string_view unit_;
  std::optional<support::FrameProgress> line_;
};

}  // namespace fixproof::measure
