#include "measure/accuracy/pixel_error.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "fixed/fixed.hpp"
#include "verify/cases/draw.hpp"

namespace fixproof::measure {

namespace {

constexpr std::int64_t units_per_one = 65536;
/// Distances from 1 to 32768: fifteen octaves.
constexpr int octave_count = 15;

/// The largest x on the page at distance `z`, both in units.
std::int32_t edge(const PageProjection& page, std::int32_t z) {
  return static_cast<std::int32_t>(std::int64_t{page.half_width} * z / std::abs(page.constant));
}

/// The signed error of the point x at distance z, in pixels to the right. The product of a drawn
/// word and the distance fits in 64 bits.
template <class N>
double pixels_off(const PageProjection& page, std::int32_t x, std::int32_t z) {
  const N depth = N::from_raw(-z);
  const auto quotient = fixproof::try_divide(N::from_raw(x), depth);
  // No divide faults, because |z| is at least 1 and |x| is less than |z|.
  const N drawn = *quotient * N(page.constant);
  const std::int64_t off =
      std::int64_t{drawn.raw()} * depth.raw() - std::int64_t{x} * page.constant * units_per_one;
  return static_cast<double>(off) / (static_cast<double>(depth.raw()) * units_per_one);
}

using ErrorOf = double(const PageProjection& page, std::int32_t x, std::int32_t z);

DistanceOctave octave(ErrorOf error_of, const PageProjection& page, std::uint64_t key, int exponent,
                      std::uint64_t cases, const std::atomic<bool>& stop) {
  DistanceOctave o{.nearest = 1 << exponent};
  const auto first = static_cast<std::int32_t>(o.nearest * units_per_one);
  double sum = 0;
  std::uint64_t half_pixel_errors = 0;
  for (std::uint64_t i = 0; i < cases && !stop; ++i) {
    cases::Draw draw(key, i);
    const auto z = first + static_cast<std::int32_t>(draw.below(static_cast<std::uint64_t>(first)));
    const std::int32_t most = edge(page, z);
    const auto x = static_cast<std::int32_t>(draw.below(2 * static_cast<std::uint64_t>(most) + 1));
    const double error = std::fabs(error_of(page, x - most, z));
    o.max = std::max(o.max, error);
    sum += error;
    half_pixel_errors += error >= 0.5 ? 1 : 0;
  }
  o.mean = sum / static_cast<double>(cases);
  o.half = static_cast<double>(half_pixel_errors) / static_cast<double>(cases);
  return o;
}

/// Whether no point at distances from `whole` to `whole` + 1 can be half a pixel off. Truncating
/// the divisor moves a point outward by at most half_width / whole, and rounding the quotient adds
/// at most one of its units.
bool bounded_below_half(const PageProjection& page, std::int32_t whole) {
  const std::int64_t off =
      page.half_width * units_per_one + std::int64_t{std::abs(page.constant)} * whole;
  return 2 * off < whole * units_per_one;
}

/// The distance from which no point is half a pixel off. An 8088 divides by the whole part of the
/// distance, so the worst distance is just below the next whole one. At that distance, moving a
/// point toward the middle by `whole` units lowers its quotient by one unit. That point has the
/// same rounding and a smaller error, so testing `whole` points at the edge of the page is enough.
std::int32_t safe_distance(ErrorOf error_of, const PageProjection& page,
                           const std::atomic<bool>& stop) {
  for (std::int32_t whole = 32767; whole > 0 && !stop; --whole) {
    if (bounded_below_half(page, whole)) continue;
    const auto z = static_cast<std::int32_t>(whole * units_per_one + (units_per_one - 1));
    const std::int32_t most = edge(page, z);
    for (std::int32_t x = most; x > most - whole && x > 0; --x) {
      if (std::max(std::fabs(error_of(page, x, z)), std::fabs(error_of(page, -x, z))) >= 0.5)
        return whole + 1;
    }
  }
  return 1;
}

}  // namespace

std::vector<PixelErrors> measure_pixel_errors(const PageProjection& page, std::uint64_t seed,
                                              std::uint64_t cases, const std::atomic<bool>& stop) {
  using namespace fixproof;
  std::vector<PixelErrors> all;
  for (const auto& [name, error_of] : std::initializer_list<std::pair<const char*, ErrorOf*>>{
           {"q16_16_i8088", pixels_off<q16_16_i8088>},
           {"q16_16_i8088_unrounded", pixels_off<q16_16_i8088_unrounded>},
           {"q16_16_i386", pixels_off<q16_16_i386>},
           {"q16_16_i386_unrounded", pixels_off<q16_16_i386_unrounded>}}) {
    PixelErrors& errors = all.emplace_back(
        PixelErrors{.name = name, .octaves = {}, .safe_from = safe_distance(error_of, page, stop)});
    for (int exponent = 0; exponent < octave_count; ++exponent) {
      const std::uint64_t key = cases::mix(seed) + static_cast<std::uint64_t>(exponent);
      errors.octaves.push_back(octave(error_of, page, key, exponent, cases, stop));
    }
  }
  return all;
}

}  // namespace fixproof::measure
