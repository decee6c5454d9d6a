/// @file
/// A run that nobody interrupts.
#pragma once

#include <atomic>

namespace {

const std::atomic<bool> never{false};

}  // namespace
