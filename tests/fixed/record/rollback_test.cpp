// Compares runs that go back and simulate frames again, by the last simulation of each frame.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "judge/desync/compare.hpp"
#include "tests/fixed/record/sim.hpp"
#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using namespace fixproof;
using desync::Comparison;
using desync::LogFile;
using desync::Verdict;
using recorder_test::real;

class Rollbacks : public testing::Test {
 protected:
  [[nodiscard]] std::string a() const { return folder_.path("a.log"); }
  [[nodiscard]] std::string b() const { return folder_.path("b.log"); }

  [[nodiscard]] Comparison compare(bool swapped = false) const {
    LogFile first(swapped ? b() : a());
    LogFile second(swapped ? a() : b());
    return desync::compare_last_frames(first, second);
  }

 private:
  ScratchFolder folder_;
};

/// Simulates a game that goes back. It guesses the inputs of the other player, and simulates frames
/// again after wrong guesses.
void play(const std::string& path, int late, int frames, int wrong_frame = -1) {
  const record::log log(path, {.program = "rollback", .full = {true, 20, 20}});
  std::vector<real> states{real(1)};
  const auto simulate = [&](int frame, int input) {
    record::frame(frame);
    real x = states.at(static_cast<std::size_t>(frame));
    for (int i = 0; i < 500; ++i) x = x * 3 + real::from_raw(input + i);
    if (frame == wrong_frame) x.value_ = x.plain() + q16_16::from_raw(1);
    x += real::from_raw(7);
    states.resize(static_cast<std::size_t>(frame) + 1);
    states.push_back(x);
  };
  const auto input_of = [](int frame) { return frame % 7; };
  for (int frame = 0; frame < frames; ++frame) {
    simulate(frame, frame % late == 0 ? 0 : input_of(frame));
    if (frame % late != late - 1 && frame != frames - 1) continue;
    const int back = frame / late * late;
    for (int again = back; again <= frame; ++again) simulate(again, input_of(again));
    record::confirm(frame);
  }
}

TEST_F(Rollbacks, AreComparedByTheLastSimulation) {
  play(a(), 3, 60);
  play(b(), 5, 60);
  LogFile first(a());
  LogFile second(b());
  EXPECT_NE(desync::compare(first, second).verdict, Verdict::equal);
  const Comparison found = compare();
  EXPECT_EQ(found.verdict, Verdict::equal);
  EXPECT_EQ(found.blocks, 60U);
}

TEST_F(Rollbacks, ThatAreComparedFromTheirBeginningAreInDifferentFrames) {
  play(a(), 3, 60);
  play(b(), 5, 60);
  const command::Run found = command::run({paths::command(), "desync", a(), b()});
  EXPECT_EQ(found.status, 1);
  // A simulates frames 0 to 2 again, B first simulates frames 3 and 4.
  command::expect_contains(found.out, " (frame 0), ");
  command::expect_contains(
      found.out,
      "B is in frame 3 there. If the programs simulate frames again, compare with --rollback.\n");
}

TEST_F(Rollbacks, HaveADifference) {
  play(a(), 3, 60);
  play(b(), 5, 60, 20);
  const Comparison found = compare();
  EXPECT_EQ(found.verdict, Verdict::operands);
  EXPECT_EQ(found.a.entry.frame, 20);
  const auto operation = desync::operation_of(found.a.records.at(*found.a.index).words);
  EXPECT_EQ(operation.kind, record::kind::add);
}

/// Records a frame of `operations` operations in full, and a short one after it.
void play_long_frame(const std::string& path, int operations) {
  const record::log log(path, {.full = {.is_of_frames = true, .first = 7, .last = 7}});
  record::frame(7);
  real sum;
  for (int i = 0; i < operations; ++i) sum += real();
  record::frame(8);
  sum += sum;
}

TEST_F(Rollbacks, AFrameThatGoesOnAfterAFullBlock) {
  // The frame's own record and 1,023 operations fill a block.
  play_long_frame(a(), 1023);
  play_long_frame(b(), 1025);
  for (const bool swapped : {false, true}) {
    const Comparison found = compare(swapped);
    EXPECT_EQ(found.verdict, Verdict::path);
    EXPECT_EQ(found.a.index.has_value(), swapped);
    const desync::Side& longer = swapped ? found.a : found.b;
    ASSERT_TRUE(longer.index);
    EXPECT_EQ(longer.records.at(*longer.index).operation, 1023U);
  }
}

TEST_F(Rollbacks, AFrameThatEndsWithTheRunDoesNotHideTheOthers) {
  for (const auto& [path, last] : {std::pair(a(), 100), std::pair(b(), 50)}) {
    const record::log log(path);
    for (int frame = 0; frame < 5; ++frame) {
      record::frame(frame);
      real sum;
      for (int i = 0; i < (frame == 4 ? last : 100); ++i) sum += q16_16::from_raw(i);
    }
  }
  const Comparison found = compare();
  EXPECT_EQ(found.verdict, Verdict::equal);
  EXPECT_EQ(found.blocks, 5U);
  EXPECT_EQ(found.operations, 400U);
}

TEST_F(Rollbacks, FramesThatAreNotConfirmedDoNotCount) {
  for (const auto& [path, guess] : {std::pair(a(), 1), std::pair(b(), 2)}) {
    const record::log log(path);
    for (int frame = 0; frame < 4; ++frame) {
      record::frame(frame);
      (void)(real::from_raw(frame < 3 ? 5 : guess) * 2);
      if (frame == 2) record::confirm(2);
    }
  }
  const Comparison found = compare();
  EXPECT_EQ(found.verdict, Verdict::equal);
  EXPECT_EQ(found.blocks, 3U);
}

}  // namespace
