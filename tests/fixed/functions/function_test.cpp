/// Tests the functions of real numbers against the oracle, in formats of every width and with
/// fraction bits at both ends.
#include "tests/fixed/functions/functions.hpp"
#include "tests/fixed/functions/hard_words.hpp"
#include "tests/support/each_type.hpp"
#include "tests/support/paths.hpp"

namespace {

using functions::Format;

void expect_nearest(const Format& format, std::span<const functions::Name> names, std::int64_t x,
                    std::int64_t y = 0) {
  for (const auto& [function, name] : names) {
    ASSERT_EQ(format.compute(function, x, y),
              functions::expected(format, function, x, y, oracle::Rounding::half_up))
        << name << " of raw " << x << ' ' << y;
  }
}

/// Stored integers.
class Words {
 public:
  explicit Words(const Format& format) : format_(format) {}

  /// A word of any length, so that small numbers and their negatives occur too.
  std::int64_t word() {
    const auto bits = static_cast<std::int64_t>(random_());
    return format_.raw_of(bits >> (32 + random_() % 32));
  }

  [[nodiscard]] std::vector<std::int64_t> edges() const {
    std::vector<std::int64_t> words;
    const int digits = format_.is_signed ? format_.bits - 1 : format_.bits;
    for (int bit = 0; bit <= digits; ++bit) {
      for (const int off : {-1, 0, 1}) {
        const std::int64_t word = (std::int64_t{1} << bit) + off;
        words.push_back(format_.raw_of(word));
        words.push_back(format_.raw_of(-word));
      }
    }
    return words;
  }

 private:
  const Format& format_;
  std::mt19937_64 random_{1994};
};

const auto every_format = each_type::all<Format>(functions::Formats());

TEST_OF_EACH(EveryFormat, FunctionsOfOneNumberAreNearest, Format, every_format) {
  const auto& names = functions::names_of_one;
  if (type.bits == 8) {
    for (int word = 0; word < 256; ++word) expect_nearest(type, names, type.raw_of(word));
  } else {
    Words words(type);
    for (const std::int64_t x : words.edges()) expect_nearest(type, names, x);
    for (int i = 0; i < 150; ++i) expect_nearest(type, names, words.word());
    // Whole degrees, because some have rational sines.
    for (int degrees = -360; degrees <= 720; degrees += 15) {
      expect_nearest(type, names, type.whole(degrees));
    }
  }
}

TEST_OF_EACH(EveryFormat, FunctionsOfTwoNumbersAreNearest, Format, every_format) {
  const auto& names = functions::names_of_two;
  Words words(type);
  for (int i = 0; i < 250; ++i) {
    const std::int64_t x = words.word();
    // Next to a diagonal, too.
    expect_nearest(type, names, x, i % 4 == 0 ? type.raw_of(x + i % 3) : words.word());
  }
  const std::vector<std::int64_t> edges = words.edges();
  for (std::size_t i = 0; i < edges.size(); i += 5) {
    for (std::size_t k = i % 7; k < edges.size(); k += 7) {
      expect_nearest(type, names, edges[i], edges[k]);
    }
  }
  // Powers, many of them rational.
  for (int i = -12; i <= 12; ++i) {
    for (int k = -12; k <= 12; ++k) {
      expect_nearest(type, names, type.quotient(i, 2), type.quotient(k, 4));
    }
  }
}

TEST(Functions, OfHardWordsAreNearest) {
  functions::for_each_hard_word(
      paths::source("tests/fixed/functions/hard_words.txt"),
      []<class N>(const functions::HardWord& word) {
        const auto format = Format::of<N>();
        const auto& [function, name] = functions::named(functions::names_of_one, word.function);
        EXPECT_EQ(format.compute(function, word.operand, 0), word.result)
            << name << " of raw " << word.operand;
        EXPECT_EQ(functions::expected(format, function, word.operand, 0, oracle::Rounding::half_up),
                  word.result);
      });
}

}  // namespace
