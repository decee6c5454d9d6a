/// @file
/// The functions of a format of 64 bits, and operands for them.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "fixed/fixed.hpp"
#include "oracle/function_names.hpp"
#include "tests/fixed/functions/mpfr_result.hpp"
#include "tests/support/test.hpp"

namespace long_words {

using mpfr_result::LongFormat;
using oracle::Function;
using Word = std::uint64_t;

template <class N>
Word computed(Function function, Word x_word, Word y_word) {
  using raw = typename N::raw_type;
  const N x = N::from_raw(static_cast<raw>(x_word));
  const N y = N::from_raw(static_cast<raw>(y_word));
#define CASE_OF_ONE(name) \
  case Function::name:    \
    return static_cast<Word>(name(x).raw());
#define CASE_OF_TWO(name) \
  case Function::name:    \
    return static_cast<Word>(name(x, y).raw());
  switch (function) {
    ORACLE_FUNCTIONS_OF_ONE(CASE_OF_ONE)
    ORACLE_FUNCTIONS_OF_TWO(CASE_OF_TWO)
  }
#undef CASE_OF_ONE
#undef CASE_OF_TWO
  throw std::invalid_argument("no such function");
}

struct Format {
  const char* name;
  LongFormat format;
  Word (*compute)(Function function, Word x, Word y);
};

template <class N>
Format format_of(const char* name) {
  return {
      name,
      {N::fraction_bits, std::is_signed_v<typename N::raw_type>, 8 * static_cast<int>(sizeof(N))},
      computed<N>};
}

struct Name {
  Function function;
  const char* name;
  bool has_two;
};
#define NAME_OF_ONE(name) Name{Function::name, #name, false},
#define NAME_OF_TWO(name) Name{Function::name, #name, true},
inline constexpr std::array names{ORACLE_FUNCTIONS_OF_ONE(NAME_OF_ONE)
                                      ORACLE_FUNCTIONS_OF_TWO(NAME_OF_TWO)};
#undef NAME_OF_ONE
#undef NAME_OF_TWO

/// Operands of all sizes: any number, one from -1 to 1, and one next to a multiple of an eighth.
class Random {
 public:
  Random(LongFormat format, std::uint64_t seed) : format_(format), random_(seed) {}

  Word operator()() {
    const int kind = static_cast<int>(random_() % 4);
    if (kind < 2) return sized(64);
    if (kind == 2) return sized(format_.fraction_bits + 1);
    const int places = format_.fraction_bits - 3;
    const Word eighths = random_() % 32;
    return (places >= 0 ? eighths << places : eighths >> -places) + sized(format_.fraction_bits);
  }

 private:
  /// A number with up to that many bits, or its negative.
  Word sized(int bits) {
    if (bits < 1) return 0;
    const Word most = random_() >> (bits >= 64 ? 0 : 64 - bits);
    const Word magnitude = most >> (random_() % static_cast<Word>(bits > 64 ? 64 : bits));
    return random_() % 2 == 0 ? magnitude : 0 - magnitude;
  }

