/// Durations of numbers beside integers and durations of integers.
#include "fixed/chrono.hpp"

#include <chrono>

#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace fixproof {
namespace {

using namespace std::chrono_literals;
using chrono_seconds = std::chrono::duration<q16_16>;
using chrono_ticks = std::chrono::duration<q32_32, std::ratio<1, 60>>;
constexpr chrono_seconds one_and_half(q16_16(1.5));

static_assert(one_and_half * 3 == chrono_seconds(q16_16(4.5)) && 3L * one_and_half == 4500ms);
static_assert(one_and_half / 2 == 750ms && one_and_half % 1 == 500ms);
static_assert((one_and_half + 1s).count() == q16_16(2.5) &&
              (1s + one_and_half).count() == q16_16(2.5));
static_assert((one_and_half - 1s).count() == q16_16(0.5) &&
              (1s - one_and_half).count() == q16_16(-0.5));
static_assert(std::is_same_v<decltype(one_and_half + 1min), chrono_seconds>);
static_assert((one_and_half + 250ms).count() == 1750);  // in milliseconds, as those of double
static_assert(one_and_half < 2s && one_and_half > 1s && one_and_half <= 1500ms &&
              one_and_half >= 1500ms);
static_assert(1s < one_and_half && 2s > one_and_half && 1500ms <= one_and_half &&
              1501ms >= one_and_half);
static_assert(one_and_half != 1s && 1500ms == one_and_half && !(one_and_half < 1500ms));
// Exact, where the integer is out of the range of the type.
static_assert(one_and_half < 100000s && one_and_half > -100000h && one_and_half < 1500000001ns);
static_assert(chrono_ticks(q32_32(60)) == 1s &&
              chrono_ticks(q32_32(90)) + 1s == chrono_ticks(q32_32(150)));
static_assert(std::chrono::duration<u0_64>(u0_64::from_raw(~std::uint64_t{0})) <
              std::chrono::hours::max());
static_assert(std::chrono::duration_cast<chrono_seconds>(90s).count() == 90);
static_assert(std::chrono::duration_cast<chrono_seconds>(1500ms) == one_and_half);
static_assert(std::chrono::duration_cast<std::chrono::seconds>(one_and_half) == 1s);

// As before, durations of one number type, and of double, which still converts by name alone.
static_assert(one_and_half + one_and_half == 3s && one_and_half / one_and_half == 1);
static_assert(one_and_half * q16_16(0.5) == 750ms);

TEST(Chrono, AssignsSums) {
  chrono_seconds x = one_and_half;
  x += 2s;
  x -= 1min;
  x *= 2;
  x /= 4;
  EXPECT_EQ(x.count(), q16_16(-28.25));
  EXPECT_EQ((std::chrono::duration<q16_16_saturating>(q16_16_saturating(1)) + 10h).count().raw(),
            0x7fffffff);
  EXPECT_THROW((void)(std::chrono::duration<q16_16_trapping>() + 10h), overflow_error);
}

}  // namespace
}  // namespace fixproof
