/// @file
/// Every arithmetic that can draw a scene.
#pragma once

#include <vector>

#include "xsharp/scene.hpp"

/// The type with each preset, the model with each build, and double. The 8088 builds come with the
/// printed and the repaired ConcatXforms.
inline std::vector<xsharp::ArithmeticChoice> all_arithmetics() {
  std::vector<xsharp::ArithmeticChoice> all;
  for (const char* by : {"type", "model"}) {
    for (const char* target : {"i386", "i8088"}) {
      for (const bool mul : {true, false}) {
        for (const bool div : {true, false}) all.push_back({by, target, mul, div});
      }
    }
    for (const bool mul : {true, false}) {
      for (const bool div : {true, false}) all.push_back({by, "i8088", mul, div, true});
    }
  }
  for (const char* target : {"standard", "saturating", "trapping"}) {
    all.push_back({"type", target, true, true});
  }
  all.push_back({"double", "", true, true});
  return all;
}
