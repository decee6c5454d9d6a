// Compares the three forms of Phong light (xsharp/raster/phong_row.hpp) with double, by running the
// code that draws them.
//
// The light at a pixel is 64 + 62 (L . n) / |n|. The normal n moves on a straight line between two
// unit normals that are an angle a apart. Let T = tan(a / 2), and let s = -T ... T be proportional
// to the pixels. Then the light is A cos(atan s - c) with |A| <= 1. The second derivative of
// (b + c s) / sqrt(1 + s^2) is at most sqrt(1 + 4 s^2) / (1 + s^2)^2 <= 1, and the third at most
// 3 sqrt(1 + 4 s^4) / (1 + s^2)^3 <= 3. The bound:
//
// - arithmetic, A(k): line_bound() gives the error e of each component, so the direction is off by
//   sqrt(3) e / cos(a / 2). Newton's method rounds each component at most eight times and ends when
//   the square is within four units, plus its own rounding, of 1. The last product rounds three
//   times. The factor 62 applies to all of these;
// - every fourth pixel, or the ends alone: A at the ends of a stretch, the rounding of the steps,
//   and the chord error 62 h^2 / 8, where h is the stretch's part of s;
// - quadratic: a parabola through three values scales their errors by at most 5/4. Its own error is
//   62 / 6 * 3 * 2 H^3 / (3 sqrt 3) = 62 H^3 / (3 sqrt 3), where H is half of s from the first
//   pixel to the last. The rounding of its words counts x and x^2 times.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "fixed/fixed.hpp"
#include "measure/stepping/stepping_line.hpp"
#include "xsharp/normals.hpp"
#include "xsharp/raster/phong_row.hpp"

namespace fixproof::measure {

namespace {

using xsharp::Vec3;

constexpr double light_levels = xsharp::ramp_levels;
constexpr double one_raw = 65536;
constexpr double widest_angle = std::numbers::pi / 3;

enum class PhongStepping { exact, fourth, quadratic, linear };

/// In units of 2^-16.
using RawVector = std::array<std::int64_t, 3>;

struct PhongEnds {
  RawVector from{};
  RawVector to{};
  RawVector light{};
  double angle = 0;

  [[nodiscard]] LineEnds component(std::size_t i) const { return {from.at(i), to.at(i)}; }
};

RawVector raw_of(const Vec3<double>& v) {
  return {std::llround(v.x * one_raw), std::llround(v.y * one_raw), std::llround(v.z * one_raw)};
}

Vec3<double> random_direction(cases::Draw& draw) {
  const auto part = [&] { return (static_cast<double>(draw.below(65537)) - 32768) / 32768; };
  for (;;) {
    const Vec3<double> v{part(), part(), part()};
    const double square = dot(v, v);
    if (square > 0.01 && square <= 1) return xsharp::unit(v);
  }
}

/// Extreme ends have the widest angle, and light perpendicular to the middle normal, where the
/// third derivative is greatest.
PhongEnds choose_normals(Ends which, cases::Draw& draw) {
  const bool extreme = which == Ends::extreme && draw.below(4) != 0;
  const Vec3<double> middle = random_direction(draw);
  Vec3<double> across = cross(middle, random_direction(draw));
  while (dot(across, across) < 0.01) across = cross(middle, random_direction(draw));
  across = xsharp::unit(across);
  const double angle =
      extreme ? widest_angle : widest_angle * static_cast<double>(draw.below(65537)) / 65536;
  const Vec3<double> along = middle * std::cos(angle / 2);
  const Vec3<double> aside = across * std::sin(angle / 2);
  const Vec3<double> light = !extreme ? random_direction(draw) : draw.coin() ? across : middle;
  return {raw_of(along + aside * -1.0), raw_of(along + aside), raw_of(light), angle};
}

/// The exact light in levels, `units` from the left end.
double exact_light(const PhongEnds& ends, const SpanPlace& place, std::int64_t units) {
  const double part = static_cast<double>(units) / static_cast<double>(place.units);
  double product = 0;
  double square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto from = static_cast<double>(ends.from.at(i));
    const double n = from + (static_cast<double>(ends.to.at(i)) - from) * part;
    product += static_cast<double>(ends.light.at(i)) * n;
    square += n * n;
  }
  return xsharp::ramp_dark + light_levels * product / one_raw / std::sqrt(square);
}

/// The computed light of one span.
template <class N>
class PhongLight {
 public:
  PhongLight(LineRule rule, const PhongEnds& ends, const SpanPlace& place)
      : rule_(rule), ends_(ends), place_(place) {
    for (std::size_t i = 0; i < 3; ++i) {
      row_.normal.at(i) = xsharp::step_across(number(ends.from.at(i)), number(ends.to.at(i)),
                                              place.units, place.distance);
    }
    row_.light = {number(ends.light[0]), number(ends.light[1]), number(ends.light[2])};
  }

