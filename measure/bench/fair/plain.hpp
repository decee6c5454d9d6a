/// @file
/// Peers in one line of C++, in integers and in double, and functions of libfixmath and FreeType.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "measure/bench/fair/columns.hpp"

#if defined(FAIR_LIBFIXMATH)
#include <libfixmath/fix16.h>
#endif
#if defined(FAIR_FREETYPE)
#include <freetype/freetype.h>
#endif

namespace fair {

using Word = std::int32_t;
using Wide = std::int64_t;

template <class In, class Out = In>
struct Plain {
  using in = In;
  using out = Out;
};

/// To the nearest integer, in the mode that every program starts in.
inline Word nearest(double x) { return static_cast<Word>(std::rint(x)); }

struct IdiomMultiply : Plain<Word> {
  static constexpr const char* name = "idiom";
  static Word of(Word a, Word b) { return static_cast<Word>((Wide{a} * b + 0x8000) >> 16); }
};
struct IdiomMultiplyTruncating : Plain<Word> {
  static constexpr const char* name = "idiom, rounds down";
  static Word of(Word a, Word b) { return static_cast<Word>((Wide{a} * b) >> 16); }
};
struct DoubleMultiply : Plain<Word> {
  static constexpr const char* name = "double";
  static Word of(Word a, Word b) { return nearest(static_cast<double>(a) * b * 0x1p-16); }
};

struct IdiomMultiplySaturating : Plain<Word> {
  static constexpr const char* name = "idiom";
  static Word of(Word a, Word b) {
    using limits = std::numeric_limits<Word>;
    const Wide product = (Wide{a} * b + 0x8000) >> 16;
    return static_cast<Word>(std::clamp(product, Wide{limits::min()}, Wide{limits::max()}));
  }
};
struct DoubleMultiplySaturating : Plain<Word> {
  static constexpr const char* name = "double";
  static Word of(Word a, Word b) {
    return nearest(std::clamp(static_cast<double>(a) * b * 0x1p-16, -0x1p31, 0x1p31 - 1));
  }
};

struct IdiomDivideTruncating : Plain<Word> {
  static constexpr const char* name = "idiom, truncates";
  static Word of(Word a, Word b) { return static_cast<Word>(Wide{a} * 65536 / b); }
};
/// Half the divisor's size, with the sign of the quotient, before the division truncates.
struct IdiomDivide : Plain<Word> {
  static constexpr const char* name = "idiom";
  static Word of(Word a, Word b) {
    const Wide n = Wide{a} * 65536;
    const Wide half = Wide{b} / 2;
    return static_cast<Word>(((n < 0) == (b < 0) ? n + half : n - half) / b);
  }
};
struct DoubleDivide : Plain<Word> {
  static constexpr const char* name = "double";
  static Word of(Word a, Word b) { return nearest(static_cast<double>(a) * 65536 / b); }
};

struct DoubleRoot : Plain<Word> {
  static constexpr const char* name = "double";
  static Word of(Word a, Word /*b*/ = 0) {
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): a root is at least 0, and far below 2^52
    return static_cast<Word>(std::sqrt(static_cast<double>(a) * 65536) + 0.5);
  }
};

struct DoubleSine : Plain<Word> {
  static constexpr const char* name = "double";
  static Word of(Word a, Word /*b*/ = 0) {
    return nearest(std::sin(static_cast<double>(a) / 65536) * 65536);
  }
};
struct FloatSine : Plain<Word> {
  static constexpr const char* name = "float";
  static Word of(Word a, Word /*b*/ = 0) {
    return static_cast<Word>(std::rint(std::sin(static_cast<float>(a) / 65536) * 65536));
  }
};
struct DoubleSineCosine : Plain<Word> {
  static constexpr const char* name = "double";
  static std::array<Word, 2> of(Word a) {
    const double x = static_cast<double>(a) / 65536;
    return {nearest(std::cos(x) * 65536), nearest(std::sin(x) * 65536)};
  }
};

struct RintFromDouble : Plain<double, Word> {
  static constexpr const char* name = "rint";
  static Word of(double x) { return nearest(x * 65536); }
};
struct FloorFromDouble : Plain<double, Word> {
  static constexpr const char* name = "floor";
  static Word of(double x) { return static_cast<Word>(std::floor(x * 65536 + 0.5)); }
};
struct IdiomToDouble : Plain<Word, double> {
  static constexpr const char* name = "idiom";
  static double of(Word a) { return a / 65536.0; }
};
struct IdiomThereAndBack : Plain<Word> {
  static constexpr const char* name = "rint";
  static Word of(Word a, Word /*b*/) { return RintFromDouble::of(IdiomToDouble::of(a)); }
};
struct FloorThereAndBack : Plain<Word> {
  static constexpr const char* name = "floor";
  static Word of(Word a, Word /*b*/) { return FloorFromDouble::of(IdiomToDouble::of(a)); }
};

#if defined(FAIR_LIBFIXMATH)
template <class In, class Out = In>
struct Fixmath : Plain<In, Out> {
  static constexpr const char* name = "libfixmath";
};
struct FixmathMultiply : Fixmath<Word> {
  static Word of(Word a, Word b) { return fix16_mul(a, b); }
};
struct FixmathMultiplySaturating : Fixmath<Word> {
  static Word of(Word a, Word b) { return fix16_smul(a, b); }
};
struct FixmathDivide : Fixmath<Word> {
  static Word of(Word a, Word b) { return fix16_div(a, b); }
};
struct FixmathRoot : Fixmath<Word> {
  static Word of(Word a, Word /*b*/ = 0) { return fix16_sqrt(a); }
};
struct FixmathSine : Fixmath<Word> {
  static Word of(Word a, Word /*b*/ = 0) { return fix16_sin(a); }
};
struct FixmathSineCosine : Fixmath<Word> {
  static std::array<Word, 2> of(Word a) { return {fix16_cos(a), fix16_sin(a)}; }
};
struct FixmathFromDouble : Fixmath<double, Word> {
  static Word of(double x) { return fix16_from_dbl(x); }
};
struct FixmathToDouble : Fixmath<Word, double> {
  static double of(Word a) { return fix16_to_dbl(a); }
};
struct FixmathThereAndBack : Fixmath<Word> {
  static Word of(Word a, Word /*b*/) { return fix16_from_dbl(fix16_to_dbl(a)); }
};
#endif

#if defined(FAIR_FREETYPE)
struct FreetypeMultiply : Plain<Word> {
  static constexpr const char* name = "FreeType";
  static Word of(Word a, Word b) { return static_cast<Word>(FT_MulFix(a, b)); }
};
struct FreetypeDivide : Plain<Word> {
  static constexpr const char* name = "FreeType";
  static Word of(Word a, Word b) { return static_cast<Word>(FT_DivFix(a, b)); }
};
#endif

}  // namespace fair
