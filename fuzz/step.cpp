// Target `step`: runs one instruction in the model and in Unicorn. Compares the divide error, all
// registers, the flags that the model defines, and the instruction's length. Also parses the
// instruction's text back.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "fuzz/finding.hpp"
#include "fuzz/step_case.hpp"
#include "verify/machine_code/emulator.hpp"
#include "x86model/parse.hpp"
#include "x86model/run.hpp"
#include "x86model/text.hpp"

using namespace fixproof;

namespace {

namespace x86 = x86model;
using x86::Register;
using x86::Size;

struct End {
  bool divide_error = false;
  std::optional<std::size_t> length;  ///< empty if the instruction did not complete
  x86::Registers<16> registers;
  x86::Flags flags;
};

/// Runs Unicorn one instruction at a time. Unicorn caches translations, so every instruction gets a
/// new address; a new emulator starts when none is left.
class Executor {
 public:
  /// @param length of the instruction in bytes; the random bytes after it may not be translatable
  End execute(const fuzz::StepCase& step, std::size_t length) {
    End left = execute_once(step, length);
    // An emulator that has run thousands of instructions may reject one that a new emulator runs.
    if (!left.length && !left.divide_error) {
      renew();
      left = execute_once(step, length);
    }
    return left;
  }

 private:
  End execute_once(const fuzz::StepCase& step, std::size_t length) {
    if (place_ + place_size > machine_code::segment_size) renew();
    const std::size_t place = place_;
    place_ += place_size;
    std::uint8_t* code = emulator_->memory() + place;
    std::fill_n(code, place_size, nop);
    std::copy_n(step.code.begin(), length, code);

    machine_code::SegmentMachine m(emulator_->memory());
    m.registers.write(Register::sp, Size::dword, stack);
    m.registers.write(Register::ax, Size::dword, static_cast<std::uint32_t>(place));
    End left;
    std::size_t steps = 0;
    const auto ending = emulator_->trace(
        m,
        [&](machine_code::SegmentMachine& machine, std::uint16_t next) {
          ++steps;
          if (steps == 2) {
            machine.registers = step.machine.registers;
            machine.flags = step.machine.flags;
          } else if (steps == 3) {
            left.length = next - place;
            left.registers = machine.registers;
            left.flags = machine.flags;
          }
        },
        3);
    left.divide_error = ending == machine_code::CallEnding::divide_error && steps == 2;
    return left;
  }

  static constexpr std::uint8_t nop = 0x90;
  static constexpr std::size_t place_size = 16;
  static constexpr std::uint32_t stack = 0x2000;

  void renew() {
    constexpr std::array<std::uint8_t, 2> jmp_ax{0xFF, 0xE0};
    emulator_.reset();
    emulator_ = std::make_unique<machine_code::Emulator>(jmp_ax);
    place_ = machine_code::code_origin + machine_code::page_size;
  }

  std::unique_ptr<machine_code::Emulator> emulator_;
  std::size_t place_ = machine_code::segment_size;
};

std::string text_of(const x86::Registers<16>& registers, std::uint16_t flags) {
  std::string text;
  for (std::size_t r = 0; r < x86::register_count; ++r) {
    text += fmt::format("{}={:08x} ", x86::name_of(static_cast<Register>(r), Size::dword),
                        registers.read(static_cast<Register>(r), Size::dword));
  }
  return text + fmt::format("fl={:04x}", flags);
}

std::optional<std::string> difference(const End& model, const End& unicorn) {
  if (model.divide_error != unicorn.divide_error) {
    return fmt::format("divide error: model {}, unicorn {}", model.divide_error,
                       unicorn.divide_error);
  }
  if (model.divide_error) return std::nullopt;
  const auto defined = static_cast<std::uint16_t>(~model.flags.undefined);
  if (model.length == unicorn.length && model.registers == unicorn.registers &&
      model.flags.value == (unicorn.flags.value & defined)) {
    return std::nullopt;
  }
  return fmt::format("model   {}, undefined {:04x}, {} bytes\n  unicorn {}, {} bytes",
                     text_of(model.registers, model.flags.value), model.flags.undefined,
                     model.length.value_or(0), text_of(unicorn.registers, unicorn.flags.value),
                     unicorn.length.value_or(0));
}

/// Whether Unicorn would crash the process: version 2.0.1 divides -2^63 by -1 with the host's IDIV.
/// The correct result is #DE, because the quotient does not fit.
bool ends_unicorn(const x86::Instruction& instruction, const singlestep::StepMachine& m) {
  const auto& divisor = instruction.operands[0];
  return instruction.mnemonic == x86::Mnemonic::idiv && divisor.size == Size::dword &&
         m.registers.read(Register::dx, Size::dword) == 0x80000000U &&
         m.registers.read(Register::ax, Size::dword) == 0 &&
         m.registers.read(divisor.reg, Size::dword) == 0xFFFFFFFFU;
}

bool reads_back(const x86::Instruction& instruction) {
  const auto again = x86::parse(x86::text_of(instruction));
  return again && x86::text_of(*again) == x86::text_of(instruction);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (const std::string reason = machine_code::Emulator::absence(); !reason.empty()) {
    fuzz::report_finding("step needs Unicorn: " + reason);
  }
  const fuzz::StepCase step = fuzz::read_step_case({data, size});
  const auto decoded = step.decoded();
  if (!decoded) return 0;
  End model;
  model.length = decoded->length;
  singlestep::StepMachine machine = step.machine;
  const x86::Outcome outcome = x86::execute_any(decoded->instruction, machine);
  model.divide_error = outcome == x86::Outcome::divide_error;
  model.registers = machine.registers;
  model.flags = machine.flags;
  if (outcome != x86::Outcome::proceeds && !model.divide_error) {
    fuzz::report_finding("the model does not execute it\n  replay: " +
                         step.replay(decoded->instruction));
  }
  static Executor unicorn;
  End expected;
  if (ends_unicorn(decoded->instruction, step.machine)) {
    expected.divide_error = true;
  } else {
    expected = unicorn.execute(step, decoded->length);
  }
  if (const auto found = difference(model, expected)) {
    fuzz::report_finding(fmt::format("{}\n  {}\n  replay: {}", x86::text_of(decoded->instruction),
                                     *found, step.replay(decoded->instruction)));
  }
  if (!reads_back(decoded->instruction)) {
    fuzz::report_finding("not read back from its text\n  replay: " +
                         step.replay(decoded->instruction));
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t room, unsigned seed) {
  if (room < fuzz::step_input_size) return size;
  fuzz::StepCase step = fuzz::read_step_case({data, size});
  fuzz::mutate_step_case(step, seed);
  fuzz::write_step_case(step, std::span(data, room).first<fuzz::step_input_size>());
  return fuzz::step_input_size;
}
