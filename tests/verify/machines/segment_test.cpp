// CosSin's table is in the code segment, and CosSin reads it with a CS: override. On the processor
// the data segment ends before the code, so a read without the override faults.
#include "tests/support/test.hpp"
#include "verify/machine_code/frame.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "verify/machine_code/processor.hpp"
#include "x86model/cosine_table.hpp"

namespace {

using namespace fixproof;
using x86model::Routine;

/// Replaces every CS: before a MOV or an operand-size prefix by a NOP.
std::vector<std::uint8_t> without_overrides(std::span<const std::uint8_t> code, int& changed) {
  constexpr std::uint8_t cs = 0x2E;
  constexpr std::uint8_t mov = 0x8B;
  constexpr std::uint8_t operand_size = 0x66;
  constexpr std::uint8_t nop = 0x90;
  std::vector<std::uint8_t> bytes(code.begin(), code.end());
  const std::size_t end = bytes.size() - 4 * x86model::cosine_table.size();
  for (std::size_t i = 0; i + 1 < end; ++i) {
    if (bytes[i] != cs || (bytes[i + 1] != mov && bytes[i + 1] != operand_size)) continue;
    bytes[i] = nop;
    ++changed;
  }
  return bytes;
}

/// Calls with the angle 45.0 degrees; returns cosine and sine in `out`, and the ending.
machine_code::CallEnding call(machine_code::Processor& processor,
                              std::span<const std::uint8_t> code,
                              std::array<std::uint32_t, 2>& out) {
  processor.load(code);
  const machine_code::Frame frame = machine_code::frame_of(Routine::cossin);
  machine_code::SegmentMachine m(processor.memory());
  const std::array<std::uint32_t, 1> angle{450};
  machine_code::scramble(m, frame, 1);
  frame.enter(m, angle);
  machine_code::CallEnding ending{};
  {
    const machine_code::Processor::Calls calls(processor);
    ending = calls.call(m);
  }
  frame.leave(m, out);
  return ending;
}

TEST(Segment, TheTableIsReadWithTheCode) {
  if (const auto why = machine_code::Processor::absence(); !why.empty()) GTEST_SKIP() << why;
  machine_code::Processor processor;
  for (const auto target : {x86model::Target::i386, x86model::Target::i8088}) {
    const auto code =
        machine_code::machine_code(machine_code::ProgramKey{Routine::cossin, target, {}});
    if (code.empty()) GTEST_SKIP() << machine_code::machine_code_absence();
    std::array<std::uint32_t, 2> out{};
    EXPECT_EQ(call(processor, code, out), machine_code::CallEnding::returned);
    // 65536 * sqrt(1/2) = 46340.95
    EXPECT_EQ(out, (std::array<std::uint32_t, 2>{46341, 46341}));
    int changed = 0;
    const auto spoilt = without_overrides(code, changed);
    EXPECT_EQ(changed, target == x86model::Target::i386 ? 8 : 16);
    EXPECT_EQ(call(processor, spoilt, out), machine_code::CallEnding::fault);
  }
}

}  // namespace
