/// Compares 10^7 results of each function in four formats of 64 bits with MPFR. One function takes
/// minutes; FIXPROOF_STREAMS=3/20 selects the third of twenty parts of each.
#include <iostream>

#include "tests/fixed/functions/long_words.hpp"
#include "verify/cases/plan.hpp"

namespace many_long_words_test {
namespace {

using long_words::Format;
using long_words::Name;
using long_words::Word;

const std::array formats{long_words::format_of<fixproof::q32_32>("q32_32"),
                         long_words::format_of<fixproof::q48_16>("q48_16"),
                         long_words::format_of<fixproof::q16_48>("q16_48"),
                         long_words::format_of<fixproof::u32_32>("u32_32")};

constexpr std::uint64_t all = 10'000'000;
/// Random operands of a seed of their own, so that parts do not depend on each other.
constexpr std::uint64_t per_block = 1000;

class ManyLongWords : public testing::TestWithParam<std::tuple<Format, Name>> {};

TEST_P(ManyLongWords, AreThoseOfMpfr) {
  const auto& [format, name] = GetParam();
  const char* const asked = std::getenv("FIXPROOF_STREAMS");
  const fixproof::cases::Shard part =
      fixproof::cases::parse_shard(asked != nullptr ? asked : "1/1");
  long_words::Comparison comparison(format);
  for (std::uint64_t block = part.index - 1; block < all / per_block; block += part.count) {
    long_words::Random word(format.format, block);
    for (std::uint64_t i = 0; i < per_block; ++i) {
      const Word x = word();
      const Word y = word();
      ASSERT_NO_FATAL_FAILURE(comparison.compare(name, x, y));
    }
  }
  std::cout << format.name << ' ' << name.name << ": " << comparison.count()
            << " results compared\n";
}

INSTANTIATE_TEST_SUITE_P(All, ManyLongWords,
                         testing::Combine(testing::ValuesIn(formats),
                                          testing::ValuesIn(long_words::names)),
                         [](const auto& one) {
                           return std::string(std::get<0>(one.param).name) + "_" +
                                  std::get<1>(one.param).name;
                         });

}  // namespace
}  // namespace many_long_words_test
