/// Tests that 64 bits decide every function of one number in the formats that variant.hpp counts as
/// tried, and that the results are those of words. Without FIXED_ASSERTIONS, an undecided result is
/// a number that no other result is.
///
/// Ten minutes on one core: ./test release -L slow -R ManyCompactWords
#include <atomic>
#include <iostream>
#include <thread>

#include "tests/fixed/functions/compact_words.hpp"

namespace {

using namespace fixproof;
using functions::InBoth;

constexpr std::int64_t none = std::numeric_limits<std::int64_t>::min();

/// Functions of which some words of 32 bits are out of range, but not most.
bool takes_all_words(const std::string& name) {
  return name.starts_with("log") || name.starts_with("sin_") || name.starts_with("cos_") ||
         name.starts_with("tan") || name == "sin" || name == "cos" || name == "rsqrt";
}

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

template <class N>
void expect_same_words(const std::string& format) {
  using limits = std::numeric_limits<typename N::raw_type>;
  using bits = detail::result_bits<N, N>;
  static_assert(detail::is_tried<bits>);
  for (const InBoth<bits>& function : functions::functions_in_both<bits, rounding::half_up>) {
    // Beyond 64, exponentials are constant, and so are sines of unit triangles beyond 1. Vectors
    // and cube roots need no try: hard_pairs and exact integers show that they are decided.
    constexpr std::int64_t most = std::int64_t{65} << N::fraction_bits;
    const bool all = takes_all_words(function.name);
    const std::int64_t first = all ? limits::min() : std::max<std::int64_t>(limits::min(), -most);
    const std::int64_t last = all ? limits::max() : std::min<std::int64_t>(limits::max(), most);
    EXPECT_EQ(first_difference(function, first, last), none) << format << ' ' << function.name;
    std::cout << format << ' ' << function.name << ": all words\n" << std::flush;
  }
}

template <class Raw, int... Points>
void expect_same_formats(std::integer_sequence<int, Points...> /*points*/) {
  (expect_same_words<number<Raw, Points + 1>>(std::to_string(Points + 1)), ...);
}

TEST(ManyCompactWords, Of16Bits) {
  expect_same_formats<std::int16_t>(std::make_integer_sequence<int, 15>());
  expect_same_formats<std::uint16_t>(std::make_integer_sequence<int, 16>());
}

TEST(ManyCompactWords, Of16And16) { expect_same_words<q16_16>("q16_16"); }

TEST(ManyCompactWords, Of16And16Unsigned) { expect_same_words<u16_16>("u16_16"); }

}  // namespace
