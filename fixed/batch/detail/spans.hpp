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

/// A range to whose elements T a batch can write. An rvalue must be a view, such as std::span,
/// because results in a temporary are lost. `Range` is the type deduced for `Range&&`.
template <class Range, class T>
concept written = std::same_as<T, element_t<Range>> &&
    requires(std::conditional_t<std::is_lvalue_reference_v<Range>, Range, const Range&> range) {
  { *std::data(range) } -> std::same_as<T&>;
};

/// A range to which numbers N can be written.
template <class Range, class N>
concept output_of = number_range<Range> && written<Range, N>;

/// A range of numbers N.
template <class Range, class N>
concept input_of = number_range<Range> && std::same_as<N, element_t<Range>>;

/// A type that can be initialised from two or three numbers N.
template <class T, class N, std::size_t size>
concept made_of = (size == 2 &&
                   requires(N n) {
                     T{n, n};
                   }) ||
                  (size == 3 && requires(N n) {
                    T{n, n, n};
                  });

/// A type that keeps numbers N as they are. Constructors may convert them, as that of glm::vec3
/// does, so a class with constructors must have a number N as `x` or `[0]`.
template <class T, class N>
concept keeps = std::is_aggregate_v<T> || requires(T t) {
  { t.x } -> std::same_as<N&>;
} || requires(T t) {
  { t[0] } -> std::same_as<N&>;
};

/// A range whose elements consist of exactly `size` numbers N.
template <class Range, class N, std::size_t size>
concept tuples_of = is_number<N> && std::is_trivially_copyable_v<element_t<Range>> &&
                        std::is_standard_layout_v<element_t<Range>> &&
                        sizeof(element_t<Range>) == size * sizeof(N) &&
                    made_of<element_t<Range>, N, size>&& keeps<element_t<Range>, N>&& sized<Range>;

template <class Range, class N, std::size_t size>
concept output_tuples_of = tuples_of<Range, N, size> && written<Range, element_t<Range>> &&
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

/// Stored integers of numbers N: of a vertex or of a point.
template <class N, std::size_t size>
using raw_tuple = std::array<typename N::raw_type, size>;

/// Loads an element of `size` numbers. Copies them one by one, because GCC 12 keeps the array in
/// memory after a memcpy of more than a register.
template <class N, std::size_t size>
FIXED_ALWAYS_INLINE raw_tuple<N, size> load_tuple(const void* base, std::size_t index) noexcept {
  const auto* const from = static_cast<const char*>(base) + index * size * sizeof(N);
  raw_tuple<N, size> tuple;
  for (std::size_t c = 0; c < size; ++c) std::memcpy(&tuple[c], from + c * sizeof(N), sizeof(N));
  return tuple;
}

/// The same from columns.
template <class N, std::size_t size>
FIXED_ALWAYS_INLINE raw_tuple<N, size> load_tuple(const std::array<const N*, size>& from,
                                                  std::size_t index) noexcept {
  raw_tuple<N, size> tuple;
  for (std::size_t c = 0; c < size; ++c) tuple[c] = from[c][index].raw();
  return tuple;
}

template <class N, std::size_t size>
void store_tuple(void* base, std::size_t index, const raw_tuple<N, size>& tuple) noexcept {
  auto* const to = static_cast<char*>(base) + index * size * sizeof(N);
  for (std::size_t c = 0; c < size; ++c) std::memcpy(to + c * sizeof(N), &tuple[c], sizeof(N));
}

template <class N, std::size_t size>
void store_tuple(const std::array<N*, size>& to, std::size_t index,
                 const raw_tuple<N, size>& tuple) noexcept {
  for (std::size_t c = 0; c < size; ++c) to[c][index] = N::from_raw(tuple[c]);
}

}  // namespace fixproof::detail

/// Refuses the calls of a batch that no other overload takes. `text` says what the batch takes.
/// `result` is the return type of the other overloads, because clang reports a result of the wrong
/// type before the text.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): declares a function
#define FIXED_REFUSED_BATCH(result, name, text) \
  template <detail::sized X, class... T>        \
  result name(const X&, const T&...) FIXED_INSTEAD(text);

/// The same for a batch whose ranges all hold numbers. `last` names the argument that may follow
/// them.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): declares a function
#define FIXED_REFUSED_RANGES(result, name, last)                                                \
  FIXED_REFUSED_BATCH(                                                                          \
      result, name,                                                                             \
      "a batch takes arrays, vectors or spans of one number type; any result ranges are last, " \
      "neither const nor temporary; " last " may follow")
