/// @file
/// A program that uses everything of fixed/record/recorded.hpp. It must compile and give the same
/// result with recording and without.
#pragma once

#include <cstdint>
#include <string>

#include "fixed/record/recorded.hpp"

namespace fixproof::recorder_test {

/// Returns the raw result of a few operations.
inline std::int32_t run_either(const std::string& path) {
  using number = recorded<q16_16>;
  record::options options{.program = "either"};
  options.full = record::full_range::from_text("frames:-1-3");
  const record::log log(path, options);
  const record::full_range range{.is_of_frames = false, .first = 2, .last = 3};
  const record::log inner(path + "2", {.full = range});
  const record::log literal("/gone/x");
  options.full = record::options::from_environment();
  number x(1.5);
  for (int i = -2; i < 3; ++i) {
    record::frame(i);
    record::mark("step");
    x = sqrt(x * x) + 1;
    record::confirm(i);
    record::flush();
  }
  const record::position here = record::where();
  if (options.full.to_text() != "nothing") return 0;
  if (!(here == record::where()) || here.records > 100 || !log.good() || *log.problem() != '\0') {
    return 0;
  }
  const q16_16 plain(x);
  return plain.raw();
}

}  // namespace fixproof::recorder_test
