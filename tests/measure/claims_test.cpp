// Tests verdicts, and clock counts of whole calls against hand sums from Intel's tables.
#include "measure/clocks/claims.hpp"

#include "measure/clocks/call_clocks.hpp"
#include "tests/measure/never.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using x86model::Cpu;

TEST(Claims, AVerdictNeedsAllOfARange) {
  const auto verdict = [](measure::Bounds measured) {
    return measure::judge(measured, {2, 3}, measure::Evidence::decides);
  };
  EXPECT_EQ(verdict({2, 3}), measure::ClaimVerdict::holds);
  EXPECT_EQ(verdict({2.5, 2.5}), measure::ClaimVerdict::holds);
  EXPECT_EQ(verdict({1, 1.9}), measure::ClaimVerdict::does_not_hold);
  EXPECT_EQ(verdict({3.1, 9}), measure::ClaimVerdict::does_not_hold);
  EXPECT_EQ(verdict({1, 2}), measure::ClaimVerdict::open);
  EXPECT_EQ(verdict({2.9, 3.1}), measure::ClaimVerdict::open);
  EXPECT_EQ(verdict({1, 9}), measure::ClaimVerdict::open);
}

TEST(Claims, EvidenceOfOneSideSaysNothingOfTheOther) {
  const measure::Bounds allowed{2, 3};
  const measure::Bounds inside{2.5, 2.5};
  const measure::Bounds outside{1, 1};
  EXPECT_EQ(measure::judge(inside, allowed, measure::Evidence::can_show),
            measure::ClaimVerdict::holds);
  EXPECT_EQ(measure::judge(outside, allowed, measure::Evidence::can_show),
            measure::ClaimVerdict::open);
  EXPECT_EQ(measure::judge(inside, allowed, measure::Evidence::can_refute),
            measure::ClaimVerdict::not_refuted);
  EXPECT_EQ(measure::judge(outside, allowed, measure::Evidence::can_refute),
            measure::ClaimVerdict::does_not_hold);
  EXPECT_EQ(measure::judge(inside, allowed, measure::Evidence::neither),
            measure::ClaimVerdict::open);
  EXPECT_EQ(measure::judge(outside, allowed, measure::Evidence::neither),
            measure::ClaimVerdict::open);
}

TEST(Claims, FiguresThatAreOpenDecideNothing) {
  const auto of = [](const std::vector<measure::ClaimVerdict>& verdicts) {
    measure::Claim claim;
    for (const measure::ClaimVerdict v : verdicts) claim.figures.push_back({"", {}, v});
    return measure::verdict_on(claim);
  };
  using enum measure::ClaimVerdict;
  EXPECT_EQ(of({open, open}), open);
  EXPECT_EQ(of({open, holds, holds}), holds);
  EXPECT_EQ(of({does_not_hold, open}), does_not_hold);
  EXPECT_EQ(of({holds, does_not_hold, holds}), in_part);
}

TEST(Spread, MeansAreOfTypicalCallsAlone) {
  measure::Spread s;
  s.add({10, 12});
  s.add({20, 20});
  s.bound({5, 40});
  EXPECT_EQ(s.least(), 5U);
  EXPECT_EQ(s.most(), 40U);
  EXPECT_EQ(s.calls(), 2U);
  EXPECT_EQ(s.mean_min(), 15);
  EXPECT_EQ(s.mean_max(), 16);
}

const measure::ProcessorClocks& on(const measure::CallClocks& clocks, Cpu cpu) {
  for (const measure::ProcessorClocks& p : clocks.processors) {
    if (p.cpu == cpu) return p;
  }
  throw std::invalid_argument("not on this processor");
}

// FixedMul on a 386: PUSH 2, MOV 2, MOV from memory 4, IMUL from memory 9 + the multiplier's bits,
// ADD 2, ADC 2, SHR 3, POP 4, RET 10, and 3 for ADD SP,8. 3 * 2^16 has 18 bits, 1.0 is 2^16: 32 +
// 27 and 32 + 25. On a 486: 14 to 21, with IMUL 27 to 29 and 26 to 27.
TEST(CallClocks, FixedMulOnA386) {
  measure::CallClocks clocks = measure::no_calls(
      {.operation = cases::Operation::mul, .build = {.target = cases::Target::i386}});
  measure::add_calls(clocks, std::array{0x00010000U, 0x00030000U, 0x00030000U, 0x00010000U}, true,
                     never);
  EXPECT_EQ(clocks.processors.size(), 2U);
  EXPECT_EQ(clocks.instructions.least(), 9U);
  EXPECT_EQ(clocks.instructions.most(), 9U);
  const measure::Spread& counted = on(clocks, Cpu::i386).clocks;
  EXPECT_EQ(counted.least(), 57U);
  EXPECT_EQ(counted.most(), 59U);
  EXPECT_EQ(counted.mean_min(), 58);
  EXPECT_EQ(counted.mean_max(), 58);
  EXPECT_EQ(on(clocks, Cpu::i486).clocks.least(), 40U);
  EXPECT_EQ(on(clocks, Cpu::i486).clocks.most(), 50U);
}

