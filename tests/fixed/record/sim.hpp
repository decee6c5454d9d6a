/// @file
/// A loop of recorded operations with a planted difference.
#pragma once

#include <cstdint>
#include <string>

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): switches recording on
#define FIXPROOF_RECORD 1
#include "fixed/record/recorded.hpp"

namespace fixproof::recorder_test {

using real = recorded<q16_16>;
static_assert(!std::is_same_v<real, q16_16>);

/// What one side does differently.
enum class Plant { nothing, operand, arithmetic, order, contraction, extra };

/// 0 if the product is rounded. A compiler that contracts it with the difference computes 2^-14.
inline double contracted() {
  const volatile double a = 1 + 0x1p-27;
  const volatile double b = 1 + 0x1p-26;
  return (a * a - b) * 0x1p40;
}

/// Returns the turn of an operation of the loop, from 0. A turn has four operations.
inline std::uint64_t turn_of(std::uint64_t operation) { return operation / 4; }

/// Records `turns` turns of four operations in a log, with a mark every 1,000 turns and a frame
/// every 5,000. The turn `at` has the planted difference.
inline void run(const std::string& path, std::uint64_t turns, Plant plant, std::uint64_t at,
                record::full_range full = {}) {
  const record::log log(path, {.program = "test", .full = full});
  real sum;
  const real small = real::from_raw(3);
  for (std::uint64_t turn = 0; turn < turns; ++turn) {
    if (turn % 5000 == 0) record::frame(static_cast<std::int64_t>(turn / 5000));
    if (turn % 1000 == 0) record::mark(turn % 2000 == 0 ? "even" : "odd");
    const real step = real::from_raw(static_cast<std::int32_t>(turn % 999983));
    if (turn == at && plant != Plant::nothing) {
      switch (plant) {
        case Plant::operand:
          sum.value_ =
              q16_16::from_raw(sum.raw() ^ 1);  // a change of memory, which is not recorded
          break;
        case Plant::arithmetic:
          // The sum of a different arithmetic, one unit more.
          record::detail::note<record::kind::add, q16_16>(
              record::nowhere, q16_16::from_raw(sum.raw() + step.raw() + 1), sum.plain(),
              step.plain());
          sum = sum.plain() + step.plain();
          sum += small;
          sum = sum * real(q16_16(1));
          continue;
        case Plant::order:
          sum += small;
          sum += step;
          sum = sum * real(q16_16(1));
          continue;
        case Plant::contraction:
          sum += real(contracted());
          break;
        default:
          sum = -sum;
          break;
      }
    }
    sum += step;
    sum += small;
    sum = sum * real(q16_16(1));
  }
}

}  // namespace fixproof::recorder_test
