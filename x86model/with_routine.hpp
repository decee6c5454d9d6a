/// @file
/// Turns a routine that is known at run time into a template argument.
#pragma once

#include "x86model/routine.hpp"

namespace x86model {

/// Returns `f.template operator()<routine>()`.
template <class Function>
constexpr decltype(auto) with_routine(Routine routine, const Function& f) {
  switch (routine) {
    case Routine::mul:
      return f.template operator()<Routine::mul>();
    case Routine::div:
      return f.template operator()<Routine::div>();
    case Routine::cossin:
      return f.template operator()<Routine::cossin>();
    case Routine::xformvec:
      return f.template operator()<Routine::xformvec>();
    case Routine::concat:
      break;
  }
  return f.template operator()<Routine::concat>();
}

}  // namespace x86model
