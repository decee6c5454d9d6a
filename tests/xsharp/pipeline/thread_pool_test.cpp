#include "support/thread_pool.hpp"

#include <atomic>

#include "tests/support/test.hpp"

namespace fixproof::support {
namespace {

TEST(ThreadPool, PartsCoverEachItemOnceAndEvenly) {
  for (const std::size_t workers : {1U, 2U, 3U, 7U}) {
    const ThreadPool pool(workers);
    for (const std::size_t count : {0U, 1U, 6U, 7U, 8U, 1000U}) {
      std::size_t next = 0;
      for (std::size_t worker = 0; worker < workers; ++worker) {
        const auto part = pool.part(count, worker);
        EXPECT_EQ(part.first, next);
        EXPECT_LE(part.end - part.first, count / workers + 1);
        next = part.end;
      }
      EXPECT_EQ(next, count);
    }
  }
}

TEST(ThreadPool, EachWorkerWorksOncePerRun) {
  ThreadPool pool(4);
  std::vector<int> worked(4);
  for (int i = 1; i <= 100; ++i) {
    pool.run([&](std::size_t worker) { ++worked[worker]; });
    EXPECT_EQ(worked, std::vector<int>(4, i));
  }
}

TEST(ThreadPool, ZeroWorkersCountAsOne) { EXPECT_EQ(ThreadPool(0).workers(), 1U); }

TEST(ThreadPool, RethrowsAnExceptionAndCanRunAgain) {
  for (const std::size_t workers : {1U, 3U}) {
    ThreadPool pool(workers);
    std::atomic<std::size_t> ended = 0;
    const auto fails = [&](std::size_t worker) {
      ++ended;
      if (worker == workers - 1) throw std::runtime_error("worker " + std::to_string(worker));
    };
    EXPECT_THROW(pool.run(fails), std::runtime_error);
    EXPECT_EQ(ended, workers);
    pool.run([&](std::size_t) { ++ended; });
    EXPECT_EQ(ended, 2 * workers);
  }
}

TEST(EachInThreads, IsDoneOnce) {
  for (const std::size_t count : {0U, 1U, 2U, 1000U}) {
    std::vector<std::atomic<int>> done(count);
    for_each_in_threads(count, [&](std::size_t i) { ++done[i]; });
    for (const std::atomic<int>& times : done) ASSERT_EQ(times, 1);
  }
}

TEST(EachInThreads, EndsAfterAnException) {
  const std::size_t all = 1'000'000'000;
  std::atomic<std::size_t> done = 0;
  const auto fails = [&](std::size_t i) {
    if (i == 10) throw std::runtime_error("10");
    ++done;
  };
  EXPECT_THROW(for_each_in_threads(all, fails), std::runtime_error);
  EXPECT_LT(done, all - 1);
}

}  // namespace
}  // namespace fixproof::support
