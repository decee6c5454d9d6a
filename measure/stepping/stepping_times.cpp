#include "measure/stepping/stepping_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "fixed/fixed.hpp"
#include "verify/cases/draw.hpp"
#include "xsharp/normals.hpp"
#include "xsharp/raster/parabola.hpp"
#include "xsharp/raster/span_loops.hpp"
#include "xsharp/raster/step.hpp"
#include "xsharp/ratio.hpp"

namespace fixproof::measure {

namespace {

using N = fixproof::q16_16;
constexpr std::size_t row_pixels = xsharp::longest_span;
/// Spans per pass of the setup loop.
constexpr std::size_t begun_spans = 256;

class TimedRow {
 public:
  explicit TimedRow(std::uint64_t seed) {
    cases::Draw draw(cases::mix(seed), 0);
    for (std::uint32_t* word : {&u_, &du_, &v_, &dv_})
      *word = static_cast<std::uint32_t>(draw.bits());
    for (std::size_t i = 0; i < xsharp::bitmap_texels; ++i) {
      bitmap_.push_back(static_cast<std::uint8_t>(draw.bits()));
    }
    hide();
    for (std::size_t i = 0; i < begun_spans; ++i) {
      from_.at(i) = static_cast<std::int32_t>(draw.below(std::uint64_t{256} << 16U));
      to_.at(i) = static_cast<std::int32_t>(draw.below(std::uint64_t{256} << 16U));
      units_.at(i) = static_cast<std::int64_t>(65536 + draw.below(std::uint64_t{319} * 65536));
      distance_.at(i) = static_cast<std::int64_t>(draw.below(65536));
    }
  }

  void gouraud() {
    loops_.gouraud(pixels_, static_cast<std::uint16_t>(u_), static_cast<std::uint16_t>(du_));
  }
  void gouraud_wide() { loops_.gouraud_wide(pixels_, u_, du_); }
  void texture() { loops_.texture(pixels_, bitmap_, u_, du_, v_, dv_); }
  void quadratic() { xsharp::quadratic(pixels_, {u_, du_, dv_}); }
  /// The cleared buffer lets every pixel pass the test.
  void depth_drawn() {
    buffer_.fill(std::numeric_limits<std::int16_t>::min());
    loops_.depth(pixels_, buffer_, 1, depth_, depth_step);
  }
  void depth_hidden() { loops_.depth(pixels_, hidden_, 1, depth_, depth_step); }
  void begin_spans() {
    for (std::size_t i = 0; i < begun_spans; ++i) {
      begun_.at(i) =
          xsharp::words_of(xsharp::step_across(N::from_raw(from_.at(i)), N::from_raw(to_.at(i)),
                                               units_.at(i), distance_.at(i)),
                           xsharp::dropped_bits);
    }
  }
  /// Computes the two quotients of an exact texture coordinate pair.
  void exact_places() {
    for (std::size_t i = 0; i < begun_spans; ++i) {
      const N depth = N::from_raw(static_cast<std::int32_t>(units_.at(i)));
      begun_.at(i) = {raw(xsharp::ratio(N::from_raw(from_.at(i)), depth)),
                      raw(xsharp::ratio(N::from_raw(to_.at(i)), depth))};
    }
  }
  /// Computes light at a pixel: normalizes a normal and multiplies it by the light.
  void exact_lights() {
    const N two_thirds = N::from_raw(0xAAAB);
    for (std::size_t i = 0; i < begun_spans; ++i) {
      const N part = N::from_raw(static_cast<std::int32_t>(distance_.at(i) / 4));
      const xsharp::Vec3<N> normal = xsharp::unit(xsharp::Vec3<N>{two_thirds, part, two_thirds});
      begun_.at(i).start = raw(normal.x * part + normal.y * two_thirds + normal.z * part);
    }
  }

  /// @throws WrongContender if a timed loop gives a wrong result
  void judge() {
    gouraud();
    expect("8.8", [&](std::uint32_t k) { return (u_ + k * du_) >> 8U & 0xFFU; });
    gouraud_wide();
    expect("16.16", [&](std::uint32_t k) { return (u_ + k * du_) >> 16U & 0xFFU; });
    texture();
    expect("texture", [&](std::uint32_t k) {
      return bitmap_.at(((v_ + k * dv_) >> 8U & 0xFFU) * 256 + ((u_ + k * du_) >> 8U & 0xFFU));
    });
    quadratic();
    expect("quadratic",
           [&](std::uint32_t k) { return (u_ + k * du_ + k * (k - 1) / 2 * dv_) >> 24U; });
    pixels_.fill(0);
    depth_drawn();
    expect("depth, drawn", [](std::uint32_t) { return 1U; });
    for (std::uint32_t k = 0; k < row_pixels; ++k) {
      const auto exact = static_cast<std::int16_t>((depth_ + k * depth_step) >> 8U);
      if (buffer_.at(k) != exact) wrong("depth", k);
    }
    pixels_.fill(0);
    depth_hidden();
    expect("depth, hidden", [](std::uint32_t) { return 0U; });
    begin_spans();
    for (std::size_t i = 0; i < begun_spans; ++i) {
      // Half a unit from the quotient and half a unit from the word.
      const std::int64_t word = static_cast<std::int32_t>(begun_.at(i).step);
      const std::int64_t off =
          word * 256 * units_.at(i) - (std::int64_t{to_.at(i)} - from_.at(i)) * 65536;
      if (std::abs(off) * 2 > units_.at(i) * 257) wrong("slope", i);
    }
  }

