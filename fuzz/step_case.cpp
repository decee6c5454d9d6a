#include "fuzz/step_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "fuzz/words.hpp"
#include "verify/cases/draw.hpp"
#include "verify/cases/stream_makers.hpp"
#include "verify/cases/streams.hpp"
#include "verify/singlestep/shown.hpp"
#include "x86model/execute.hpp"
#include "x86model/text.hpp"

namespace fixproof::fuzz {

namespace {

namespace x86 = x86model;

constexpr std::size_t flags_at = 1 + max_code_bytes;
constexpr std::size_t registers_at = flags_at + 2;

/// The part of a register that the processor's instructions can change.
x86::Size size_on(x86::Target cpu) {
  return cpu == x86::Target::i386 ? x86::Size::dword : x86::Size::word;
}

x86::Register register_at(std::size_t i) { return static_cast<x86::Register>(i); }

/// Whether the instruction reads or writes memory or jumps.
bool uses_memory(const x86::Instruction& instruction) {
  const x86::Mnemonic op = instruction.mnemonic;
  const auto& all = instruction.operands;
  return x86::is_control_flow(op) || op == x86::Mnemonic::push || op == x86::Mnemonic::pop ||
         x86::detail::is_store_string(op) ||
         std::any_of(all.begin(), all.end(),
                     [](const x86::Operand& o) { return o.kind == x86::Operand::Kind::memory; });
}

/// Draws bytes until they form a modelled instruction, which takes some dozens of attempts.
void draw_code(StepCase& step, cases::Draw& draw) {
  do {
    for (auto& byte : step.code) byte = static_cast<std::uint8_t>(draw.bits());
    const bool wide = step.cpu == x86::Target::i386 && draw.coin();
    if (wide) step.code[0] = 0x66;
    // SHLD and SHRD are rare by chance.
    if (wide && draw.below(16) == 0) {
      step.code[1] = 0x0F;
      step.code[2] = draw.coin() ? 0xA4 : 0xAC;
    }
    // Makes the operand a register instead of memory, at each byte that may be a ModR/M byte.
    for (std::size_t i = 1; i < 4; ++i) {
      if (step.code[i] != 0x0F && step.code[i] != 0xA4 && step.code[i] != 0xAC && draw.coin()) {
        step.code[i] |= 0xC0U;
      }
    }
  } while (!step.decoded());
}

void draw_register(StepCase& step, cases::Draw& draw) {
  static const auto lattice = cases::boundary_lattice(32);
  static const auto narrow = cases::boundary_lattice(16);
  const x86::Register r = register_at(draw.below(x86::register_count));
  const std::uint32_t before = step.machine.registers.read(r, x86::Size::dword);
  const cases::Format format;
  std::uint32_t value = 0;
  switch (draw.below(5)) {
    case 0:
      value = static_cast<std::uint32_t>(lattice[draw.below(lattice.size())]);
      break;
    case 1:
      value = static_cast<std::uint32_t>(narrow[draw.below(narrow.size())]);
      break;
    case 2:
      value = cases::scaled_word(draw, format);
      break;
    case 3:
      value = before + 1 - 2 * static_cast<std::uint32_t>(draw.coin());
      break;
    default:
      value = step.machine.registers.read(register_at(draw.below(x86::register_count)),
                                          x86::Size::dword);
  }
  step.machine.registers.write(r, size_on(step.cpu), value);
}

}  // namespace

std::optional<x86::Decoded> StepCase::decoded() const {
  const bool i386 = cpu == x86::Target::i386;
  const auto result = x86::decode(code, i386 ? x86::Cpu::i386 : x86::Cpu::i8088);
  const auto* whole = std::get_if<x86::Decoded>(&result);
  if (whole == nullptr || uses_memory(whole->instruction)) return std::nullopt;
  return *whole;
}

std::string StepCase::replay(const x86::Instruction& instruction) const {
  const bool i386 = cpu == x86::Target::i386;
  const x86::Size size = size_on(cpu);
  std::string line = x86::text_of(instruction) + " |";
  for (const x86::Register r : singlestep::shown_registers) {
    line += fmt::format(" {}={:0{}x}", x86::name_of(r, size), machine.registers.read(r, size),
                        i386 ? 8 : 4);
  }
  return fmt::format("echo '{} fl={:04x}' | fixproof step --cpu {}", line, machine.flags.value,
                     i386 ? "386" : "8088");
}

StepCase read_step_case(std::span<const std::uint8_t> bytes) {
  std::array<std::uint8_t, step_input_size> whole{};
  std::copy_n(bytes.begin(), std::min(bytes.size(), whole.size()), whole.begin());
  StepCase step;
  step.cpu = (whole[0] & 1U) != 0 ? x86::Target::i8088 : x86::Target::i386;
  std::copy_n(whole.begin() + 1, max_code_bytes, step.code.begin());
  const auto flags = static_cast<std::uint16_t>(whole[flags_at] << 8U | whole[flags_at + 1]);
  step.machine.flags = {static_cast<std::uint16_t>(flags & x86::arithmetic_flags), 0};
  std::array<std::uint32_t, x86::register_count> registers{};
  read_words(std::span(whole).subspan(registers_at), registers);
  for (std::size_t i = 0; i < registers.size(); ++i) {
    step.machine.registers.write(register_at(i), size_on(step.cpu), registers[i]);
  }
  return step;
}

void write_step_case(const StepCase& step, std::span<std::uint8_t, step_input_size> bytes) {
  bytes[0] = step.cpu == x86::Target::i8088 ? 1 : 0;
  std::copy(step.code.begin(), step.code.end(), bytes.begin() + 1);
  bytes[flags_at] = static_cast<std::uint8_t>(step.machine.flags.value >> 8U);
  bytes[flags_at + 1] = static_cast<std::uint8_t>(step.machine.flags.value);
  std::array<std::uint32_t, x86::register_count> registers{};
  for (std::size_t i = 0; i < registers.size(); ++i) {
    registers[i] = step.machine.registers.read(register_at(i), x86::Size::dword);
  }
  write_words(registers, bytes.subspan(registers_at));
}

void mutate_step_case(StepCase& step, std::uint32_t seed) {
  cases::Draw draw(seed, 0);
  if (draw.below(16) == 0) {
    step.cpu = draw.coin() ? x86::Target::i386 : x86::Target::i8088;
    for (std::size_t i = 0; i < x86::register_count; ++i) {
      const std::uint32_t kept = step.machine.registers.read(register_at(i), size_on(step.cpu));
      step.machine.registers.write(register_at(i), x86::Size::dword, kept);
    }
  }
  if (draw.coin() || !step.decoded()) draw_code(step, draw);
  for (auto more = draw.below(4); more > 0; --more) draw_register(step, draw);
  if (draw.below(4) == 0) {
    step.machine.flags.value = static_cast<std::uint16_t>(draw.bits() & x86::arithmetic_flags);
  }
}

}  // namespace fixproof::fuzz
