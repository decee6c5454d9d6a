/// @file
/// Throws an exception, or aborts if exceptions are disabled; the only place that does.
#pragma once

#if !defined(__cpp_exceptions)
#include <cstdio>
#include <cstdlib>
#endif

namespace fixproof::detail {

/// Throws Error(text); without exceptions (-fno-exceptions) writes the text to stderr and aborts.
template <class Error>
[[noreturn]] void throw_error(const char* text) {
#if defined(__cpp_exceptions)
  throw Error(text);
#else
  std::fputs(text, stderr);
  std::fputc('\n', stderr);
  std::abort();
#endif
}

}  // namespace fixproof::detail
