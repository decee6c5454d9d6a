// Finds the operands whose results are nearest to a tie, of one function in one format:
//
//     find_hard_words FUNCTION FORMAT COUNT
//     find_hard_words FUNCTION FORMAT near
//
// The second form compares every result within 2^-20 ulps of a tie with the oracle. Its status is 1
// if one differs, or if no distance is known.
//
// Tries every word. 64 bits say how near a result is to a tie; of the nearest ones, 334 bits say it
// exactly. Prints a line for each, the nearest first: function, format, operand and result as
// stored integers, and the distance in ulps as a power of two. Ties themselves are left out.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <thread>
#include <vector>

#include "fixed/formats.hpp"
#include "oracle/real_function.hpp"
#include "tests/fixed/functions/functions.hpp"

namespace {

using namespace fixproof;
using Decimal100 = boost::multiprecision::cpp_bin_float_100;

struct HardWord {
  std::int64_t operand = 0;
  std::int64_t distance = 0;  ///< by 64 bits, in units of 2^-40 ulps
};

bool is_nearer(const HardWord& a, const HardWord& b) { return a.distance < b.distance; }

/// Keeps only the `count` nearest ones.
void prune(std::vector<HardWord>& words, std::size_t count) {
  if (words.size() <= count) return;
  std::ranges::nth_element(words, words.begin() + static_cast<std::ptrdiff_t>(count), is_nearer);
  words.resize(count);
}

constexpr std::int64_t unknown_distance = std::numeric_limits<std::int64_t>::max();

/// The distance of a result from a tie in units of 2^-40 ulps, by 64 bits of the C library. For the
/// functions that do not say it: those that the type computes with exact integers, and sin and cos
/// of 8.8 and 16.16. Unknown for all others.
template <class N>
std::int64_t library_distance(oracle::Function function, std::int64_t raw, N /*format*/) {
  using oracle::Function;
  const long double x = std::ldexp(static_cast<long double>(raw), -N::fraction_bits);
  long double value = 0;
  switch (function) {
    case Function::cbrt:
      value = std::cbrt(x);
      break;
    case Function::rsqrt:
      if (raw <= 0) return unknown_distance;
      value = 1 / std::sqrt(x);
      break;
    case Function::reciprocal:
      if (raw == 0) return unknown_distance;
      value = 1 / x;
      break;
    case Function::sin:
      value = std::sin(x);
      break;
    case Function::cos:
      value = std::cos(x);
      break;
    default:
      return unknown_distance;
  }
  const long double ulps = std::ldexp(value, N::fraction_bits);
  return static_cast<std::int64_t>(std::ldexp(std::abs(ulps - std::floor(ulps) - 0.5L), 40));
}

/// The operands `first`, `first + step` and so on, up to the highest word, whose distance is below
/// `limit`. Keeps fewer than 4 * `count` of them, with the `count` nearest. Sets `has_distance` if
/// the distance of a word is known.
template <class N>
std::vector<HardWord> nearest_of(const functions::Named<N>& f, std::size_t count,
                                 std::int64_t limit, std::int64_t first, std::int64_t step,
                                 std::atomic<bool>& has_distance) {
  using limits = std::numeric_limits<typename N::raw_type>;
  std::vector<HardWord> words;
  for (std::int64_t raw = limits::min() + first; raw <= limits::max(); raw += step) {
    detail::last_distance = unknown_distance;
    const N result = f.compute(N::from_raw(static_cast<typename N::raw_type>(raw)), N());
    if (detail::last_distance == unknown_distance) {
      detail::last_distance = library_distance(f.function, raw, N());
    }
    if (detail::last_distance != unknown_distance) has_distance = true;
    if (detail::last_distance >= limit) continue;
    // Limits come from results out of range, whose ties do not matter.
    if (result.raw() == limits::max() || result.raw() == limits::min()) continue;
    words.push_back({raw, detail::last_distance});
    if (words.size() < 4 * count) continue;
    prune(words, count);
    limit = std::ranges::max_element(words, is_nearer)->distance;
  }
  return words;
}

/// The exact distance of a result from a tie in ulps, and its floor.
template <class N>
Decimal100 exact_distance(oracle::Function function, std::int64_t operand) {
  const Decimal100 x = ldexp(Decimal100(operand), -N::fraction_bits);
  const Decimal100 value =
      ldexp(oracle::real_function(function, x, Decimal100(0)), N::fraction_bits);
  return abs(value - floor(value) - 0.5);
}

/// nearest_of() on every processor. Ends the program with status 1 if no distance is known.
template <class N>
std::vector<std::vector<HardWord>> nearest_of_all(const functions::Named<N>& f, std::size_t count,
                                                  std::int64_t limit) {
  const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::vector<HardWord>> found(threads);
  std::atomic<bool> has_distance = false;
  std::vector<std::jthread> workers;
  for (unsigned i = 0; i < threads; ++i) {
    workers.emplace_back(
        [&, i] { found[i] = nearest_of(f, count, limit, i, threads, has_distance); });
  }
  workers.clear();
  if (!has_distance) {
    fmt::print(stderr, "find_hard_words: nothing tells how near {} is to a tie in this format\n",
               f.name);
    std::exit(1);
  }
  return found;
}

/// Compares the results within 2^-20 ulps of a tie with the oracle.
template <class N>
bool compare_near(const functions::Named<N>& f, const char* format) {
  // A sixteenth more, because 64 bits are not exact.
  constexpr std::int64_t limit = (std::int64_t{1} << 20) * 17 / 16;
  constexpr auto all = std::numeric_limits<std::size_t>::max() / 8;
  std::size_t words = 0;
  std::size_t different = 0;
  const auto found = nearest_of_all(f, all, limit);
  detail::quick_bits = 16;  // as in fixed/detail/nearest.hpp, to compare what users call
  for (const auto& part : found) {
    for (const HardWord& word : part) {
      const N x = N::from_raw(static_cast<typename N::raw_type>(word.operand));
      const N want = functions::expected(f.function, x, N(), oracle::Rounding::half_up);
      const N result = f.compute(x, N());
      ++words;
      if (result == want) continue;
      ++different;
      fmt::print("{} {} {}: {} instead of {}\n", f.name, format, word.operand, result.raw(),
                 want.raw());
    }
  }
  fmt::print("{} {}: {} words within 2^-20 ulps of a tie, {} differ\n", f.name, format, words,
             different);
  return different == 0;
}

template <class N>
void find(const functions::Named<N>& f, const char* format, std::size_t count) {
  // 64 bits may put the nearest ones in the wrong order.
  const std::size_t candidates = 4 * count;
  const auto found = nearest_of_all(f, candidates, std::numeric_limits<std::int64_t>::max());
  std::vector<std::pair<Decimal100, std::int64_t>> words;
  for (const auto& part : found) {
    for (const HardWord& word : part) {
      const Decimal100 distance = exact_distance<N>(f.function, word.operand);
      if (distance > ldexp(Decimal100(1), -200)) words.emplace_back(distance, word.operand);
    }
  }
  std::ranges::sort(words, std::greater());
  // Of an odd or even function, the positive operand stands for both.
  words.erase(std::unique(words.begin(), words.end(),
                          [](const auto& a, const auto& b) {
                            return a.first == b.first && a.second == -b.second;
                          }),
              words.end());
  std::ranges::reverse(words);
  words.resize(std::min(words.size(), count));
  for (const auto& [distance, operand] : words) {
    const N x = N::from_raw(static_cast<typename N::raw_type>(operand));
    const N result = functions::expected(f.function, x, N(), oracle::Rounding::half_up);
    fmt::print("{} {} {} {} 2^{:.1f}\n", f.name, format, operand, result.raw(),
               static_cast<double>(log2(distance)));
  }
}

enum class Answer { found, different, unknown };

/// @param count 0 to compare the words near a tie
template <class N>
Answer find_in(std::string_view function, const char* format, std::size_t count) {
  for (const functions::Named<N>& f : functions::unary<N>) {
    if (function != f.name) continue;
    if (count == 0) return compare_near(f, format) ? Answer::found : Answer::different;
    find(f, format, count);
    return Answer::found;
  }
  return Answer::unknown;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> args(argv + 1, argv + argc);
  std::size_t count = 0;
  if (args.size() == 3) std::from_chars(args[2].data(), args[2].data() + args[2].size(), count);
  if (args.size() != 3 || (count == 0 && args[2] != "near")) {
    fmt::print(stderr, "usage: find_hard_words FUNCTION FORMAT (COUNT | near)\n");
    return 2;
  }
  const Answer answer = args[1] == "q8_8"     ? find_in<q8_8>(args[0], "q8_8", count)
                        : args[1] == "q24_8"  ? find_in<q24_8>(args[0], "q24_8", count)
                        : args[1] == "q16_16" ? find_in<q16_16>(args[0], "q16_16", count)
                        : args[1] == "q8_24"  ? find_in<q8_24>(args[0], "q8_24", count)
                        : args[1] == "q2_30"  ? find_in<q2_30>(args[0], "q2_30", count)
                                              : Answer::unknown;
  if (answer == Answer::unknown) {
    fmt::print(stderr, "no function {} in {}; formats are q8_8, q24_8, q16_16, q8_24 and q2_30\n",
               args[0], args[1]);
    return 2;
  }
  return answer == Answer::found ? 0 : 1;
}
