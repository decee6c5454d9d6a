// For sketches of Arduino, which include a library by its name. Use namespace fixproof, as in `fixproof::q16_16 x(1.5);`.
#pragma once
#include "fixed/fixed.hpp"