  LongFormat format_;
  std::mt19937_64 random_;
};

/// The multiples of `unit` that are nearest to integers, by its continued fraction, as integers.
inline std::vector<Word> nearest_multiples(mpfr_ptr unit) {
  std::vector<Word> found;
  mpfr_result::Real rest(512);
  mpfr_result::Real whole(512);
  mpfr_set(rest, unit, MPFR_RNDN);
  // Convergents: numerators approximate denominator times the unit.
  Word before = 0;
  Word numerator = 1;
  for (int i = 0; i < 80; ++i) {
    mpfr_floor(whole, rest);
    if (mpfr_cmp_d(whole, 0x1p63) >= 0) break;
    const Word part = mpfr_get_uj(whole, MPFR_RNDN);
    if (part != 0 && numerator > (~Word{0} - before) / part) break;
    const Word next = part * numerator + before;
    before = numerator;
    numerator = next;
    found.push_back(numerator);
    mpfr_sub(rest, rest, whole, MPFR_RNDN);
    if (mpfr_zero_p(mpfr_ptr(rest)) != 0) break;
    mpfr_ui_div(rest, 1, rest, MPFR_RNDN);
  }
  return found;
}

/// Operands that are hard for some function.
inline std::vector<Word> hard_words(LongFormat format) {
  const int places = format.fraction_bits;
  std::vector<Word> words{0};
  // Angles near multiples of an eighth turn, and numbers near multiples of logarithms.
  mpfr_result::Real unit(512);
  const auto add_multiples = [&] {
    mpfr_mul_2si(unit, unit, places, MPFR_RNDN);
    for (const Word word : nearest_multiples(unit)) words.push_back(word);
  };
  for (const int eighth : {1, 2, 3}) {
    mpfr_const_pi(unit, MPFR_RNDN);
    mpfr_div_2si(unit, unit, eighth, MPFR_RNDN);
    add_multiples();
  }
  mpfr_const_log2(unit, MPFR_RNDN);
  add_multiples();
  mpfr_set_ui(unit, 10, MPFR_RNDN);
  mpfr_log2(unit, unit, MPFR_RNDN);
  add_multiples();
  // Powers of two, of ten, whole numbers and eighths.
  for (int i = 0; i < 64; ++i) words.push_back(Word{1} << i);
  for (int i = 0; i < 64; ++i) words.push_back(3 * (Word{1} << i));
  Word ten = 1;
  for (int i = 0; i < 20; ++i, ten *= 10) {
    if (places < 64) words.push_back(ten << places);
  }
  for (Word i = 0; i < 400; ++i) {
    if (places < 64) words.push_back(i << places);
    if (places > 3) words.push_back(i << (places - 3));
  }
  // Operands whose root, cube root or reciprocal root is next to a tie.
  std::mt19937_64 random(7);
  mpfr_result::Real power(512);
  for (int i = 0; i < 2000; ++i) {
    const Word result = random() >> (random() % 64);
    mpfr_set_uj(unit, result, MPFR_RNDN);
    mpfr_add_d(unit, unit, i % 4 == 0 ? 0 : 0.5, MPFR_RNDN);
    mpfr_div_2si(unit, unit, places, MPFR_RNDN);
    for (const int exponent : {2, 3, -2, -1}) {
      mpfr_pow_si(power, unit, exponent, MPFR_RNDN);
      mpfr_mul_2si(power, power, places, MPFR_RNDN);
      if (mpfr_number_p(mpfr_ptr(power)) != 0 && mpfr_cmp_d(power, 0x1p63) < 0) {
        words.push_back(mpfr_get_uj(power, MPFR_RNDN));
      }
    }
  }
  std::vector<Word> all;
  for (const Word word : words) {
    for (const Word near : {word - 1, word, word + 1}) {
      all.push_back(near);
      if (format.is_signed) all.push_back(0 - near);
    }
  }
  return all;
}

/// Powers with a rational result, ties among them, and their neighbours.
inline std::vector<std::pair<Word, Word>> hard_powers(LongFormat format) {
  const int places = format.fraction_bits;
  std::vector<std::pair<Word, Word>> pairs;
  for (const Word root : {1U, 3U, 5U, 7U, 9U, 15U, 21U, 255U, 1023U}) {
    Word power = root;
    for (int q = 0; q < 6 && power != 0; ++q) {
      // power^(1 / 2^q) is the root; a factor of two gives ties.
      for (int twos = 0; twos < 64; ++twos) {
        if (power << twos >> twos != power) break;
        for (const Word p : {1U, 2U, 3U, 5U, 7U, 8U, 31U, 64U}) {
          if (q > places || (places - q < 64 && p << (places - q) >> (places - q) != p)) continue;
          const Word y = places - q < 64 ? p << (places - q) : 0;
          for (const Word x : {(power << twos) - 1, power << twos, (power << twos) + 1}) {
            pairs.emplace_back(x, y);
            if (format.is_signed) pairs.emplace_back(x, 0 - y);
            if (format.is_signed) pairs.emplace_back(0 - x, y);
          }
          pairs.emplace_back(power << twos, y + 1);
        }
      }
      power = power >> 32 == 0 ? power * power : 0;
      if (root == 1 && q > 3) break;
    }
  }
  return pairs;
}

/// Compares results of a format with those of MPFR, and counts those in the domain.
class Comparison {
 public:
  explicit Comparison(const Format& format, mpfr_rnd_t rounding = MPFR_RNDN)
      : format_(format), results_(format.format, rounding) {}

  void compare(const Name& name, Word any_x, Word any_y) {
    const Word x = stored(any_x);
    const Word y = stored(any_y);
    const auto want = results_.of(name.function, x, y);
    if (!want) return;
    ++count_;
    ASSERT_EQ(format_.compute(name.function, x, y), *want)
        << format_.name << ": " << name.name << " of " << std::hex << x << ' ' << y;
  }

  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  /// The stored integer that has the low bits of a word, extended.
  [[nodiscard]] Word stored(Word word) const {
    const int above = 64 - format_.format.bits;
    const Word top = word << above;
    return format_.format.is_signed ? static_cast<Word>(static_cast<std::int64_t>(top) >> above)
                                    : top >> above;
  }

  const Format& format_;
  mpfr_result::Results results_;
  std::size_t count_ = 0;
};

}  // namespace long_words
