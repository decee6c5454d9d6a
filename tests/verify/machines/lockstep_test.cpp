// Runs the model and Unicorn in lock step and compares registers and defined flags after every
// instruction. Unicorn gets a random value for each flag that the model calls undefined.
#include <fmt/format.h>

#include "tests/support/test.hpp"
#include "verify/cases/draw.hpp"
#include "verify/cases/streams.hpp"
#include "verify/cases/words.hpp"
#include "verify/machine_code/emulator.hpp"
#include "verify/machine_code/frame.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "x86model/call.hpp"

namespace {

using namespace fixproof;
using x86model::Outcome;
using x86model::Routine;

/// One instruction of the model's run and the machine state after it.
struct Instant {
  std::size_t position;
  x86model::Registers<16> registers;
  x86model::Flags flags;
};

/// A run of the model from registers that hold `garbage`.
struct History {
  std::vector<Instant> instants;
  x86model::Ending ending;
  std::vector<std::uint32_t> out;
};

template <Routine routine>
History history_of(const machine_code::ProgramKey& key, const x86model::Registers<16>& garbage,
                   std::span<const std::uint32_t> in) {
  const auto program = x86model::assemble(x86model::listing(key.routine, key.target), key.build);
  x86model::CallMachine<routine, 16> m;
  m.registers = garbage;
  x86model::enter<routine>(m, in);
  History h{};
  h.ending = x86model::run(program.instructions(), m, [&](std::size_t at, const auto& machine) {
    h.instants.push_back({at, machine.registers, machine.flags});
  });
  h.out.resize(static_cast<std::size_t>(x86model::arity(routine).out));
  x86model::leave<routine>(m, h.out);
  return h;
}

History history_of(const machine_code::ProgramKey& key, const x86model::Registers<16>& garbage,
                   std::span<const std::uint32_t> in) {
  switch (key.routine) {
    case Routine::mul:
      return history_of<Routine::mul>(key, garbage, in);
    case Routine::div:
      return history_of<Routine::div>(key, garbage, in);
    case Routine::cossin:
      return history_of<Routine::cossin>(key, garbage, in);
    case Routine::xformvec:
      return history_of<Routine::xformvec>(key, garbage, in);
    case Routine::concat:
      break;
  }
  return history_of<Routine::concat>(key, garbage, in);
}

std::string shown(const x86model::Registers<16>& registers, std::uint16_t flags) {
  std::string text;
  for (std::size_t r = 0; r < x86model::register_count; ++r) {
    text += fmt::format("{:08x} ",
                        registers.read(static_cast<x86model::Register>(r), x86model::Size::dword));
  }
  return text + fmt::format("flags {:03x}", flags);
}

class Lockstep {
 public:
  /// @param code machine code to run; different from the program's in tests of the comparison
  Lockstep(const machine_code::ProgramKey& key, std::span<const std::uint8_t> code)
      : key_(key), emulator_(code) {}

  /// @return the first difference, or an empty string
  std::string difference(std::span<const std::uint32_t> in) {
    const machine_code::Frame frame = machine_code::frame_of(key_.routine);
    machine_code::SegmentMachine m(emulator_.memory());
    machine_code::scramble(m, frame, cases_);
    cases::Draw random(1981, cases_++);
    const History model = history_of(key_, m.registers, in);
    frame.enter(m, in);

    std::string found;
    std::size_t steps = 0;
    const auto step = [&](machine_code::SegmentMachine& machine, std::uint16_t next) {
      if (found.empty()) found = difference_at(model, steps, machine, next);
      const std::uint16_t undefined =
          steps == 0
              ? x86model::arithmetic_flags
              : model.instants.at(std::min(steps, model.instants.size()) - 1).flags.undefined;
      const auto noise = static_cast<std::uint16_t>(random.bits() & undefined);
      machine.flags.value = static_cast<std::uint16_t>((machine.flags.value & ~undefined) | noise);
      ++steps;
    };
    const machine_code::CallEnding ending = emulator_.trace(m, step, model.instants.size() + 1);
    if (!found.empty()) return found;
    const bool returned = model.ending.outcome == Outcome::returned;
    if (!returned && model.ending.outcome != Outcome::divide_error) {
      return fmt::format("the model breaks off at row {}", model.ending.position);
    }
    const auto expected =
        returned ? machine_code::CallEnding::returned : machine_code::CallEnding::divide_error;
    if (ending != expected || steps != model.instants.size() + 1) {
      return fmt::format("ended as {} after {} steps, not as {} after {}", static_cast<int>(ending),
                         steps - 1, static_cast<int>(expected), model.instants.size());
    }
    if (ending != machine_code::CallEnding::returned) return "";
    std::vector<std::uint32_t> out(model.out.size());
    frame.leave(m, out);
    return out == model.out ? "" : "results differ: " + cases::hex_words(out, 32);
  }

