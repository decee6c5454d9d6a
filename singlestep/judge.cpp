#include "singlestep/judge.hpp"

#include <fmt/format.h>

#include <optional>

#include "singlestep/shown.hpp"
#include "singlestep/step_machine.hpp"
#include "support/usage_error.hpp"
#include "x86model/run.hpp"

namespace fixproof::singlestep {

namespace {

namespace x86 = x86model;

constexpr std::uint8_t hlt = 0xF4;

/// The byte at `address` after the instruction, if the case lists it.
std::optional<std::uint8_t> byte_at(const Case& c, std::uint32_t address) {
  for (const State* state : {&c.final, &c.initial}) {
    if (const auto at = state->ram.find(address); at != state->ram.end()) return at->second;
  }
  return std::nullopt;
}

/// The interrupt vector word that a fault reads. The case must list it.
std::optional<std::uint32_t> vector_word(const Case& c, std::uint32_t address) {
  const auto low = c.initial.ram.find(address);
  const auto high = c.initial.ram.find(address + 1);
  if (low == c.initial.ram.end() || high == c.initial.ram.end()) return std::nullopt;
  return std::uint32_t{low->second} | std::uint32_t{high->second} << 8U;
}

/// Returns whether the listed bytes at SS:`offset` are consistent with `word`. A set lists written
/// memory only if it changed.
bool may_hold(const Case& c, std::uint32_t offset, std::uint32_t word, x86::Target cpu) {
  for (std::uint32_t i = 0; i < 2; ++i) {
    std::uint32_t address = (c.initial[Place::ss] << 4U) + ((offset + i) & 0xFFFFU);
    // The 8088 has 20 address lines.
    if (cpu == x86::Target::i8088) address &= 0xFFFFFU;
    const auto byte = byte_at(c, address);
    if (byte && *byte != (word >> (8 * i) & 0xFFU)) return false;
  }
  return true;
}

bool has_fault(const Case& c, x86::Target cpu, std::size_t length) {
  const bool i386 = cpu == x86::Target::i386;
  const auto offset = vector_word(c, 0);
  const auto segment = vector_word(c, 2);
  if (!offset || !segment || c.final[Place::cs] != *segment) return false;
  // The 386 sets end every case with a HLT; after a fault it is the first instruction of the
  // handler.
  const std::uint32_t ip = c.final[Place::ip];
  if (ip != *offset && !(i386 && ip == *offset + 1)) return false;
  const std::uint32_t sp = c.initial[Place::sp];
  if (((sp - c.final[Place::sp]) & 0xFFFFU) != 6) return false;
  const std::uint32_t back = c.initial[Place::ip] + (i386 ? 0 : static_cast<std::uint32_t>(length));
  return !c.final.ram.empty() && may_hold(c, sp - 4, c.initial[Place::cs], cpu) &&
         may_hold(c, sp - 6, back, cpu);
}

StepMachine machine_of(const State& state) {
  StepMachine m;
  for (std::size_t i = 0; i < x86::register_count; ++i) {
    m.registers.write(static_cast<x86::Register>(i), x86::Size::dword,
                      state[static_cast<Place>(i)]);
  }
  m.flags = {static_cast<std::uint16_t>(state[Place::flags] & x86::arithmetic_flags), 0};
  return m;
}

/// Compares the registers, except for the parts that has_fault() checks if `fault` is set.
void compare_registers(const Case& c, const StepMachine& m, x86::Target cpu, bool fault,
                       Differences& differences) {
  for (std::size_t i = 0; i < place_count; ++i) {
    const auto place = static_cast<Place>(i);
    if (place == Place::ip || place == Place::flags || !c.initial.registers[i]) continue;
    std::uint32_t model = c.initial[place];
    if (i < x86::register_count) {
      model = m.registers.read(static_cast<x86::Register>(i), x86::Size::dword);
    }
    std::uint32_t file = c.final[place];
    if (fault && place == Place::cs) continue;
    // has_fault() has already checked the low half, SP.
    if (fault && place == Place::sp) file = (file & 0xFFFF0000U) | (model & 0xFFFFU);
    if (model == file) continue;
    differences.push_back(fmt::format("{0}: model {1:0{3}x}, file {2:0{3}x}", name_of(place, cpu),
                                      model, file, bits_of(place, cpu) / 4));
  }
}

void compare_flags(const Case& c, const StepMachine& m, Differences& differences) {
  const std::uint32_t file = c.final[Place::flags];
  const std::uint32_t judged = x86::arithmetic_flags & ~std::uint32_t{m.flags.undefined};
  const std::uint32_t wrong = (m.flags.value ^ file) & judged;
  for (const auto& [flag, name] : shown_flags) {
    if ((wrong & flag) == 0) continue;
    const bool model = (m.flags.value & flag) != 0;
    differences.push_back(fmt::format("{}: model {:d}, file {:d}", name, model, !model));
  }
  // No instruction here changes the other bits of FLAGS, such as TF and DF.
  constexpr std::uint32_t others = ~std::uint32_t{x86::arithmetic_flags};
  if (((file ^ c.initial[Place::flags]) & others) == 0) return;
  differences.push_back(fmt::format("other flags: model {:x}, file {:x}",
                                    c.initial[Place::flags] & others, file & others));
}

/// The length of the instruction. In the 386 sets a HLT may follow it.
std::size_t length_of(const Case& c, x86::Target cpu) {
  const bool halted = cpu == x86::Target::i386 && c.bytes.size() > 1 && c.bytes.back() == hlt;
  return c.bytes.size() - (halted ? 1 : 0);
}

}  // namespace

std::variant<Differences, Skip> judge(const Case& c, x86::Target cpu) {
  const auto decoded = decode(c.bytes, cpu);
  if (const Skip* reason = std::get_if<Skip>(&decoded)) return *reason;
  const auto& [instruction, length] = std::get<Decoded>(decoded);
  // F4h may also be the last byte of an immediate.
  if (length != c.bytes.size() && length != length_of(c, cpu)) {
    throw support::UsageError(
        fmt::format("there are {} bytes, but the instruction has {}", c.bytes.size(), length));
  }
  StepMachine m = machine_of(c.initial);
  const x86::Outcome outcome = x86::execute_any(instruction, m);
  const bool model_faults = outcome == x86::Outcome::divide_error;
  if (outcome != x86::Outcome::proceeds && !model_faults) return Skip::not_modelled;
  const bool file_faults = has_fault(c, cpu, length);
  Differences differences;
  if (model_faults != file_faults) {
    differences.emplace_back(model_faults ? "divide error: model yes, file no"
                                          : "divide error: model no, file yes");
    return differences;
  }
  compare_registers(c, m, cpu, model_faults, differences);
  if (!model_faults) compare_flags(c, m, differences);
  return differences;
}

}  // namespace fixproof::singlestep
