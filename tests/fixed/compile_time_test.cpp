/// Checks properties of the library at compile time.
#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

#include "fixed/fixed.hpp"

namespace {

using namespace fixproof;

static_assert(sizeof(q16_16) == 4 && sizeof(q8_8) == 2);
static_assert(std::is_trivially_copyable_v<q16_16> && std::is_standard_layout_v<q16_16>);
static_assert(std::is_nothrow_default_constructible_v<q16_16_trapping>);
static_assert(std::totally_ordered<q16_16> && std::regular<q8_8_trapping>);

// There are no implicit conversions, and no surprising explicit ones.
static_assert(!std::is_convertible_v<int, q16_16> && !std::is_convertible_v<double, q16_16>);
static_assert(!std::is_convertible_v<q16_16, int> && !std::is_convertible_v<q16_16, double>);
static_assert(!std::is_convertible_v<q8_8, q16_16>);
static_assert(!std::is_convertible_v<q16_16, q16_16_saturating>);
static_assert(!std::is_constructible_v<bool, q16_16>);
static_assert(std::is_constructible_v<q16_16, long double> &&
              !std::is_convertible_v<long double, q16_16>);

// Operators are noexcept except under policies that throw.
template <class Number>
constexpr bool plain_nothrow =
    noexcept(Number() + Number()) && noexcept(Number() * Number()) && noexcept(
        -Number()) && noexcept(Number(1.0)) && noexcept(Number(1)) && noexcept(sqrt(Number()));
template <class Number>
constexpr bool divide_nothrow = noexcept(Number() / Number());
static_assert(plain_nothrow<q16_16> && divide_nothrow<q16_16>);
static_assert(plain_nothrow<q16_16_saturating> && divide_nothrow<q16_16_saturating>);
static_assert(plain_nothrow<q16_16_i386> && !divide_nothrow<q16_16_i386>);
static_assert(plain_nothrow<q8_8_i8088> && !divide_nothrow<q8_8_i8088>);
static_assert(!plain_nothrow<q16_16_trapping> && !divide_nothrow<q16_16_trapping>);
static_assert(noexcept(try_divide(q16_16_trapping(), q16_16_trapping())));

static_assert(q16_16::from_raw(0x12345).raw() == 0x12345);
static_assert(std::same_as<q16_16::raw_type, std::int32_t>);
static_assert(std::same_as<q8_8::raw_type, std::int16_t>);
static_assert(q16_16() == q16_16(0) && q16_16().raw() == 0);

static_assert(q16_16(1).raw() == 0x10000 && q16_16(-1).raw() == -0x10000);
static_assert(q16_16(-1.0).raw() == -0x10000);
static_assert(q16_16(0x1p-17).raw() == 1 && q16_16(-0x1p-17).raw() == 0);
static_assert(q16_16(-0x1.8p-16).raw() == -1 && q16_16(0x1.8p-16).raw() == 2);
static_assert(q16_16(32768).raw() == std::numeric_limits<std::int32_t>::min());
static_assert(q16_16_saturating(32768).raw() == 0x7fffffff);
static_assert(q16_16(65537.5) == q16_16(1.5));
static_assert(q16_16(0x1p200) == q16_16());
static_assert(static_cast<int>(q16_16(-2.75)) == -2);
static_assert(to_integer<rounding::floor>(q16_16(-2.75)) == -3);
static_assert(static_cast<double>(q16_16::from_raw(-1)) == -0x1p-16);
static_assert(static_cast<float>(q16_16::from_raw(0x7fffffff)) == 32768.0f);
static_assert(q8_8(q16_16(1.5)) == q8_8(1.5) && q16_16(q8_8(-0.25)) == q16_16(-0.25));

// The default policy rounds every tie up.
static_assert((q16_16::from_raw(1) * q16_16(0.5)).raw() == 1);
static_assert((q16_16::from_raw(-1) * q16_16(0.5)).raw() == 0);
static_assert((q16_16::from_raw(1) / q16_16(2)).raw() == 1);
static_assert((q16_16::from_raw(-1) / q16_16(2)).raw() == 0);
static_assert((q16_16::from_raw(1) / q16_16(-2)).raw() == 0);
static_assert(mul_add(q16_16::from_raw(-1), q16_16(0.5), q16_16()).raw() == 0);
static_assert(lerp(q16_16(), q16_16::from_raw(-1), q16_16(0.5)).raw() == 0);
constexpr q16_16 from_text(const char* first, const char* last) {
  q16_16 value(99);
  from_chars(first, last, value);
  return value;
}
constexpr char half_unit[] = "-0.00000762939453125";
static_assert(from_text(half_unit, half_unit + sizeof half_unit - 1).raw() == 0);
static_assert(from_text(half_unit + 1, half_unit + sizeof half_unit - 1).raw() == 1);
constexpr std::array term_a{q16_16::from_raw(-1)};
constexpr std::array term_b{q16_16(0.5)};
static_assert(dot(term_a, term_b).raw() == 0);
static_assert(round(q16_16(-0.5)) == q16_16() && round(q16_16(0.5)) == q16_16(1));

constexpr auto lowest_wrapping = std::numeric_limits<q16_16>::lowest();
static_assert(-lowest_wrapping == lowest_wrapping && abs(lowest_wrapping) == lowest_wrapping);
static_assert(lowest_wrapping / q16_16(-1) == lowest_wrapping);
static_assert(lowest_wrapping * q16_16(-1) == lowest_wrapping);
constexpr auto lowest_saturating = std::numeric_limits<q16_16_saturating>::lowest();
constexpr auto highest_saturating = std::numeric_limits<q16_16_saturating>::max();
static_assert(-lowest_saturating == highest_saturating);
static_assert(lowest_saturating / q16_16_saturating(-1) == highest_saturating);
static_assert(highest_saturating + highest_saturating == highest_saturating);
static_assert(!try_divide(q16_16(1), q16_16()) &&
              try_divide(lowest_wrapping, q16_16(-1)) == lowest_wrapping);
static_assert(!try_divide(std::numeric_limits<q16_16_trapping>::lowest(), q16_16_trapping(-1)));

static_assert(sqrt(q16_16(2)).raw() == 92682);  // 1.41421356 * 65536 = 92681.90
static_assert(sqrt(q16_16(-4)) == q16_16());
// policy::moving refuses every plain operand and conversion, and changes no result.
using moving = with_policy<q16_16, policy{.multiply = rounding::floor, .moving = true}>;
using moved = with_policy<q16_16, policy{.multiply = rounding::floor}>;
template <class Number, class Plain>
constexpr int mixed_expressions = [] {
  int count = 0;
  count += requires(Number x, Plain n) { x + n; }
  ? 1 : 0;
  count += requires(Number x, Plain n) { n - x; }
  ? 1 : 0;
  count += requires(Number x, Plain n) { x* n; }
  ? 1 : 0;
  count += requires(Number x, Plain n) { x / n; }
  ? 1 : 0;
  count += requires(Number x, Plain n) { x % n; }
  ? 1 : 0;
  count += requires(Number x, Plain n) { x == n; }
  ? 1 : 0;
  count += requires(Number x, Plain n) { n < x; }
  ? 1 : 0;
  count += requires(Number x, Plain n) { x += n; }
  ? 1 : 0;
  count += requires(Number x, Plain n) { x %= n; }
  ? 1 : 0;
  count += requires(Number x) { ++x; }
  ? 1 : 0;
  count += requires(Number x) { x--; }
  ? 1 : 0;
  count += std::is_constructible_v<Number, Plain> ? 1 : 0;
  count += requires(Number x) { static_cast<Plain>(x); }
  ? 1 : 0;
  return count;
}();
static_assert(mixed_expressions<moved, int> == 13 && mixed_expressions<moving, int> == 0);
static_assert(mixed_expressions<moving, std::uint64_t> == 0 &&
              mixed_expressions<moving, short> == 0);
static_assert(mixed_expressions<moved, double> == 4 && mixed_expressions<moving, double> == 0);
static_assert(mixed_expressions<moving, long double> == 0 && mixed_expressions<moving, float> == 0);
static_assert((moving::from_raw(-3) * moving(q16_16(0.5))).raw() ==
              (moved::from_raw(-3) * moved(0.5)).raw());
static_assert(to_integer<rounding::floor>(moving(q16_16(-1.5))) == -2 &&
              (moving(q16_16(1)) << 1) == moving(q16_16(2)));

static_assert(sin_cos_of_tenths<q16_16>(900) == sin_and_cos<q16_16>{q16_16(1), q16_16()});
static_assert(floor(q16_16(-0.5)) == q16_16(-1) && ceil(q16_16(-0.5)) == q16_16());

// A function of every header in a constant expression.
static_assert(checked_multiply(q16_16(200), q16_16(200)) == std::nullopt);
static_assert(multiply<q2_30>(q16_16(0.5), q8_8(0.5)) == q2_30(0.25));
static_assert(mul_div(q16_16(3), q16_16(5), q16_16(4)) == q16_16(3.75));
static_assert(ratio<q2_30>(1, 4) == q2_30(0.25));
static_assert(fmod(q16_16(5.5), q16_16(2)) == q16_16(1.5));
static_assert(lerp(q2_30(0), q2_30(1), q2_30(0.5)) == q2_30(0.5));
static_assert(pi_v<q8_24>.raw() == 52707179);  // 3.14159265... * 2^24 = 52707178.9

}  // namespace
