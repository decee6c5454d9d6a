/// @file
/// Concepts and loads for spans of numbers, vertices and points.
#pragma once

#include <algorithm>
#include <array>  // std::data, std::size
#include <concepts>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "fixed/detail/inlining.hpp"
#include "fixed/detail/instead.hpp"
#include "fixed/detail/storage.hpp"
#include "fixed/math.hpp"

namespace fixproof::detail {

/// A range to whose elements Type a batch can write. An rvalue must be a view, such as std::span,
/// because results in a temporary are lost. `Range` is the type deduced for `Range&&`.
template <class Range, class Type>
concept written = std::same_as<Type, element_t<Range>> &&
    requires(std::conditional_t<std::is_lvalue_reference_v<Range>, Range, const Range&> range) {
  { *std::data(range) } -> std::same_as<Type&>;
};

/// A range to which numbers Number can be written.
template <class Range, class Number>
concept output_of = number_range<Range> && written<Range, Number>;

/// A range of numbers Number.
template <class Range, class Number>
concept input_of = number_range<Range> && std::same_as<Number, element_t<Range>>;

/// A type that can be initialised from two or three numbers Number.
template <class Type, class Number, std::size_t size>
concept made_of = (size == 2 &&
                   requires(Number n) {
                     Type{n, n};
                   }) ||
                  (size == 3 && requires(Number n) {
                    Type{n, n, n};
                  });

/// A type that keeps numbers Number as they are. Constructors may convert them, as that of
/// glm::vec3 does, so a class with constructors must have a number Number as `x` or `[0]`.
template <class Type, class Number>
concept keeps = std::is_aggregate_v<Type> || requires(Type t) {
  { t.x } -> std::same_as<Number&>;
} || requires(Type t) {
  { t[0] } -> std::same_as<Number&>;
};

/// A range whose elements consist of exactly `size` numbers Number.
template <class Range, class Number, std::size_t size>
concept tuples_of =
    is_number<Number> && std::is_trivially_copyable_v<element_t<Range>> &&
        std::is_standard_layout_v<element_t<Range>> &&
        sizeof(element_t<Range>) == size * sizeof(Number) &&
    made_of<element_t<Range>, Number, size>&& keeps<element_t<Range>, Number>&& sized<Range>;

template <class Range, class Number, std::size_t size>
concept output_tuples_of = tuples_of<Range, Number, size> && written<Range, element_t<Range>> &&
    std::is_copy_assignable_v<element_t<Range>>;

/// Returns a pointer to the first element, also if data() returns a class that converts to one.
template <class Range>
FIXED_ALWAYS_INLINE constexpr auto* start_of(Range& range) noexcept {
  return static_cast<std::remove_reference_t<decltype(*std::data(range))>*>(std::data(range));
}

/// Returns the length of the shortest range. Sizes may be signed, as in Qt. Compares two at a time,
/// because GCC 12 keeps a list of sizes in memory.
template <class First, class... Others>
FIXED_ALWAYS_INLINE constexpr std::size_t shortest(const First& first,
                                                   const Others&... others) noexcept {
  auto least = static_cast<std::size_t>(std::size(first));
  ((least = (std::min)(least, static_cast<std::size_t>(std::size(others)))), ...);
  return least;
}

/// Stored integers of numbers Number: of a vertex or of a point.
template <class Number, std::size_t size>
using raw_tuple = std::array<typename Number::raw_type, size>;

/// Loads an element of `size` numbers. Copies them one by one, because GCC 12 keeps the array in
/// memory after a memcpy of more than a register.
template <class Number, std::size_t size>
FIXED_ALWAYS_INLINE raw_tuple<Number, size> load_tuple(const void* base,
                                                       std::size_t index) noexcept {
  const auto* const from = static_cast<const char*>(base) + index * size * sizeof(Number);
  raw_tuple<Number, size> tuple;
  for (std::size_t c = 0; c < size; ++c)
    std::memcpy(&tuple[c], from + c * sizeof(Number), sizeof(Number));
  return tuple;
}

/// The same from columns.
template <class Number, std::size_t size>
FIXED_ALWAYS_INLINE raw_tuple<Number, size> load_tuple(const std::array<const Number*, size>& from,
                                                       std::size_t index) noexcept {
  raw_tuple<Number, size> tuple;
  for (std::size_t c = 0; c < size; ++c) tuple[c] = from[c][index].raw();
  return tuple;
}

template <class Number, std::size_t size>
void store_tuple(void* base, std::size_t index, const raw_tuple<Number, size>& tuple) noexcept {
  auto* const to = static_cast<char*>(base) + index * size * sizeof(Number);
  for (std::size_t c = 0; c < size; ++c)
    std::memcpy(to + c * sizeof(Number), &tuple[c], sizeof(Number));
}

template <class Number, std::size_t size>
void store_tuple(const std::array<Number*, size>& to, std::size_t index,
                 const raw_tuple<Number, size>& tuple) noexcept {
  for (std::size_t c = 0; c < size; ++c) to[c][index] = Number::from_raw(tuple[c]);
}

}  // namespace fixproof::detail

/// Refuses the calls of a batch that no other overload takes. `text` says what the batch takes.
/// `result` is the return type of the other overloads, because clang reports a result of the wrong
/// type before the text.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): declares a function
#define FIXED_REFUSED_BATCH(result, name, text) \
  template <detail::sized Xs, class... Type>    \
  result name(const Xs&, const Type&...) FIXED_INSTEAD(text);

/// The same for a batch whose ranges all hold numbers. `last` names the argument that may follow
/// them.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): declares a function
#define FIXED_REFUSED_RANGES(result, name, last)                                                \
  FIXED_REFUSED_BATCH(                                                                          \
      result, name,                                                                             \
      "a batch takes arrays, vectors or spans of one number type; any result ranges are last, " \
      "neither const nor temporary; " last " may follow")
