/// @file
/// A stop flag that is never set.
#pragma once

#include <atomic>

namespace {

const std::atomic<bool> never{false};

}  // namespace
