/// @file
/// The number type that records its operations.
#pragma once

#include <compare>
#include <concepts>
#include <type_traits>
#include <utility>

#include "fixed/fixed.hpp"
#include "fixed/record/log.hpp"
#include "fixed/record/note.hpp"

namespace fixproof {

template <class Number>
class recorded_number;

namespace record::detail {

template <class Type>
inline constexpr bool is_recorded = false;
template <class Number>
inline constexpr bool is_recorded<recorded_number<Number>> = true;

/// Returns a place. As a default argument, FIXPROOF_HERE gives the place of the call.
constexpr place here(const char* file, unsigned line) noexcept { return {file, line}; }

}  // namespace record::detail

/// The place of a call, as the default of an argument.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the compiler evaluates it where it is a default
// argument
#define FIXPROOF_HERE fixproof::record::detail::here(__builtin_FILE(), __builtin_LINE())

/// A Number, such as q16_16, that puts each of its operations into the log of its thread, with the
/// operands and the result.
///
/// It has the interface and the results of Number. It also works in constant expressions, which are
/// not recorded. A Number converts to it, so literals and constants of Number can be used with it;
/// plain() converts back. Copies, comparisons and conversions to other types make no number and are
/// not recorded.
template <class Number>
class recorded_number {
 public:
  /// @name As in Number
  /// \{

  /// The members of Number with these names.
  using raw_type = typename Number::raw_type;
  static constexpr int fraction_bits = Number::fraction_bits;
  static constexpr policy rules = Number::rules;
  static constexpr bool never_throws = Number::never_throws;
  static constexpr bool multiply_never_throws = Number::multiply_never_throws;
  static constexpr bool divide_never_throws = Number::divide_never_throws;
  /// \}

  /// The number type whose operations it records.
  using plain_type = Number;

  /// An operand with the place of the operation. An operator cannot have default arguments, but the
  /// conversion of its operand can, and the compiler evaluates them at the place of the operator.
  struct operand {
    Number value;        ///< The plain number.
    record::place from;  ///< The place of the operation.

    // NOLINTBEGIN(google-explicit-constructor): converts the operands of operators
    /// Converts a recorded number.
    constexpr operand(recorded_number x, record::place at = FIXPROOF_HERE) noexcept
        : value(x.value_), from(at) {}
    /// Converts a plain number.
    constexpr operand(Number x, record::place at = FIXPROOF_HERE) noexcept : value(x), from(at) {}
    // NOLINTEND(google-explicit-constructor)
  };
  /// The left side of a compound assignment, with its place.
  struct target {
    recorded_number& value;  ///< The number to assign to.
    record::place from;      ///< The place of the assignment.

    /// Refers to a number.
    // NOLINTNEXTLINE(google-explicit-constructor): as above
    constexpr target(recorded_number& x, record::place at = FIXPROOF_HERE) noexcept
        : value(x), from(at) {}
  };

  /// Zero.
  constexpr recorded_number() noexcept = default;
  /// The same number. This is not recorded: either the operation that made the number was, or it is
  /// a constant.
  // NOLINTNEXTLINE(google-explicit-constructor): so that literals remain usable
  constexpr recorded_number(Number x) noexcept : value_(x) {}

  /// @name Conversions
  /// \{

  /// As those of Number.
  template <detail::integer Int>
  explicit constexpr recorded_number(Int x,
                                     record::place from = FIXPROOF_HERE) noexcept(never_throws)
      : value_(converted(x, from)) {}
  template <detail::binary_float Float>
  explicit constexpr recorded_number(Float x,
                                     record::place from = FIXPROOF_HERE) noexcept(never_throws)
      : value_(converted(x, from)) {}
  template <class Raw, int Point, policy Rules>
  requires(!std::same_as<number<Raw, Point, Rules>, Number>) explicit constexpr recorded_number(
      number<Raw, Point, Rules> x, record::place from = FIXPROOF_HERE) noexcept(never_throws)
      : value_(converted(x, from)) {}
  template <class Other>
  requires(!std::same_as<Other, Number>) explicit constexpr recorded_number(
      recorded_number<Other> x, record::place from = FIXPROOF_HERE) noexcept(never_throws)
      : value_(converted(x.value_, from)) {}
  explicit constexpr operator Number() const noexcept { return value_; }
  template <std::floating_point Float>
  requires detail::binary_float<Float>
  explicit constexpr operator Float() const noexcept { return static_cast<Float>(value_); }
  template <std::integral Int>
  requires(!std::same_as<Int, bool>) explicit constexpr operator Int() const noexcept {
    return static_cast<Int>(value_);
  }
  /// \}

