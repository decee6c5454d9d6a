/// @file
/// Times of programs that need no library, so that one command compiles them with any compiler and
/// flags.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <limits>

namespace bench {

/// Keeps what `value` refers to, and all memory, from being optimised away.
template <class T>
void keep(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

/// Each contender's least time of a call, in nanoseconds per element. They take turns in every
/// round, because the clock of a processor changes.
template <std::size_t rounds, class... Runs>
auto least_times(std::size_t elements, const Runs&... runs) {
  std::array<double, sizeof...(Runs)> least{};
  least.fill(std::numeric_limits<double>::infinity());
  for (std::size_t round = 0; round < rounds; ++round) {
    std::size_t i = 0;
    const auto time = [&](const auto& run) {
      const auto start = std::chrono::steady_clock::now();
      run();
      const std::chrono::duration<double, std::nano> passed =
          std::chrono::steady_clock::now() - start;
      least[i] = std::min(least[i], passed.count() / static_cast<double>(elements));
      ++i;
    };
    (time(runs), ...);
  }
  return least;
}

}  // namespace bench
