/// @file
/// Compares an expression of plain numbers with the same expression of recorded ones, which must
/// give the same bits and make a number of records.
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <optional>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "fixed/record/recorded.hpp"
#include "tests/support/test.hpp"

namespace comparison {

using namespace fixproof;

/// @name A result as text, to compare
/// What makes the text is not inlined: it would be compiled thousands of times.
/// \{
[[gnu::noinline]] inline void add_integer(std::string& text, std::int64_t x) {
  text += std::to_string(x) + ' ';
}
[[gnu::noinline]] inline void add_real(std::string& text, double x) {
  std::array<char, 32> digits{};
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), x).ptr);
  text += ' ';
}
[[gnu::noinline]] inline void add_words(std::string& text, const char* words) { text += words; }

template <class Raw, int F, policy P>
void add(std::string& text, number<Raw, F, P> x) {
  add_integer(text, x.raw());
}
template <class N>
void add(std::string& text, recorded_number<N> x) {
  add_integer(text, x.raw());
}
template <class T>
requires std::is_arithmetic_v<T>
void add(std::string& text, T x) {
  if constexpr (std::is_integral_v<T>) {
    add_integer(text, static_cast<std::int64_t>(x));
  } else {
    add_real(text, static_cast<double>(x));
  }
}
inline void add(std::string& text, const std::string& x) { text += x; }
template <class N>
void add(std::string& text, const std::optional<N>& x) {
  if (!x) return add_words(text, "nothing");
  add(text, *x);
}
template <class N>
void add(std::string& text, const overflowing<N>& x) {
  add(text, x.value);
  if (x.overflow) add_words(text, "overflows");
}
template <class N>
void add(std::string& text, const sin_and_cos<N>& x) {
  add(text, x.sin);
  add(text, x.cos);
}
template <class A, class B>
void add(std::string& text, const std::pair<A, B>& x) {
  add(text, x.first);
  add(text, x.second);
}
/// \}

/// Three operands of one type, plain and recorded, whatever the type.
struct Operands {
  alignas(8) std::array<std::byte, 24> plain;
  alignas(8) std::array<std::byte, 24> recorded;
};

/// A number type at run time, so that the comparison is compiled once.
struct Type {
  int bits;
  bool is_signed;
  int fraction_bits;
  void (*store)(Operands& operands, const std::array<std::int64_t, 3>& raws);

  template <class N>
  static Type of() {
    using Raw = typename N::raw_type;
    return {8 * sizeof(Raw), std::is_signed_v<Raw>, N::fraction_bits, store_as<N>};
  }
  template <class N>
  static void store_as(Operands& operands, const std::array<std::int64_t, 3>& raws) {
    for (std::size_t i = 0; i < raws.size(); ++i) {
      const N plain = N::from_raw(static_cast<typename N::raw_type>(raws[i]));
      const recorded_number<N> recorded(plain);
      std::memcpy(operands.plain.data() + i * sizeof(plain), &plain, sizeof(plain));
      std::memcpy(operands.recorded.data() + i * sizeof(recorded), &recorded, sizeof(recorded));
    }
  }

  /// The stored integer with the low bits of a word.
  [[nodiscard]] std::int64_t raw_of(std::uint64_t word) const {
    const std::uint64_t high = word << (64 - bits);
    return is_signed ? static_cast<std::int64_t>(high) >> (64 - bits)
                     : static_cast<std::int64_t>(high >> (64 - bits));
  }
  /// The ends of the range, and what is special inside.
  [[nodiscard]] std::vector<std::int64_t> edges() const {
    const int digits = is_signed ? bits - 1 : bits;
    const auto high = static_cast<std::int64_t>(~std::uint64_t{0} >> (64 - digits));
    const std::int64_t low = is_signed ? -high - 1 : 0;
    std::vector<std::int64_t> raws{0, 1, low, high, low + 1, high / 3};
    if (fraction_bits < digits) raws.push_back(std::int64_t{1} << fraction_bits);
    return raws;
  }
};

/// Appends the result of an expression of three numbers, which are in memory.
using Call = void (*)(std::string& text, const void* operands);

template <class F, class T>
void call(std::string& text, const void* operands) {
  const T* const x = static_cast<const T*>(operands);
  add(text, F{}(x[0], x[1], x[2]));
}

/// The text of the result, or the message of the exception.
inline std::string outcome(Call call, const void* operands) {
  std::string text;
  try {
    call(text, operands);
  } catch (const std::exception& error) {
    return error.what();
  }
  return text;
}

class Comparison : public testing::Test {
 protected:
  /// Compares the results for the ends of the range and for random operands.
  void compare(const Type& type, const char* name, std::uint64_t records, Call plain,
               Call recorded) {
    std::vector<std::int64_t> raws = type.edges();
    for (int i = 0; i < 3; ++i) raws.push_back(type.raw_of(random_()));
    for (const std::int64_t a : raws) {
      for (const std::int64_t b : raws) {
        const std::int64_t c = raws[random_() % raws.size()];
        Operands operands{};
        type.store(operands, {a, b, c});
        const std::string expected = outcome(plain, operands.plain.data());
        const std::uint64_t before = record::detail::current_left;
        const std::string got = outcome(recorded, operands.recorded.data());
        ASSERT_EQ(got, expected) << name << ' ' << a << ' ' << b << ' ' << c;
        ASSERT_EQ(before - record::detail::current_left, records)
            << name << ' ' << a << ' ' << b << ' ' << c;
      }
    }
  }

 private:
  std::mt19937_64 random_{1994};
};

}  // namespace comparison
