/// @file
/// The rounding mode of the processor, set for a lifetime.
#pragma once

#include <cfenv>

#include "tests/support/test.hpp"

class RoundingMode {
 public:
  static constexpr std::array all{FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO};

  explicit RoundingMode(int mode) { EXPECT_EQ(std::fesetround(mode), 0); }
  RoundingMode(const RoundingMode&) = delete;
  RoundingMode& operator=(const RoundingMode&) = delete;
  ~RoundingMode() { std::fesetround(FE_TONEAREST); }
};
