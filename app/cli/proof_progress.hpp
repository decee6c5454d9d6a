/// @file
/// Progress line of a proof.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "judge/code/prove.hpp"
#include "support/terminal_line.hpp"

namespace fixproof::cli {

/// Shows the step and the seconds so far. Redraws them while a question is asked, because one may
/// take a minute.
class ProofProgress {
 public:
  ProofProgress();

  void show(const judge::ProofStep& step);

 private:
  using clock = std::chrono::steady_clock;

  void keep_drawing(const std::stop_token& stop);

  support::TerminalLine line_;
  clock::time_point begin_ = clock::now();
  std::mutex mutex_;
  std::condition_variable_any stopped_;
  judge::ProofStep step_;
  std::jthread drawer_;  ///< last, so that it ends before what it uses
};

/// Formats a step in less than 80 columns.
std::string step_text(const judge::ProofStep& step, std::chrono::seconds passed);

}  // namespace fixproof::cli
