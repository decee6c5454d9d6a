// Numbers for a debugger to look at, in a file that nothing has to run.
#include "fixed/fixed.hpp"

// A debugger finds them in the file because they are global; nothing here runs.
// NOLINTBEGIN(cppcoreguidelines-avoid-non-const-global-variables, cert-err58-cpp, *-avoid-c-arrays)

fixproof::q16_16 aliased(-0.75);
const fixproof::q16_16 constant(3);
const fixproof::q16_16* used = &constant;
fixproof::q16_16 least = fixproof::q16_16::from_raw(1);
fixproof::q16_16 lowest = std::numeric_limits<fixproof::q16_16>::lowest();
fixproof::q8_8 narrow(-2.5);
fixproof::u0_64 finest = fixproof::u0_64::from_raw(1);
auto wide = fixproof::q32_32(-1.5) + fixproof::q32_32();
fixproof::q8_8_saturating eight(127.99609375);
auto deduced = fixproof::q16_16_i8088(1.5) + fixproof::q16_16_i8088();
fixproof::number<std::int32_t, 16, fixproof::policy{.range = fixproof::overflow::saturate}> spelt(
    0);
fixproof::q16_16 pair[] = {fixproof::q16_16(1), fixproof::q16_16(-1)};

// Types without an alias in sight: the printer knows the presets by their rules.
template <class Number>
using bare = decltype(Number() + Number());
struct one_of_each {
  bare<fixproof::q16_16_trapping> trapping{1};
  bare<fixproof::q16_16_i386> i386{1};
  bare<fixproof::q16_16_i386_mul_rounded> i386_m{1};
  bare<fixproof::q16_16_i386_div_rounded> i386_d{1};
  bare<fixproof::q16_16_i386_unrounded> i386_u{1};
  bare<fixproof::q16_16_i8088_mul_rounded> i8088_m{1};
  bare<fixproof::q16_16_i8088_div_rounded> i8088_d{1};
  bare<fixproof::q16_16_i8088_unrounded> i8088_u{1};
} presets;

// NOLINTEND(cppcoreguidelines-avoid-non-const-global-variables, cert-err58-cpp, *-avoid-c-arrays)

int main() {}
