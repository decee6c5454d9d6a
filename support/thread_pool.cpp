#include "support/thread_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <system_error>

namespace fixproof::support {

ThreadPool::ThreadPool(std::size_t workers)
    // NOLINTNEXTLINE(bugprone-throw-keyword-missing): a vector of std::exception_ptr throws nothing
    : thrown_(std::max<std::size_t>(workers, 1)),
      begin_(static_cast<std::ptrdiff_t>(thrown_.size())),
      end_(static_cast<std::ptrdiff_t>(thrown_.size())) {
  const std::size_t wanted = thrown_.size() - 1;
  try {
    threads_.reserve(wanted);
    while (threads_.size() < wanted) {
      threads_.emplace_back([this, worker = threads_.size() + 1] { wait_for_work(worker); });
    }
  } catch (...) {
    // Stands in for the caller and the missing threads, so that the started ones end.
    (void)begin_.arrive(static_cast<std::ptrdiff_t>(thrown_.size() - threads_.size()));
    for (std::thread& thread : threads_) thread.join();
    try {
      throw;
    } catch (const std::system_error& error) {
      throw std::runtime_error(fmt::format("cannot start thread {} of {}: {}; use fewer --threads",
                                           threads_.size() + 1, wanted, error.code().message()));
    }
  }
}

ThreadPool::~ThreadPool() {
  if (threads_.empty()) return;
  work_ = nullptr;
  begin_.arrive_and_wait();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::run(const std::function<void(std::size_t)>& work) {
  work_ = &work;
  if (!threads_.empty()) begin_.arrive_and_wait();
  do_work(0);
  if (!threads_.empty()) end_.arrive_and_wait();
  std::exception_ptr first;
  for (std::exception_ptr& thrown : thrown_) {
    if (!first) first = thrown;
    thrown = nullptr;
  }
  if (first) std::rethrow_exception(first);
}

ThreadPool::Part ThreadPool::part(std::size_t count, std::size_t worker) const {
  // Avoids count * worker, which could overflow.
  const auto begin_of = [count, n = workers()](std::size_t i) {
    return count / n * i + count % n * i / n;
  };
  return {begin_of(worker), begin_of(worker + 1)};
}

void ThreadPool::wait_for_work(std::size_t worker) {
  while (true) {
    begin_.arrive_and_wait();
    if (work_ == nullptr) return;
    do_work(worker);
    end_.arrive_and_wait();
  }
}

void ThreadPool::do_work(std::size_t worker) {
  try {
    (*work_)(worker);
  } catch (...) {
    thrown_[worker] = std::current_exception();
  }
}

unsigned processors() { return std::max(1U, std::thread::hardware_concurrency()); }

std::unique_ptr<ThreadPool> workers_for(std::size_t most) {
  try {
    return std::make_unique<ThreadPool>(std::min<std::size_t>(most, processors()));
  } catch (const std::runtime_error&) {
    return std::make_unique<ThreadPool>(1);
  }
}

void for_each_in_threads(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  workers_for(count)->run([&](std::size_t /*worker*/) {
    try {
      for (std::size_t i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;
      throw;
    }
  });
}

}  // namespace fixproof::support
