// <fmt/core.h> before the type: fmt::format_error is in <fmt/format.h> alone.
#include <fmt/core.h>
//
#include "fixed/fixed.hpp"

std::string with_fmt_core(fixproof::q16_16 x) { return fmt::format("{:>8}", x); }
