// Judges 2,000 random combinations of an operation, formats, rules and one planted defect.
#include "fuzz/judged_results.hpp"

#include <cstdint>
#include <random>
#include <vector>

#include "tests/support/test.hpp"

namespace {

TEST(CheckCombinations, RightResultsAreRightAndOneWrongOneIsFound) {
  constexpr int combinations = 2000;
  for (std::uint32_t seed = 1; seed <= combinations; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(48);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    const auto finding = fixproof::fuzz::judged_results(bytes);
    ASSERT_FALSE(finding) << "seed " << seed << ": " << finding.value_or("");
  }
}

}  // namespace
