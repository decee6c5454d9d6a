// A shared library with hidden symbols, for log_test.cpp.
#define FIXPROOF_RECORD 1
#include "tests/fixed/record/shared_library.hpp"

Recorded square_and_sum_in_library(Recorded x) { return x * x + x; }
