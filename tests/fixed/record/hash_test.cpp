// The hash of records. The expected values were computed by a Python program, from the formula in
// docs/recorder.md.
#include "fixed/record/hash.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <random>
#include <string_view>

namespace {

using namespace fixproof;
using Record = std::array<std::uint64_t, 2>;

std::uint64_t hash_of(const Record& record) { return record::hash_words(record.data(), 2); }

/// Returns an addition of 16.16: tag and sum, then the operands.
Record addition(std::int32_t a, std::int32_t b, std::int32_t sum) {
  const auto bits = [](std::int32_t x) { return std::uint64_t{static_cast<std::uint32_t>(x)}; };
  return {bits(sum) << 32 | 0x1e08201, bits(b) << 32 | bits(a)};
}

TEST(RecordHash, HasTheDocumentedValues) {
  EXPECT_EQ(hash_of({0, 0}), 0xa2ea92cfd835386b);
  EXPECT_EQ(hash_of({~std::uint64_t{0}, ~std::uint64_t{0}}), 0x82f01a2fda483e63);
  EXPECT_EQ(hash_of(addition(1, 2, 3)), 0x5a8c0eb87f6f155a);
  constexpr std::array<std::uint64_t, 8> words{1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(record::hash_words(words.data(), words.size()), 0xad274b4589631491);
  constexpr std::string_view name = "collide";
  EXPECT_EQ(record::hash_text(name.data(), name.size()), 0x5aa7a17b7238cdc6);
}

/// A random function would change 32 of 64 bits on average. Operands are small, as in programs, so
/// the upper bits of the words hardly vary, and the keys must make up for that.
TEST(RecordHash, EveryBitOfARecordChangesAboutHalfOfTheHash) {
  std::mt19937_64 random(1994);
  constexpr int records = 2000;
  std::array<int, 128> changed{};
  for (int i = 0; i < records; ++i) {
    const auto a = static_cast<std::int32_t>(random() % 200) - 100;
    const auto b = static_cast<std::int32_t>(random() % 200000) - 100000;
    const Record record = addition(a, b, a + b);
    for (std::size_t bit = 0; bit < changed.size(); ++bit) {
      Record other = record;
      other.at(bit / 64) ^= std::uint64_t{1} << bit % 64;
      changed.at(bit) += std::popcount(hash_of(record) ^ hash_of(other));
    }
  }
  for (std::size_t bit = 0; bit < changed.size(); ++bit) {
    EXPECT_GT(changed.at(bit), 25 * records) << bit;
    EXPECT_LT(changed.at(bit), 39 * records) << bit;
  }
}

/// The hash of a block is a sum. Where two bodies push each other, one number grows by what the
/// other one loses, and a wrong push changes both by the same amount. The sum must change, too,
/// although the results that are multiplied by the same small number stay the same.
TEST(RecordHash, OppositeChangesOfTwoRecordsDoNotCancel) {
  std::mt19937_64 random(386);
  const auto number = [&](std::int32_t size) {
    return static_cast<std::int32_t>(random() % static_cast<std::uint64_t>(2 * size)) - size;
  };
  constexpr std::int32_t step = 1024;
  int cancelled = 0;
  for (int i = 0; i < 100000; ++i) {
    const std::int32_t a = number(1000);
    const std::int32_t b = number(1000);
    const std::int32_t wrong = 1 + number(500) / 2 * 2;
    if (b - a == wrong) continue;  // both changes swap the two numbers
    const std::int32_t product = number(3);
    const std::uint64_t right =
        hash_of(addition(a, step, product)) + hash_of(addition(b, step, product));
    const std::uint64_t other =
        hash_of(addition(a + wrong, step, product)) + hash_of(addition(b - wrong, step, product));
    cancelled += right == other ? 1 : 0;
  }
  EXPECT_EQ(cancelled, 0);
}

}  // namespace
