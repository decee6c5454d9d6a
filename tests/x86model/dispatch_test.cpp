// Tests that execute_any(), which has handlers for common operands, does what execute() does.
#include "tests/support/test.hpp"
#include "tests/x86model/cases.hpp"
#include "x86model/text.hpp"

namespace {

using namespace x86model;

/// execute() of the instruction's mnemonic, which looks at every operand.
template <class M>
Outcome execute_plainly(const Instruction& instruction, M& m) {
  Outcome outcome = Outcome::proceeds;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    const auto attempt = [&]<Mnemonic op>() {
      if (instruction.mnemonic == op) outcome = execute<op>(instruction, m);
    };
    (attempt.template operator()<static_cast<Mnemonic>(I)>(), ...);
  }
  (std::make_index_sequence<static_cast<std::size_t>(Mnemonic::jmp)>{});
  return outcome;
}

template <class M>
bool are_equal(const M& a, const M& b) {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
  for (std::uint32_t at = 0; a.memory.read(at, x) && b.memory.read(at, y); at += M::word_bits / 8) {
    if (x != y) return false;
  }
  return a.registers == b.registers && a.flags == b.flags;
}

/// Executes each instruction of a run in both ways, on copies of the machine.
struct InBothWays {
  std::span<const Instruction> code;
  std::size_t compared = 0;

  template <class M>
  void before(std::size_t position, const M& m) {
    const Instruction& instruction = code[position];
    if (is_control_flow(instruction.mnemonic)) return;
    M one = m;
    M other = m;
    ASSERT_EQ(execute_any(instruction, one), execute_plainly(instruction, other))
        << text_of(instruction);
    ASSERT_TRUE(are_equal(one, other)) << text_of(instruction);
    ++compared;
  }
  template <class M>
  void operator()(std::size_t /*position*/, const M& /*after*/) const {}
};

TEST(Dispatch, AHandlerForCommonOperandsDoesWhatTheInstructionDoes) {
  test::each_routine([]<Routine routine, Target target>() {
    const Program program = assemble(listing(routine, target), {});
    const auto words = test::cases(routine);
    const auto in = static_cast<std::size_t>(arity(routine).in);
    std::array<std::uint32_t, 12> out{};
    InBothWays both{program.instructions()};
    for (std::size_t i = 0; i + in <= words.size(); i += in) {
      call<routine, 16>(both.code, std::span(words).subspan(i, in),
                        std::span(out).first(static_cast<std::size_t>(arity(routine).out)), both);
      if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(both.compared, 0U);
  });
}

}  // namespace
