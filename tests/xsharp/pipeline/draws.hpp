/// @file
/// Properties of numbers of every type. RapidCheck takes seconds to compile for each type it draws
/// for, so it draws integers only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace draws {

using Integers = std::vector<std::int64_t>;
using Check = std::function<bool(const Integers&)>;

/// Whether `check` is true for `count` integers from `least` to `most`. Prints the least
/// counterexample.
bool hold(std::size_t count, std::int64_t least, std::int64_t most, const Check& check);

/// Whether `check` is true for `count` integers of 32 bits: the ends of their range, what is near
/// to them or to whole numbers of 16.16, and anything.
bool hold_for_raws(std::size_t count, const Check& check);

}  // namespace draws