  [[nodiscard]] std::uint64_t instructions() const { return instructions_; }

 private:
  std::string difference_at(const History& model, std::size_t steps,
                            const machine_code::SegmentMachine& machine, std::uint16_t next) {
    ++instructions_;
    if (steps > model.instants.size()) return fmt::format("more than {} instructions", steps - 1);
    // The positions of the listing and the addresses of the code have the same order, one to one.
    if (steps < model.instants.size() || model.ending.outcome == Outcome::divide_error) {
      const std::size_t position =
          steps < model.instants.size() ? model.instants[steps].position : model.ending.position;
      const auto place = places_.emplace(position, next).first;
      const bool in_order = place->second == next &&
                            (place == places_.begin() || std::prev(place)->second < next) &&
                            (std::next(place) == places_.end() || std::next(place)->second > next);
      if (!in_order) return fmt::format("step {}: {:04x} is not row {}", steps, next, position);
    }
    if (steps == 0) return "";
    const Instant& expected = model.instants[steps - 1];
    const auto defined = static_cast<std::uint16_t>(~expected.flags.undefined);
    if (machine.registers == expected.registers &&
        (machine.flags.value & defined) == expected.flags.value) {
      return "";
    }
    return fmt::format("after step {}, row {}:\n  unicorn {}\n  model   {}, undefined {:03x}",
                       steps, expected.position, shown(machine.registers, machine.flags.value),
                       shown(expected.registers, expected.flags.value), expected.flags.undefined);
  }

