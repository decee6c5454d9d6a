/// @file
/// A fixed set of threads that run the same function.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstddef>
#include <functional>
#include <memory>

#if !defined(__wasi__)
#include <barrier>
#include <exception>
#include <thread>
#include <vector>
#endif

namespace fixproof::support {

#if defined(__wasi__)

/// The same interface without threads, which WebAssembly's libraries lack: the caller is the only
/// worker.
class ThreadPool : private boost::noncopyable {
 public:
  explicit ThreadPool(std::size_t /*workers*/) {}

  [[nodiscard]] static constexpr std::size_t workers() { return 1; }
  static void run(const std::function<void(std::size_t)>& work) { work(0); }

  struct Part {
    std::size_t first = 0;
    std::size_t end = 0;
  };
  [[nodiscard]] static constexpr Part part(std::size_t count, std::size_t /*worker*/) {
    return {0, count};
  }
};

constexpr unsigned processors() { return 1; }

inline std::unique_ptr<ThreadPool> workers_for(std::size_t most) {
  return std::make_unique<ThreadPool>(most);
}

inline void for_each_in_threads(std::size_t count, const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < count; ++i) work(i);
}

#else

/// Threads that wait between calls of run(). The calling thread is worker 0. Only one thread may
/// call run() at a time.
class ThreadPool : private boost::noncopyable {
 public:
  /// @param workers the number of workers, including the caller; 0 counts as 1
  /// @throws std::runtime_error if a thread cannot be started
  explicit ThreadPool(std::size_t workers);
  ~ThreadPool();

  [[nodiscard]] std::size_t workers() const { return thrown_.size(); }

  /// Calls work(worker) once on each worker and returns when all calls have returned.
  /// @throws the exception of the lowest-numbered worker that threw
  void run(const std::function<void(std::size_t)>& work);

  /// The part of `count` items that belongs to a worker: from `first` up to, but excluding, `end`.
  struct Part {
    std::size_t first = 0;
    std::size_t end = 0;
  };
  [[nodiscard]] Part part(std::size_t count, std::size_t worker) const;

 private:
  void wait_for_work(std::size_t worker);
  void do_work(std::size_t worker);

  const std::function<void(std::size_t)>* work_ = nullptr;  ///< null tells the threads to end
  std::vector<std::exception_ptr> thrown_;                  ///< one for each worker
  std::barrier<> begin_;
  std::barrier<> end_;
  std::vector<std::thread> threads_;
};

/// The number of processors, at least 1.
unsigned processors();

/// One worker for each processor, but at most `most`; the caller alone if no thread can be started.
std::unique_ptr<ThreadPool> workers_for(std::size_t most);

/// Calls work(i) once for each i below `count`, in no order, on all processors. Returns when all
/// calls have returned. No worker takes another i after a call has thrown.
/// @throws one of the exceptions
void for_each_in_threads(std::size_t count, const std::function<void(std::size_t)>& work);

#endif

}  // namespace fixproof::support
