// A `fixed` of the program in the global namespace, before the type.
using fixed = int;

#include "fixed/batch/batch.hpp"
#include "fixed/batch/radian.hpp"
#include "fixed/fixed.hpp"

fixed whole_part(fixproof::q16_16 x) { return static_cast<fixed>(x); }
