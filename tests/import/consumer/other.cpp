#include "fixed/fixed.hpp"

fixed::q16_16 half_of(fixed::q16_16 x) { return x / fixed::q16_16(2); }
