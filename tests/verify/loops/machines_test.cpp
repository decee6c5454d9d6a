// Tests the loops as machine code against the model: on the host processor span by span, and on
// Unicorn in lock step. Compares registers and all 64 KiB of memory; on Unicorn also the defined
// flags.
#include "tests/support/test.hpp"
#include "tests/verify/loops/span.hpp"
#include "verify/machine_code/emulator.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "verify/machine_code/processor.hpp"
#include "x86model/encoding.hpp"

namespace {

using namespace loops_test;
using fixproof::machine_code::CallEnding;
using fixproof::machine_code::SegmentMachine;
using x86::Loop;
using x86::LoopCall;
using x86::LoopForm;

/// The return address that both callers of machine code push. Their CALL has three bytes.
constexpr std::uint32_t return_address = fixproof::machine_code::caller_origin + 3;

struct Ready {
  x86::Registers<16> registers;
  Memory memory;  ///< after the machine has entered the loop

  Ready(const LoopForm& form, const LoopCall& call, SegmentMachine& m, std::uint8_t* segment,
        const Memory& data, Random& random) {
    std::copy_n(data.begin(), fixproof::machine_code::caller_origin, segment);
    for (std::size_t r = 0; r < x86::register_count; ++r) {
      m.registers.write(static_cast<x86::Register>(r), x86::Size::dword,
                        static_cast<std::uint32_t>(random()));
    }
    x86::enter_loop(form, m, call);
    registers = m.registers;
    m.memory.write(0x5E, return_address);
    memory.assign(segment, segment + fixproof::machine_code::segment_size);
  }
};

/// The model's run from that state. Its stack is separate because its return address differs.
struct ModelRun {
  struct Instant {
    std::size_t position;
    x86::Registers<16> registers;
    x86::Flags flags;
  };
  std::vector<Instant> instants;
  x86::Ending ending{};
  Memory memory;

