#include "fuzz/log_seeds.hpp"

#include <string>

#include "fuzz/corpus.hpp"
#define FIXPROOF_RECORD 1
#include "fixed/record/recorded.hpp"
#include "support/file.hpp"

namespace fixproof::fuzz {

namespace {

/// A small run of recorded numbers, with `planted` in its operands.
std::string recorded_run(const std::filesystem::path& path, int planted, record::full_range full) {
  using real = fixproof::recorded<q16_16>;
  {
    const record::log log(path.string(), {.program = "seed", .full = full});
    real sum(1);
    for (int turn = 0; turn < 40; ++turn) {
      // Frame 5 comes twice, as in a program that goes back.
      if (turn % 5 == 0) record::frame(turn < 30 ? turn / 5 : turn / 5 - 1);
      if (turn % 10 == 3) record::mark(turn % 20 == 3 ? "move" : "collide");
      if (turn == 20) record::confirm(3);
      sum += real(turn == 17 ? planted : turn) / real(3);
      sum = sqrt(sum) * real(0.75);
    }
  }
  std::string bytes = support::read_file(path.string());
  std::filesystem::remove(path);
  return bytes;
}

}  // namespace

void write_logs(const std::filesystem::path& root) {
  Corpus corpus(root, "recorder_log");
  const std::filesystem::path path = root / "run.log";
  for (const record::full_range full :
       {record::full_range{}, record::full_range{.is_of_frames = false, .first = 3, .last = 4}}) {
    const std::string a = recorded_run(path, 17, full);
    for (const int planted : {17, 18}) {
      const std::string b = recorded_run(path, planted, full);
      for (const char sealed : {'s', 'k'}) {
        const auto pages = static_cast<char>(a.size() / record::page_bytes);
        corpus.add(std::string{sealed, pages} + a + b);
        corpus.add(std::string{sealed, pages} + a + b.substr(0, b.size() - record::page_bytes));
      }
    }
  }
}

}  // namespace fixproof::fuzz
