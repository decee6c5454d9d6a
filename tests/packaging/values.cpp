// Numbers for a debugger to look at, in a file that nothing has to run.
#include "fixed/fixed.hpp"

fixed::q16_16 aliased(-0.75);
const fixed::q16_16 constant(3);
const fixed::q16_16* used = &constant;
fixed::q16_16 least = fixed::q16_16::from_raw(1);
fixed::q16_16 lowest = std::numeric_limits<fixed::q16_16>::lowest();
fixed::q8_8 narrow(-2.5);
fixed::q8_8_saturating eight(127.99609375);
auto deduced = fixed::q16_16_i8088(1.5) + fixed::q16_16_i8088();
fixed::number<16, fixed::policy{.range = fixed::overflow::saturate}> spelt(0);
fixed::q16_16 pair[] = {fixed::q16_16(1), fixed::q16_16(-1)};

int main() {}
