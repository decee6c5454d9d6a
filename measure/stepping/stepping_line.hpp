/// @file
/// A straight line, stepped; and how far off it can be.
#pragma once

#include <cstdint>

#include "measure/stepping/stepping_span.hpp"
#include "xsharp/raster/step.hpp"

namespace fixproof::measure {

/// A value's way across a span, in units of 2^-16 of the value.
struct LineEnds {
  std::int64_t from = 0;
  std::int64_t to = 0;
};

/// How a slope comes about, and where the first pixel's value comes from.
enum class LineRule {
  rounded,      ///< step.hpp on q16_16
  cut,          ///< step.hpp on q16_16_i386_unrounded: quotients cut, products floored
  i8088,        ///< step.hpp on q16_16_i8088: divides by a whole part
  at_end,       ///< as rounded, but the first pixel has the value of the span's end
  whole_words,  ///< the words' difference by the pixels, cut; the first pixel has the end's word
};

/// What the loop is called with. @param dropped bits of 16.16 that its words do not have
xsharp::StepWords line_words(LineRule rule, const LineEnds& ends, const SpanPlace& place,
                             unsigned dropped);

/// What the stepped value, a word times 2^dropped, is off at pixel k at most, in units of 2^-17
/// units. Derived, with d for the distance and n for the units, both in pixels, D = to - from:
///
/// - the slope: a divide rounds by 1/2 unit at most, or cuts by less than 1 (s), and it counts
///   k + d times: (k + d) s;
/// - the pre-step's product: p = 1/2 unit rounded, 1 floored; none where d = 0, for then it is 0;
/// - where the word has less bits, start and slope become the nearest: 2^dropped / 2 units of each,
///   which count 1 + k times;
/// - an 8088 divides by the whole part w of the divisor, which both were doubled for as often as
///   fits: with a fraction f the slope is f / w of itself too great; where D ends
///   the doubling, it divides in two parts (xsharp::ratio()), and that is said of the second alone;
/// - on a way shorter than a pixel the start is D times d / n: |D| s units of 2^-16, and p;
/// - without pre-step the value of the end stands d pixels further: |D| d / n;
/// - by whole words the ends become the nearest words, half a word each, which is a half at the
///   start and 1 / pixels a step; a cut is less than a word a step: (k + 3/2) 2^dropped, of which
///   the 3/2 are none where the word has all bits. And pixel k stands at k / pixels of the way, not
///   at (k + d) / n: |D| / n more, unless the span is whole.
///
/// Measured and bound are compared as integers.
std::int64_t line_bound(LineRule rule, const LineEnds& ends, const SpanPlace& place,
                        unsigned dropped, std::size_t k);

/// What a line's word and its range are.
struct LineFormat {
  unsigned dropped = 0;      ///< bits of 16.16 that the word does not have
  unsigned drawn_below = 0;  ///< bits of 2^-16 below the whole part that is drawn
  std::int64_t least = 0;    ///< of the values at the ends, in 2^-16
  std::int64_t most = 0;
};

/// Appends the values of every pixel, and the exact ones, cut; what is drawn the loops know.
void judge_line(LineRule rule, const LineFormat& format, const LineEnds& ends,
                const SpanPlace& place, const xsharp::StepWords& words, SteppedSpan& out);

/// Ends in the range. Extreme ones are as far apart as it allows, or not at all or a unit apart, or
/// such that the slope's fraction is about what its rounding loses most of.
LineEnds choose_ends(const LineFormat& format, const SpanPlace& place, Ends ends,
                     cases::Draw& draw);

}  // namespace fixproof::measure
