// Replaces tests/fixed/property.hpp where RapidCheck is not available, for example on emulated
// machines. Draws operands of every magnitude from a fixed generator and does not shrink
// counterexamples.
#include <cstdint>
#include <iostream>
#include <random>

#include "tests/fixed/property.hpp"

namespace property {

namespace {

constexpr int cases = 1000;
constexpr int longest_list = 40;

/// The low bits of a word of any magnitude and either sign.
std::int64_t draw(std::mt19937_64& random, int fraction_bits) {
  const auto width = static_cast<int>(random() % static_cast<unsigned>(2 * fraction_bits)) + 1;
  return static_cast<std::int64_t>(random()) >> (64 - width);
}

Raws draw_list(std::mt19937_64& random, int fraction_bits, std::size_t length) {
  Raws raws(length);
  for (std::int64_t& raw : raws) raw = draw(random, fraction_bits);
  return raws;
}

bool failed(const Raws& operands) {
  std::cerr << "Does not hold for the stored integers";
  for (const std::int64_t raw : operands) std::cerr << ' ' << raw;
  std::cerr << '\n';
  return false;
}

}  // namespace

bool holds(int fraction_bits, int operands, const std::function<bool(const Raws&)>& check) {
  std::mt19937_64 random;
  for (int i = 0; i < cases; ++i) {
    const Raws raws = draw_list(random, fraction_bits, static_cast<std::size_t>(operands));
    if (!check(raws)) return failed(raws);
  }
  return true;
}

bool holds_for_lists(int fraction_bits,
                     const std::function<bool(const Raws&, const Raws&)>& check) {
  std::mt19937_64 random;
  for (int i = 0; i < cases; ++i) {
    const Raws a = draw_list(random, fraction_bits, random() % longest_list);
    const Raws b = draw_list(random, fraction_bits, random() % longest_list);
    if (!check(a, b)) {
      failed(a);
      return failed(b);
    }
  }
  return true;
}

bool holds_for_parts(const std::function<bool(bool, std::uint16_t, std::uint64_t)>& check) {
  std::mt19937_64 random;
  for (int i = 0; i < cases; ++i) {
    const auto whole = static_cast<std::uint16_t>(draw(random, 16));
    const std::uint64_t fraction = random();
    for (const bool negative : {false, true}) {
      if (!check(negative, whole, fraction)) return failed({negative ? -whole : whole});
    }
  }
  return true;
}

}  // namespace property
