/// \file
/// Sines and cosines of many angles in radians: the results of fixed/trig.hpp, to the bit, several
/// times as fast where the processor has AVX2, AVX-512 or NEON. Not part of fixed/fixed.hpp.
///
/// Paths are those of fixed/batch.hpp.
#pragma once

#include <algorithm>
#include <array>  // std::data, std::size
#include <concepts>
#include <cstddef>

#include "fixed/detail/batch_targets.hpp"
#include "fixed/detail/radian.hpp"
#include "fixed/detail/radian_targets.hpp"
#include "fixed/math.hpp"
#include "fixed/number.hpp"

/// Functions of many numbers at once.
namespace fixed::batch {

/// results[i] = fixed::sin(angles[i]), for arrays, vectors, spans and the like of numbers of one
/// type. As many as the shorter has; both may be the same, but not overlap otherwise.
///
///     std::vector<fixed::q16_16> angles(1000), sines(1000);
///     fixed::batch::sin(angles, sines);
template <detail::number_range Angles, detail::number_range Results>
requires std::same_as<detail::element_t<Angles>, detail::element_t<Results>>
void sin(const Angles& angles, Results&& results, path use = best()) noexcept {
  constexpr int bits = detail::element_t<Angles>::fraction_bits;
  const std::size_t count = std::min<std::size_t>(std::size(angles), std::size(results));
  detail::all_sines<bits>(use, detail::raws(std::data(angles)), detail::raws(std::data(results)),
                          count, 0);
}

/// As sin(), with fixed::cos.
template <detail::number_range Angles, detail::number_range Results>
requires std::same_as<detail::element_t<Angles>, detail::element_t<Results>>
void cos(const Angles& angles, Results&& results, path use = best()) noexcept {
  constexpr int bits = detail::element_t<Angles>::fraction_bits;
  const std::size_t count = std::min<std::size_t>(std::size(angles), std::size(results));
  detail::all_sines<bits>(use, detail::raws(std::data(angles)), detail::raws(std::data(results)),
                          count, detail::quarter_turn);
}

/// cosines[i] and sines[i] = fixed::sin_cos(angles[i]), as sin() otherwise. The angles may be where
/// one of the results is to be.
template <detail::number_range Angles, detail::number_range Cosines, detail::number_range Sines>
requires std::same_as<detail::element_t<Angles>, detail::element_t<Cosines>> &&
    std::same_as<detail::element_t<Angles>, detail::element_t<Sines>>
void sin_cos(const Angles& angles, Cosines&& cosines, Sines&& sines, path use = best()) noexcept {
  constexpr int bits = detail::element_t<Angles>::fraction_bits;
  const std::size_t count = std::min<std::size_t>(
      std::size(angles), std::min<std::size_t>(std::size(cosines), std::size(sines)));
  detail::all_of_both<bits>(use, detail::raws(std::data(angles)), detail::raws(std::data(cosines)),
                            detail::raws(std::data(sines)), count);
}

}  // namespace fixed::batch
