/// Sines and cosines of many angles: what the functions of one angle give, on every path that this
/// processor has.
#include "fixed/batch_radian.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "fixed/fixed.hpp"

namespace {

using namespace fixed;

/// One way to calculate a batch; it may leave out a rest that is less than a block.
template <int F>
struct way {
  using raw = detail::raw_t<F>;
  std::string name;
  std::function<std::size_t(const raw*, raw*, std::size_t, std::uint64_t)> sines;
  std::function<std::size_t(const raw*, raw*, raw*, std::size_t)> both;
};

template <int F>
std::vector<way<F>> ways() {
  std::vector<way<F>> all;
#if defined(FIXED_BATCH_X86)
  if (batch::has(batch::path::avx2)) {
    all.push_back({"avx2", detail::radian_avx2::sines<F>, detail::radian_avx2::both<F>});
  }
  if (batch::has(batch::path::avx512)) {
    all.push_back({"avx512", detail::radian_avx512::sines<F>, detail::radian_avx512::both<F>});
  }
#endif
  all.push_back({"best",
                 [](const auto* angles, auto* results, std::size_t count, std::uint64_t ahead) {
                   detail::all_sines<F>(batch::best(), angles, results, count, ahead);
                   return count;
                 },
                 [](const auto* angles, auto* cosines, auto* sines, std::size_t count) {
                   detail::all_of_both<F>(batch::best(), angles, cosines, sines, count);
                   return count;
                 }});
  return all;
}

/// Enough that some hundred blocks have a doubtful lane: a lane is one in 2^12.
template <int F>
std::vector<detail::raw_t<F>> many_angles() {
  std::mt19937 random(16);
  std::vector<detail::raw_t<F>> angles(100'003);
  for (auto& angle : angles) {
    const auto word = static_cast<std::int32_t>(random());
    angle = static_cast<detail::raw_t<F>>(word >> (random() % 4 == 0 ? random() % 32 : 0));
  }
  return angles;
}

template <int F>
void expect_same_bits() {
  using raw = detail::raw_t<F>;
  const std::vector<raw> angles = many_angles<F>();
  for (const way<F>& w : ways<F>()) {
    std::vector<raw> results(angles.size());
    std::vector<raw> cosines(angles.size());
    for (const std::uint64_t ahead : {std::uint64_t{0}, detail::quarter_turn}) {
      const std::size_t done = w.sines(angles.data(), results.data(), angles.size(), ahead);
      ASSERT_GT(done + 16, angles.size()) << w.name;
      for (std::size_t i = 0; i < done; ++i) {
        ASSERT_EQ(results[i], detail::nearest_sine<F>(angles[i], ahead)) << w.name << angles[i];
      }
    }
    const std::size_t done = w.both(angles.data(), cosines.data(), results.data(), angles.size());
    ASSERT_GT(done + 16, angles.size()) << w.name;
    for (std::size_t i = 0; i < done; ++i) {
      ASSERT_EQ(results[i], detail::nearest_sine<F>(angles[i], 0)) << w.name << angles[i];
      ASSERT_EQ(cosines[i], detail::nearest_sine<F>(angles[i], detail::quarter_turn)) << w.name;
    }
  }
}

TEST(BatchRadian, SameBitsAsOneByOne) {
  expect_same_bits<16>();
  expect_same_bits<8>();
}

template <class Number>
std::vector<Number> numbers(std::size_t count) {
  std::vector<Number> all;
  for (std::size_t i = 0; i < count; ++i) {
    all.push_back(Number::from_raw(static_cast<typename Number::raw_type>(7919 * i + 0x01faf7eb)));
  }
  return all;
}

/// Nothing beyond the shorter is read or written, whatever the length.
template <class Number>
void expect_every_length() {
  const Number untouched = Number::from_raw(77);
  for (std::size_t count = 0; count < 70; ++count) {
    const std::vector<Number> angles = numbers<Number>(count);
    std::vector<Number> sines(count + 3, untouched);
    std::vector<Number> cosines(count + 3, untouched);
    batch::sin(angles, sines);
    batch::cos(angles, cosines);
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(sines[i], fixed::sin(angles[i]));
      ASSERT_EQ(cosines[i], fixed::cos(angles[i]));
    }
    for (std::size_t i = count; i < count + 3; ++i) {
      ASSERT_EQ(sines[i], untouched);
      ASSERT_EQ(cosines[i], untouched);
    }
  }
}

TEST(BatchRadian, EveryLength) {
  expect_every_length<q16_16>();
  expect_every_length<q8_8_saturating>();
}

TEST(BatchRadian, InPlace) {
  const std::vector<q16_16> angles = numbers<q16_16>(50'000);
  std::vector<q16_16> sines = angles;
  batch::sin(sines, sines);
  std::vector<q16_16> cosines_there = angles;
  std::vector<q16_16> sines_elsewhere(angles.size());
  batch::sin_cos(cosines_there, cosines_there, sines_elsewhere);
  std::vector<q16_16> sines_there = angles;
  std::vector<q16_16> cosines_elsewhere(angles.size());
  batch::sin_cos(sines_there, cosines_elsewhere, sines_there);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto [cos, sin] = fixed::sin_cos(angles[i]);
    ASSERT_EQ(sines[i], sin);
    ASSERT_EQ(sines_elsewhere[i], sin);
    ASSERT_EQ(sines_there[i], sin);
    ASSERT_EQ(cosines_there[i], cos);
    ASSERT_EQ(cosines_elsewhere[i], cos);
  }
}

}  // namespace
