/// @file
/// Conversion from the outcome of a model run to the ending of a case.
#pragma once

#include "verify/parties/party.hpp"
#include "x86model/execute.hpp"

namespace fixproof::parties {

constexpr Ending ending_of(x86model::Outcome outcome) {
  switch (outcome) {
    case x86model::Outcome::returned:
      return Ending::value;
    case x86model::Outcome::divide_error:
      return Ending::divide_error;
    case x86model::Outcome::undefined_flag:
      return Ending::undefined_flag;
    default:
      return Ending::broken;
  }
}

}  // namespace fixproof::parties
