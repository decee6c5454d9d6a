// The type after macros of <windows.h>, of Arduino.h and of newlib's <ctype.h>. The standard
// library comes before them, because they break it too.
#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <charconv>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <istream>
#include <iterator>
#include <limits>
#include <optional>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>
#include <version>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

// NOLINTBEGIN(cppcoreguidelines-macro-usage)
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define near
#define far
#define small char
#define interface struct
#define IN
#define OUT
#define abs(x) ((x) > 0 ? (x) : -(x))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x)-0.5))
#define constrain(x, low, high) ((x) < (low) ? (low) : ((x) > (high) ? (high) : (x)))
#define radians(degrees) ((degrees)*0.017453292519943295)
#define degrees(radians) ((radians)*57.29577951308232)
#define sq(x) ((x) * (x))
#define bit(b) (1UL << (b))
#define lowByte(w) ((unsigned char)((w)&0xff))
#define word(...) make_word(__VA_ARGS__)
#define F(text) (text)
#define PI 3.1415926535897932
#define DEC 10
#define HEX 16
#define B1 1
#define _U 01
#define _L 02
#define _N 04
#define _S 010
#define _P 020
#define _C 040
#define _X 0100
#define _B 0200
// NOLINTEND(cppcoreguidelines-macro-usage)

#include "fixed/batch/batch.hpp"
#include "fixed/batch/functions.hpp"
#include "fixed/batch/radian.hpp"
#include "fixed/fixed.hpp"

using fixproof::q16_16;

// A name in parentheses is not expanded as a macro.
static_assert((fixproof::min)(q16_16(1), q16_16(2)) == q16_16(1));
static_assert((fixproof::max)(q16_16(1), q16_16(2)) == q16_16(2));
static_assert((fixproof::abs)(q16_16(-1)) == q16_16(1));
static_assert((fixproof::round)(q16_16(1.5)) == q16_16(2));
static_assert((std::numeric_limits<q16_16>::max)().raw() == 0x7fffffff);
static_assert(fixproof::sqrt(q16_16(4)) == q16_16(2));
static_assert(fixproof::exp2(q16_16(4)) == 16 && fixproof::log2(q16_16(16)) == 4);
static_assert(fixproof::atan2(q16_16(), q16_16(1)) == 0);

bool among_macros(std::span<const q16_16> a, std::span<q16_16> roots) {
  return fixproof::batch::sqrt(a, roots).clean();
}
