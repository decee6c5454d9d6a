// What recorder.c does, with the recorder: recorder_cpp LOG COUNT
#include <cstdint>
#include <cstdlib>

#include "fixed/record/recorded.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  using real = fixproof::recorded<fixproof::q16_16>;
  const fixproof::record::log log(argv[1], {.program = "C++"});
  real x;
  for (long i = 0; i < std::atol(argv[2]); ++i) {
    x += fixproof::q16_16::from_raw(static_cast<std::int32_t>(i));
  }
  return log.good() ? 0 : 2;
}
