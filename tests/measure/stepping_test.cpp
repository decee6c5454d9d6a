// Tests the errors of stepping on spans worked by hand. One unit is 2^-16.
#include "fixed/fixed.hpp"
#include "measure/stepping/stepping_clocks.hpp"
#include "measure/stepping/stepping_line.hpp"
#include "measure/stepping/stepping_run.hpp"
#include "measure/stepping/stepping_statistics.hpp"
#include "measure/stepping/stepping_times.hpp"
#include "tests/measure/never.hpp"
#include "tests/support/test.hpp"
#include "tests/xsharp/surfaces/strip.hpp"
#include "xsharp/raster/depth_buffer.hpp"

namespace {

using namespace fixproof;

constexpr std::int64_t level = 65536;
constexpr measure::LineFormat narrow{8, 16, 2 * level, 254 * level};
constexpr measure::LineFormat wide{0, 16, 2 * level, 254 * level};
constexpr measure::SpanPlace three_pixels{3, 3 * 65536, 0};
/// From half a pixel left of the first centre to half a pixel right of the second.
constexpr measure::SpanPlace half_in{2, 2 * 65536, 32768};

std::vector<measure::SteppedValue> judged_values(measure::LineRule rule,
                                                 const measure::LineFormat& format,
                                                 const measure::LineEnds& ends,
                                                 const measure::SpanPlace& place) {
  measure::SteppedSpan span;
  measure::judge_line(rule, format, ends, place,
                      measure::line_words(rule, ends, place, format.dropped), span);
  return span.values;
}

void expect_value(const measure::SteppedValue& value, double error_units, double bound_units) {
  EXPECT_NEAR(value.error * 65536, error_units, 1e-9);
  EXPECT_NEAR(value.bound * 65536, bound_units, 1e-9);
  EXPECT_TRUE(value.within);
}

// One level over three pixels is 21845 1/3 units per pixel, rounded to 21845: each step loses a
// third of a unit. Rounding a slope loses at most half a unit.
TEST(SteppedLine, RoundedSlope) {
  const auto values =
      judged_values(measure::LineRule::rounded, wide, {10 * level, 11 * level}, three_pixels);
  ASSERT_EQ(values.size(), 3U);
  expect_value(values[0], 0, 0);
  expect_value(values[1], -1.0 / 3, 0.5);
  expect_value(values[2], -2.0 / 3, 1);
}

// 21845 units are 85.3 words of 256 units, rounded to 85 words, 21760 units per pixel. The bound is
// half a word for the start, plus half a word and half a unit per pixel.
TEST(SteppedLine, NarrowWord) {
  const auto values =
      judged_values(measure::LineRule::rounded, narrow, {10 * level, 11 * level}, three_pixels);
  expect_value(values[1], -85 - 1.0 / 3, 128 + 128.5);
  expect_value(values[2], -170 - 2.0 / 3, 128 + 257);
}

// Going down a level, truncation toward zero adds a third of a unit per step, at most a unit.
TEST(SteppedLine, CutSlope) {
  const auto values =
      judged_values(measure::LineRule::cut, wide, {11 * level, 10 * level}, three_pixels);
  expect_value(values[1], 1.0 / 3, 1);
  expect_value(values[2], 2.0 / 3, 2);
}

// Three units over two pixels, 1.5, round to 2 per pixel. Half a pixel in gives 1 instead of 0.75,
// then 3 instead of 2.25. The bound is half a unit per pixel from the end and half for the product.
TEST(SteppedLine, PreStep) {
  const measure::LineEnds ends{10 * level, 10 * level + 3};
  const auto values = judged_values(measure::LineRule::rounded, wide, ends, half_in);
  expect_value(values[0], 0.25, 0.75);
  expect_value(values[1], 0.75, 1.25);
  // Without the pre-step, the first pixel takes the end's value: 0, then 2. Half a pixel of the
  // slope is 0.75 units, 1 in the bound.
  const auto from_end = judged_values(measure::LineRule::at_end, wide, ends, half_in);
  expect_value(from_end[0], -0.75, 1);
  expect_value(from_end[1], -0.25, 1.5);
}

// 256 words over three pixels: 85, not 85.3. Bound: a word per step, half for the start, one for
// the ends.
TEST(SteppedLine, WholeWords) {
  const auto values =
      judged_values(measure::LineRule::whole_words, narrow, {10 * level, 11 * level}, three_pixels);
  expect_value(values[2], -170 - 2.0 / 3, 3.5 * 256);
}

// 200 levels over 1.5078125 pixels. Doubling both six times gives 12800 / 96.5, which an 8088 would
// compute as 12800 / 96 = 133.3333 instead of 132.6425. With the divisor doubled seven more times,
// to 12352, it loses only half a unit by rounding and half a unit in the product.
TEST(SteppedLine, SteepOnAn8088) {
  const auto values = judged_values(measure::LineRule::i8088, wide, {10 * level, 210 * level},
                                    {2, 65536 + 32768 + 512, 0});
  EXPECT_LE(std::fabs(values[1].error), 1.0 / 65536);
  EXPECT_TRUE(values[1].within);
  EXPECT_DOUBLE_EQ(values[1].bound, 1.0 / 65536);
}

// 1 level over 1.5 pixels and a unit: doubled up to 8192 / 12288.125, where an 8088 uses 12288.
TEST(SteppedLine, DivisorCutByAn8088) {
  const auto values = judged_values(measure::LineRule::i8088, wide, {10 * level, 11 * level},
                                    {2, 65536 + 32768 + 1, 0});
  // 2/3 of a level rounds to 43691 units; the exact value is 43690.22.
  EXPECT_NEAR(values[1].error * 65536, 43691 - 65536.0 * 8192 / 12288.125, 1e-6);
  EXPECT_TRUE(values[1].within);
  EXPECT_LE(values[1].bound, 2.0 / 65536);
}

// A step that is too large violates the bound.
TEST(SteppedLine, AWrongStepIsBeyondTheBound) {
  const measure::LineEnds ends{10 * level, 11 * level};
  xsharp::StepWords words = measure::line_words(measure::LineRule::rounded, ends, three_pixels, 0);
  words.step += 2;
  measure::SteppedSpan span;
  measure::judge_line(measure::LineRule::rounded, wide, ends, three_pixels, words, span);
  EXPECT_TRUE(span.values[0].within);
  EXPECT_FALSE(span.values[1].within);
  span.drawn = span.exact;
  measure::SteppingStatistics statistics;
  statistics.add_errors(three_pixels, span);
  EXPECT_EQ(statistics.beyond.substr(0, 12), "pixel 1 of 3");
  EXPECT_GT(statistics.part_of_bound, 1);
}

// Exact values are floored: a third of a unit below level 11 is level 10.
TEST(SteppedLine, TheExactPictureIsCut) {
  measure::SteppedSpan span;
  const measure::LineEnds ends{11 * level, 11 * level - 1};
  measure::judge_line(measure::LineRule::rounded, wide, ends, three_pixels, {}, span);
  EXPECT_EQ(span.exact, (std::vector<std::int64_t>{11, 10, 10}));
}

TEST(SteppingStatistics, BandsAndWrongPixels) {
  measure::SteppedSpan span;
  span.exact = {1, 1, 2, 2, 3};
  span.drawn = {1, 1, 1, 2, 3};
  measure::SteppingStatistics statistics;
  statistics.add_picture(span, false);
  EXPECT_EQ(statistics.drawn, 5U);
  EXPECT_EQ(statistics.wrong, 1U);
  EXPECT_EQ(statistics.max_error, 1);
  EXPECT_EQ(statistics.bands.exact, 3U);
  EXPECT_EQ(statistics.bands.drawn, 3U);
  EXPECT_EQ(statistics.bands.wrong, 2U) << "the first is too long, the second too short";
  EXPECT_EQ(statistics.bands.widest, 1U);
  EXPECT_EQ(statistics.missed, 0U);
}

TEST(SteppingStatistics, MissedTexels) {
  measure::SteppedSpan span;
  span.exact = {5, 6, 7, 256 + 8};
  span.drawn = {5, 5, 7, 3 * 256 + 7};
  measure::SteppingStatistics statistics;
  statistics.add_picture(span, true);
  EXPECT_EQ(statistics.wanted, 4U);
  EXPECT_EQ(statistics.missed, 2U);
  EXPECT_EQ(statistics.wrong, 2U);
  EXPECT_EQ(statistics.max_error, 2) << "two rows";
  EXPECT_EQ(statistics.bands.wrong, 2U);
}

TEST(SteppingRun, PlacesHaveTheirPixels) {
  for (std::size_t pixels = 1; pixels <= xsharp::longest_span; ++pixels) {
    for (std::uint64_t i = 0; i < 64; ++i) {
      const measure::SpanPlace place = measure::span_place(7, pixels, i);
      ASSERT_EQ(place.pixels, pixels);
      ASSERT_GE(place.distance, 0);
      ASSERT_LT(place.distance, 65536);
      ASSERT_LT(place.centre(pixels - 1), place.units);
      ASSERT_GE(place.centre(pixels), place.units);
      ASSERT_TRUE(place.whole() || i % 8 >= 2);
    }
  }
}

const measure::SteppingStatistics& of_rule(const std::vector<measure::SteppingRow>& rows,
                                           const std::string& rule) {
  for (const measure::SteppingRow& row : rows) {
    if (row.variant.rule == rule) return row.statistics;
  }
  throw std::invalid_argument(rule);
}

// Every value keeps its bound, and some value comes close to it.
TEST(SteppingRun, LinesTakeTheirBounds) {
  for (const measure::SteppingRow& row : measure::measure_stepping_rows(
           measure::line_variants(), 1, 4, never, [](std::uint64_t) {})) {
    EXPECT_EQ(row.statistics.beyond, "") << row.variant.value << ", " << row.variant.rule;
    EXPECT_GT(row.statistics.part_of_bound, 0.9);
    EXPECT_EQ(row.statistics.spans, 4 * 320U);
    EXPECT_EQ(row.statistics.pixels, 4 * 320 * 321 / 2U);
  }
}

// One end of the face is twice as far away. A straight line is off by (√2 - 1) / (√2 + 1) = 0.17157
// of the 255 texels, 43.75. An exact place every sixteenth pixel removes that error.
TEST(SteppingRun, LinearTextureBesideTrueOne) {
  const auto rows = measure::measure_stepping_rows(measure::texture_variants(), 1, 4, never,
                                                   [](std::uint64_t) {});
  for (const measure::SteppingRow& row : rows)
    EXPECT_EQ(row.statistics.beyond, "") << row.variant.rule;
  EXPECT_GT(of_rule(rows, "never (affine)").all.error, 43);
  EXPECT_LT(of_rule(rows, "never (affine)").all.error, 43.75 + 0.63);
  for (const measure::ErrorAndBound& e : of_rule(rows, "every 16th").along)
    EXPECT_LT(e.error, 0.25);
  EXPECT_LT(of_rule(rows, "every pixel").all.error, 0.01);
}

// Normals 60 degrees apart, s from -0.57735 to 0.57735. A straight line is off by at most 62 s^2 /
// 2 = 10.33 levels, a parabola by 62 s^3 / (3 √3) = 2.30. Halfway, linear interpolation gives cos
// 30 of the maximum light, 8.3 levels less.
TEST(SteppingRun, PhongByParabola) {
  const auto rows =
      measure::measure_stepping_rows(measure::phong_variants(), 1, 4, never, [](std::uint64_t) {});
  for (const measure::SteppingRow& row : rows)
    EXPECT_EQ(row.statistics.beyond, "") << row.variant.rule;
  EXPECT_GT(of_rule(rows, "ends alone, linear").all.error, 62 * (1 - std::sqrt(0.75)) - 0.4);
  EXPECT_LT(of_rule(rows, "ends alone, linear").all.error, 10.33 + 0.4);
  EXPECT_GT(of_rule(rows, "quadratic").all.error, 1.5);
  EXPECT_LT(of_rule(rows, "quadratic").all.error, 2.3 + 0.5);
  EXPECT_LT(of_rule(rows, "every pixel").all.error, 0.32);
}

TEST(SteppingRun, EndsWhenStopped) {
  const std::atomic<bool> now{true};
  EXPECT_TRUE(
      measure::measure_stepping_rows(measure::line_variants(), 1, 1, now, [](std::uint64_t) {
      }).empty());
}

/// The words for a rectangle, from the values at its left and right ends.
template <class N>
xsharp::StepWords drawn_words(xsharp::SurfaceKind kind, const measure::LineEnds& ends,
                              std::int32_t pixels) {
  xsharp::Surface surface;
  surface.kind = kind;
  const auto value = [](std::int64_t units) {
    return xsharp::PointValues{0, static_cast<double>(units) / 65536};
  };
  const auto picture = surfaces::strip(pixels, value(ends.from), value(ends.to));
  return surfaces::calls_of<N>(surfaces::scene_of(surface), picture, 320).at(0).one;
}

TEST(SteppedLine, IsWhatTheFillerDraws) {
  for (std::int32_t pixels = 1; pixels <= 320; ++pixels) {
    const measure::SpanPlace place{static_cast<std::size_t>(pixels), std::int64_t{pixels} * 65536,
                                   0};
    const measure::LineEnds ends{5 * level + pixels, 250 * level - 77 * pixels};
    EXPECT_EQ(drawn_words<fixproof::q16_16>(xsharp::SurfaceKind::gouraud16, ends, pixels),
              measure::line_words(measure::LineRule::rounded, ends, place, 0));
    EXPECT_EQ(
        drawn_words<fixproof::q16_16_i386_unrounded>(xsharp::SurfaceKind::gouraud16, ends, pixels),
        measure::line_words(measure::LineRule::cut, ends, place, 0));
    xsharp::StepWords narrow_words =
        measure::line_words(measure::LineRule::rounded, ends, place, 8);
    narrow_words.step &= 0xFFFFU;
    EXPECT_EQ(drawn_words<fixproof::q16_16>(xsharp::SurfaceKind::gouraud8, ends, pixels),
              narrow_words);
  }
}

// An uncleared buffer has two fewer bits and starts where the first picture's depths begin.
TEST(SteppedLine, IsWhatABufferThatIsNotClearedIsFilledBy) {
  using N = fixproof::q16_16;
  xsharp::DepthBuffer buffer(xsharp::DepthBuffering::no_clear);
  buffer.begin(320, 1);
  const xsharp::StepWords nothing = buffer.words(xsharp::Step<N>{});
  for (std::int32_t pixels = 1; pixels <= 320; ++pixels) {
    const measure::SpanPlace place{static_cast<std::size_t>(pixels), std::int64_t{pixels} * 65536,
                                   0};
    const measure::LineEnds ends{5 * level + pixels, 32000 * level - 77 * pixels};
    const auto step = xsharp::step_across(N::from_raw(static_cast<std::int32_t>(ends.from)),
                                          N::from_raw(static_cast<std::int32_t>(ends.to)),
                                          place.units, place.distance);
    xsharp::StepWords words = measure::line_words(measure::LineRule::rounded, ends, place, 10);
    words.start += nothing.start;
    EXPECT_EQ(buffer.words(step), words);
  }
}

// 21845 units are 21.3 words of 1024, rounded to 21 words, 21504 units per pixel. In units of 2^18,
// four depths, the bound is half a word for the start, plus half a word and half a unit per pixel.
TEST(SteppedLine, WordOfABufferThatIsNotCleared) {
  constexpr measure::LineFormat uncleared{10, 18, 0, 32767 * level};
  const auto values =
      judged_values(measure::LineRule::rounded, uncleared, {8 * level, 9 * level}, three_pixels);
  expect_value(values[1], (-341 - 1.0 / 3) / 4, (512 + 512.5) / 4.0);
  expect_value(values[2], (-682 - 2.0 / 3) / 4, (512 + 1025) / 4.0);
}

// The loop, two quotients every eighth pixel, and three values to start a span of 160 pixels.
TEST(SteppingTimes, AddUpToAPixel) {
  const std::vector<measure::SteppingTimes> times{{"texture 8.8", "pixel", {1, 1, 0}},
                                                  {"an exact place", "pixel", {4, 4, 0}},
                                                  {"slope, start and words", "value", {16, 16, 0}}};
  EXPECT_NEAR(measure::nanoseconds_per_pixel("texture, perspective", "every 8th", times).value(),
              1 + 4.0 / 8 + 3 * 16.0 / 160, 1e-12);
  EXPECT_FALSE(measure::nanoseconds_per_pixel("intensity 8.8", "8088", times));
}

// A value's divide and multiply, divided by the ten pixels of the span.
TEST(SteppingClocks, APixelHasItsShareOfTheSpan) {
  const std::vector<measure::SetupClocks> setups{{x86model::Cpu::i386, {100, 110}, {50, 60}}};
  const auto costs = measure::measure_pixel_costs(setups);
  ASSERT_EQ(costs.size(), 5U);
  for (const measure::PixelCost& cost : costs) {
    EXPECT_NEAR(cost.of_span[0].min - cost.pixel.min, 15.0 * cost.values, 1e-9) << cost.loop;
    EXPECT_NEAR(cost.of_span[0].max - cost.pixel.max, 17.0 * cost.values, 1e-9) << cost.loop;
  }
  EXPECT_EQ(costs.back().values, 2) << "a texture has two coordinates";
}

// With a divide of 200 clocks, two per pixel take 400; the loop takes fewer than 30 by Intel's
// tables.
TEST(SteppingClocks, ClaimsAreJudged) {
  const auto claims = measure::judge_stepping_claims({{x86model::Cpu::i386, {200, 200}, {50, 50}}});
  ASSERT_EQ(claims.size(), 3U);
  ASSERT_EQ(claims[0].figures.size(), 2U);
  // Two MOVs to memory of 2 clocks and INC 2, against STOSB 4. Then 42 clocks per pixel against 19.
  EXPECT_EQ(claims[0].figures[0].measured.min, 6.0 / 4);
  EXPECT_EQ(claims[0].figures[0].measured.max, 6.0 / 4);
  EXPECT_EQ(claims[0].figures[0].verdict, measure::ClaimVerdict::does_not_hold);
  EXPECT_NEAR(claims[0].figures[1].measured.min, 42.0 / 19, 1e-9);
  EXPECT_EQ(measure::verdict_on(claims[0]), measure::ClaimVerdict::in_part);
  for (const std::size_t i : {1U, 2U}) ASSERT_EQ(claims[i].figures.size(), 1U) << claims[i].text;
  EXPECT_EQ(measure::verdict_on(claims[2]), measure::ClaimVerdict::holds);
  EXPECT_GT(claims[2].figures[0].measured.min, 400.0 / 30);
}

}  // namespace
