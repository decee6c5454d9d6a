/// Tests bytes in both orders against patterns written by hand, and every number of 16 bits.
#include "fixed/bytes.hpp"

#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace bytes_test {

using namespace fixproof;
constexpr auto little = std::endian::little;
constexpr auto big = std::endian::big;

template <class... Byte>
constexpr auto pattern(Byte... bytes) {
  return std::array{static_cast<std::byte>(bytes)...};
}

/// Whether x becomes these bytes with the highest first, and they become x, in both orders.
template <class Number, std::size_t Count>
constexpr bool is_pattern(Number x, std::array<std::byte, Count> from_highest) {
  static_assert(byte_count<Number> == Count);
  std::array<std::byte, Count> from_lowest{};
  for (std::size_t i = 0; i < Count; ++i) from_lowest[i] = from_highest[Count - 1 - i];
  return to_bytes<big>(x) == from_highest && to_bytes<little>(x) == from_lowest &&
         from_bytes<Number, big>(from_highest) == x && from_bytes<Number, little>(from_lowest) == x;
}

static_assert(is_pattern(q4_4(-1.5), pattern(0xe8)));
static_assert(is_pattern(u0_8(0.5), pattern(0x80)));
static_assert(is_pattern(q8_8(1.5), pattern(0x01, 0x80)));
static_assert(is_pattern(q8_8(-1.5), pattern(0xfe, 0x80)));
static_assert(is_pattern(u8_8(255.25), pattern(0xff, 0x40)));
static_assert(is_pattern(q16_16::from_raw(0x12345678), pattern(0x12, 0x34, 0x56, 0x78)));
static_assert(is_pattern(q16_16(-1.5), pattern(0xff, 0xfe, 0x80, 0x00)));
static_assert(is_pattern(q16_16_trapping(-1), pattern(0xff, 0xff, 0x00, 0x00)));
static_assert(is_pattern(u16_16::from_raw(0xfedcba98), pattern(0xfe, 0xdc, 0xba, 0x98)));
static_assert(is_pattern(q32_32::from_raw(0x0123456789abcdef),
                         pattern(0x01, 0x23, 0x45, 0x67, 0x89, 0xab, 0xcd, 0xef)));
static_assert(is_pattern(q48_16(-1), pattern(0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x00, 0x00)));
static_assert(is_pattern(u0_64::from_raw(0xfedcba9876543210),
                         pattern(0xfe, 0xdc, 0xba, 0x98, 0x76, 0x54, 0x32, 0x10)));
static_assert(noexcept(to_bytes<big>(q16_16())));

TEST(Bytes, TakesArraysAndParts) {
  const std::byte plain[]{std::byte{0x01}, std::byte{0x80}};
  EXPECT_EQ((from_bytes<q8_8, big>(plain)), q8_8(1.5));
  EXPECT_EQ((from_bytes<q8_8, big>(pattern(0x01, 0x80))), q8_8(1.5));
  std::vector<std::byte> file(7);
  file[3] = std::byte{0x02};
  EXPECT_EQ((from_bytes<q16_16, big>(std::span(file).subspan<2, 4>())), q16_16(2));
}

template <class Number, class Bytes>
concept readable = requires(Bytes bytes) {
  from_bytes<Number, big>(bytes);
};
static_assert(readable<q16_16, std::array<std::byte, 4>>);
static_assert(readable<q16_16, std::span<std::byte, 4>>);
static_assert(!readable<q16_16, std::array<std::byte, 3>>);
static_assert(!readable<q16_16, std::array<std::byte, 5>>);
static_assert(!readable<q16_16, std::vector<std::byte>>);
static_assert(!readable<int, std::array<std::byte, 4>>);

TEST(Bytes, EveryNumberOf16Bits) {
  for (int raw = -0x8000; raw <= 0x7fff; ++raw) {
    const auto x = q8_8::from_raw(static_cast<std::int16_t>(raw));
    const auto low = static_cast<std::byte>(raw & 0xff);
    const auto high = static_cast<std::byte>(raw >> 8 & 0xff);
    ASSERT_EQ(to_bytes<little>(x), (std::array{low, high}));
    ASSERT_EQ((from_bytes<q8_8, big>(std::array{high, low})), x);
  }
}

TEST(Bytes, NativeIsTheOrderOfMemory) {
  const q16_16 x = q16_16::from_raw(0x01020304);
  std::array<std::byte, 4> memory{};
  std::memcpy(memory.data(), &x, sizeof x);
  EXPECT_EQ(to_bytes<std::endian::native>(x), memory);
}

}  // namespace bytes_test