  /// As Number::from_raw().
  [[nodiscard]] static constexpr recorded_number from_raw(
      raw_type raw, record::place from = FIXPROOF_HERE) noexcept {
    const Number result = Number::from_raw(raw);
    if (!std::is_constant_evaluated()) {
      record::detail::note<record::kind::from_raw, Number>(from, result, result);
    }
    return result;
  }
  template <class Type>
  requires std::is_floating_point_v<Type>
  static recorded_number from_raw(Type, record::place = {}) = delete;

  /// The stored integer.
  [[nodiscard]] constexpr raw_type raw() const noexcept { return value_.raw(); }
  /// The plain number, whose operations are not recorded.
  [[nodiscard]] constexpr Number plain() const noexcept { return value_; }

  /// @name Comparisons
  /// \{

  /// As those of Number.
  friend constexpr bool operator==(recorded_number, recorded_number) noexcept = default;
  friend constexpr auto operator<=>(recorded_number, recorded_number) noexcept = default;
  template <detail::integer Int>
  friend constexpr bool operator==(recorded_number a, Int b) noexcept {
    return a.value_ == b;
  }
  template <detail::integer Int>
  friend constexpr std::strong_ordering operator<=>(recorded_number a, Int b) noexcept {
    return a.value_ <=> b;
  }
  /// \}

  /// The number itself.
  [[nodiscard]] constexpr recorded_number operator+() const noexcept { return *this; }
  /// As the operators of Number, and recorded.
  [[nodiscard]] friend constexpr recorded_number operator-(operand a) noexcept(never_throws) {
    return record::detail::logged<record::kind::negate, Number>(
        a.from, [](Number x) { return -x; }, a.value);
  }

  /// @cond
  // NOLINTBEGIN(cppcoreguidelines-macro-usage,bugprone-macro-parentheses): defines operators
#define FIXPROOF_RECORDED_OPERATOR(op, name, is_noexcept)                                       \
  [[nodiscard]] friend constexpr recorded_number operator op(recorded_number a,                 \
                                                             operand b) noexcept(is_noexcept) { \
    return record::detail::logged<record::kind::name, Number>(                                  \
        b.from, [](Number x, Number y) { return x op y; }, a.value_, b.value);                  \
  }                                                                                             \
  template <detail::integer Int>                                                                \
  [[nodiscard]] friend constexpr recorded_number operator op(operand a,                         \
                                                             Int b) noexcept(is_noexcept) {     \
    return record::detail::logged<record::kind::name##_integer, Number>(                        \
        a.from, [](Number x, Int y) { return x op y; }, a.value, b);                            \
  }                                                                                             \
  friend constexpr recorded_number& operator op##=(target a,                                    \
                                                   recorded_number b) noexcept(is_noexcept) {   \
    return a.value = record::detail::logged<record::kind::name, Number>(                        \
               a.from, [](Number x, Number y) { return x op y; }, a.value.value_, b.value_);    \
  }                                                                                             \
  template <detail::integer Int>                                                                \
  friend constexpr recorded_number& operator op##=(target a, Int b) noexcept(is_noexcept) {     \
    return a.value = record::detail::logged<record::kind::name##_integer, Number>(              \
               a.from, [](Number x, Int y) { return x op y; }, a.value.value_, b);              \
  }
