/// @file
/// A stop flag that is never set.
#pragma once

#include <atomic>

inline const std::atomic<bool> never{false};