  ModelRun(const Ready& ready, std::span<const x86::Instruction> code, bool keep_instants)
      : memory(ready.memory) {
    Memory stack(0x60, 0xFF);
    x86::LoopMachine m{.registers = ready.registers,
                       .memory = x86::ByteMemory(memory, memory, stack)};
    ending = x86::run(code, m, [&](std::size_t at, const x86::LoopMachine& machine) {
      if (keep_instants || instants.empty()) {
        instants.push_back({at, machine.registers, machine.flags});
      } else {
        instants.back() = {at, machine.registers, machine.flags};
      }
    });
  }
};

std::string skip_reason(const std::string& machine_absence) {
  const std::string absence = fixproof::machine_code::machine_code_absence();
  return absence.empty() ? machine_absence : absence;
}

TEST(LoopsOnSilicon, EveryFormAndLength) {
  if (const auto why = skip_reason(fixproof::machine_code::Processor::absence()); !why.empty()) {
    GTEST_SKIP() << why;
  }
  Random random(386);
  // A texture can cover the whole segment.
  fixproof::machine_code::Processor processor(fixproof::machine_code::segment_size);
  for (const LoopForm& form : x86::all_loop_forms()) {
    processor.load(fixproof::machine_code::machine_code(form));
    const auto code = x86::code_of(form);
    const bool words = form.loop == Loop::gouraud_word;
    const Memory data = noise(random);
    for (std::uint32_t pixels = words ? 2 : 1; pixels <= most; pixels += words ? 2 : 1) {
      SegmentMachine m(processor.memory());
      const LoopCall call = draw_call(form.loop, pixels, random);
      const Ready ready(form, call, m, processor.memory(), data, random);
      const ModelRun model(ready, code, false);
      ASSERT_EQ(model.ending.outcome, x86::Outcome::returned) << text(form);
      const auto ending = [&] {
        const fixproof::machine_code::Processor::Calls calls(processor);
        return calls.call(m);
      }();
      ASSERT_EQ(ending, CallEnding::returned) << text(form) << ", pixels " << pixels;
      ASSERT_EQ(m.registers, model.instants.back().registers) << text(form) << ", " << pixels;
      ASSERT_TRUE(std::equal(model.memory.begin(), model.memory.end(), processor.memory()))
          << text(form) << ", pixels " << pixels;
    }
  }
}

/// Describes the first difference between the model and Unicorn, instruction by instruction; empty
/// if there is none. Randomises the flags that the model leaves undefined.
std::string difference(const LoopForm& form, std::span<const std::uint8_t> machine_code,
                       const LoopCall& call, Random& random) {
  fixproof::machine_code::Emulator emulator(machine_code);
  SegmentMachine m(emulator.memory());
  const Ready ready(form, call, m, emulator.memory(), noise(random), random);
  const auto code = x86::code_of(form);
  const ModelRun model(ready, code, true);
  if (model.ending.outcome != x86::Outcome::returned) return "the model breaks off";
  std::vector<std::uint32_t> places;
  std::uint32_t place = x86::code_address;
  for (const x86::Instruction& instruction : code) {
    places.push_back(place);
    place += static_cast<std::uint32_t>(x86::encoding_of(instruction).bytes());
  }
  std::string found;
  std::size_t steps = 0;
  const auto step = [&](SegmentMachine& machine, std::uint16_t next) {
    std::uint16_t undefined = x86::arithmetic_flags;
    const auto fail = [&](const char* what) {
      if (found.empty()) found = "step " + std::to_string(steps) + ": " + what;
    };
    if (steps > model.instants.size()) return fail("one too many");
    if (steps < model.instants.size() && places.at(model.instants[steps].position) != next) {
      fail("another instruction is next");
    }
    if (steps > 0) {
      const ModelRun::Instant& expected = model.instants[steps - 1];
      undefined = expected.flags.undefined;
      const auto defined = static_cast<std::uint16_t>(~undefined);
      if (machine.registers != expected.registers) fail("registers");
      if ((machine.flags.value & defined) != expected.flags.value) fail("flags");
    }
    const auto junk = static_cast<std::uint16_t>(random() & undefined);
    machine.flags.value = static_cast<std::uint16_t>((machine.flags.value & ~undefined) | junk);
    ++steps;
  };
  const CallEnding ending = emulator.trace(m, step, model.instants.size() + 1);
  if (!found.empty()) return found;
  if (ending != CallEnding::returned || steps != model.instants.size() + 1) return "the end";
  const bool same = std::equal(model.memory.begin(), model.memory.end(), emulator.memory());
  return same ? "" : "memory";
}

TEST(LoopsOnUnicorn, InLockStep) {
  if (const auto why = skip_reason(fixproof::machine_code::Emulator::absence()); !why.empty()) {
    GTEST_SKIP() << why;
  }
  Random random(1981);
  for (const LoopForm& form : x86::all_loop_forms()) {
    for (const std::uint32_t pixels : {2U, 24U}) {
      EXPECT_EQ(difference(form, fixproof::machine_code::machine_code(form),
                           draw_call(form.loop, pixels, random), random),
                "")
          << text(form) << ", pixels " << pixels;
    }
    if (form.loop == Loop::gouraud_word) continue;
    for (const std::uint32_t pixels : {1U, 3U}) {
      EXPECT_EQ(difference(form, fixproof::machine_code::machine_code(form),
                           draw_call(form.loop, pixels, random), random),
                "")
          << text(form) << ", pixels " << pixels;
    }
  }
}

TEST(LoopsOnUnicorn, TheLongestSpanInLockStep) {
  if (const auto why = skip_reason(fixproof::machine_code::Emulator::absence()); !why.empty()) {
    GTEST_SKIP() << why;
  }
  Random random(320);
  const LoopForm form{Loop::texture, x86::Counting::unrolled};
  EXPECT_EQ(difference(form, fixproof::machine_code::machine_code(form),
                       draw_call(form.loop, most, random), random),
            "");
}

/// Whether a byte is a 32-bit prefix, of INC EDI or SHR ECX, that small numbers do not need.
bool is_idle_prefix(std::span<const std::uint8_t> code, std::size_t at) {
  return code[at] == 0x66 && (code[at + 1] == 0x47 || code[at + 1] == 0xD1);
}

/// Flipping one bit of any code byte must make the comparison fail.
TEST(LoopsOnUnicorn, SeesOtherCode) {
  if (const auto why = skip_reason(fixproof::machine_code::Emulator::absence()); !why.empty()) {
    GTEST_SKIP() << why;
  }
  for (const LoopForm& form :
       {LoopForm{Loop::gouraud_word}, LoopForm{Loop::texture}, LoopForm{Loop::depth_test}}) {
    const auto right = fixproof::machine_code::machine_code(form);
    for (std::size_t at = 0; at + 1 < right.size(); ++at) {
      std::vector<std::uint8_t> wrong(right.begin(), right.end());
      wrong[at] ^= 1U;
      if (is_idle_prefix(right, at)) continue;
      Random random(7);
      bool differs = false;
      // The last one is for SHR of CL: it needs a count above 255.
      for (const std::uint32_t pixels : {16U, 16U, 16U, 258U}) {
        if (differs) break;
        differs = !difference(form, wrong, draw_call(form.loop, pixels, random), random).empty();
      }
      EXPECT_TRUE(differs) << text(form) << ", byte " << at;
    }
  }
}

}  // namespace
