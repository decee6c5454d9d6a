// Tests that a symbolic run reports its limits and that every operand has one path under any
// limits.
#include "tests/support/test.hpp"
#include "x86model/notation.hpp"
#include "x86model/symbolic/call.hpp"
#include "x86model/symbolic/evaluate.hpp"

namespace {

using namespace x86model;
using namespace x86model::notation;
namespace sym = x86model::symbolic;

/// The paths of a listing that is called like FixedMul.
std::vector<sym::Path> paths_of(sym::Terms& terms, const Listing& listing,
                                const sym::RunOptions& options) {
  const Program program = assemble(listing, {});
  return sym::run(terms, program.instructions(), sym::enter(terms, Routine::mul), options);
}

std::size_t count(const std::vector<sym::Path>& paths, Outcome outcome) {
  return static_cast<std::size_t>(std::count_if(
      paths.begin(), paths.end(), [&](const sym::Path& path) { return path.outcome == outcome; }));
}

// Counts from 20 to below 0, so the jump executes 21 times.
TEST(Paths, ALoopMayJumpAsOftenAsIsSaid) {
  const Listing loop{sub(cx, cx), add(cx, 20), label("again"), dec(cx), jns("again"), ret()};
  for (const int most : {1, 20, 21}) {
    sym::Terms terms;
    const auto paths = paths_of(terms, loop, {.max_jumps = most});
    ASSERT_EQ(paths.size(), 1U);
    EXPECT_EQ(paths[0].outcome, most < 21 ? Outcome::step_limit : Outcome::returned) << most;
  }
}

// A jump that depends on CX may end the loop each time.
TEST(Paths, AnOpenLoopEndsOnceForEveryJump) {
  sym::Terms terms;
  const auto paths =
      paths_of(terms, {label("again"), dec(cx), jns("again"), ret()}, {.max_jumps = 3});
  EXPECT_EQ(count(paths, Outcome::returned), 3U);
  EXPECT_EQ(count(paths, Outcome::step_limit), 1U);
  EXPECT_EQ(paths.size(), 4U);
}

TEST(Paths, ThereAreNoMoreThanIsSaid) {
  // Three sign tests give eight paths. The run checks the limit before it splits a path.
  const Listing signs{add(ax, 0), js("b"),    label("b"), add(bx, 0), js("c"),
                      label("c"), add(cx, 0), js("d"),    label("d"), ret()};
  struct Limit {
    std::size_t most;
    std::size_t least_given_up;
    std::size_t max_returned;
  };
  for (const auto& [most, least_given_up, max_returned] :
       {Limit{1000, 0, 8}, Limit{4, 1, 7}, Limit{0, 1, 0}}) {
    sym::Terms terms;
    const auto paths = paths_of(terms, signs, {.max_paths = most});
    EXPECT_GE(count(paths, Outcome::step_limit), least_given_up) << most;
    EXPECT_LE(count(paths, Outcome::returned), max_returned) << most;
    EXPECT_LE(paths.size(), std::min(most + 2, std::size_t{8})) << most;
    EXPECT_EQ(paths.size(), count(paths, Outcome::step_limit) + count(paths, Outcome::returned));
    sym::Evaluation evaluation(terms, sym::concrete);
    for (std::size_t set = 0; set < 8; ++set) {
      // AX, CX and BX are registers 0, 1 and 3.
      for (const std::size_t bit : {0U, 1U, 2U}) {
        evaluation.set(sym::numbered("register", bit == 2 ? 3 : bit),
                       (set >> bit & 1U) != 0 ? 0x8000 : 0x7FFF);
      }
      const auto taken = std::count_if(paths.begin(), paths.end(), [&](const sym::Path& path) {
        return evaluation(path.condition) != 0;
      });
      EXPECT_EQ(taken, 1) << most << ' ' << set;
    }
  }
}

TEST(Paths, ACallOfAnythingElseIsNotFixedMul) {
  const Listing calls{call("Other"), ret(), proc("Other"), ret()};
  sym::Terms terms;
  const auto summed_up = paths_of(terms, calls, {.calls_are_fixed_mul = true});
  ASSERT_EQ(summed_up.size(), 1U);
  EXPECT_EQ(summed_up[0].outcome, Outcome::bad_address);
  const auto followed = paths_of(terms, calls, {});
  ASSERT_EQ(followed.size(), 1U);
  EXPECT_EQ(followed[0].outcome, Outcome::returned);
}

}  // namespace
