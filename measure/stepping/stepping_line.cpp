#include "measure/stepping/stepping_line.hpp"

#include <algorithm>
#include <cstdlib>

#include "fixed/fixed.hpp"

namespace fixproof::measure {

namespace {

using xsharp::StepWords;

constexpr std::int64_t pixel_units = 65536;

/// n / d rounded up, for n >= 0 and d > 0.
std::int64_t quotient_up(std::int64_t n, std::int64_t d) { return n / d + (n % d == 0 ? 0 : 1); }

template <class N>
StepWords stepped_words(const LineEnds& ends, const SpanPlace& place, unsigned dropped,
                        bool from_end = false) {
  const auto number = [](std::int64_t raw) { return N::from_raw(static_cast<std::int32_t>(raw)); };
  const N from = number(ends.from);
  auto step = xsharp::step_across(from, number(ends.to), place.units, place.distance);
  if (from_end) step.start = from;
  return xsharp::words_of(step, dropped);
}

/// The document's own rule: (a2 - a1) / (x2 - x1) in words, with a truncating divide.
StepWords whole_words(const LineEnds& ends, const SpanPlace& place, unsigned dropped) {
  const auto word = [dropped](std::int64_t raw) {
    return static_cast<std::int32_t>(xsharp::word_of(static_cast<std::int32_t>(raw), dropped));
  };
  const std::int64_t difference = std::int64_t{word(ends.to)} - word(ends.from);
  const std::int64_t step = difference / static_cast<std::int64_t>(place.pixels);
  return {static_cast<std::uint32_t>(word(ends.from)), static_cast<std::uint32_t>(step)};
}

/// The slope error of an 8088 per pixel, in half units of 2^-16, from dividing n / d by whole parts
/// of d. Rounding is not included.
std::int64_t dropped_by_8088(std::int64_t difference, std::int64_t units) {
  constexpr std::int64_t most = 8191 * pixel_units;
  std::int64_t n = std::abs(difference);
  std::int64_t d = units;
  const auto double_both = [&] {
    for (int doublings = 0; doublings < 29 && n < most && d < most; ++doublings) {
      n *= 2;
      d *= 2;
    }
  };
  double_both();
  std::int64_t product = 0;
  if (d < most) {
    // The divide has two parts. The upper part times d is n (1 + fraction / whole), apart from two
    // half units. The quotient's half unit counts once per pixel of the doubled divisor, and d
    // divides the product's half unit.
    std::int64_t divisor = d;
    while (divisor < most) divisor *= 2;
    n = quotient_up(n * (divisor % pixel_units), divisor / pixel_units * pixel_units) +
        quotient_up(divisor, 2 * pixel_units) + 1;
    product = d % pixel_units == 0 ? 0 : 1;
  }
  const std::int64_t divided = n;
  const std::int64_t by = d;
  double_both();
  const std::int64_t whole = d / pixel_units;
  const std::int64_t fraction = d % pixel_units;
  // The result is n / by * fraction / whole units of the slope. 2^-16 of a pixel in n is 65536
  // units.
  return product + (fraction == 0 ? 0 : quotient_up(2 * divided * fraction / whole + 1, by));
}

}  // namespace

StepWords line_words(LineRule rule, const LineEnds& ends, const SpanPlace& place,
                     unsigned dropped) {
  switch (rule) {
    case LineRule::cut:
      return stepped_words<fixproof::q16_16_i386_unrounded>(ends, place, dropped);
    case LineRule::i8088:
      return stepped_words<fixproof::q16_16_i8088>(ends, place, dropped);
    case LineRule::at_end:
      return stepped_words<fixproof::q16_16>(ends, place, dropped, true);
    case LineRule::whole_words:
      return whole_words(ends, place, dropped);
    case LineRule::rounded:
      break;
  }
  return stepped_words<fixproof::q16_16>(ends, place, dropped);
}

std::int64_t line_bound(LineRule rule, const LineEnds& ends, const SpanPlace& place,
                        unsigned dropped, std::size_t k) {
  constexpr std::int64_t unit = std::int64_t{1} << 17;
  const std::int64_t way = std::abs(ends.to - ends.from);
  const auto steps = static_cast<std::int64_t>(k);
  if (rule == LineRule::whole_words) {
    const std::int64_t word = unit << dropped;
    const std::int64_t geometry =
        place.whole() ? 0 : std::min(quotient_up(way * pixel_units, place.units), way) * unit;
    return steps * word + (dropped == 0 ? 0 : word * 3 / 2) + geometry;
  }
  const std::int64_t halves = rule == LineRule::cut ? 2 : 1;
  const std::int64_t words = dropped == 0 ? 0 : (steps + 1) << (dropped + 16);
  const bool at_end = rule == LineRule::at_end;
  const std::int64_t product = place.distance == 0 || at_end ? 0 : halves * pixel_units;
  const std::int64_t apart = at_end ? quotient_up(way * place.distance, place.units) * unit : 0;
  if (place.units < pixel_units) {
    // d / n loses 2^-12 of itself, because doubling gives its divisor a whole part of 13 bits.
    const std::int64_t part = rule == LineRule::i8088 ? way * 32 : 0;
    return (at_end ? 0 : way * halves) + part + product + words + apart;
  }
  const std::int64_t lost =
      rule == LineRule::i8088 ? dropped_by_8088(ends.to - ends.from, place.units) : 0;
  const std::int64_t counted = at_end ? steps * pixel_units : place.centre(k);
  return counted * (halves + lost) + product + words + apart;
}

void judge_line(LineRule rule, const LineFormat& format, const LineEnds& ends,
                const SpanPlace& place, const StepWords& words, SteppedSpan& out) {
  const auto drawn_unit = static_cast<double>(std::int64_t{1} << format.drawn_below);
  std::uint32_t word = words.start;
  for (std::size_t k = 0; k < place.pixels; ++k, word += words.step) {
    const std::int64_t stepped = static_cast<std::int32_t>(word << format.dropped);
    // Below 2^57: the difference is at most 2^32 and the centre at most 2^25.
    const std::int64_t over = (ends.to - ends.from) * place.centre(k);
    // The exact value minus the stepped one. The register wraps, so the difference is modulo 2^16.
    const std::int64_t turn = place.units * (std::int64_t{1} << 32);
    std::int64_t above = over - (stepped - ends.from) * place.units;
    if (2 * std::abs(above) > turn) above += above < 0 ? turn : -turn;
    const std::int64_t bound = line_bound(rule, ends, place, format.dropped, k);
    const std::int64_t off = std::abs(above);
    const std::int64_t max_error =
        off / place.units * (1 << 17) + quotient_up(off % place.units * (1 << 17), place.units);
    out.values.push_back(
        {-static_cast<double>(above) / static_cast<double>(place.units) / drawn_unit,
         static_cast<double>(bound) / (1 << 17) / drawn_unit, max_error <= bound});
    std::int64_t exact = over / place.units;
    if (over % place.units < 0) --exact;
    out.exact.push_back((ends.from + exact) >> format.drawn_below);
  }
}

LineEnds choose_ends(const LineFormat& format, const SpanPlace& place, Ends ends,
                     cases::Draw& draw) {
  const std::int64_t range = format.most - format.least;
  const auto below = [&](std::int64_t count) {
    return static_cast<std::int64_t>(draw.below(static_cast<std::uint64_t>(count)));
  };
  if (ends == Ends::random)
    return {format.least + below(range + 1), format.least + below(range + 1)};
  std::int64_t way = 0;
  switch (draw.below(6)) {
    case 0:
      way = range;
      break;
    case 1:
      way = std::min<std::int64_t>(below(3), range);
      break;
    case 2:
      way = std::min(draw.magnitude(31), range);
      break;
    default: {
      // The slope is slightly off a half unit, or off half a word if the word has fewer bits.
      const std::int64_t steepest = range * pixel_units / place.units;
      std::int64_t slope = below(std::clamp<std::int64_t>(steepest, 1, std::int64_t{1} << 31));
      const std::int64_t word = std::int64_t{1} << format.dropped;
      const bool cut_word = draw.coin();
      if (format.dropped != 0)
        slope = slope / word * word + (cut_word ? word - 1 : word / 2 - below(2));
      const std::int64_t halves = 2 * slope + 1 + below(2);
      way = std::min(halves * place.units / (2 * pixel_units), range);
      if (draw.coin() && way > 0) --way;
      break;
    }
  }
  // The way starts at an end of the range or anywhere.
  const std::int64_t room = range - way;
  const std::int64_t low = format.least + (draw.coin() ? 0 : below(room + 1));
  return draw.coin() ? LineEnds{low, low + way} : LineEnds{low + way, low};
}

}  // namespace fixproof::measure
