/// @file
/// Numbers of a type that is known at run time. Operands, loops and comparisons that use them are
/// compiled once; of each number type, a test compiles only the operations.
#pragma once

#include <bit>

#include "tests/fixed/batch/expected.hpp"
#include "tests/support/test.hpp"

namespace batch_test {

using Report = fixproof::batch::report;
using Options = fixproof::batch::options;

/// The stored integer of a number of any type of up to 63 bits, or 64 with a sign.
using Word = std::int64_t;
using Words = std::vector<Word>;

/// A number type at run time.
struct Type {
  std::size_t size;
  bool is_signed;
  int fraction_bits;
  fixproof::policy rules;

  template <class N>
  static constexpr Type of() {
    return {sizeof(N), std::is_signed_v<typename N::raw_type>, N::fraction_bits, N::rules};
  }
  [[nodiscard]] int bits() const { return static_cast<int>(8 * size); }
  [[nodiscard]] Word highest() const {
    return std::numeric_limits<Word>::max() >> (64 - bits() - (is_signed ? 0 : 1));
  }
  [[nodiscard]] Word lowest() const { return is_signed ? -highest() - 1 : 0; }
};

inline std::ostream& operator<<(std::ostream& out, const Type& type) {
  constexpr std::array roundings{"half_up",  "half_away", "floor",
                                 "truncate", "half_even", "ceiling"};
  constexpr std::array ranges{"wraps", "saturates", "traps"};
  constexpr std::array faults{"none", "zero_divisor", "unsigned_quotient", "signed_quotient"};
  const auto name = [](const auto& names, auto rule) {
    return names.at(static_cast<std::size_t>(rule));
  };
  const fixproof::policy& rules = type.rules;
  return out << (type.is_signed ? "signed " : "unsigned ") << type.bits() << " bits, "
             << type.fraction_bits << " after the point, " << name(ranges, rules.range)
             << ", multiply " << name(roundings, rules.multiply) << ", divide "
             << name(roundings, rules.divide) << " by the "
             << (rules.divisor == fixproof::divisor_width::full ? "full" : "whole part of the")
             << " divisor, fault " << name(faults, rules.fault);
}

/// Returns make(std::type_identity<N>()) of each type N of a list.
template <class... N, class Make>
auto of_each(testing::Types<N...> /*list*/, const Make& make) {
  return std::vector{make(std::type_identity<N>())...};
}

template <class N>
N number_of(Word word) {
  return N::from_raw(static_cast<typename N::raw_type>(word));
}

/// What the address of a column means to a batch.
template <class N>
std::span<const N> numbers(const void* from, std::size_t count) {
  return {static_cast<const N*>(from), count};
}
template <class N>
std::span<N> numbers(void* to, std::size_t count) {
  return {static_cast<N*>(to), count};
}

/// Numbers in memory between guards. Without words, they are noise.
class Column {
 public:
  /// @param before the number of guards in front, for other alignments
  Column(const Type& type, std::size_t count, std::size_t before = 1)
      : type_(type), before_(before), bytes_((before + count + 1) * type.size, noise) {}
  /// Takes the words modulo the range of the type.
  Column(const Type& type, const Words& words, std::size_t before = 1)
      : Column(type, words.size(), before) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      auto word = static_cast<std::uint64_t>(words[i]);
      if constexpr (std::endian::native == std::endian::big) word <<= 64 - type.bits();
      std::memcpy(at(i), &word, type.size);
    }
  }

  [[nodiscard]] std::size_t size() const { return bytes_.size() / type_.size - before_ - 1; }
  [[nodiscard]] std::byte* at(std::size_t i) { return &bytes_[(before_ + i) * type_.size]; }
  [[nodiscard]] const std::byte* at(std::size_t i) const {
    return &bytes_[(before_ + i) * type_.size];
  }
  [[nodiscard]] Word operator[](std::size_t i) const {
    std::uint64_t word = 0;
    std::memcpy(&word, at(i), type_.size);
    const int unused = 64 - type_.bits();
    if constexpr (std::endian::native == std::endian::little) word <<= unused;
    return type_.is_signed ? static_cast<Word>(word) >> unused : static_cast<Word>(word >> unused);
  }
  /// Whether only the last guard in front and the one behind are noise, as they were.
  [[nodiscard]] bool intact() const {
    const auto is_noise = [](std::byte b) { return b == noise; };
    return std::all_of(at(0) - type_.size, at(0), is_noise) &&
           std::all_of(at(size()), at(size()) + type_.size, is_noise);
  }

 private:
  static constexpr std::byte noise{0x5a};
  Type type_;
  std::size_t before_;
  std::vector<std::byte> bytes_;
};

/// Whether the first results are the expected ones, and nothing is written around the column.
inline testing::AssertionResult same(const Column& got, const Column& want, std::size_t count) {
  if (!got.intact()) return testing::AssertionFailure() << "writes outside its output";
  const auto bytes = static_cast<std::size_t>(want.at(count) - want.at(0));
  if (std::memcmp(got.at(0), want.at(0), bytes) == 0) return testing::AssertionSuccess();
  std::size_t i = 0;
  while (got[i] == want[i]) ++i;
  return testing::AssertionFailure() << "number " << i << " of " << count << " is raw " << got[i]
                                     << " instead of raw " << want[i];
}
inline testing::AssertionResult same(const Column& got, const Column& want) {
  return same(got, want, want.size());
}

/// operands<N>() of a type N at run time.
inline Words operands(const Type& type, std::size_t count, unsigned seed) {
  const Word one = Word{1} << type.fraction_bits;
  const std::array<Word, 9> special{
      0, 1, -1, type.highest(), type.lowest(), one, -one, type.lowest() + 1, 3};
  const auto digits = static_cast<unsigned>(type.bits() - 1);
  std::mt19937 random(seed);
  Words all(count);
  for (Word& x : all) {
    const auto word = static_cast<std::int32_t>(random());
    x = random() % 8 == 0 ? special[random() % special.size()]
                          : (word >> (31 - digits)) >> (random() % digits);
  }
  return all;
}

}  // namespace batch_test
