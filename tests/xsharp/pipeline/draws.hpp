/// @file
/// Property checks for numbers of every type. RapidCheck takes seconds to compile for each type, so
/// it draws only integers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace draws {

using Integers = std::vector<std::int64_t>;
using Check = std::function<bool(const Integers&)>;

/// Whether `check` is true for `count` integers from `least` to `most`. Prints the smallest
/// counterexample.
bool hold(std::size_t count, std::int64_t least, std::int64_t most, const Check& check);

/// Whether `check` is true for `count` 32-bit integers: range ends, values near them or near whole
/// 16.16 numbers, and arbitrary values.
bool hold_for_raws(std::size_t count, const Check& check);

}  // namespace draws
