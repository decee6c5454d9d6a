// A program's own `fixed`, and every name of the standard library without its qualifier.
#include <iomanip>
#include <iostream>

// NOLINTNEXTLINE(google-build-using-namespace): what is tested
using namespace std;

#include "fixed/batch/batch.hpp"
#include "fixed/batch/functions.hpp"
#include "fixed/batch/radian.hpp"
#include "fixed/fixed.hpp"

void print_fixed(fixproof::q16_16 x) {
  cout << fixed << setprecision(3) << static_cast<double>(x) << ' ' << fixproof::sqrt(x) << '\n';
}

namespace program {

using fixed = int;  // as in the sources of Doom

constexpr fixed one = fixproof::q16_16(1).raw();
static_assert(exp(fixproof::q16_16()) == 1 && atan(fixproof::q16_16()) == 0);
static_assert(one == 0x10000 && fixproof::sin(fixproof::q16_16(0)) == fixproof::q16_16(0));

}  // namespace program
