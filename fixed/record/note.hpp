/// @file
/// Puts one operation into the log.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "fixed/checked.hpp"
#include "fixed/number.hpp"
#include "fixed/record/layout.hpp"
#include "fixed/record/log.hpp"
#include "fixed/sine.hpp"

namespace fixproof::record::detail {

/// An operand or a result: its type and its bits.
struct value {
  std::uint32_t type;
  word bits;
};

/// The hash of many operands, as one operand.
struct digest {
  word hash;
};

constexpr std::uint32_t class_code(value_class c) noexcept { return static_cast<std::uint32_t>(c); }

/// Returns an integer in two's complement, extended to 64 bits by its sign.
constexpr word bits_of(std::integral auto integer) noexcept { return static_cast<word>(integer); }

template <class Raw, int Point, policy Rules>
constexpr value value_of(number<Raw, Point, Rules> x) noexcept {
  return {type_code<number<Raw, Point, Rules>>, bits_of(x.raw())};
}
template <std::integral Int>
constexpr value value_of(Int x) noexcept {
  if constexpr (std::same_as<Int, bool>) {
    return {class_code(value_class::boolean), x ? word{1} : word{0}};
  } else {
    // `long` has 32 bits on some machines, so every integer is recorded with 64 bits.
    const bool is_above_signed = x > 0 && static_cast<std::int64_t>(x) < 0;
    return {integer_code(8, is_above_signed) | class_code(value_class::integer), bits_of(x)};
  }
}
constexpr value value_of(digest x) noexcept { return {class_code(value_class::digest), x.hash}; }

/// @name The values of a result
/// \{

/// A result may be a number or an integer, an optional number, a number and whether it overflowed,
/// or two values.
template <class Type>
constexpr std::array<value, 1> values_of(const Type& x) noexcept {
  return {value_of(x)};
}
template <class Raw, int Point, policy Rules>
constexpr std::array<value, 1> values_of(
    const std::optional<number<Raw, Point, Rules>>& x) noexcept {
  if (!x) return {value{type_code<number<Raw, Point, Rules>> | class_code(value_class::none), 0}};
  return {value_of(*x)};
}
template <class Raw, int Point, policy Rules>
constexpr std::array<value, 2> values_of(const overflowing<number<Raw, Point, Rules>>& x) noexcept {
  return {value_of(x.value), value_of(x.overflow)};
}
template <class Raw, int Point, policy Rules>
constexpr std::array<value, 2> values_of(const sin_and_cos<number<Raw, Point, Rules>>& x) noexcept {
  return {value_of(x.sin), value_of(x.cos)};
}
template <class First, class Second>
constexpr std::array<value, 2> values_of(const std::pair<First, Second>& x) noexcept {
  return {value_of(x.first), value_of(x.second)};
}
/// \}

/// Records any operands and results.
template <std::size_t Operands, std::size_t Results>
inline void note_long(word first, place from, const std::array<value, Operands>& operands,
                      const std::array<value, Results>& results) noexcept {
  constexpr std::size_t count = Operands + Results;
  static_assert(count <= max_values);
  constexpr std::size_t values = 1 + (count + 1) / 2;
  std::array<word, (values + count + 1) / 2 * 2> words{};
  words[0] = first | tag_is_long | word{Operands} << long_operands_shift |
             word{Results} << long_results_shift;
  std::size_t i = 0;
  const auto put_value = [&](const value& v) {
    words[1 + i / 2] |= word{v.type} << (i % 2 == 0 ? 0 : 32);
    words[values + i++] = v.bits;
  };
  for (const value& v : operands) put_value(v);
  for (const value& v : results) put_value(v);
  put(words, from);
}

/// Records one or two operands that have the type of the result. The second one may be an integer
/// of 32 bits.
template <kind Kind, class Number>
FIXED_INLINE inline void note_short(place from, word a, word b, Number result) noexcept {
  constexpr word tag = type_code<Number> | static_cast<std::uint32_t>(Kind);
  const word c = bits_of(result.raw());
  if constexpr (sizeof(typename Number::raw_type) == 8) {
    put(std::array<word, 4>{tag, a, b, c}, from);
  } else {
    put(std::array<word, 2>{tag | c << 32, (a & 0xffffffff) | b << 32}, from);
  }
}

/// Records a number that comes from outside.
template <kind Kind, class Number>
FIXED_INLINE inline void note_input(place from, Number x) noexcept {
  note_short<Kind>(from, 0, 0, x);
}

/// Records an operation whose operands are numbers and integers.
template <kind Kind, class Number, class Result, class... Operands>
FIXED_INLINE inline void note_exact(place from, const Result& result,
                                    const Operands&... operands) noexcept {
  if constexpr (std::same_as<Result, Number>) {
    if constexpr (sizeof...(Operands) <= 2 && (std::same_as<Operands, Number> && ...)) {
      static_assert(sizeof...(Operands) == short_operands(Kind),
                    "desync would show other operands");
      const std::array<word, 3> raw{bits_of(operands.raw())...};
      note_short<Kind>(from, raw[0], raw[1], result);
      return;
    } else if constexpr (has_integer(Kind)) {
      const auto write = [&](Number a, auto b) FIXED_INLINE {
        if (!std::in_range<std::int32_t>(b)) return false;
        note_short<Kind>(from, bits_of(a.raw()), bits_of(b), result);
        return true;
      };
      if (write(operands...)) return;
    }
  }
  const std::array<value, sizeof...(Operands)> values{value_of(operands)...};
  note_long(word{type_code<Number>} | static_cast<word>(Kind), from, values, values_of(result));
}

/// Records an operation of the type `Number`.
template <kind Kind, class Number, class Result, class... Operands>
FIXED_INLINE inline void note(place from, const Result& result,
                              const Operands&... operands) noexcept {
  if constexpr ((std::floating_point<Operands> || ...)) {
    (put_input(static_cast<double>(operands)), ...);
    note_input<Kind>(from, result);
  } else {
    note_exact<Kind, Number>(from, result, operands...);
  }
}
/// Records an operation without a result, a term of a sum.
template <kind Kind, class Number, class... Operands>
inline void note_term(place from, const Operands&... operands) noexcept {
  const std::array<value, sizeof...(Operands)> values{value_of(operands)...};
  note_long(word{type_code<Number>} | static_cast<word>(Kind), from, values,
            std::array<value, 0>{});
}

/// Records an operation that threw.
template <kind Kind, class Number, class... Operands>
inline void note_throw(place from, const Operands&... operands) noexcept {
  constexpr word first = type_code<Number> | static_cast<word>(Kind) | long_threw;
  constexpr std::array<value, 0> nothing{};
  if constexpr ((std::floating_point<Operands> || ...)) {
    (put_input(static_cast<double>(operands)), ...);
    note_long(first, from, nothing, nothing);
  } else {
    const std::array<value, sizeof...(Operands)> values{value_of(operands)...};
    note_long(first, from, values, nothing);
  }
}

/// Returns `compute(operands...)`, and records the operation except in constant expressions.
template <kind Kind, class Number, class Compute, class... Operands>
FIXED_INLINE constexpr auto logged(place from, const Compute& compute,
                                   const Operands&... operands) {
  if (std::is_constant_evaluated()) return compute(operands...);
#if defined(__cpp_exceptions)
  if constexpr (!Number::never_throws || !Number::multiply_never_throws ||
                !Number::divide_never_throws) {
    try {
      const auto result = compute(operands...);
      note<Kind, Number>(from, result, operands...);
      return result;
    } catch (...) {
      note_throw<Kind, Number>(from, operands...);
      throw;
    }
  } else
#endif
  {
    const auto result = compute(operands...);
    note<Kind, Number>(from, result, operands...);
    return result;
  }
}

}  // namespace fixproof::record::detail
