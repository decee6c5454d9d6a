// Tests instructions as fuzz inputs.
#include "fuzz/step_case.hpp"

#include "tests/support/test.hpp"
#include "x86model/forms.hpp"

namespace {

using namespace fixproof;
using x86model::Register;
using x86model::Size;

TEST(StepCase, IsReadAndWritten) {
  // On an 8088: add ax, bx; carry set; AX 1234h, the others numbered upwards.
  std::array<std::uint8_t, fuzz::step_input_size> bytes{1, 0x01, 0xD8};
  bytes[10] = 0x01;
  bytes[13] = 0x12;
  bytes[14] = 0x34;
  const auto step = fuzz::read_step_case(bytes);
  EXPECT_EQ(step.cpu, x86model::Target::i8088);
  EXPECT_EQ(step.machine.flags.value, x86model::CF);
  EXPECT_EQ(step.machine.registers.read(Register::ax, Size::dword), 0x1234U);
  const auto decoded = step.decoded();
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->length, 2U);
  EXPECT_EQ(step.replay(decoded->instruction),
            "echo 'add ax, bx | ax=1234 bx=0000 cx=0000 dx=0000 si=0000 di=0000 bp=0000 sp=0000 "
            "fl=0001' | fixproof step --cpu 8088");
  std::array<std::uint8_t, fuzz::step_input_size> back{};
  fuzz::write_step_case(step, back);
  EXPECT_EQ(back, bytes);
}

TEST(StepCase, BytesThatAreNoInstruction) {
  EXPECT_FALSE(fuzz::read_step_case({}).decoded());
  EXPECT_FALSE(fuzz::read_step_case(std::array<std::uint8_t, 2>{0, 0x66}).decoded());
}

TEST(StepCase, MutationLeavesAn8088ItsWidth) {
  fuzz::StepCase step;
  int of_8088 = 0;
  for (std::uint32_t seed = 0; seed < 2000; ++seed) {
    fuzz::mutate_step_case(step, seed);
    if (step.cpu != x86model::Target::i8088) continue;
    ++of_8088;
    for (std::size_t r = 0; r < x86model::register_count; ++r) {
      ASSERT_LE(step.machine.registers.read(static_cast<Register>(r), Size::dword), 0xFFFFU);
    }
  }
  EXPECT_GT(of_8088, 100);
}

TEST(StepCase, MutationComesToEveryFormWithRegisters) {
  std::set<std::string> seen;
  fuzz::StepCase step;
  for (std::uint32_t seed = 0; seed < 20000; ++seed) {
    fuzz::mutate_step_case(step, seed);
    const auto decoded = step.decoded();
    ASSERT_TRUE(decoded);
    seen.insert(x86model::form_text(decoded->instruction));
  }
  for (const auto cpu : {x86model::Target::i8088, x86model::Target::i386}) {
    for (const std::string& form : x86model::form_texts(cpu)) {
      // Jumps need a label, and PUSH, POP, CALL and RET use the stack.
      const std::string name = form.substr(0, form.find(' '));
      const std::set<std::string> elsewhere{"push", "pop", "call", "ret", "jmp",
                                            "js",   "jns", "jz",   "ja",  "jg"};
      EXPECT_TRUE(elsewhere.contains(name) || seen.contains(form)) << form;
    }
  }
}

}  // namespace
