#include "oracle/fast_sine.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

#include "oracle/exact.hpp"
#include "oracle/fast.hpp"
#include "oracle/format.hpp"
#include "oracle/real.hpp"

namespace oracle::fast {
namespace {

constexpr int kFraction = 62;
/// The error bound of every component of four_bytes(), in units of 2^-62: as vectors, entries of
/// the table are off by less than 0.71 each, and each of three products adds less than 4.48.
constexpr std::int64_t kError = 17;

/// The cosine and the sine of an angle in units of 2^-62.
struct Turned {
  std::int64_t cos;
  std::int64_t sin;
};

std::int64_t to_fraction(const Integer& scaled) {
  constexpr int kDigits = 60;
  return rounded(scaled, Integer(1) << (16 + kDigits - kFraction), Rounding::half_up)
      .convert_to<std::int64_t>();
}

using Table = std::array<std::array<Turned, 256>, 4>;

/// Entry [k][byte] is for byte * 2^(8k) ulps; the uppermost byte is signed.
Table make_table() {
  Table table{};
  for (Word place = 0; place < 4; ++place) {
    for (Word byte = 0; byte < 256; ++byte) {
      const Word angle = byte << (8 * place);
      table.at(place).at(byte) = {to_fraction(scaled_cos_of_radians(angle, 60)),
                                  to_fraction(scaled_sin_of_radians(angle, 60))};
    }
  }
  return table;
}

/// a * b in units of 2^-62, for magnitudes up to 1; less than 2 units too low.
std::int64_t product(std::int64_t a, std::int64_t b) {
  constexpr std::int64_t kLow = (std::int64_t{1} << 31) - 1;
  const std::int64_t a1 = a >> 31;
  const std::int64_t b1 = b >> 31;
  return a1 * b1 + ((a1 * (b & kLow) + (a & kLow) * b1) >> 31);
}

/// The rotation by the sum of both angles.
Turned product(Turned a, Turned b) {
  return {product(a.cos, b.cos) - product(a.sin, b.sin),
          product(a.sin, b.cos) + product(a.cos, b.sin)};
}

Turned four_bytes(Word angle) {
  static const Table table = make_table();
  const auto part = [angle](std::size_t place) {
    return table[place][angle >> (8 * place) & 0xff];
  };
  return product(product(part(3), part(2)), product(part(1), part(0)));
}

Word angle_in_16_16(Word angle, int fraction_bits) {
  return static_cast<Word>(signed_ulps(angle, fraction_bits).value() *
                           (std::int64_t{1} << (16 - fraction_bits)));
}

/// Whether both ends of the error interval round to the same value.
bool settled(std::int64_t value, int dropped) {
  const std::int64_t half = std::int64_t{1} << (dropped - 1);
  return (value - kError + half) >> dropped == (value + kError + half) >> dropped;
}

Word nearest(std::int64_t value, int fraction_bits) {
  const int dropped = kFraction - fraction_bits;
  const std::int64_t half = std::int64_t{1} << (dropped - 1);
  return static_cast<Word>(
      fast::wrap(static_cast<std::uint64_t>((value + half) >> dropped), fraction_bits));
}

}  // namespace

Word sin(Word angle, int fraction_bits) {
  const std::int64_t value = four_bytes(angle_in_16_16(angle, fraction_bits)).sin;
  if (!settled(value, kFraction - fraction_bits)) return oracle::sin(angle, fraction_bits);
  return nearest(value, fraction_bits);
}

Word cos(Word angle, int fraction_bits) {
  const std::int64_t value = four_bytes(angle_in_16_16(angle, fraction_bits)).cos;
  if (!settled(value, kFraction - fraction_bits)) return oracle::cos(angle, fraction_bits);
  return nearest(value, fraction_bits);
}

}  // namespace oracle::fast
