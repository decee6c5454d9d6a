// Logs of killed runs, and forged logs. A log must be read as far as it is sound, or refused by
// name. Nothing else may happen.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <utility>

#include "fixed/record/hash.hpp"
#include "judge/desync/compare.hpp"
#include "support/file.hpp"
#include "support/usage_error.hpp"
#include "tests/fixed/record/sim.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using namespace fixproof;
using desync::LogFile;
using desync::Verdict;
using recorder_test::Plant;

class Logs : public testing::Test {
 protected:
  void SetUp() override {
    // The difference is in block 92. Without it, no test would read the records.
    recorder_test::run(a(), 25000, Plant::nothing, 0, {false, 92, 93});
    recorder_test::run(b(), 25000, Plant::operand, 23000, {false, 92, 93});
    LogFile first(a());
    LogFile second(b());
    ASSERT_EQ(desync::compare(first, second).verdict, Verdict::operands);
  }

  [[nodiscard]] std::string path(const char* name) const { return folder_.path(name); }
  [[nodiscard]] std::string a() const { return path("a.log"); }
  [[nodiscard]] std::string b() const { return path("b.log"); }

  static std::string read(const std::string& path) { return support::read_file(path); }
  static void write(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  }

  /// Reads both logs in every way. Returns whether one was refused.
  [[nodiscard]] bool refused() const {
    try {
      LogFile first(a());
      LogFile second(b());
      const auto found = desync::compare(first, second);
      std::uint64_t file = 0;
      for (const desync::Record& record : found.a.records) {
        (void)text_of(desync::operation_of(record.words));
        if (std::exchange(file, record.file) != record.file) (void)first.name(file);
      }
      LogFile third(a());
      (void)desync::compare_last_frames(third, second);
    } catch (const support::UsageError& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(folder_.path())) << error.what();
      return true;
    }
    return false;
  }

 private:
  ScratchFolder folder_;
};

TEST_F(Logs, CutAnywhereTheyAreReadToThere) {
  const std::string bytes = read(a());
  std::uint64_t last = 0;
  for (std::size_t length = record::page_bytes; length < bytes.size(); length += 337) {
    write(a(), bytes.substr(0, length));
    LogFile log(a());
    EXPECT_FALSE(log.is_complete());
    EXPECT_EQ(log.torn_bytes(), length % record::page_bytes);
    EXPECT_GE(log.blocks(), last);
    last = log.blocks();
    LogFile other(b());
    EXPECT_EQ(desync::compare(log, other).verdict, Verdict::equal);  // the last page is gone
  }
  EXPECT_GT(last, 60U);
}

TEST_F(Logs, EveryBitThatIsFlippedIsFoundOrDoesNotMatter) {
  const std::string bytes = read(a());
  std::mt19937_64 random(8088);
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    std::string damaged = bytes;
    const std::size_t bit = random() % (bytes.size() * 8);
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    write(a(), damaged);
    found += refused() ? 1 : 0;
  }
  EXPECT_GT(found, 50);  // only damage to pages that are read is found
}

/// These pages have right checksums and wrong contents.
TEST_F(Logs, PagesWithImpossibleContentsAreRefused) {
  const std::string bytes = read(a());
  std::mt19937_64 random(386);
  int found = 0;
  for (int i = 0; i < 500; ++i) {
    std::string forged = bytes;
    const std::size_t page = random() % (bytes.size() / record::page_bytes);
    std::array<std::uint64_t, record::page_words> words{};
    for (std::size_t at = 0; at < record::page_bytes; ++at) {
      words[at / 8] |=
          std::uint64_t{static_cast<unsigned char>(bytes[page * record::page_bytes + at])}
          << (8 * (at % 8));
    }
    const std::size_t word = random() % 3 == 0 ? random() % record::page_words : random() % 16;
    words[word] = random() % 2 == 0 ? random() : words[word] ^ (std::uint64_t{1} << random() % 64);
    words[7] = 0;
    words[7] = record::hash_words(words.data(), words.size());
    for (std::size_t at = 0; at < record::page_bytes; ++at) {
      forged[page * record::page_bytes + at] =
          static_cast<char>(words[at / 8] >> (8 * (at % 8)) & 0xff);
    }
    write(a(), forged);
    found += refused() ? 1 : 0;
  }
  EXPECT_GT(found, 25);
}

TEST_F(Logs, WhatIsNoLogIsRefused) {
  write(a(), "");
  EXPECT_TRUE(refused());
  write(a(), std::string(5000, '\0'));
  EXPECT_TRUE(refused());
  write(a(), read(b()).substr(1));
  EXPECT_TRUE(refused());
  std::filesystem::remove(a());
  EXPECT_TRUE(refused());
  std::filesystem::create_directory(a());
  EXPECT_TRUE(refused());
}

TEST_F(Logs, OfAKilledProgramGoOnToItsLastPage) {
  const std::string killed = path("killed.log");
  EXPECT_EXIT(
      {
        const record::log log(killed);
        recorder_test::real x(1);
        for (std::uint64_t i = 0;; ++i) {
          x += recorder_test::real::from_raw(static_cast<std::int32_t>(i % 1000));
          if (i == 100000) std::_Exit(7);
        }
      },
      testing::ExitedWithCode(7), "");
  LogFile log(killed);
  EXPECT_FALSE(log.is_complete());
  // The log has all full pages, each of 30 blocks of 1,024 operations.
  EXPECT_EQ(log.blocks(), 200002U / 1024 / 30 * 30);
}

TEST_F(Logs, ThatCannotBeWrittenDoNotStopTheProgram) {
  const record::log log(path("gone/x.log"));
  EXPECT_FALSE(log.good());
  recorder_test::real x(1);
  for (int i = 0; i < 100000; ++i) x += 1;
  EXPECT_EQ(x.plain(), q16_16(1) + q16_16(100000));
}

}  // namespace
