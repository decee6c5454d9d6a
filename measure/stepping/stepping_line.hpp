/// @file
/// Stepped straight lines and the bounds of their errors.
#pragma once

#include <cstdint>

#include "measure/stepping/stepping_span.hpp"
#include "xsharp/raster/step.hpp"

namespace fixproof::measure {

/// The values at the ends of a span, in units of 2^-16.
struct LineEnds {
  std::int64_t from = 0;
  std::int64_t to = 0;
};

/// How a rule computes the slope and the first pixel's value.
enum class LineRule {
  rounded,      ///< step.hpp on q16_16
  cut,          ///< step.hpp on q16_16_i386_unrounded: truncated quotients, floored products
  i8088,        ///< step.hpp on q16_16_i8088: divides by the whole part
  at_end,       ///< as rounded, but the first pixel has the end's value
  whole_words,  ///< word difference / pixels, truncated; starts at the end's word
};

/// The words that the loop starts with. @param dropped bits of 16.16 that the words lack
xsharp::StepWords line_words(LineRule rule, const LineEnds& ends, const SpanPlace& place,
                             unsigned dropped);

/// The largest error of the stepped value, a word times 2^dropped, at pixel k, in units of 2^-17
/// units. In the derivation, d is the distance and n the units, both in pixels, and D = to - from:
///
/// - slope: a divide rounds by at most 1/2 unit or truncates by less than 1 (s), which counts k + d
///   times: (k + d) s;
/// - product of the pre-step: p = 1/2 unit if rounded, 1 if floored, 0 if d = 0;
/// - words with fewer bits: start and slope are rounded to nearest, 2^dropped / 2 units each, which
///   count 1 + k times;
/// - 8088: the divisor is truncated to its whole part w, after dividend and divisor are doubled as
///   often as both fit. A fraction f makes the slope too large by f / w of itself. If D ends the
///   doubling, the divide has two parts (xsharp::ratio()), and this is the error of the second
///   part;
/// - ways shorter than a pixel: the start is D times d / n, which adds |D| s units of 2^-16, and p;
/// - no pre-step: the end's value is d pixels off: |D| d / n;
/// - whole words: the ends are rounded to words, half a word each, which adds a half at the start
///   and 1 / pixels per step. Truncation adds less than a word per step. The sum is (k + 3/2)
///   2^dropped, without the 3/2 if the word has all bits. Pixel k is at k / pixels of the way
///   instead of (k + d) / n, which adds |D| / n unless the span is whole.
///
/// The error and the bound are compared as integers.
std::int64_t line_bound(LineRule rule, const LineEnds& ends, const SpanPlace& place,
                        unsigned dropped, std::size_t k);

/// The word format of a line and the range of its values.
struct LineFormat {
  unsigned dropped = 0;      ///< bits of 16.16 that the word lacks
  unsigned drawn_below = 0;  ///< bits of 2^-16 below the drawn whole part
  std::int64_t least = 0;    ///< range of the values at the ends, in 2^-16
  std::int64_t most = 0;
};

/// Appends every pixel's value and its truncated exact value. The loops append the drawn ones.
void judge_line(LineRule rule, const LineFormat& format, const LineEnds& ends,
                const SpanPlace& place, const xsharp::StepWords& words, SteppedSpan& out);

/// Chooses ends in the range. Extreme ends are as far apart as possible, equal or a unit apart, or
/// give a slope whose rounding loses most.
LineEnds choose_ends(const LineFormat& format, const SpanPlace& place, Ends ends,
                     cases::Draw& draw);

}  // namespace fixproof::measure
