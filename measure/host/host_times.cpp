#include "measure/host/host_times.hpp"

#include <algorithm>
#include <ctime>

namespace fixproof::measure {

namespace {

using std::chrono::nanoseconds;

/// Reading the thread's clock takes a microsecond, a thousandth of a sample.
constexpr nanoseconds sample_length = std::chrono::milliseconds(1);

nanoseconds time_passes(const TimedLoop& loop, std::uint64_t passes) {
  loop.pass();
  const nanoseconds begin = thread_time();
  for (std::uint64_t i = 0; i < passes; ++i) {
    loop.pass();
    // Makes the compiler treat a pass's writes as read before the next pass.
    std::atomic_signal_fence(std::memory_order_seq_cst);
  }
  return thread_time() - begin;
}

/// The number of passes in one sample: two thirds to four thirds of the sample length.
std::uint64_t passes_of_a_sample(const TimedLoop& loop) {
  std::uint64_t passes = 1;
  while (std::min(time_passes(loop, passes), time_passes(loop, passes)) < sample_length * 2 / 3) {
    passes *= 2;
  }
  return passes;
}

}  // namespace

nanoseconds thread_time() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + nanoseconds(time.tv_nsec);
}

void to_json(support::Json& json, const Times& times) {
  json = {{"min", times.min}, {"median", times.median}, {"spread", times.spread}};
}

Times times_of(std::vector<double> samples) {
  std::ranges::sort(samples);
  const auto quartile = [&](std::size_t i) { return samples[i * (samples.size() - 1) / 4]; };
  return {samples.front(), quartile(2), (quartile(3) - quartile(1)) / quartile(2)};
}

std::vector<Times> time_in_turn(const std::vector<TimedLoop>& loops, std::uint64_t rounds,
                                const std::atomic<bool>& stop,
                                const std::function<void(std::uint64_t)>& done) {
  std::vector<std::uint64_t> passes;
  for (const TimedLoop& loop : loops) passes.push_back(passes_of_a_sample(loop));
  std::vector<std::vector<double>> samples(loops.size());
  for (std::uint64_t round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < loops.size(); ++i) {
      if (stop) return {};
      const std::chrono::duration<double, std::nano> passed = time_passes(loops[i], passes[i]);
      samples[i].push_back(passed.count() / static_cast<double>(passes[i] * loops[i].operations));
    }
    done(round + 1);
  }
  std::vector<Times> times;
  for (std::vector<double>& of_loop : samples) times.push_back(times_of(std::move(of_loop)));
  return times;
}

}  // namespace fixproof::measure
