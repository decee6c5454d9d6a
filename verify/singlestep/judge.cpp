#include "verify/singlestep/judge.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "support/usage_error.hpp"
#include "verify/singlestep/capture_memory.hpp"
#include "verify/singlestep/shown.hpp"
#include "x86model/decode.hpp"
#include "x86model/run.hpp"

namespace fixproof::singlestep {

namespace {

namespace x86 = x86model;
using x86::Cpu;

constexpr std::uint8_t hlt = 0xF4;
constexpr std::uint32_t trap_and_interrupt_flags = 0x300;
constexpr std::uint32_t direction_flag = 0x400;

/// Interrupts of faults.
constexpr std::uint32_t divide_error = 0;
constexpr std::uint32_t stack_fault = 12;
constexpr std::uint32_t segment_fault = 13;

/// The state that the model expects after the case.
struct Expected {
  std::array<std::uint32_t, place_count> registers{};
  std::uint32_t undefined_flags = 0;

  std::uint32_t& operator[](Place place) { return registers[static_cast<std::size_t>(place)]; }
};

/// The interrupt vector word that a fault reads. The case must list it.
std::optional<std::uint32_t> vector_word(const Case& c, std::uint32_t address) {
  const auto low = c.initial.ram.find(address);
  const auto high = c.initial.ram.find(address + 1);
  if (low == c.initial.ram.end() || high == c.initial.ram.end()) return std::nullopt;
  return std::uint32_t{low->second} | std::uint32_t{high->second} << 8U;
}

/// The distance of the final instruction pointer from the address of the next instruction: the sets
/// since the 286 end with the HLT that is there.
std::uint32_t final_hlt(Cpu cpu) { return cpu == Cpu::i8088 ? 0 : 1; }

/// Whether the case ends at the handler of an interrupt.
bool has_fault(const Case& c, Cpu cpu, std::uint32_t interrupt) {
  const auto offset = vector_word(c, 4 * interrupt);
  const auto segment = vector_word(c, 4 * interrupt + 2);
  return offset && segment && c.final[Place::cs] == *segment &&
         c.final[Place::ip] == ((*offset + final_hlt(cpu)) & 0xFFFFU);
}

/// DS, or SS for an address in BP.
Place data_segment(const x86::Instruction& instruction) {
  for (const x86::Operand& o : instruction.operands) {
    const bool based = o.addressing == x86::Addressing::base ||  //
                       o.addressing == x86::Addressing::index;
    if (o.kind == x86::Operand::Kind::memory && based && o.reg == x86::Register::bp) {
      return Place::ss;
    }
  }
  return Place::ds;
}

CaptureMachine machine_of(const Case& c, Cpu cpu, Place data) {
  CaptureMachine m{{}, {}, CaptureMemory(c, cpu, data)};
  for (std::size_t i = 0; i < x86::register_count; ++i) {
    m.registers.write(static_cast<x86::Register>(i), x86::Size::dword,
                      c.initial[static_cast<Place>(i)]);
  }
  m.flags = {static_cast<std::uint16_t>(c.initial[Place::flags] & x86::arithmetic_flags), 0};
  return m;
}

/// @param next before: the address of the instruction after it; after: of the one to execute next
x86::Outcome execute(const x86::Instruction& instruction, CaptureMachine& m, std::uint32_t& next) {
  if (!x86::is_control_flow(instruction.mnemonic)) return x86::execute_any(instruction, m);
  const x86::Operand& to = instruction.operands[0];
  std::uint32_t target = next + static_cast<std::uint32_t>(to.value);
  if (to.kind == x86::Operand::Kind::reg || to.kind == x86::Operand::Kind::memory) {
    if (!m.read(to, to.size, target)) return x86::Outcome::bad_address;
  }
  return x86::transfer(instruction.mnemonic, m, target, next);
}

void push_frame(const Case& c, CaptureMachine& m, std::uint32_t flags, std::uint32_t back) {
  for (const std::uint32_t word : {flags, c.initial[Place::cs], back}) m.push(word);
}

void compare_registers(const Case& c, const Expected& expected, Cpu cpu, Differences& differences) {
  for (std::size_t i = 0; i < place_count; ++i) {
    const auto place = static_cast<Place>(i);
    if (place == Place::flags || !c.initial.registers[i]) continue;
    const std::uint32_t model = expected.registers[i];
    if (model == c.final[place]) continue;
    differences.push_back(fmt::format("{0}: model {1:0{3}x}, file {2:0{3}x}", name_of(place, cpu),
                                      model, c.final[place], bits_of(place, cpu) / 4));
  }
}

void compare_flags(const Case& c, Expected& expected, Differences& differences) {
  const std::uint32_t model = expected[Place::flags];
  const std::uint32_t wrong = (model ^ c.final[Place::flags]) & ~expected.undefined_flags;
  for (const auto& [flag, name] : shown_flags) {
    if ((wrong & flag) == 0) continue;
    const bool set = (model & flag) != 0;
    differences.push_back(fmt::format("{}: model {:d}, file {:d}", name, set, !set));
  }
  constexpr std::uint32_t others = ~std::uint32_t{x86::arithmetic_flags};
  if ((wrong & others) == 0) return;
  differences.push_back(fmt::format("other flags: model {:x}, file {:x}", model & others,
                                    c.final[Place::flags] & others));
}

std::optional<std::uint8_t> byte_in(const Ram& ram, std::uint32_t address) {
  const auto found = ram.find(address);
  if (found == ram.end()) return std::nullopt;
  return found->second;
}

/// Compares the bytes that the file lists at the end, and those that the model has written.
void compare_memory(const Case& c, const Ram& written, Differences& differences) {
  constexpr std::size_t max_bytes = 16;
  std::size_t wrong = 0;
  const auto text_of = [](std::optional<std::uint8_t> byte) {
    return byte ? fmt::format("{:02x}", *byte) : "nothing";
  };
  const auto compare = [&](std::uint32_t address) {
    const auto before = byte_in(c.initial.ram, address);
    auto model = byte_in(written, address);
    auto file = byte_in(c.final.ram, address);
    if (!model) model = before;
    if (!file) file = before;
    if (model == file || ++wrong > max_bytes) return;
    differences.push_back(
        fmt::format("memory {:05x}: model {}, file {}", address, text_of(model), text_of(file)));
  };
  for (const auto& [address, byte] : c.final.ram) compare(address);
  for (const auto& [address, byte] : written) {
    if (!c.final.ram.contains(address)) compare(address);
  }
  if (wrong > max_bytes) {
    differences.push_back(fmt::format("memory: {} more bytes", wrong - max_bytes));
  }
}

/// Checks that the bytes are one instruction; since the 286, a HLT may follow it.
void check_length(const Case& c, Cpu cpu, std::size_t length) {
  const std::size_t rest = c.bytes.size() - length;
  if (rest == 0 || (cpu != Cpu::i8088 && rest == 1 && c.bytes.back() == hlt)) return;
  throw support::UsageError(
      fmt::format("there are {} bytes, but the instruction has {}", c.bytes.size(), length));
}

/// The flags after the case, other than the six arithmetic flags. Since only LOADALL sets bits 12
/// to 15 in real mode on a 286, the first instruction clears them.
std::uint32_t other_flags(const Case& c, Cpu cpu) {
  const std::uint32_t kept = ~std::uint32_t{x86::arithmetic_flags};
  return c.initial[Place::flags] & (cpu == Cpu::i286 ? kept & 0xFFFU : kept);
}

/// @throws UsageError if the bytes end inside the instruction
Skip skip_for(x86::Undecoded reason) {
  switch (reason) {
    case x86::Undecoded::prefix:
      return Skip::prefix;
    case x86::Undecoded::form:
      return Skip::form;
    case x86::Undecoded::addressing:
      return Skip::addressing;
    case x86::Undecoded::cut_off:
      break;
  }
  throw support::UsageError("bytes end before the instruction does");
}

}  // namespace

std::string_view name_of(Skip reason) {
  static constexpr std::array<std::string_view, skip_count> names{
      "prefix in no listing", "form in no listing", "addressing in no listing",
      "direction flag set", "end of a segment"};
  return names.at(static_cast<std::size_t>(reason));
}

std::variant<Differences, Skip> judge(const Case& c, Cpu cpu) {
  const auto decoded = x86::decode(c.bytes, cpu);
  if (const auto* reason = std::get_if<x86::Undecoded>(&decoded)) return skip_for(*reason);
  const auto& [instruction, length] = std::get<x86::Decoded>(decoded);
  check_length(c, cpu, length);
  if (x86::detail::is_store_string(instruction.mnemonic) &&
      (c.initial[Place::flags] & direction_flag) != 0) {
    return Skip::direction;
  }

  CaptureMachine m = machine_of(c, cpu, data_segment(instruction));
  std::uint32_t next = c.initial[Place::ip] + static_cast<std::uint32_t>(length);
  const x86::Outcome outcome = execute(instruction, m, next);
  const bool model_faults = outcome == x86::Outcome::divide_error;
  if (m.memory.crossed_end()) {
    if (has_fault(c, cpu, segment_fault) || has_fault(c, cpu, stack_fault))
      return Skip::segment_end;
    return Differences{"end of a segment: model crosses it, file has no fault"};
  }
  if (const auto address = m.memory.unlisted()) {
    return Differences{
        fmt::format("memory {:05x}: model reads it, file does not list it", *address)};
  }
  if (outcome != x86::Outcome::proceeds && !model_faults) return Skip::form;
  if (model_faults != has_fault(c, cpu, divide_error)) {
    return Differences{model_faults ? "divide error: model yes, file no"
                                    : "divide error: model no, file yes"};
  }

  Expected expected;
  for (std::size_t i = 0; i < place_count; ++i) {
    expected.registers[i] = c.initial.registers[i].value_or(0);
  }
  std::uint32_t flags = other_flags(c, cpu) | m.flags.value;
  expected.undefined_flags = m.flags.undefined;
  if (model_faults) {
    expected.undefined_flags = x86::arithmetic_flags;
    flags = other_flags(c, cpu) | (c.final[Place::flags] & x86::arithmetic_flags);
    const std::uint32_t back = cpu == Cpu::i8088 ? next : c.initial[Place::ip];
    push_frame(c, m, flags, back);
    flags &= ~trap_and_interrupt_flags;
    expected[Place::cs] = *vector_word(c, 2);
    next = *vector_word(c, 0);
  }
  expected[Place::flags] = flags;
  expected[Place::ip] = (next + final_hlt(cpu)) & 0xFFFFU;
  for (std::size_t i = 0; i < x86::register_count; ++i) {
    expected.registers[i] = m.registers.read(static_cast<x86::Register>(i), x86::Size::dword);
  }
  Differences differences;
  compare_registers(c, expected, cpu, differences);
  compare_flags(c, expected, differences);
  compare_memory(c, m.memory.written(), differences);
  return differences;
}

}  // namespace fixproof::singlestep
