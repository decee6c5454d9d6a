// Times from_chars of numbers beside std::from_chars of a double, for the same texts of one kind
// each, in a random order. Checks every result once. Needs no library:
//
//     g++ -std=c++20 -O2 -I. measure/bench/text_bench.cpp -o text_bench && ./text_bench
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "fixed/fixed.hpp"
#include "measure/bench/least_time.hpp"

namespace {

using fixproof::q16_16;
using fixproof::q32_32;
using Texts = std::vector<std::string>;

constexpr std::size_t count = 4096;

template <class Number>
std::errc read(std::string_view text, Number& number) {
  using std::from_chars;
  return from_chars(text.data(), text.data() + text.size(), number).ec;
}

template <class Number>
void read_all(const Texts& texts, std::vector<Number>& numbers) {
  for (std::size_t i = 0; i < count; ++i) read(texts[i], numbers[i]);
  bench::keep(numbers);
}

/// Whether every number is within half an ulp of the double. Every tie is a double, so rounding the
/// text to a double does not take it across one.
template <class Number>
bool are_right(const Texts& texts) {
  const double ulp = std::ldexp(1.0, -Number::fraction_bits);
  for (const std::string& text : texts) {
    double exact = 0;
    Number number;
    if (read(text, exact) != std::errc() || read(text, number) != std::errc()) return false;
    if (std::abs(static_cast<double>(number) - exact) > 0.5 * ulp) return false;
  }
  return true;
}

std::string printed(std::chars_format form, int precision, double x) {
  std::string text(400, '\0');
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x, form, precision).ptr;
  text.resize(static_cast<std::size_t>(end - text.data()));
  return text;
}

/// Texts of numbers of all signs and sizes below `end`.
Texts texts_of(std::chars_format form, int precision, double end) {
  std::mt19937_64 random(54);
  Texts texts;
  while (texts.size() < count) {
    const double share = std::ldexp(static_cast<double>(static_cast<std::int64_t>(random())), -63);
    texts.push_back(printed(form, precision, share * end));
  }
  return texts;
}

/// The same with random digits, more than a double has, and an end.
Texts long_texts(std::size_t digits, const std::string& end = "") {
  Texts texts = texts_of(std::chars_format::fixed, 0, 32000);
  std::mt19937 random(55);
  for (std::string& text : texts) {
    text += '.';
    for (std::size_t i = 0; i < digits; ++i) text += static_cast<char>('0' + random() % 10);
    text += end;
  }
  return texts;
}

bool time_kind(const char* name, const Texts& texts) {
  std::vector<double> doubles(count);
  std::vector<q16_16> words(count);
  std::vector<q32_32> longs(count);
  if (!are_right<q16_16>(texts) || !are_right<q32_32>(texts)) {
    std::printf("%-16s wrong result\n", name);
    return false;
  }
  const auto [of_double, of_word, of_long] = bench::least_times<200>(
      count, [&] { read_all(texts, doubles); }, [&] { read_all(texts, words); },
      [&] { read_all(texts, longs); });
  std::printf("%-16s %-16.14s %6.1f %6.1f %5.2f %6.1f %5.2f\n", name, texts[0].c_str(), of_double,
              of_word, of_word / of_double, of_long, of_long / of_double);
  return true;
}

}  // namespace

int main() {
  std::printf("%-16s %-16s double q16_16 ratio q32_32 ratio\n", "ns per number", "such as");
  bool right = time_kind("integers", texts_of(std::chars_format::fixed, 0, 32000));
  right = time_kind("1 digit", texts_of(std::chars_format::fixed, 1, 100)) && right;
  right = time_kind("3 digits", texts_of(std::chars_format::fixed, 3, 32000)) && right;
  right = time_kind("6 digits", texts_of(std::chars_format::fixed, 6, 32000)) && right;
  right = time_kind("below 1", texts_of(std::chars_format::fixed, 7, 1)) && right;
  right = time_kind("9 digits", texts_of(std::chars_format::fixed, 9, 32000)) && right;
  right = time_kind("exact", texts_of(std::chars_format::fixed, 16, 32000)) && right;
  right = time_kind("exponents", texts_of(std::chars_format::scientific, 5, 32000)) && right;
  right = time_kind("long exponents", texts_of(std::chars_format::scientific, 16, 32000)) && right;
  right = time_kind("25 digits", long_texts(25)) && right;
  right = time_kind("300 digits", long_texts(300)) && right;
  right = time_kind("25 digits, e0", long_texts(25, "e0")) && right;
  return right ? 0 : 1;
}
