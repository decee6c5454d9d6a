/// @file
/// Throws an exception, or aborts if exceptions are disabled; the only place that does. If the
/// program defines FIXED_ON_ERROR, it calls that function instead.
#pragma once

#if defined(FIXED_ON_ERROR)
/// The program's function for errors, which has the name that FIXED_ON_ERROR stands for and does
/// not return. Its arguments are constants.
/// @param what      "overflow", "divide error" or "domain error"; another text for a wrong format
/// @param operation as in the source: "operator+", "sqrt"
extern "C" [[noreturn]] void FIXED_ON_ERROR(const char* what, const char* operation);
#elif !defined(__cpp_exceptions)
#include <cstdio>
#include <cstdlib>
#endif

namespace fixproof::detail {

/// Throws Error(text); without exceptions (-fno-exceptions) writes the text to stderr and aborts.
template <class Error>
[[noreturn]] void throw_error(const char* text) {
#if defined(FIXED_ON_ERROR)
  FIXED_ON_ERROR(text, "");
#elif defined(__cpp_exceptions)
  throw Error(text);
#else
  std::fputs(text, stderr);
  std::fputc('\n', stderr);
  std::abort();
#endif
}

}  // namespace fixproof::detail
