/// @file
/// Recorded forms of the operations with overflow as a value, between formats, and with exact
/// intermediate results.
#pragma once

#include <concepts>
#include <optional>
#include <type_traits>

#include "fixed/checked.hpp"
#include "fixed/mixed.hpp"
#include "fixed/record/functions.hpp"
#include "fixed/record/number.hpp"
#include "fixed/wide.hpp"

namespace fixproof {

namespace record::detail {

/// Returns the plain number of a plain or a recorded number.
template <class Number>
constexpr Number plain(Number x) noexcept {
  return x;
}
template <class Number>
constexpr Number plain(recorded_number<Number> x) noexcept {
  return x.value_;
}
template <class Type>
struct plain_type_of {
  using type = Type;
};
template <class Number>
struct plain_type_of<recorded_number<Number>> {
  using type = Number;
};

/// Returns the result of an operation with recorded numbers in place of plain ones.
template <class Number>
constexpr std::optional<recorded_number<Number>> as_recorded(
    const std::optional<Number>& x) noexcept {
  return x ? std::optional<recorded_number<Number>>(*x) : std::nullopt;
}
template <class Number>
constexpr overflowing<recorded_number<Number>> as_recorded(const overflowing<Number>& x) noexcept {
  return {x.value, x.overflow};
}
template <class Number>
constexpr recorded_number<Number> as_recorded(Number x) noexcept {
  return x;
}

}  // namespace record::detail

/// @cond
// NOLINTBEGIN(cppcoreguidelines-macro-usage,bugprone-macro-parentheses): defines functions
#define FIXPROOF_RECORDED(name, parameters, plain_parameters, ...)                              \
  template <class Number>                                                                       \
  [[nodiscard]] constexpr auto name parameters noexcept {                                       \
    return record::detail::as_recorded(record::detail::logged<record::kind::name, Number>(      \
        from, [] plain_parameters { return fixproof::name FIXPROOF_ARGUMENTS; }, __VA_ARGS__)); \
  }
#define FIXPROOF_RECORDED_FORMS(operation, parameters, plain_parameters, ...)           \
  FIXPROOF_RECORDED(checked_##operation, parameters, plain_parameters, __VA_ARGS__)     \
  FIXPROOF_RECORDED(overflowing_##operation, parameters, plain_parameters, __VA_ARGS__) \
  FIXPROOF_RECORDED(saturating_##operation, parameters, plain_parameters, __VA_ARGS__)  \
  FIXPROOF_RECORDED(wrapping_##operation, parameters, plain_parameters, __VA_ARGS__)
#define FIXPROOF_ONE (recorded_number<Number> a, record::place from = FIXPROOF_HERE)
#define FIXPROOF_TWO \
  (recorded_number<Number> a, recorded_number<Number> b, record::place from = FIXPROOF_HERE)

#define FIXPROOF_ARGUMENTS (x, y)
FIXPROOF_RECORDED_FORMS(add, FIXPROOF_TWO, (Number x, Number y), a.value_, b.value_)
FIXPROOF_RECORDED_FORMS(subtract, FIXPROOF_TWO, (Number x, Number y), a.value_, b.value_)
FIXPROOF_RECORDED_FORMS(multiply, FIXPROOF_TWO, (Number x, Number y), a.value_, b.value_)
FIXPROOF_RECORDED_FORMS(divide, FIXPROOF_TWO, (Number x, Number y), a.value_, b.value_)
FIXPROOF_RECORDED(checked_remainder, FIXPROOF_TWO, (Number x, Number y), a.value_, b.value_)
FIXPROOF_RECORDED_FORMS(shift_left,
                        (recorded_number<Number> a, int places, record::place from = FIXPROOF_HERE),
                        (Number x, int y), a.value_, places)
#undef FIXPROOF_ARGUMENTS
#define FIXPROOF_ARGUMENTS (x)
FIXPROOF_RECORDED_FORMS(negate, FIXPROOF_ONE, (Number x), a.value_)
FIXPROOF_RECORDED_FORMS(abs, FIXPROOF_ONE, (Number x), a.value_)
FIXPROOF_RECORDED(checked_sqrt, FIXPROOF_ONE, (Number x), a.value_)
#undef FIXPROOF_ARGUMENTS
#define FIXPROOF_ARGUMENTS (x, y, z)
FIXPROOF_RECORDED_FORMS(mul_add,
                        (recorded_number<Number> a, recorded_number<Number> b,
                         recorded_number<Number> c, record::place from = FIXPROOF_HERE),
                        (Number x, Number y, Number z), a.value_, b.value_, c.value_)
#undef FIXPROOF_ARGUMENTS
#undef FIXPROOF_ONE
#undef FIXPROOF_TWO
#undef FIXPROOF_RECORDED_FORMS
#undef FIXPROOF_RECORDED

#define FIXPROOF_RECORDED_MIXED(name, kind_name)                                      \
  template <class To, any_number First, any_number Second>                            \
  requires(record::detail::is_recorded<First> || record::detail::is_recorded<Second>) \
      [[nodiscard]] constexpr To                                                      \
      name(First a, Second b, record::place from = FIXPROOF_HERE) noexcept(           \
          noexcept(fixproof::name<typename record::detail::plain_type_of<To>::type>(  \
              record::detail::plain(First()), record::detail::plain(Second())))) {    \
    using Number = typename record::detail::plain_type_of<To>::type;                  \
    return record::detail::logged<record::kind::kind_name, Number>(                   \
        from, [](auto x, auto y) { return fixproof::name<Number>(x, y); },            \
        record::detail::plain(a), record::detail::plain(b));                          \
  }
FIXPROOF_RECORDED_MIXED(add, add_to)
FIXPROOF_RECORDED_MIXED(subtract, subtract_to)
FIXPROOF_RECORDED_MIXED(multiply, multiply_to)
FIXPROOF_RECORDED_MIXED(divide, divide_to)
FIXPROOF_RECORDED_MIXED(hypot, hypot)
#undef FIXPROOF_RECORDED_MIXED
// NOLINTEND(cppcoreguidelines-macro-usage,bugprone-macro-parentheses)
/// @endcond

/// As ratio() of plain numbers.
template <class Recorded, detail::integer Int>
requires record::detail::is_recorded<Recorded>
[[nodiscard]] constexpr Recorded ratio(Int n, Int d) noexcept(Recorded::divide_never_throws) {
  using Number = typename Recorded::plain_type;
  return record::detail::logged<record::kind::ratio, Number>(
      record::nowhere, [](Int x, Int y) { return fixproof::ratio<Number>(x, y); }, n, d);
}

/// The accumulator of recorded numbers. It records every term and the result.
template <class Number, std::uint64_t Terms>
class accumulator<recorded_number<Number>, Terms> {
  using recorded = recorded_number<Number>;

 public:
  /// Zero.
  constexpr accumulator() noexcept = default;

  /// @name As in the accumulator of plain numbers
  /// \{

  /// Adds or subtracts a number or a product.
  constexpr accumulator& add(recorded x, record::place from = FIXPROOF_HERE) noexcept {
    sum_.add(x.value_);
    return noted<record::kind::accumulator_add>(from, x.value_);
  }
  constexpr accumulator& subtract(recorded x, record::place from = FIXPROOF_HERE) noexcept {
    sum_.subtract(x.value_);
    return noted<record::kind::accumulator_subtract>(from, x.value_);
  }
  constexpr accumulator& add_product(recorded a, recorded b,
                                     record::place from = FIXPROOF_HERE) noexcept {
    sum_.add_product(a.value_, b.value_);
    return noted<record::kind::accumulator_add_product>(from, a.value_, b.value_);
  }
  constexpr accumulator& subtract_product(recorded a, recorded b,
                                          record::place from = FIXPROOF_HERE) noexcept {
    sum_.subtract_product(a.value_, b.value_);
    return noted<record::kind::accumulator_subtract_product>(from, a.value_, b.value_);
  }
  /// \}

  /// The sum, rounded once.
  [[nodiscard]] constexpr recorded result(record::place from = FIXPROOF_HERE) const
      noexcept(Number::multiply_never_throws) {
    return record::detail::logged<record::kind::accumulator_result, Number>(
        from, [this] { return sum_.result(); });
  }
  /// The sum as a To, rounded once.
  template <any_number To>
  [[nodiscard]] constexpr To result(record::place from = FIXPROOF_HERE) const
      noexcept(To::multiply_never_throws) {
    using plain = typename record::detail::plain_type_of<To>::type;
    return record::detail::logged<record::kind::accumulator_result, plain>(
        from, [this] { return sum_.template result<plain>(); });
  }

 private:
  template <record::kind Kind, class... Operands>
  constexpr accumulator& noted(record::place from, Operands... operands) noexcept {
    if (!std::is_constant_evaluated()) record::detail::note_term<Kind, Number>(from, operands...);
    return *this;
  }

  accumulator<Number, Terms> sum_;
};

}  // namespace fixproof
