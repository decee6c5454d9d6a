// Target `judged_results`: a random operation, formats and rules, and the verdict of `check` on
// right results and on one wrong result.
#include <cstddef>
#include <cstdint>

#include "fuzz/finding.hpp"
#include "fuzz/judged_results.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fixproof::fuzz::report_if_any(fixproof::fuzz::judged_results({data, size}));
  return 0;
}
