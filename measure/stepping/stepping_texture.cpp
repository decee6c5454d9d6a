// Textures in perspective: exact texture coordinates at intervals, affine steps between them. It
// runs the code that draws them (xsharp/raster/perspective_place.hpp, xsharp/raster/stretch.hpp).
//
// A texture coordinate p, where 1 is 256 texels, is q / w. The depth w and q = p w are straight
// lines on the screen. The bound, with s = 1/2 unit if the arithmetic rounds and 1 if it truncates:
//
// - line_bound() gives the error Ew of w. The error Eq of q adds the product at its ends, s. The
//   coordinate is then off by (Eq + p Ew) / (w - Ew), plus s of the quotient;
// - j steps from one exact coordinate to the next add j s to the larger error of the two;
// - a chord of the curve u = q / w between depths a and b is off by at most
//   |ua - ub| |√a - √b| / (√a + √b). The maximum is at w = √(a b), where the curve's slope, a
//   multiple of 1 / w^2, equals the chord's.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fixed/fixed.hpp"
#include "measure/stepping/stepping_line.hpp"
#include "xsharp/raster/perspective_place.hpp"
#include "xsharp/raster/stretch.hpp"

namespace fixproof::measure {

namespace {

__extension__ typedef __int128 Wide;  // NOLINT(modernize-use-using): __extension__ needs typedef

struct PerspectiveEnds {
  LineEnds place;  ///< 128 to 65408: from the middle of the first texel to that of the last
  LineEnds depth;
};

constexpr LineFormat place_format{0, 8, 128, 65536 - 128};
constexpr std::int64_t nearest_depth = 32767 * std::int64_t{65536};
/// The far end of a face is at most twice as far as the near end.
constexpr double max_ratio = 2;
/// Here the near end is 16 times as far as the nearest depth.
constexpr std::int64_t farthest_depth = nearest_depth / 16;

LineEnds choose_depths(Ends ends, cases::Draw& draw) {
  const auto part = [&] { return static_cast<double>(draw.below(65537)) / 65536; };
  const bool extreme = ends == Ends::extreme;
  const double near = extreme ? (draw.coin() ? 1.0 : 0.0) : part();
  const double size =
      static_cast<double>(farthest_depth) *
      std::pow(static_cast<double>(nearest_depth) / static_cast<double>(farthest_depth), near);
  const double ratio =
      extreme ? (draw.below(4) == 0 ? 1.0 : max_ratio) : 1 + (max_ratio - 1) * part();
  const LineEnds depth{static_cast<std::int64_t>(size), static_cast<std::int64_t>(size / ratio)};
  return draw.coin() ? depth : LineEnds{depth.to, depth.from};
}

/// The exact texture coordinate at a pixel, as a fraction.
struct ExactPlace {
  Wide numerator = 0;
  Wide denominator = 1;
};

ExactPlace exact_place(const PerspectiveEnds& ends, const SpanPlace& place, std::size_t k) {
  const Wide left = Wide{ends.depth.from} * (place.units - place.centre(k));
  const Wide right = Wide{ends.depth.to} * place.centre(k);
  return {ends.place.from * left + ends.place.to * right, left + right};
}

double value_of(const ExactPlace& p) {
  return static_cast<double>(p.numerator) / static_cast<double>(p.denominator);
}

double depth_at(const PerspectiveEnds& ends, const SpanPlace& place, std::size_t k) {
  return static_cast<double>(exact_place(ends, place, k).denominator) /
         static_cast<double>(place.units);
}

/// The largest error of a chord between two depths, relative to the difference of its ends.
double chord_error(double one, double other) {
  const double a = std::sqrt(one);
  const double b = std::sqrt(other);
  return std::fabs(a - b) / (a + b);
}

/// The words of one coordinate per pixel, and their bounds in units.
struct SteppedPlaces {
  std::vector<std::uint32_t> words;
  std::vector<double> bounds;
};

template <class N>
class Perspective {
 public:
  Perspective(LineRule rule, const PerspectiveEnds& ends, const SpanPlace& place)
      : rule_(rule), ends_(ends), place_(place) {
    const N near = number(ends.depth.from);
    const N far = number(ends.depth.to);
    const N from = number(ends.place.from) * near;
    const N to = number(ends.place.to) * far;
    stepped_.products.front() = xsharp::step_across(from, to, place.units, place.distance);
    stepped_.depth = xsharp::step_across(near, far, place.units, place.distance);
  }

  [[nodiscard]] std::array<N, 1> at(std::size_t k) const { return stepped_.at(k); }

  /// The largest error of at(k), in units.
  [[nodiscard]] double bound_at(std::size_t k) const {
    const double unit = 131072;
    const double s = rule_ == LineRule::cut ? 1 : 0.5;
    const LineEnds product{product_end(ends_.place.from, ends_.depth.from),
                           product_end(ends_.place.to, ends_.depth.to)};
    const double of_depth =
        static_cast<double>(line_bound(rule_, ends_.depth, place_, 0, k)) / unit;
    const double of_product =
        static_cast<double>(line_bound(rule_, product, place_, 0, k)) / unit + s;
    return (of_product + of_depth) * 65536 / (depth_at(ends_, place_, k) - of_depth) + s;
  }

 private:
  static N number(std::int64_t raw) { return N::from_raw(static_cast<std::int32_t>(raw)); }
  static std::int64_t product_end(std::int64_t place, std::int64_t depth) {
    return place * depth / 65536;
  }

