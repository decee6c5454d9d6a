/// Tests that 64 bits decide every function of one number in the formats that variant.hpp counts as
/// tried, and that the results are those of words. An undecided result is a number that no other
/// result is.
///
/// Hours on one core: ./test release -L slow -R ManyCompactWords
#include <atomic>
#include <iostream>
#include <set>
#include <string>
#include <thread>

#include "tests/fixed/functions/compact_words.hpp"

namespace {

using namespace fixproof;
using functions::InBoth;

constexpr std::int64_t none = std::numeric_limits<std::int64_t>::min();

/// The first word from `first` to `last` whose results differ, or `none`.
template <class Bits>
std::int64_t first_difference(const InBoth<Bits>& function, std::int64_t first, std::int64_t last) {
  const unsigned count = std::max(1U, std::thread::hardware_concurrency());
  std::atomic<std::int64_t> different = none;
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < count; ++i) {
    threads.emplace_back([&, i] {
      for (std::int64_t x = first + i; x <= last && different == none; x += count) {
        if (!is_same(function, x, 1)) different = x;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  return different;
}

/// Compares the functions with these names, or all if there are none, for the words that are at
/// most `most` in magnitude.
template <class N>
void expect_same_words(const std::set<std::string>& names, std::int64_t most) {
  using limits = std::numeric_limits<typename N::raw_type>;
  using bits = detail::result_bits<N, N>;
  static_assert(detail::is_tried<bits>);
  for (const InBoth<bits>& function : functions::functions_in_both<bits, rounding::half_up>) {
    const std::string name = function.name;
    if (!names.empty() && !names.contains(name)) continue;
    const std::int64_t first = std::max<std::int64_t>(limits::min(), -most);
    const std::int64_t last = std::min<std::int64_t>(limits::max(), most);
    EXPECT_EQ(first_difference(function, first, last), none) << N::fraction_bits << ' ' << name;
    std::cout << N::fraction_bits << ' ' << name << ": all words to " << most << '\n' << std::flush;
  }
}

constexpr std::int64_t every_word = std::int64_t{1} << 32;

template <class Raw, int... Points>
void expect_same_formats(std::integer_sequence<int, Points...> /*points*/) {
  (expect_same_words<number<Raw, Points + 1>>({}, every_word), ...);
}

TEST(ManyCompactWords, Of16Bits) {
  expect_same_formats<std::int16_t>(std::make_integer_sequence<int, 15>());
  expect_same_formats<std::uint16_t>(std::make_integer_sequence<int, 16>());
}

// Beyond 64, exponentials are constant. Two turns in degrees are all phases but that of 0, because
// a phase is rounded down, and its constant error is less than any part that is dropped. The phases
// of turns have no error.
TEST(ManyCompactWords, Of16And16) { expect_same_words<q16_16>({}, std::int64_t{720} << 16); }

// All magnitudes: the functions take the magnitude first, or are symmetric in each step.
TEST(ManyCompactWords, Of16And16Logarithms) {
  expect_same_words<u16_16>({"log", "log2", "log10"}, every_word);
}
TEST(ManyCompactWords, Of16And16Radians) {
  expect_same_words<u16_16>({"sin", "cos", "tan"}, every_word);
}

}  // namespace
