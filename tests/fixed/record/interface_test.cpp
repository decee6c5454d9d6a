// Runs every operation of the type on the recorded type. It must give the same bits and make one
// record, or none if it makes no number. `interface` checks that no function of fixed/ is missing
// here.
#include <array>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>

#define FIXPROOF_RECORD 1
#include "fixed/record/recorded.hpp"
#include "tests/fixed/record/comparison.hpp"

namespace {

using namespace fixproof;

template <class Number>
class Interface : public comparison::Comparison {
 protected:
  /// Calls a function object of type F with plain and with recorded operands. Only the two calls
  /// are compiled for each of the hundreds of types F.
  template <class F>
  void expect(const char* name, std::uint64_t records, F) {
    compare(comparison::Type::of<Number>(), name, records, comparison::call<F, Number>,
            comparison::call<F, recorded_number<Number>>);
  }
};

using Types = testing::Types<q16_16, q16_16_saturating, q16_16_trapping, q16_16_i386, q16_16_i8088,
                             q8_8, q2_30, u8_8, q8_0, q32_32>;
TYPED_TEST_SUITE(Interface, Types);

/// Tests an expression of a, b and c, whose type T is plain or recorded.
#define EXPRESSION(records, ...)                                                               \
  this->expect(#__VA_ARGS__, records,                                                          \
               []([[maybe_unused]] auto a, [[maybe_unused]] auto b, [[maybe_unused]] auto c) { \
                 [[maybe_unused]] typedef decltype(a) T;                                       \
                 return __VA_ARGS__;                                                           \
               })
#define RECORDS(...) EXPRESSION(1, __VA_ARGS__)
#define PASSES(...) EXPRESSION(0, __VA_ARGS__)
#define RECORDS_TWO(...) EXPRESSION(2, __VA_ARGS__)

TYPED_TEST(Interface, Operators) {
  RECORDS(a + b);
  RECORDS(a - b);
  RECORDS(a * b);
  RECORDS(a / b);
  RECORDS(a % b);
  RECORDS(-a);
  PASSES(+a);
  RECORDS(a << 3);
  RECORDS(a >> 3);
  RECORDS(a << -70);
  RECORDS(a + 7);
  RECORDS(a - 7);
  RECORDS(a * 7);
  RECORDS(a / 7);
  RECORDS(a % 7);
  RECORDS(a / 0);
  RECORDS(a * (std::int64_t{1} << 40));
  RECORDS(7U + a);
  RECORDS(7 - a);
  RECORDS(7 * a);
  RECORDS([](auto x, auto y) {
    x += y;
    return x;
  }(a, b));
  RECORDS([](auto x, auto y) {
    x -= y;
    return x;
  }(a, b));
  RECORDS([](auto x, auto y) {
    x *= y;
    return x;
  }(a, b));
  RECORDS([](auto x, auto y) {
    x /= y;
    return x;
  }(a, b));
  RECORDS([](auto x, auto y) {
    x %= y;
    return x;
  }(a, b));
  RECORDS([](auto x) {
    x += 5;
    return x;
  }(a));
  RECORDS([](auto x) {
    x -= 5;
    return x;
  }(a));
  RECORDS([](auto x) {
    x *= 5;
    return x;
  }(a));
  RECORDS([](auto x) {
    x /= 5;
    return x;
  }(a));
  RECORDS([](auto x) {
    x %= 5;
    return x;
  }(a));
  RECORDS([](auto x) {
    x <<= 2;
    return x;
  }(a));
  RECORDS([](auto x) {
    x >>= 2;
    return x;
  }(a));
  RECORDS([](auto x) {
    x <<= 2U;
    return x;
  }(a));
  RECORDS(a << 2U);
  RECORDS(a >> std::size_t{2});
  RECORDS([](auto x) {
    ++x;
    return x;
  }(a));
  RECORDS([](auto x) {
    --x;
    return x;
  }(a));
  RECORDS([](auto x) {
    const auto old = x++;
    return std::pair(x, old);
  }(a));
  RECORDS([](auto x) {
    const auto old = x--;
    return std::pair(x, old);
  }(a));
  PASSES(a == b);
  PASSES(a < b);
  PASSES(a <= 3);
  PASSES(3 > a);
  PASSES(a != 3);
  PASSES((a <=> b) < 0);
}

TYPED_TEST(Interface, Conversions) {
  RECORDS(T::from_raw(static_cast<typename T::raw_type>(17)));
  RECORDS(T(17));
  RECORDS(T(1.7));
  RECORDS(T(-1.7F));
  RECORDS(T(std::numeric_limits<double>::quiet_NaN()));
  RECORDS(T(q4_12(1.75)));
  PASSES(a.raw());
  PASSES(static_cast<double>(a));
  PASSES(static_cast<float>(a));
  PASSES(static_cast<int>(a));
  PASSES(to_integer<rounding::half_even>(a));
  PASSES(to_string(a));
  PASSES([](auto x) {
    std::ostringstream out;
    out << x;
    return out.str();
  }(a));
  PASSES([](auto x) {
    std::array<char, 200> text{};
    return std::string(text.data(), to_chars(text.data(), text.data() + text.size(), x).ptr);
  }(a));
  PASSES(std::to_integer<int>(to_bytes<std::endian::big>(a)[0]));
  PASSES(std::hash<T>{}(a) % 1000);
  PASSES((std::numeric_limits<T>::max)());
  RECORDS([](auto x) {
    std::istringstream("1.25") >> x;
    return x;
  }(a));
  RECORDS([](auto x) {
    const std::string text = "1.25";
    from_chars(text.data(), text.data() + text.size(), x);
    return x;
  }(a));
  RECORDS([](auto x) {
    const std::array<std::byte, sizeof(x)> bytes{std::byte{1}};
    return from_bytes<decltype(x), std::endian::big>(bytes);
  }(a));
}

TYPED_TEST(Interface, Functions) {
  RECORDS(floor(a));
  RECORDS(ceil(a));
  RECORDS((round)(a));
  RECORDS(trunc(a));
  RECORDS((abs)(a));
  RECORDS((min)(a, b));
  RECORDS((max)(a, b));
  RECORDS([](auto x, auto y) {
    using std::min;
    return min(x, y);
  }(a, b));
  RECORDS([](auto x, auto y) {
    using std::max;
    return max(x, y);
  }(a, b));
  RECORDS_TWO(clamp(a, b, c));
  RECORDS(sqrt(a));
  RECORDS(mul_add(a, b, c));
  RECORDS(lerp(a, b, c));
  RECORDS(mul_div(a, b, c));
  RECORDS(fmod(a, b));
  RECORDS(rint(a));
  RECORDS(nearbyint(a));
  RECORDS(copysign(a, b));
  RECORDS(nextafter(a, b));
  RECORDS(nexttoward(a, b));
  RECORDS([](auto x) {
    decltype(x) whole;
    const auto rest = modf(x, &whole);
    return std::pair(rest, whole);
  }(a));
  PASSES((signbit)(a));
  PASSES((isfinite)(a));
  PASSES((isinf)(a));
  PASSES((isnan)(a));
  PASSES((isnormal)(a));
  RECORDS(reciprocal(a));
  RECORDS(hypot(a, b));
  RECORDS(hypot(a, b, c));
  RECORDS(try_divide(a, b));
  RECORDS(dot(std::array{a, b, c}, std::array{c, c, b}));
  if constexpr (std::is_signed_v<typename TypeParam::raw_type>) {
    RECORDS(remainder(a, b));
    RECORDS([](auto x, auto y) {
      int n = 0;
      const auto rest = remquo(x, y, &n);
      return std::pair(rest, n);
    }(a, b));
  }
  if constexpr (TypeParam::rules.divisor == divisor_width::full &&
                TypeParam::rules.fault != divide_fault::unsigned_quotient) {
    RECORDS(divide<T>(a, b));
  }
  RECORDS(add<T>(a, b));
  RECORDS(subtract<T>(a, b));
  RECORDS(multiply<T>(a, b));
  RECORDS(ratio<T>(7, 3));
  RECORDS(sqrt<T>(a));
  RECORDS(hypot<T>(a, b));
  RECORDS(hypot<T>(a, b, c));
  RECORDS(dot<T>(std::array{a, b, c}, std::array{c, c, b}));
  EXPRESSION(5,
             accumulator<T>().add(a).subtract(b).add_product(a, c).subtract_product(b, c).result());
  EXPRESSION(2, accumulator<T>().add_product(a, c).template result<T>());
}

/// Another format, plain if T is plain and recorded if T is recorded.
template <class T>
using Other = std::conditional_t<record::detail::is_recorded<T>, recorded_number<q4_12>, q4_12>;

TYPED_TEST(Interface, ResultsInAnotherFormat) {
  RECORDS(sqrt<Other<T>>(a));
  RECORDS(hypot<Other<T>>(a, b));
  RECORDS(hypot<Other<T>>(a, b, c));
  RECORDS(dot<Other<T>>(std::array{a, b, c}, std::array{c, c, b}));
  EXPRESSION(2, accumulator<T>().add_product(a, c).template result<Other<T>>());
  // Two records, because the conversion is recorded, too.
  RECORDS_TWO(hypot<T>(a, Other<T>(b)));
  RECORDS_TWO(hypot<Other<T>>(a, Other<T>(b), c));
  RECORDS_TWO(dot<T>(std::array{a}, std::array{Other<T>(b)}));
}

TYPED_TEST(Interface, Overflow) {
#define FORMS(operation, ...)                    \
  RECORDS(checked_##operation(__VA_ARGS__));     \
  RECORDS(overflowing_##operation(__VA_ARGS__)); \
  RECORDS(saturating_##operation(__VA_ARGS__));  \
  RECORDS(wrapping_##operation(__VA_ARGS__))
  FORMS(add, a, b);
  FORMS(subtract, a, b);
  FORMS(multiply, a, b);
  FORMS(mul_add, a, b, c);
  FORMS(negate, a);
  FORMS(abs, a);
  FORMS(shift_left, a, 5);
  FORMS(divide, a, b);
#undef FORMS
  RECORDS(checked_remainder(a, b));
  RECORDS(checked_sqrt(a));
  RECORDS([](auto x, auto y) {
    sticky_status s;
    const auto sum = s.add(x, y);
    return std::pair(sum, s.overflow());
  }(a, b));
}

template <class Number>
class InterfaceFunctions : public Interface<Number> {};
using Narrow = testing::Types<q16_16, q16_16_saturating, q16_16_trapping, q8_8, q2_14>;
TYPED_TEST_SUITE(InterfaceFunctions, Narrow);

TYPED_TEST(InterfaceFunctions, OfAtMost32Bits) {
  RECORDS(sin(a));
  RECORDS(cos(a));
  RECORDS(tan(a));
  RECORDS(sin_of_degrees(a));
  RECORDS(cos_of_degrees(a));
  RECORDS(tan_of_degrees(a));
  RECORDS(sin_of_turns(a));
  RECORDS(cos_of_turns(a));
  RECORDS(tan_of_turns(a));
  RECORDS(sin_of_tenths<T>(301));
  RECORDS(cos_of_tenths<T>(301));
  RECORDS(sin_cos_of_tenths<T>(301));
  RECORDS(sin_of_tenths<T>('z'));
  RECORDS(exp(a));
  RECORDS(exp2(a));
  RECORDS(expm1(a));
  RECORDS(log(a));
  RECORDS(log1p(a));
  RECORDS(log2(a));
  RECORDS(log10(a));
  RECORDS(sinh(a));
  RECORDS(cosh(a));
  RECORDS(tanh(a));
  RECORDS(cbrt(a));
  RECORDS(rsqrt(a));
  RECORDS(pow(a, b));
  RECORDS(atan(a));
  RECORDS(atan2(a, b));
  RECORDS(asin(a));
  RECORDS(acos(a));
  RECORDS(sin_cos(a));
  RECORDS(sin_cos_of_degrees(a));
  RECORDS(sin_cos_of_turns(a));
}

TYPED_TEST(InterfaceFunctions, ResultsInAnotherFormat) {
  RECORDS(sin<Other<T>>(a));
  RECORDS(cos<Other<T>>(a));
  RECORDS(tan<Other<T>>(a));
  RECORDS(sin_of_degrees<Other<T>>(a));
  RECORDS(cos_of_degrees<Other<T>>(a));
  RECORDS(tan_of_degrees<Other<T>>(a));
  RECORDS(sin_of_turns<Other<T>>(a));
  RECORDS(cos_of_turns<Other<T>>(a));
  RECORDS(tan_of_turns<Other<T>>(a));
  RECORDS(sin_cos<Other<T>>(a));
  RECORDS(sin_cos_of_degrees<Other<T>>(a));
  RECORDS(sin_cos_of_turns<Other<T>>(a));
  RECORDS(exp<Other<T>>(a));
  RECORDS(exp2<Other<T>>(a));
  RECORDS(expm1<Other<T>>(a));
  RECORDS(sinh<Other<T>>(a));
  RECORDS(cosh<Other<T>>(a));
  RECORDS(tanh<Other<T>>(a));
  RECORDS(log<Other<T>>(a));
  RECORDS(log1p<Other<T>>(a));
  RECORDS(log2<Other<T>>(a));
  RECORDS(log10<Other<T>>(a));
  RECORDS(atan<Other<T>>(a));
  RECORDS(asin<Other<T>>(a));
  RECORDS(acos<Other<T>>(a));
  RECORDS(atan2<Other<T>>(a, b));
  RECORDS(sin<T>(a));
  RECORDS(atan2<T>(a, b));
}

// The rest of the interface.
using R = recorded<q16_16>;
static_assert(sizeof(R) == sizeof(q16_16) && std::is_trivially_copyable_v<R>);
static_assert(is_number_v<R> && any_number<R>);
static_assert(std::is_same_v<std::common_type_t<R, int>, R>);
static_assert(pi_v<R> == pi_v<q16_16> && std::numbers::e_v<R> == std::numbers::e_v<q16_16>);
static_assert(R(1.5) * 2 == R(3) && noexcept(R() + R()) &&
              !noexcept(recorded<q16_16_trapping>() + recorded<q16_16_trapping>()));
static_assert(std::integral_constant<int, static_cast<int>(R(7) / R(2))>::value == 3);
template <R Value>
struct Argument {};
[[maybe_unused]] constexpr Argument<R(0.5)> argument;

/// What does not compile with the type does not compile with the recorded type either.
template <class T>
inline constexpr bool refuses = !requires(T a) {
  a + 1.5;
}
&&!requires(T a) { a == 0.5; }
&&!requires(T a) { 1 / a; }
&&!requires(T a, recorded<q8_8> b) { a + b; }
&&!requires(T a) { a << 1.5; }
&&!requires(T a) { a >>= 1.5; }
&&!requires(T a) { a << a; }
&&!requires(T a) { a & 1; }
&&!requires(T a) { T::from_raw(1.5); }
&&!std::is_convertible_v<int, T> && !std::is_convertible_v<T, int> &&
    !std::is_constructible_v<T, const char*> && !std::is_constructible_v<bool, T>;
static_assert(refuses<R>);

}  // namespace