 private:
  static constexpr std::uint32_t depth_ = 0x001000;
  static constexpr std::uint32_t depth_step = 0x2345;

  static std::uint32_t raw(N value) { return static_cast<std::uint32_t>(value.raw()); }

  [[noreturn]] static void wrong(const char* what, std::size_t k) {
    throw WrongContender(
        fmt::format("the timed loop of {} gives a wrong value at index {}", what, k));
  }
  template <class Exact>
  void expect(const char* what, const Exact& exact) const {
    for (std::uint32_t k = 0; k < row_pixels; ++k) {
      if (pixels_.at(k) != exact(k)) wrong(what, k);
    }
  }
  void hide() { hidden_.fill(std::numeric_limits<std::int16_t>::max()); }

  xsharp::PlainLoops loops_;
  std::uint32_t u_ = 0;
  std::uint32_t du_ = 0;
  std::uint32_t v_ = 0;
  std::uint32_t dv_ = 0;
  std::vector<std::uint8_t> bitmap_;
  std::array<std::uint8_t, row_pixels> pixels_{};
  std::array<std::int16_t, row_pixels> buffer_{};
  std::array<std::int16_t, row_pixels> hidden_{};
  std::array<std::int32_t, begun_spans> from_{};
  std::array<std::int32_t, begun_spans> to_{};
  std::array<std::int64_t, begun_spans> units_{};
  std::array<std::int64_t, begun_spans> distance_{};
  std::array<xsharp::StepWords, begun_spans> begun_{};
};

struct NamedPass {
  const char* what;
  const char* of;
  void (TimedRow::*pass)();
  std::size_t operations;
};

constexpr std::array passes{
    NamedPass{"intensity 8.8", "pixel", &TimedRow::gouraud, row_pixels},
    NamedPass{"intensity 16.16", "pixel", &TimedRow::gouraud_wide, row_pixels},
    NamedPass{"depth 16.8, drawn", "pixel", &TimedRow::depth_drawn, row_pixels},
    NamedPass{"depth 16.8, hidden", "pixel", &TimedRow::depth_hidden, row_pixels},
    NamedPass{"texture 8.8", "pixel", &TimedRow::texture, row_pixels},
    NamedPass{"quadratic 8.24", "pixel", &TimedRow::quadratic, row_pixels},
    NamedPass{"slope, start and words", "value", &TimedRow::begin_spans, begun_spans},
    NamedPass{"an exact place", "pixel", &TimedRow::exact_places, begun_spans},
    NamedPass{"Phong's light", "pixel", &TimedRow::exact_lights, begun_spans},
};

constexpr double costed_span = 160;

struct Recipe {
  const char* value;
  const char* rule;
  const char* loop;
  int begun;          ///< values in the setup of a span
  const char* exact;  ///< the exact computation, if there is one
  double per_pixel;   ///< per pixel
};
constexpr std::array recipes{
    Recipe{"intensity 8.8", "rounded", "intensity 8.8", 1, "", 0},
    Recipe{"intensity 16.16", "rounded", "intensity 16.16", 1, "", 0},
    Recipe{"depth 16.8", "rounded", "depth 16.8, drawn", 1, "", 0},
    Recipe{"depth 14.8, not cleared", "rounded", "depth 16.8, drawn", 1, "", 0},
    Recipe{"texture 8.8, affine", "rounded", "texture 8.8", 2, "", 0},
    Recipe{"texture, perspective", "every pixel", "texture 8.8", 3, "an exact place", 1},
    Recipe{"texture, perspective", "every 8th", "texture 8.8", 3, "an exact place", 1.0 / 8},
    Recipe{"texture, perspective", "every 16th", "texture 8.8", 3, "an exact place", 1.0 / 16},
    Recipe{"texture, perspective", "never (affine)", "texture 8.8", 2, "", 0},
    Recipe{"Phong", "every pixel", "", 3, "Phong's light", 1},
    Recipe{"Phong", "every 4th", "intensity 16.16", 3, "Phong's light", 1.0 / 4},
    Recipe{"Phong", "quadratic", "quadratic 8.24", 3, "Phong's light", 3 / costed_span},
    Recipe{"Phong", "ends alone, linear", "intensity 16.16", 3, "Phong's light", 2 / costed_span},
};

}  // namespace

std::optional<double> nanoseconds_per_pixel(const std::string& value, const std::string& rule,
                                            const std::vector<SteppingTimes>& times) {
  const auto least = [&](std::string_view what) {
    double ns = 0;
    for (const SteppingTimes& t : times) {
      if (t.what == what) ns = t.times.min;
    }
    return ns;
  };
  for (const Recipe& r : recipes) {
    if (r.value != value || r.rule != rule) continue;
    return least(r.loop) + least(r.exact) * r.per_pixel +
           least("slope, start and words") * r.begun / costed_span;
  }
  return std::nullopt;
}

std::vector<SteppingTimes> time_stepping(std::uint64_t seed, std::uint64_t rounds,
                                         const std::atomic<bool>& stop,
                                         const std::function<void(std::uint64_t)>& timed) {
  TimedRow row(seed);
  row.judge();
  std::vector<TimedLoop> loops;
  for (const NamedPass& pass : passes) {
    loops.push_back({[&row, pass] { (row.*pass.pass)(); }, pass.operations});
  }
  const std::vector<Times> times = time_in_turn(loops, rounds, stop, timed);
  std::vector<SteppingTimes> all;
  for (std::size_t i = 0; i < times.size(); ++i) {
    all.push_back({passes.at(i).what, passes.at(i).of, times[i]});
  }
  return all;
}

}  // namespace fixproof::measure