// The sum of the 39 listing rows that FixedMul on an 8088 executes for 1.0 * 1.0. MUL takes 117
// clocks plus one for each 1 bit in AX and one for DX = 0: 119, 118, 119 and 118.
TEST(CallClocks, FixedMulOnAn8088) {
  constexpr std::uint64_t pushes = 5 * 15;
  constexpr std::uint64_t pops = 5 * 12;
  constexpr std::uint64_t loads = 4 * 21;
  constexpr std::uint64_t moves = 7 * 2;
  constexpr std::uint64_t between_registers = 8 * 3;
  constexpr std::uint64_t with_constants = 2 * 4;
  constexpr std::uint64_t jumps = 3 * 16;
  constexpr std::uint64_t multiplies = 119 + 118 + 119 + 118;
  constexpr std::uint64_t ret = 20;
  measure::CallClocks clocks = measure::no_calls(
      {.operation = cases::Operation::mul, .build = {.target = cases::Target::i8088}});
  measure::add_calls(clocks, std::array{0x00010000U, 0x00010000U}, true, never);
  EXPECT_EQ(clocks.instructions.least(), 39U);
  EXPECT_EQ(on(clocks, Cpu::i8088).clocks.least(), pushes + pops + loads + moves +
                                                       between_registers + with_constants + jumps +
                                                       multiplies + ret);
}

/// One frame that computes only 1.0 * 1.0, in each build.
measure::RecordedScene one_product() {
  measure::RecordedScene scene{"one product", {}};
  for (const auto& build : measure::recorded_builds()) {
    measure::SceneOperands operands{.build = build, .frames = 1};
    operands.log.at(static_cast<std::size_t>(cases::Operation::mul)) = {0x00010000, 0x00010000};
    scene.builds.push_back(operands);
  }
  return scene;
}

const measure::Claim& claim_about(const std::vector<measure::Claim>& claims,
                                  std::string_view words) {
  for (const measure::Claim& c : claims) {
    if (c.text.find(words) != std::string::npos) return c;
  }
  throw std::invalid_argument("no such claim");
}

// For 1.0 * 1.0, the 39 rows of the 8088's FixedMul take 155 clocks on a 386 and 220 on a 286. The
// 386's FixedMul takes 32 + 25 on a 386 and 40 to 48 on a 486.
TEST(Claims, FiguresOfOneProduct) {
  const auto claims = measure::judge_claims({one_product()});
  const measure::Claim& slower = claim_about(claims, "2.5 times");
  ASSERT_EQ(slower.figures.size(), 2U);
  EXPECT_DOUBLE_EQ(slower.figures[0].measured.min, 155.0 / 57);
  EXPECT_DOUBLE_EQ(slower.figures[0].measured.max, 155.0 / 57);
  // The claim depends on the 486's figure.
  EXPECT_EQ(slower.figures[0].verdict, measure::ClaimVerdict::open);
  const measure::Claim& at = claim_about(claims, "8 MHz AT is about 10");
  ASSERT_EQ(at.figures.size(), 1U);
  EXPECT_DOUBLE_EQ(at.figures[0].measured.min, 220.0 / 8 / (48.0 / 33));
  EXPECT_DOUBLE_EQ(at.figures[0].measured.max, 220.0 / 8 / (40.0 / 33));
  // The claim is about whole animations, so the listings decide nothing.
  EXPECT_EQ(at.figures[0].verdict, measure::ClaimVerdict::open);
  // The unrounded 386 code omits ADD and ADC, 4 of 57 clocks. If the rounded product takes 57 of a
  // program's 570 clocks, that is 4 of 566.
  const measure::Claim& rounding = claim_about(claims, "cost of rounding");
  ASSERT_EQ(rounding.figures.size(), 3U);
  EXPECT_DOUBLE_EQ(rounding.figures[0].measured.min, 100 * (57.0 / 53 - 1));
  EXPECT_EQ(rounding.figures[0].verdict, measure::ClaimVerdict::holds);
  EXPECT_NEAR(rounding.figures[1].measured.min, 100 * 4.0 / 566, 1e-9);
  EXPECT_EQ(claim_about(claims, "native").figures.size(), 1U);
  // 1.0 needs no rounding.
  EXPECT_EQ(claim_about(claims, "2^-16").figures.at(0).measured.max, 0);
}

