/// @file
/// How a declaration that must not be used says what to write instead.
#pragma once

#include <cstddef>

#include "fixed/detail/standard.hpp"

namespace fixproof::detail {

/// A string literal as a template argument.
template <std::size_t Length>
struct advice {
  char text[Length]{};  // NOLINT(*-avoid-c-arrays): as that of the literal

  // NOLINTNEXTLINE(google-explicit-constructor,*-avoid-c-arrays): a literal is one, and converts
  constexpr advice(const char (&literal)[Length]) {
    for (std::size_t i = 0; i < Length; ++i) text[i] = literal[i];
  }
};

/// True for every text: g++ prints the constraints of a deleted function, and so the text.
template <advice Text>
concept instead = true;

}  // namespace fixproof::detail

/// Ends a declaration whose use does not compile. `text` says what to write; it is in the first
/// line of the compiler's message. In a `requires` expression such a use is false, not an error.
/// Clang does not print the declaration of a deleted function, but it prints the text of an
/// unavailable one.
#if defined(__clang__)
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): an attribute
#define FIXED_INSTEAD(text) __attribute__((unavailable(text)))
#else
#define FIXED_INSTEAD(text)                \
  requires fixproof::detail::instead<text> \
  = delete
#endif
