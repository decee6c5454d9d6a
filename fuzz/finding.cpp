#include "fuzz/finding.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace fixproof::fuzz {

void report_finding(const std::string& text) {
  fmt::print(stderr, "FINDING: {}\n", text);
  std::abort();
}

}  // namespace fixproof::fuzz
