/// Compares batch sines and cosines on every path with the functions of one angle.
#include "fixed/batch/radian.hpp"
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;

/// All paths. The library replaces those that the processor lacks.
constexpr std::array paths{batch::path::portable, batch::path::neon, batch::path::avx2,
                           batch::path::avx512, batch::path::fastest};

/// Enough angles for some hundred blocks with a doubtful lane; one lane in 2^12 is doubtful.
template <class Number>
std::vector<Number> many_angles() {
  std::mt19937 random(16);
  std::vector<Number> angles(100'003);
  for (Number& angle : angles) {
    const auto word = static_cast<std::int32_t>(random());
    angle = Number::from_raw(
        static_cast<typename Number::raw_type>(word >> (random() % 4 == 0 ? random() % 32 : 0)));
  }
  return angles;
}

template <class Number>
void expect_same_bits() {
  const std::vector<Number> angles = many_angles<Number>();
  std::vector<Number> sines;
  std::vector<Number> cosines;
  for (const Number angle : angles) {
    sines.push_back(fixproof::sin(angle));
    cosines.push_back(fixproof::cos(angle));
  }
  for (const batch::path path : paths) {
    std::vector<Number> results(angles.size());
    std::vector<Number> others(angles.size());
    batch::sin(angles, results, path);
    ASSERT_EQ(results, sines) << static_cast<int>(path);
    batch::cos(angles, results, path);
    ASSERT_EQ(results, cosines) << static_cast<int>(path);
    batch::sin_cos(angles, results, others, path);
    ASSERT_EQ(results, sines) << static_cast<int>(path);
    ASSERT_EQ(others, cosines) << static_cast<int>(path);
  }
}

TEST(BatchRadian, SameBitsAsOneByOne) {
  expect_same_bits<q16_16>();
  expect_same_bits<q8_8>();
}

/// The first is doubtful, which short spans leave to the plain loop.
template <class Number>
std::vector<Number> numbers(std::size_t count) {
  std::vector<Number> all;
  for (std::size_t i = 0; i < count; ++i) {
    all.push_back(Number::from_raw(static_cast<typename Number::raw_type>(7919 * i + 0x01faf7eb)));
  }
  return all;
}

/// Expects no read or write beyond the shorter of the two ranges, for every length.
template <class Number>
void expect_every_length(batch::path path) {
  const Number untouched = Number::from_raw(77);
  for (std::size_t count = 0; count < 70; ++count) {
    const std::vector<Number> angles = numbers<Number>(count);
    std::array<std::vector<Number>, 4> results;
    results.fill(std::vector<Number>(count + 3, untouched));
    auto& [sines, cosines, cosines_of_both, sines_of_both] = results;
    batch::sin(angles, sines, path);
    batch::cos(angles, cosines, path);
    batch::sin_cos(angles, sines_of_both, cosines_of_both, path);
    for (std::size_t i = 0; i < count; ++i) {
      const Number sine = fixproof::sin(angles[i]);
      const Number cosine = fixproof::cos(angles[i]);
      ASSERT_EQ(sines[i], sine);
      ASSERT_EQ(sines_of_both[i], sine);
      ASSERT_EQ(cosines[i], cosine);
      ASSERT_EQ(cosines_of_both[i], cosine);
    }
    for (const std::vector<Number>& one : results) {
      for (std::size_t i = count; i < count + 3; ++i) {
        ASSERT_EQ(one[i], untouched) << "path " << static_cast<int>(path) << ", length " << count;
      }
    }
  }
}

TEST(BatchRadian, EveryLength) {
  for (const batch::path path : paths) {
    expect_every_length<q16_16>(path);
    expect_every_length<q8_8_saturating>(path);
  }
}

/// Whether batch::sin accepts Results. It rejects another number type and read-only results.
template <class Results>
concept takes_sines = requires(const std::vector<q16_16>& angles, Results& results) {
  batch::sin(angles, results);
  batch::sin_cos(angles, std::span(results), results);
};
static_assert(takes_sines<std::vector<q16_16>> && takes_sines<std::array<q16_16, 3>>);
static_assert(!takes_sines<const std::vector<q16_16>>);
static_assert(!takes_sines<std::vector<q16_16_saturating>> && !takes_sines<std::vector<int>>);

TEST(BatchRadian, InPlace) {
  const std::vector<q16_16> angles = numbers<q16_16>(50'000);
  std::vector<q16_16> sines = angles;
  batch::sin(sines, sines);
  std::vector<q16_16> cosines_there = angles;
  std::vector<q16_16> sines_elsewhere(angles.size());
  batch::sin_cos(cosines_there, sines_elsewhere, cosines_there);
  std::vector<q16_16> sines_there = angles;
  std::vector<q16_16> cosines_elsewhere(angles.size());
  batch::sin_cos(sines_there, sines_there, cosines_elsewhere);
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto [sin, cos] = fixproof::sin_cos(angles[i]);
    ASSERT_EQ(sines[i], sin);
    ASSERT_EQ(sines_elsewhere[i], sin);
    ASSERT_EQ(sines_there[i], sin);
    ASSERT_EQ(cosines_there[i], cos);
    ASSERT_EQ(cosines_elsewhere[i], cos);
  }
}

}  // namespace