  [[nodiscard]] const xsharp::PhongRow<N>& row() const { return row_; }

  /// The largest error of row().at() up to pixel k, in levels.
  [[nodiscard]] double bound_to(std::size_t k) const {
    const double s = rounding();
    double component = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto bound = line_bound(rule_, ends_.component(i), place_, 0, k);
      component = std::max(component, static_cast<double>(bound) / 131072 + s);
    }
    const double shortest = std::cos(ends_.angle / 2);
    const double direction = std::numbers::sqrt3 * (component + 8 * s) / shortest;
    const double length = (4 + 3 * s) / 2;
    return light_levels * (direction + length + 3 * s) * 1.001 / one_raw;
  }

  [[nodiscard]] double rounding() const { return rule_ == LineRule::cut ? 1 : 0.5; }
  /// The part of s per pixel.
  [[nodiscard]] double curve_per_pixel() const {
    return 2 * std::tan(ends_.angle / 2) * one_raw / static_cast<double>(place_.units) * 1.001;
  }

 private:
  static N number(std::int64_t raw) { return N::from_raw(static_cast<std::int32_t>(raw)); }

  LineRule rule_;
  const PhongEnds& ends_;
  const SpanPlace& place_;
  xsharp::PhongRow<N> row_{};
};

/// Appends one pixel. @param value with `bits` fraction bits
void add_light(SteppedSpan& out, std::uint32_t value, unsigned bits, double exact, double bound) {
  const double error = static_cast<double>(value) / static_cast<double>(1U << bits) - exact;
  out.values.push_back({error, bound, std::fabs(error) <= bound});
  out.drawn.push_back(static_cast<std::int64_t>(value >> bits & 0xFFU));
  out.exact.push_back(static_cast<std::int64_t>(std::floor(exact)));
}

template <class N>
std::uint32_t raw_word(N value) {
  return static_cast<std::uint32_t>(value.raw());
}

template <class N>
void straight(std::size_t every, const PhongLight<N>& light, const PhongEnds& ends,
              const SpanPlace& place, SteppedSpan& out) {
  light.row().in_lines(
      place.pixels, every, [&](const xsharp::Stretch& stretch, const xsharp::Step<N>& line) {
        const auto [from, to, count] = stretch;
        const double h = light.curve_per_pixel() * static_cast<double>(to - from);
        xsharp::StepWords words = xsharp::words_of(line, 0);
        for (std::size_t k = from; k < from + count; ++k, words.start += words.step) {
          const double chord = k == from || k == to ? 0 : light_levels * h * h / 8;
          const double steps = light.rounding() * static_cast<double>(k - from) / one_raw;
          add_light(out, words.start, 16, exact_light(ends, place, place.centre(k)),
                    light.bound_to(to) + steps + chord);
        }
      });
}

/// The rounding error of fine_ratio() with the numerator n, in units of 2^-24. `rounding` is the
/// error of its divides together, in units of their quotient.
double fine_loss(std::int64_t n, double rounding) {
  unsigned doublings = 0;
  for (; doublings < 8 && std::abs(n) < 8191 * std::int64_t{65536}; ++doublings) n *= 2;
  return rounding * (1U << (8 - doublings));
}

