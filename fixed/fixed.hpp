/// \file
/// Everything of namespace fixed.
#pragma once

#include "fixed/error.hpp"
#include "fixed/number.hpp"
#include "fixed/policy.hpp"
