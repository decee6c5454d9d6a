#include "fuzz/finding.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "support/error_text.hpp"

namespace fixproof::fuzz {

void report_finding(const std::string& text) {
  support::write_error(fmt::format("FINDING: {}\n", text));
  std::abort();
}

}  // namespace fixproof::fuzz