template <class N>
void parabola(const PhongLight<N>& light, const PhongEnds& ends, const SpanPlace& place,
              SteppedSpan& out) {
  const auto last = static_cast<std::int32_t>(place.pixels - 1);
  const N first = light.row().at(0);
  const N middle = light.row().at(std::int64_t{last} * 32768);
  const N end = light.row().at(std::int64_t{last} * 65536);
  const std::int64_t to_middle = std::int64_t{middle.raw()} - first.raw();
  const std::int64_t to_end = std::int64_t{end.raw()} - first.raw();
  const double s = light.rounding();
  const double step_loss = fine_loss(4 * to_middle - to_end, s);
  const double bend_loss = last == 0 ? 0 : fine_loss(2 * (to_end - 2 * to_middle), s + s / last);
  const double half = light.curve_per_pixel() * last / 2;
  const double curve = light_levels * half * half * half / (3 * std::numbers::sqrt3);
  const double through = 1.25 * light.bound_to(place.pixels - 1) + curve;
  xsharp::Parabola p = light.row().parabola(0, place.pixels);
  for (std::size_t k = 0; k < place.pixels; ++k, p.start += p.step, p.step += p.second) {
    const auto x = static_cast<double>(k);
    const double words = (x * step_loss + x * x * bend_loss) / (1 << 24);
    add_light(out, p.start, 24, exact_light(ends, place, place.centre(k)), through + words);
  }
}

template <class N>
void step_phong(LineRule rule, PhongStepping form, const PhongEnds& ends, const SpanPlace& place,
                SteppedSpan& out) {
  const PhongLight<N> light(rule, ends, place);
  switch (form) {
    case PhongStepping::exact:
      for (std::size_t k = 0; k < place.pixels; ++k) {
        add_light(out, raw_word(light.row().at(xsharp::units_of(k))), 16,
                  exact_light(ends, place, place.centre(k)), light.bound_to(k));
      }
      return;
    case PhongStepping::fourth:
      straight(4, light, ends, place, out);
      return;
    case PhongStepping::linear:
      straight(xsharp::longest_span, light, ends, place, out);
      return;
    case PhongStepping::quadratic:
      parabola(light, ends, place, out);
      return;
  }
}

struct PhongRule {
  const char* value;
  const char* name;
  LineRule rule;
  PhongStepping form;
};

constexpr std::array phong_rules{
    PhongRule{"Phong", "every pixel", LineRule::rounded, PhongStepping::exact},
    PhongRule{"Phong", "every 4th", LineRule::rounded, PhongStepping::fourth},
    PhongRule{"Phong", "quadratic", LineRule::rounded, PhongStepping::quadratic},
    PhongRule{"Phong", "ends alone, linear", LineRule::rounded, PhongStepping::linear},
    PhongRule{"Phong, cut", "every pixel", LineRule::cut, PhongStepping::exact},
    PhongRule{"Phong, cut", "every 4th", LineRule::cut, PhongStepping::fourth},
    PhongRule{"Phong, cut", "quadratic", LineRule::cut, PhongStepping::quadratic},
};

}  // namespace

std::vector<SteppingVariant> phong_variants() {
  std::vector<SteppingVariant> variants;
  for (const PhongRule& rule : phong_rules) {
    variants.push_back(
        {rule.value, rule.name, Drawn::level, "normals to 60 degrees apart, any light",
         [rule](const SpanPlace& place, Ends which, cases::Draw draw, SteppedSpan& out) {
           const PhongEnds ends = choose_normals(which, draw);
           if (rule.rule == LineRule::cut) {
             step_phong<fixproof::q16_16_i386_unrounded>(rule.rule, rule.form, ends, place, out);
           } else {
             step_phong<fixproof::q16_16>(rule.rule, rule.form, ends, place, out);
           }
         }});
  }
  return variants;
}

}  // namespace fixproof::measure
