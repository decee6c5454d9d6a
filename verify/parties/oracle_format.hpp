/// @file
/// The format of a word as the oracle takes it.
#pragma once

#include "oracle/format.hpp"
#include "verify/cases/format.hpp"

namespace fixproof::parties {

inline oracle::Format oracle_format(const cases::Format& format) {
  return {format.word_bits, format.fraction_bits, format.is_signed};
}

}  // namespace fixproof::parties