  machine_code::ProgramKey key_;
  machine_code::Emulator emulator_;
  std::map<std::size_t, std::uint16_t> places_;
  std::uint64_t cases_ = 0;
  std::uint64_t instructions_ = 0;
};

/// Operands for a program: a sample of the lattice where there is one, and random cases.
std::vector<std::uint32_t> cases_for(const machine_code::ProgramKey& key) {
  const cases::Variant v{.operation = static_cast<cases::Operation>(key.routine)};
  const std::size_t in = cases::words_in(v.operation);
  std::vector<std::uint32_t> words;
  const auto add = [&](cases::Stream stream, std::uint64_t first, std::size_t cases) {
    words.resize(words.size() + cases * in);
    cases::make_cases(stream, v, 1994, first, std::span(words).last(cases * in));
  };
  switch (key.routine) {
    case Routine::mul:
    case Routine::div:
      // 5 shares no divisor with the lattice's width, so every value occurs.
      for (std::uint64_t i = 0; i < *cases::size_of(cases::Stream::lattice, v); i += 5)
        add(cases::Stream::lattice, i, 1);
      add(cases::Stream::scaled, 0, 2000);
      add(cases::Stream::uniform, 0, 500);
      if (key.routine == Routine::div) add(cases::Stream::fault_edge, 0, 1000);
      break;
    case Routine::cossin:
      for (std::uint64_t i = 0; i < 0x10000; i += 11) add(cases::Stream::every, i, 1);
      break;
    case Routine::xformvec:
    case Routine::concat:
      add(cases::Stream::lattice_words, 0, 150);
      add(cases::Stream::scaled, 0, 100);
      break;
  }
  return words;
}

std::string skip_reason() {
  const std::string reason = machine_code::Emulator::absence();
  return reason.empty() ? machine_code::machine_code_absence() : reason;
}

class LockstepOf : public testing::TestWithParam<std::string> {};

machine_code::ProgramKey key_named(const std::string& name) {
  for (const machine_code::ProgramKey& key : machine_code::all_programs()) {
    if (machine_code::name_of(key) == name) return key;
  }
  throw std::invalid_argument(name);
}

TEST_P(LockstepOf, EveryInstructionAgrees) {
  if (!skip_reason().empty()) GTEST_SKIP() << skip_reason();
  const machine_code::ProgramKey key = key_named(GetParam());
  Lockstep lockstep(key, machine_code::machine_code(key));
  const auto words = cases_for(key);
  const auto in = static_cast<std::size_t>(x86model::arity(key.routine).in);
  for (std::size_t i = 0; i < words.size(); i += in) {
    const auto operands = std::span(words).subspan(i, in);
    const std::string difference = lockstep.difference(operands);
    ASSERT_EQ(difference, "") << GetParam() << ": " << cases::hex_words(operands, 32);
  }
  RecordProperty("instructions", std::to_string(lockstep.instructions()));
}

std::vector<std::string> programs_in_lockstep() {
  std::vector<std::string> names;
  for (const machine_code::ProgramKey& key : machine_code::all_programs()) {
    // Without rounding, the divide as scanned adds a flag that DIV leaves undefined.
    if (!key.build.endif_as_scanned || key.build.div_rounding)
      names.push_back(machine_code::name_of(key));
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Program, LockstepOf, testing::ValuesIn(programs_in_lockstep()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(Lockstep, SeesOtherCode) {
  if (!skip_reason().empty()) GTEST_SKIP() << skip_reason();
  const machine_code::ProgramKey key = key_named("mul-i386-on");
  const auto right = machine_code::machine_code(key);
  // 1.5 * 2.5, and a product whose rounding carries through all of EDX.
  constexpr std::array<std::array<std::uint32_t, 2>, 2> cases{
      {{0x00018000, 0x00028000}, {0x00000001, 0xFFFF8000}}};
  const auto differs = [&](std::span<const std::uint8_t> code) {
    return std::any_of(cases.begin(), cases.end(), [&](const auto& operands) {
      return !Lockstep(key, code).difference(operands).empty();
    });
  };
  EXPECT_FALSE(differs(right));
  // Excludes the RET: with the zeros behind it, C2h is a RET too.
  for (std::size_t at = 0; at + 1 < right.size(); ++at) {
    std::vector<std::uint8_t> wrong(right.begin(), right.end());
    wrong[at] ^= 1U;
    EXPECT_TRUE(differs(wrong)) << "byte " << at;
  }
}

TEST(Lockstep, SeesThatAnUndefinedFlagIsRead) {
  if (!skip_reason().empty()) GTEST_SKIP() << skip_reason();
  const machine_code::ProgramKey key = key_named("div-i8088-off-scanned");
  const std::array<std::uint32_t, 2> operands{0x00030000, 0x00020000};
  EXPECT_EQ(Lockstep(key, machine_code::machine_code(key))
                .difference(operands)
                .rfind("the model breaks off", 0),
            0);
}

TEST(Lockstep, FlagsWrittenBetweenInstructionsCount) {
  if (!skip_reason().empty()) GTEST_SKIP() << skip_reason();
  // ADD AX,0 clears CF, and ADC AX,0 adds CF to AX, which holds 0.
  machine_code::Emulator emulator(
      std::array<std::uint8_t, 7>{0x05, 0x00, 0x00, 0x15, 0x00, 0x00, 0xC3});
  for (const std::uint16_t carry : {std::uint16_t{0}, std::uint16_t{x86model::CF}}) {
    machine_code::SegmentMachine m(emulator.memory());
    m.registers.write(x86model::Register::sp, x86model::Size::word, 0x40);
    const auto ending =
        emulator.trace(m, [&](machine_code::SegmentMachine& machine, std::uint16_t next) {
          if (next == machine_code::code_origin + 3) machine.flags.value = carry;
        });
    EXPECT_EQ(ending, machine_code::CallEnding::returned);
    EXPECT_EQ(m.registers.read(x86model::Register::ax, x86model::Size::word), carry);
  }
}

}  // namespace
