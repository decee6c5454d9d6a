/// @file
/// Reads the files of vectors whose angles are nearest to a tie.
#pragma once

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"

namespace functions {

/// A line of a file of hard pairs: format, y, x, the angle of (x, y) in ulps, distance.
struct HardPair {
  std::string format;
  std::int64_t y = 0;
  std::int64_t x = 0;
  std::int64_t result = 0;
};

/// The pairs of a file of this folder. A line that is no pair fails the test and is left out.
inline std::vector<HardPair> hard_pairs(const std::string& name) {
  std::ifstream file(paths::source("tests/fixed/functions/" + name));
  std::vector<HardPair> pairs;
  std::string line;
  while (std::getline(file, line)) {
    if (line.starts_with('#')) continue;
    std::istringstream parts(line);
    HardPair pair;
    if (parts >> pair.format >> pair.y >> pair.x >> pair.result) {
      pairs.push_back(pair);
    } else {
      ADD_FAILURE() << name << " has the line '" << line
                    << "', but a line has format, y, x, result, distance";
    }
  }
  return pairs;
}

}  // namespace functions
