// Broken programs, each of which the verification must catch: every instruction of FixedMul and
// FixedDiv that has a plausible wrong neighbour is replaced by it, one at a time; roundings are
// swapped; a fault is dropped.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <map>

#include "verify/engine.hpp"
#include "x86model/call.hpp"
#include "x86model/text.hpp"

namespace {

using namespace fixproof;
namespace x86 = x86model;

Ending ending_of(x86::Outcome outcome) {
  if (outcome == x86::Outcome::returned) return Ending::value;
  return outcome == x86::Outcome::divide_error ? Ending::divide_error : Ending::broken;
}

/// A model that runs one given program.
template <x86::Routine routine>
class Broken final : public Party {
 public:
  explicit Broken(const x86::Program& program) : program_(program) {}
  [[nodiscard]] std::string_view name() const override { return "broken"; }
  [[nodiscard]] bool answers(const Variant&) const override { return true; }
  void answer(const Variant&, const Batch& batch) const override {
    for (std::size_t i = 0; i < batch.endings.size(); ++i) {
      batch.endings[i] =
          ending_of(x86::call<routine, 16>(program_.instructions(), batch.in.subspan(2 * i, 2),
                                           batch.out.subspan(i, 1))
                        .outcome);
    }
  }

 private:
  x86::Program program_;
};

/// Whether level 1 finds a mismatch between `party` and the oracle; stops at the first.
bool caught(const Party& party, const Variant& variant) {
  const Plan plan(1, 54, {Row{variant, {"broken", "fast"}}});
  std::atomic<bool> stop = false;
  RunOptions options{.threads = 1, .stop = &stop};
  options.observe = [&](const Report& so_far) { stop = so_far.mismatches() > 0; };
  options.observe_every = std::chrono::milliseconds(1);
  const std::array parties{&party, &party_named("fast")};
  return run(plan, parties, options).mismatches() > 0;
}

/// What each instruction is mistaken for.
const std::map<x86::Mnemonic, std::vector<x86::Mnemonic>> mistakes{
    {x86::Mnemonic::add, {x86::Mnemonic::sub}},
    {x86::Mnemonic::adc, {x86::Mnemonic::add, x86::Mnemonic::sbb}},
    {x86::Mnemonic::sbb, {x86::Mnemonic::sub, x86::Mnemonic::adc}},
    {x86::Mnemonic::neg, {x86::Mnemonic::inc}},
    {x86::Mnemonic::inc, {x86::Mnemonic::neg}},
    {x86::Mnemonic::dec, {x86::Mnemonic::inc}},
    {x86::Mnemonic::mul, {x86::Mnemonic::imul}},
    {x86::Mnemonic::imul, {x86::Mnemonic::mul}},
    {x86::Mnemonic::div, {x86::Mnemonic::idiv}},
    {x86::Mnemonic::idiv, {x86::Mnemonic::div}},
    {x86::Mnemonic::xor_, {x86::Mnemonic::add}},
    {x86::Mnemonic::shr, {x86::Mnemonic::shl}},
    {x86::Mnemonic::sar, {x86::Mnemonic::shr}},
    {x86::Mnemonic::rol, {x86::Mnemonic::shl}},
    {x86::Mnemonic::shld, {x86::Mnemonic::shrd}},
    {x86::Mnemonic::shrd, {x86::Mnemonic::shld}},
    {x86::Mnemonic::jns, {x86::Mnemonic::js, x86::Mnemonic::jmp}},
    {x86::Mnemonic::jz, {x86::Mnemonic::jmp}},
};

/// Every sabotaged program of a routine, its name with it, that level 1 did not catch.
template <x86::Routine routine>
std::vector<std::string> survivors(const Variant& v, std::size_t& tried) {
  const auto target = v.target == Target::i386 ? x86::Target::i386 : x86::Target::i8088;
  const x86::Program sound = x86::assemble(
      x86::listing(routine, target), {.mul_rounding = v.mul_round, .div_rounding = v.div_round});
  std::vector<std::string> survived;
  for (std::size_t at = 0; at < sound.size; ++at) {
    const auto known = mistakes.find(sound.code.at(at).mnemonic);
    if (known == mistakes.end()) continue;
    for (const x86::Mnemonic wrong : known->second) {
      x86::Program program = sound;
      program.code.at(at).mnemonic = wrong;
      ++tried;
      if (caught(Broken<routine>(program), v)) continue;
      survived.push_back(std::to_string(at) + ' ' + x86::text_of(sound.code.at(at)) + " -> " +
                         std::string(x86::name_of(wrong)));
    }
  }
  return survived;
}

using Names = std::vector<std::string>;

TEST(Sabotage, EveryWrongInstructionOfTheMultiplyIsCaught) {
  std::size_t tried = 0;
  for (const bool round : {true, false}) {
    EXPECT_EQ((survivors<x86::Routine::mul>({.target = Target::i386, .mul_round = round}, tried)),
              Names{});
    // High word times high word: only the low half is used, in which MUL and IMUL are the same.
    EXPECT_EQ((survivors<x86::Routine::mul>({.target = Target::i8088, .mul_round = round}, tried)),
              Names{"23 mul bx -> imul"});
  }
  EXPECT_GE(tried, 40U);
}

TEST(Sabotage, EveryWrongInstructionOfTheDivideIsCaught) {
  std::size_t tried = 0;
  for (const bool round : {true, false}) {
    Variant v{.operation = Operation::div, .target = Target::i386, .div_round = round};
    EXPECT_EQ((survivors<x86::Routine::div>(v, tried)), Names{});
    v.target = Target::i8088;
    EXPECT_EQ((survivors<x86::Routine::div>(v, tried)), Names{});
  }
  EXPECT_GE(tried, 40U);
}

TEST(Sabotage, TheSoundProgramsAreNotCaught) {
  const Variant v{.target = Target::i8088};
  const x86::Program sound = x86::assemble(x86::listing(x86::Routine::mul, x86::Target::i8088), {});
  EXPECT_FALSE(caught(Broken<x86::Routine::mul>(sound), v));
}

TEST(Sabotage, SwappedRoundingIsCaught) {
  for (const Target t : {Target::i386, Target::i8088}) {
    for (const bool round : {true, false}) {
      const auto target = t == Target::i386 ? x86::Target::i386 : x86::Target::i8088;
      const x86::Build swapped{.mul_rounding = !round, .div_rounding = !round};
      EXPECT_TRUE(caught(Broken<x86::Routine::mul>(
                             x86::assemble(x86::listing(x86::Routine::mul, target), swapped)),
                         {.operation = Operation::mul, .target = t, .mul_round = round}));
      EXPECT_TRUE(caught(Broken<x86::Routine::div>(
                             x86::assemble(x86::listing(x86::Routine::div, target), swapped)),
                         {.operation = Operation::div, .target = t, .div_round = round}));
    }
  }
}

TEST(Sabotage, TheOtherProcessorsRoutineIsCaught) {
  for (const bool round : {true, false}) {
    const x86::Build build{.mul_rounding = round, .div_rounding = round};
    EXPECT_TRUE(caught(Broken<x86::Routine::mul>(x86::assemble(
                           x86::listing(x86::Routine::mul, x86::Target::i386), build)),
                       {.operation = Operation::mul, .target = Target::i8088, .mul_round = round}));
    EXPECT_TRUE(caught(Broken<x86::Routine::div>(x86::assemble(
                           x86::listing(x86::Routine::div, x86::Target::i8088), build)),
                       {.operation = Operation::div, .target = Target::i386, .div_round = round}));
  }
}

/// The sound model, but for a divide by zero, which it answers with 0.
class DropsAFault final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "broken"; }
  [[nodiscard]] bool answers(const Variant&) const override { return true; }
  void answer(const Variant& v, const Batch& batch) const override {
    party_named("model").answer(v, batch);
    for (std::size_t i = 0; i < batch.endings.size(); ++i) {
      if (batch.in[2 * i + 1] != 0) continue;
      batch.endings[i] = Ending::value;
      batch.out[i] = 0;
    }
  }
};

TEST(Sabotage, ADroppedFaultIsCaught) {
  for (const Target t : {Target::i386, Target::i8088}) {
    EXPECT_TRUE(caught(DropsAFault(), {.operation = Operation::div, .target = t}));
  }
}

}  // namespace
