/// @file
/// Several threads for one loop.
#pragma once

#include <barrier>
#include <cstddef>
#include <exception>
#include <functional>
#include <thread>
#include <vector>

namespace xsharp {

/// Threads that wait for work, and the one that gives it. Not to be given work by two at once.
class Crew {
 public:
  /// @param workers how many work, the caller included; 0 counts as 1
  /// @throws std::system_error where there cannot be so many threads
  explicit Crew(std::size_t workers)
      : workers_(workers == 0 ? 1 : workers),
        begin_(static_cast<std::ptrdiff_t>(workers_)),
        end_(static_cast<std::ptrdiff_t>(workers_)),
        thrown_(workers_) {
    try {
      threads_.reserve(workers_ - 1);
      for (std::size_t i = 1; i < workers_; ++i) {
        threads_.emplace_back([this, i] { wait_for_work(i); });
      }
    } catch (...) {  // there is no work: those that wait for it go home
      (void)begin_.arrive(static_cast<std::ptrdiff_t>(workers_ - threads_.size()));
      for (std::thread& thread : threads_) thread.join();
      throw;
    }
  }
  ~Crew() {
    if (threads_.empty()) return;
    work_ = nullptr;
    begin_.arrive_and_wait();
    for (std::thread& thread : threads_) thread.join();
  }
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;
  Crew(Crew&&) = delete;
  Crew& operator=(Crew&&) = delete;

  [[nodiscard]] std::size_t workers() const { return workers_; }

  /// Calls work(worker) once on each thread, workers from 0, and returns when all have returned.
  /// @throws what the lowest of the workers that threw has thrown
  void run(const std::function<void(std::size_t)>& work) {
    work_ = &work;
    if (!threads_.empty()) begin_.arrive_and_wait();
    do_work(0);
    if (!threads_.empty()) end_.arrive_and_wait();
    for (std::exception_ptr& thrown : thrown_) {
      if (!thrown) continue;
      const std::exception_ptr first = thrown;
      thrown_.assign(workers_, nullptr);
      std::rethrow_exception(first);
    }
  }

  /// The part of `count` things that is a worker's: from the first up to, not including, the end.
  struct Part {
    std::size_t first = 0;
    std::size_t end = 0;
  };
  [[nodiscard]] Part part(std::size_t count, std::size_t worker) const {
    return {count / workers_ * worker + count % workers_ * worker / workers_,
            count / workers_ * (worker + 1) + count % workers_ * (worker + 1) / workers_};
  }

 private:
  void wait_for_work(std::size_t worker) {
    for (;;) {
      begin_.arrive_and_wait();
      if (work_ == nullptr) return;
      do_work(worker);
      end_.arrive_and_wait();
    }
  }

  void do_work(std::size_t worker) {
    try {
      (*work_)(worker);
    } catch (...) {
      thrown_[worker] = std::current_exception();
    }
  }

  std::size_t workers_;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::barrier<> begin_;
  std::barrier<> end_;
  std::vector<std::exception_ptr> thrown_;
  std::vector<std::thread> threads_;
};

}  // namespace xsharp