// The 8088 executes 73 bytes of code and moves 30 of data: 412 bus clocks, fewer than the table's.
// If it waits for the code, the code's 292 clocks are added.
TEST(Claims, AnI8088HasTwoFigures) {
  const auto claims = measure::judge_claims({one_product()});
  const measure::Claim& pc = claim_about(claims, "40 times");
  ASSERT_EQ(pc.figures.size(), 2U);
  constexpr double table =
      5 * 15 + 5 * 12 + 4 * 21 + 7 * 2 + 8 * 3 + 2 * 4 + 3 * 16 + (119 + 118 + 119 + 118) + 20;
  EXPECT_EQ(pc.figures[1].verdict,
            measure::judge(pc.figures[1].measured, pc.allowed, measure::Evidence::decides));
  EXPECT_DOUBLE_EQ(pc.figures[1].measured.min / pc.figures[0].measured.min,
                   (table + 4 * 73) / table);
  EXPECT_DOUBLE_EQ(pc.figures[1].measured.max / pc.figures[0].measured.max,
                   (table + 4 * 73) / table);
}

TEST(Claims, RoundingChangesAProductByAUnit) {
  measure::RecordedScene scene = one_product();
  for (measure::SceneOperands& build : scene.builds) {
    build.log.at(static_cast<std::size_t>(cases::Operation::mul)) = {0x00000001, 0x00008000};
  }
  const auto claims = measure::judge_claims({scene});
  const measure::Claim& effect = claim_about(claims, "2^-16");
  EXPECT_EQ(effect.figures.at(0).measured.max, 1);
  EXPECT_EQ(effect.figures.at(0).verdict, measure::ClaimVerdict::holds);
}

// ConcatXforms and XformVec make 36 and 9 calls of FixedMul from C, 57 clocks each for factors of
// 1.0.
TEST(Claims, TheCubesOfChapter52AreCountedByCallsOfFixedMul) {
  measure::RecordedScene scene = one_product();
  scene.name = "twelve cubes";
  for (measure::SceneOperands& build : scene.builds) {
    build.log = {};
    build.log.at(static_cast<std::size_t>(cases::Operation::concat)).assign(24, 0x00010000);
    build.log.at(static_cast<std::size_t>(cases::Operation::xformvec)).assign(15, 0x00010000);
  }
  const auto claims = measure::judge_claims({scene});
  const measure::Claim& cubes = claim_about(claims, "twelve cubes");
  ASSERT_EQ(cubes.figures.size(), 1U);
  EXPECT_EQ(cubes.figures[0].where, "twelve cubes, 45 + 0 FixedMul, 0 FixedDiv");
  EXPECT_DOUBLE_EQ(cubes.figures[0].measured.min, 20e6 / (45 * 57));
  EXPECT_EQ(cubes.figures[0].verdict, measure::ClaimVerdict::not_refuted);
}

TEST(Claims, SayWhereTheyArePrinted) {
  for (const measure::Claim& claim : measure::judge_claims({one_product()}))
    EXPECT_NE(claim.place, "") << claim.text;
  for (const measure::NotJudged& statement : measure::not_judged()) {
    EXPECT_NE(statement.place, "");
    EXPECT_NE(statement.reason, "");
  }
}

TEST(CallClocks, ADivideErrorIsCountedAsThatAlone) {
  measure::CallClocks clocks = measure::no_calls(
      {.operation = cases::Operation::div, .build = {.target = cases::Target::i386}});
  measure::add_calls(clocks, std::array{0x00010000U, 0U}, true, never);
  EXPECT_EQ(clocks.faults, 1U);
  EXPECT_EQ(clocks.instructions.calls(), 0U);
}

TEST(CallClocks, EveryBuildIsTimedOnce) {
  const auto variants = measure::timed_variants();
  // mul, div, xformvec and concat on two targets with two roundings, CosSin on two targets, and
  // chapter 52's two. Chapter 52 has its third routine, ConcatXforms, in C.
  EXPECT_EQ(variants.size(), 4U * 4 + 2 + 2);
}

}  // namespace
