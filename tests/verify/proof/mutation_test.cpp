// Runs level 1 against wrong programs: a sample of all mutants, swapped roundings, the other
// processor's routine, a missing fault. `fixproof mutate` tries all mutants.
#include "tests/support/test.hpp"
#include "verify/parties/interpreter.hpp"
#include "verify/parties/parties.hpp"
#include "verify/proof/kill.hpp"
#include "verify/proof/query.hpp"

namespace {

using namespace fixproof;

constexpr std::uint64_t seed = 54;

// Of all mutants, one of so many is tried, and at least so many of those are killed.
#ifdef FIXPROOF_NIGHTLY
constexpr std::size_t every = 97, least_killed = 60;
#else
constexpr std::size_t every = 291, least_killed = 20;
#endif

bool caught(const x86model::Program& program, const cases::Variant& v) {
  return proof::cases_to_kill(v, *parties::make_interpreter_of("broken", program), seed)
      .has_value();
}

TEST(Mutation, ThereAreMutantsOfEveryKind) {
  std::string changes;
  for (const auto& mutant : proof::mutants_of({.build = {.target = cases::Target::i8088}}))
    changes += mutant.change + '\n';
  for (const char* wanted :
       {"mul bx -> imul bx", "mov ax, si -> mov si, ax", "sub cx, cx -> sub dx, cx",
        "xor cx, 1 -> xor cx, 2", "xor cx, 1 -> xor cx, 0", "add ax, 0x8000 -> add ax, 0\n",
        "jns .CheckSecondOperand -> js .CheckSecondOperand",
        "jns .CheckSecondOperand -> jmp .CheckSecondOperand",
        "jz .FixedMulDone -> jz .SaveSignStatus", "ret -> left out", "neg ax -> twice",
        "mov ax, [bp+6] -> mov ax, [bp+4]"}) {
    EXPECT_NE(changes.find(wanted), std::string::npos) << wanted;
  }
}

TEST(Mutation, JumpsStillLeadWhereTheyLed) {
  // Removing or doubling an instruction must keep each label before the same instruction.
  const cases::Variant v{.build = {.target = cases::Target::i8088}};
  for (const auto& mutant : proof::mutants_of(v)) {
    if (!mutant.change.ends_with("twice") && !mutant.change.ends_with("left out")) continue;
    std::size_t jumps = 0;
    for (const auto& i : mutant.program.instructions()) {
      const auto& o = i.operands[0];
      if (o.kind != x86model::Operand::Kind::label) continue;
      ++jumps;
      ASSERT_LT(static_cast<std::size_t>(o.value), mutant.program.size);
      const auto& target = mutant.program.code.at(static_cast<std::size_t>(o.value));
      const bool led_to_the_change = mutant.change.ends_with("left out") && target.label == nullptr;
      if (led_to_the_change) continue;
      EXPECT_STREQ(target.label, o.name) << mutant.change;
    }
    EXPECT_GE(jumps, 2U);
  }
}

TEST(Mutation, AShareOfAllMutantsIsKilledOrEquivalent) {
  const proof::Solver solver("z3");
  std::size_t killed = 0;
  for (const cases::Variant& v : cases::all_variants()) {
    if (!parties::has_program(v) || v.build.chapter_52 || !cases::rounds(v)) continue;
    const auto all = proof::mutants_of(v);
    for (std::size_t i = 5; i < all.size(); i += every) {
      const proof::MutantResult judgement = proof::judge(v, all[i].program, seed, solver, 60);
      EXPECT_NE(judgement.fate, proof::Fate::gap) << all[i].change;
      if (judgement.fate == proof::Fate::killed) ++killed;
    }
  }
  EXPECT_GE(killed, least_killed);
}

TEST(Mutation, WhatDoesTheSameIsEquivalent) {
  const proof::Solver solver("z3");
  const cases::Variant v{.build = {.target = cases::Target::i8088}};
  // Its terms are the routine's own, so the solver is not asked.
  const proof::MutantResult own = proof::judge(v, parties::program_of(v), seed, solver, 60);
  EXPECT_EQ(own.fate, proof::Fate::equivalent);
  EXPECT_EQ(own.proof.questions, 0U);
  bool found = false;
  for (const auto& mutant : proof::mutants_of(v)) {
    // Only the low half of that product is used, and MUL and IMUL agree in it.
    if (mutant.change != "23 mul bx -> imul bx") continue;
    found = true;
    const proof::MutantResult same = proof::judge(v, mutant.program, seed, solver, 60);
    EXPECT_EQ(same.fate, proof::Fate::equivalent);
    EXPECT_GT(same.proof.questions, 0U);
  }
  EXPECT_TRUE(found);
}

// A proof of a transform takes the results of FixedMul for those of the routine, which has a proof
// of its own.
TEST(Mutation, AnotherFixedMulIsNotTheSame) {
  const cases::Variant rounds{.operation = cases::Operation::xformvec,
                              .build = {.target = cases::Target::i8088, .mul_round = true}};
  cases::Variant truncates = rounds;
  truncates.build.mul_round = false;
  const x86model::Program own = parties::program_of(rounds);
  const x86model::Program other = parties::program_of(truncates);
  EXPECT_TRUE(proof::has_same_terms(rounds, own.instructions()));
  EXPECT_FALSE(proof::has_same_terms(rounds, other.instructions()));
}

TEST(Mutation, TheSecondRoundKillsToo) {
  const proof::Solver solver("z3");
  const cases::Variant v{.operation = cases::Operation::cossin};
  constexpr std::uint64_t most_in_first_round = 20 * 256;  // CosSin has fewer streams than 20
  std::size_t late = 0;
  for (const auto& mutant : proof::mutants_of(v)) {
    const auto by =
        proof::cases_to_kill(v, *parties::make_interpreter_of("mutant", mutant.program), seed);
    if (!by || *by <= most_in_first_round) continue;
    ++late;
    EXPECT_EQ(proof::judge(v, mutant.program, seed, solver, 60).cases, *by) << mutant.change;
  }
  EXPECT_GT(late, 0U);
}

TEST(Mutation, SwappedRoundingsAreCaught) {
  for (const cases::Operation o : {cases::Operation::mul, cases::Operation::div}) {
    for (const cases::Target t : {cases::Target::i386, cases::Target::i8088}) {
      for (const bool round : {true, false}) {
        const cases::Variant v{.operation = o,
                               .build = {.target = t, .mul_round = round, .div_round = round}};
        cases::Variant other = v;
        other.build.mul_round = other.build.div_round = !round;
        EXPECT_TRUE(caught(parties::program_of(other), v));
        other = v;
        other.build.target = t == cases::Target::i386 ? cases::Target::i8088 : cases::Target::i386;
        EXPECT_TRUE(caught(parties::program_of(other), v));
        EXPECT_FALSE(caught(parties::program_of(v), v));
      }
    }
  }
}

TEST(Mutation, APlantedOrMissingCarryIsCaught) {
  for (const bool round : {true, false}) {
    const cases::Variant printed{.operation = cases::Operation::concat,
                                 .build = {.target = cases::Target::i8088, .mul_round = round}};
    cases::Variant repaired = printed;
    repaired.build.repaired = true;
    EXPECT_TRUE(caught(parties::program_of(repaired), printed));
    EXPECT_TRUE(caught(parties::program_of(printed), repaired));
    EXPECT_FALSE(caught(parties::program_of(printed), printed));
    EXPECT_FALSE(caught(parties::program_of(repaired), repaired));
  }
}

/// The correct model, except that it answers 0 to a divide by zero.
class DropsAFault final : public parties::Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "broken"; }
  [[nodiscard]] std::string identity() const override { return "a test"; }
  [[nodiscard]] bool answers(const cases::Variant& /*variant*/) const override { return true; }
  void fill(const cases::Variant& v, const parties::Cases& asked) const override {
    parties::party_named("model").answer(v, asked);
    for (std::size_t i = 0; i < asked.endings.size(); ++i) {
      if (asked.in[2 * i + 1] != 0) continue;
      asked.endings[i] = parties::Ending::value;
      asked.out[i] = 0;
    }
  }
};

TEST(Mutation, ADroppedFaultIsCaught) {
  for (const cases::Target t : {cases::Target::i386, cases::Target::i8088}) {
    EXPECT_TRUE(proof::cases_to_kill({.operation = cases::Operation::div, .build = {.target = t}},
                                     DropsAFault(), seed));
  }
}

}  // namespace
