/// @file
/// Numbers as bytes in a defined order, for files and networks.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "fixed/number.hpp"
#include "fixed/policy.hpp"
#include "fixed/traits.hpp"

namespace fixproof {

/// The number of bytes that a Number takes: the size of its stored integer.
template <any_number Number>
inline constexpr std::size_t byte_count = sizeof(typename Number::raw_type);

namespace detail {

/// How far the byte at `index` lies above the lowest bit, for an integer of `count` bytes.
template <std::endian Order>
constexpr int shift_of_byte(std::size_t index, std::size_t count) noexcept {
  static_assert(Order == std::endian::little || Order == std::endian::big,
                "the order of bytes is std::endian::little or std::endian::big");
  return static_cast<int>(8 * (Order == std::endian::little ? index : count - 1 - index));
}

}  // namespace detail

/// The stored integer of x as two's complement bytes in the given order, the same on every machine.
///
///     constexpr auto bytes = to_bytes<std::endian::big>(q16_16(-1.5));  // ff fe 80 00
///     static_assert(bytes.size() == 4 && bytes[1] == std::byte{0xfe});
///
/// @tparam Order std::endian::little or std::endian::big
template <std::endian Order, class Raw, int Point, policy Rules>
[[nodiscard]] constexpr std::array<std::byte, sizeof(Raw)> to_bytes(
    number<Raw, Point, Rules> x) noexcept {
  const auto bits = static_cast<std::uint64_t>(x.raw());
  std::array<std::byte, sizeof(Raw)> bytes{};
  for (std::size_t i = 0; i < sizeof(Raw); ++i) {
    bytes[i] = static_cast<std::byte>(bits >> detail::shift_of_byte<Order>(i, sizeof(Raw)) & 0xff);
  }
  return bytes;
}

/// The number that to_bytes() of the same order made these bytes of. Every pattern is a number.
///
/// An array of the right size converts to the span. Of a longer span, take `first<Size>()` or
/// `subspan<At, Size>()`.
///
///     constexpr std::array file{std::byte{0x80}, std::byte{1}, std::byte{7}};
///     static_assert(from_bytes<q8_8, std::endian::little>(std::span(file).first<2>()) ==
///     q8_8(1.5));
///
/// @tparam Number the type of the result
/// @tparam Order  std::endian::little or std::endian::big
template <any_number Number, std::endian Order>
[[nodiscard]] constexpr Number from_bytes(
    std::span<const std::byte, byte_count<Number>> bytes) noexcept {
  using raw = typename Number::raw_type;
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < sizeof(raw); ++i) {
    bits |= std::to_integer<std::uint64_t>(bytes[i])
            << detail::shift_of_byte<Order>(i, sizeof(raw));
  }
  return Number::from_raw(static_cast<raw>(bits));
}

}  // namespace fixproof