  LineRule rule_;
  PerspectiveEnds ends_;
  SpanPlace place_;
  xsharp::PerspectivePlace<N, 1> stepped_;
};

/// @param every pixels from one exact coordinate to the next
template <class N>
void step_places(LineRule rule, std::size_t every, const PerspectiveEnds& ends,
                 const SpanPlace& place, SteppedPlaces& out) {
  const Perspective<N> perspective(rule, ends, place);
  const double s = rule == LineRule::cut ? 1 : 0.5;
  const auto draw = [&](const xsharp::Stretch& stretch,
                        const std::array<xsharp::Step<N>, 1>& line) {
    const auto [from, to, count] = stretch;
    const double bound = perspective.bound_at(from);
    const double bound_there = perspective.bound_at(to);
    const double chord = std::fabs(value_of(exact_place(ends, place, to)) -
                                   value_of(exact_place(ends, place, from))) *
                         chord_error(depth_at(ends, place, from), depth_at(ends, place, to));
    xsharp::StepWords words = xsharp::words_of(line.front(), 0);
    for (std::size_t j = 0; j < count; ++j) {
      out.words.push_back(words.start);
      const double steps = static_cast<double>(j) * s + (from + j == to ? 0 : chord);
      out.bounds.push_back(j == 0 ? bound : std::max(bound, bound_there) + steps);
      words.start += words.step;
    }
  };
  xsharp::in_stretches(
      place.pixels, every, [&](std::size_t k) { return perspective.at(k); }, draw);
}

/// Steps a straight line between the exact ends in place of the perspective curve.
void step_affine(const PerspectiveEnds& ends, const SpanPlace& place, SteppedPlaces& out) {
  const xsharp::StepWords words = line_words(LineRule::rounded, ends.place, place, 0);
  const double chord =
      std::fabs(static_cast<double>(ends.place.to - ends.place.from)) *
      chord_error(static_cast<double>(ends.depth.from), static_cast<double>(ends.depth.to));
  for (std::size_t k = 0; k < place.pixels; ++k) {
    out.words.push_back(words.start + static_cast<std::uint32_t>(k) * words.step);
    out.bounds.push_back(
        static_cast<double>(line_bound(LineRule::rounded, ends.place, place, 0, k)) / 131072 +
        chord);
  }
}

SteppedValue judged(std::uint32_t word, double bound, const ExactPlace& exact) {
  const Wide off = static_cast<std::int32_t>(word) * exact.denominator - exact.numerator;
  const double error = static_cast<double>(off) / static_cast<double>(exact.denominator);
  // The tolerance covers the rounding of the bound, which is a double.
  return {error / 256, bound / 256, std::fabs(error) <= bound * (1 + 1e-9) + 1e-9};
}

std::int64_t texel(const ExactPlace& exact) {
  return static_cast<std::int64_t>(exact.numerator / exact.denominator) >> 8;
}

struct PerspectiveRule {
  const char* value;
  const char* name;
  LineRule rule;
  std::size_t every;  ///< 0: never
};

void step_perspective(const PerspectiveRule& rule, const SpanPlace& place, Ends which,
                      cases::Draw draw, SteppedSpan& out) {
  const LineEnds depth = choose_depths(which, draw);
  const PerspectiveEnds across{choose_ends(place_format, place, which, draw), depth};
  const PerspectiveEnds down{choose_ends(place_format, place, which, draw), depth};
  static thread_local std::array<SteppedPlaces, 2> both;
  for (std::size_t i = 0; i < 2; ++i) {
    SteppedPlaces& places = both.at(i);
    places.words.clear();
    places.bounds.clear();
    const PerspectiveEnds& ends = i == 0 ? across : down;
    if (rule.every == 0) {
      step_affine(ends, place, places);
    } else if (rule.rule == LineRule::cut) {
      step_places<fixproof::q16_16_i386_unrounded>(rule.rule, rule.every, ends, place, places);
    } else {
      step_places<fixproof::q16_16>(rule.rule, rule.every, ends, place, places);
    }
  }
  const auto& [columns, rows] = both;
  for (std::size_t k = 0; k < place.pixels; ++k) {
    const ExactPlace u = exact_place(across, place, k);
    const ExactPlace v = exact_place(down, place, k);
    out.values.push_back(nearer_bound(judged(columns.words[k], columns.bounds[k], u),
                                      judged(rows.words[k], rows.bounds[k], v)));
    out.drawn.push_back((rows.words[k] & 0xFF00U) | (columns.words[k] >> 8U & 0xFFU));
    out.exact.push_back(texel(v) * 256 + texel(u));
  }
}

constexpr std::array perspective_rules{
    PerspectiveRule{"texture, perspective", "every pixel", LineRule::rounded, 1},
    PerspectiveRule{"texture, perspective", "every 8th", LineRule::rounded, 8},
    PerspectiveRule{"texture, perspective", "every 16th", LineRule::rounded, 16},
    PerspectiveRule{"texture, perspective", "never (affine)", LineRule::rounded, 0},
    PerspectiveRule{"texture, perspective, cut", "every pixel", LineRule::cut, 1},
    PerspectiveRule{"texture, perspective, cut", "every 8th", LineRule::cut, 8},
    PerspectiveRule{"texture, perspective, cut", "every 16th", LineRule::cut, 16},
};

}  // namespace

std::vector<SteppingVariant> texture_variants() {
  std::vector<SteppingVariant> variants;
  for (const PerspectiveRule& rule : perspective_rules) {
    variants.push_back(
        {rule.value, rule.name, Drawn::texel,
         "0.5 to 255.5, depth 1023.9 to 32767, at one end to twice the other",
         [rule](const SpanPlace& place, Ends which, cases::Draw draw, SteppedSpan& out) {
           step_perspective(rule, place, which, draw, out);
         }});
  }
  return variants;
}

}  // namespace fixproof::measure
