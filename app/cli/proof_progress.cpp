#include "app/cli/proof_progress.hpp"

#include <fmt/format.h>

namespace fixproof::cli {

ProofProgress::ProofProgress() {
  if (!line_.is_seen()) return;
  drawer_ = std::jthread([this](const std::stop_token& stop) { keep_drawing(stop); });
}

void ProofProgress::show(const judge::ProofStep& step) {
  const std::lock_guard lock(mutex_);
  step_ = step;
}

void ProofProgress::keep_drawing(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stopped_.wait_for(lock, stop, std::chrono::milliseconds(200),
                            [&] { return stop.stop_requested(); })) {
    line_.show(step_text(step_, std::chrono::floor<std::chrono::seconds>(clock::now() - begin_)));
  }
}

std::string step_text(const judge::ProofStep& step, std::chrono::seconds passed) {
  const std::string what =
      step.attempt == 0
          ? "following the paths"
          : fmt::format(
                "path {} of {}{}", step.path, step.paths,
                step.attempt == 1 ? std::string() : fmt::format(", attempt {}", step.attempt));
  return fmt::format("{}, {} s", what, passed.count());
}

}  // namespace fixproof::cli
