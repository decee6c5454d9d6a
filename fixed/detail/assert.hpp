/// @file
/// Checks, in the tests of Fixproof, of the bounds that make a conversion exact.
///
/// FIXED_ASSERT(condition) is no code in programs. The tests of the functions and all code under
/// sanitizers are compiled with FIXED_ASSERTIONS: there, a bound that does not hold ends the
/// program, and a constant expression does not compile.
#pragma once

#include "fixed/detail/trap.hpp"

// NOLINTBEGIN(cppcoreguidelines-macro-usage): the condition must not be evaluated in programs
#if defined(FIXED_ASSERTIONS)
#define FIXED_ASSERT(condition) static_cast<void>((condition) || (fixproof::detail::trap(), false))
#else
#define FIXED_ASSERT(condition) static_cast<void>(0)
#endif
// NOLINTEND(cppcoreguidelines-macro-usage)