#define FIXPROOF_RECORDED_SHIFT(op, name)                                                         \
  [[nodiscard]] friend constexpr recorded_number operator op(operand x,                           \
                                                             int places) noexcept(never_throws) { \
    return record::detail::logged<record::kind::name, Number>(                                    \
        x.from, [](Number a, int n) { return a op n; }, x.value, places);                         \
  }                                                                                               \
  friend constexpr recorded_number& operator op##=(target x, int places) noexcept(never_throws) { \
    return x.value = record::detail::logged<record::kind::name, Number>(                          \
               x.from, [](Number a, int n) { return a op n; }, x.value.value_, places);           \
  }                                                                                               \
  [[nodiscard]] friend constexpr recorded_number operator op(                                     \
      operand x, detail::integer auto places) noexcept(never_throws) {                            \
    return x op detail::places_of(places);                                                        \
  }                                                                                               \
  friend constexpr recorded_number& operator op##=(                                               \
      target x, detail::integer auto places) noexcept(never_throws) {                             \
    return operator op##=(x, detail::places_of(places));                                          \
  }                                                                                               \
  friend recorded_number operator op(operand, std::floating_point auto) = delete;                 \
  friend recorded_number& operator op##=(target, std::floating_point auto) = delete;
#define FIXPROOF_RECORDED_STEP(op, name)                                                   \
  friend constexpr recorded_number& operator op##op(target x) noexcept(never_throws) {     \
    return x.value = record::detail::logged<record::kind::name##_integer, Number>(         \
               x.from, [](Number a, int n) { return a op n; }, x.value.value_, 1);         \
  }                                                                                        \
  friend constexpr recorded_number operator op##op(target x, int) noexcept(never_throws) { \
    const recorded_number before = x.value;                                                \
    x.value = record::detail::logged<record::kind::name##_integer, Number>(                \
        x.from, [](Number a, int n) { return a op n; }, x.value.value_, 1);                \
    return before;                                                                         \
  }
  // NOLINTEND(cppcoreguidelines-macro-usage,bugprone-macro-parentheses)
  FIXPROOF_RECORDED_OPERATOR(+, add, never_throws)
  FIXPROOF_RECORDED_OPERATOR(-, subtract, never_throws)
  FIXPROOF_RECORDED_OPERATOR(*, multiply, multiply_never_throws)
  FIXPROOF_RECORDED_OPERATOR(/, divide, divide_never_throws)
  FIXPROOF_RECORDED_OPERATOR(%, remainder, divide_never_throws)
  FIXPROOF_RECORDED_SHIFT(<<, shift_left)
  FIXPROOF_RECORDED_SHIFT(>>, shift_right)
  FIXPROOF_RECORDED_STEP(+, add)
  FIXPROOF_RECORDED_STEP(-, subtract)
  /// @endcond
#undef FIXPROOF_RECORDED_OPERATOR
#undef FIXPROOF_RECORDED_SHIFT
#undef FIXPROOF_RECORDED_STEP

  /// @name Operators with an integer first
  /// \{

  /// As those of Number. A sum or product is recorded as one with the number first.
  template <detail::integer Int>
  [[nodiscard]] friend constexpr recorded_number operator+(Int a,
                                                           operand b) noexcept(never_throws) {
    return record::detail::logged<record::kind::add_integer, Number>(
        b.from, [](Number x, Int y) { return y + x; }, b.value, a);
  }
  template <detail::integer Int>
  [[nodiscard]] friend constexpr recorded_number operator-(Int a,
                                                           operand b) noexcept(never_throws) {
    return record::detail::logged<record::kind::integer_subtract, Number>(
        b.from, [](Number x, Int y) { return y - x; }, b.value, a);
  }
  template <detail::integer Int>
  [[nodiscard]] friend constexpr recorded_number operator*(Int a, operand b) noexcept(
      multiply_never_throws) {
    return record::detail::logged<record::kind::multiply_integer, Number>(
        b.from, [](Number x, Int y) { return y * x; }, b.value, a);
  }
  /// \}

 private:
  static constexpr Number converted(auto x, record::place from) noexcept(never_throws) {
    return record::detail::logged<record::kind::convert, Number>(
        from, [](auto y) { return Number(y); }, x);
  }

 public:
  /// The plain number; use plain() instead. It is public for the same reason as number::raw_.
  Number value_{};
};

/// @cond
template <class Number>
inline constexpr bool detail::is_number<recorded_number<Number>> = true;
/// @endcond

}  // namespace fixproof
