#include "judge/code/clock_table.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "judge/code/clock_rows.hpp"

namespace fixproof::judge {

namespace {

using figures::Cell;
using figures::not_taken;
using figures::Row;
using figures::rows;
using figures::Transfer;
using figures::transfers;
using x86model::Cpu;
using x86model::Instruction;
using x86model::Mnemonic;
using x86model::Range;
using x86model::Register;
using x86model::Size;
using ModelOperand = x86model::Operand;

/// What follows the return to a caller: ADD SP,n with an 8-bit n.
constexpr int caller_bytes = 3;

bool names_has(std::string_view names, std::string_view mnemonic) {
  const std::size_t at = names.find(mnemonic);
  return at != std::string_view::npos && at > 0 && names[at - 1] == ' ' &&
         names[at + mnemonic.size()] == ' ';
}

template <class T, std::size_t n>
const T* row_of(const std::array<T, n>& table, std::string_view mnemonic, std::string_view shape) {
  const auto* found = std::find_if(table.begin(), table.end(), [&](const T& row) {
    return names_has(row.names, mnemonic) && row.shape == shape;
  });
  return found == table.end() ? nullptr : found;
}

template <class T>
auto column(Cpu cpu, const T& row) {
  switch (cpu) {
    case Cpu::i8088:
      return row.i8088;
    case Cpu::i286:
      return row.i286;
    case Cpu::i386:
      return row.i386;
    case Cpu::i486:
      break;
  }
  return row.i486;
}

std::optional<Range> transfer_clocks(Cpu cpu, const TimedStep& step) {
  const TimedLine& line = *step.line;
  const bool conditional = is_conditional(line.mnemonic);
  const std::string_view name = conditional ? "jcc" : std::string_view(line.mnemonic);
  const bool passes = may_pass(line.mnemonic) && !step.taken;
  const Transfer* row =
      passes ? row_of(not_taken, name, line.shape) : row_of(transfers, name, line.shape);
  if (row == nullptr) return std::nullopt;
  std::uint32_t clocks = column(cpu, *row);
  // The next instruction's length counts after a taken jump, and after every LOOP of a 386.
  if (!passes || (cpu == Cpu::i386 && name.starts_with("loop"))) {
    if (cpu == Cpu::i286) {
      clocks += step.next == nullptr ? caller_bytes : step.next->line.bytes;
    } else if (cpu == Cpu::i386) {
      clocks +=
          static_cast<std::uint32_t>(step.next == nullptr ? caller_bytes : step.next->components);
    }
  }
  return Range{clocks, clocks};
}

/// The 8088's address calculation (table 2-20 of its manual).
std::uint32_t address_clocks(const TimedLine& line) {
  const std::uint32_t segment = line.overrides_segment ? 2 : 0;
  if (line.shape.find('m') == std::string::npos) return segment;
  if (line.bases.empty()) return segment + 6;
  if (line.bases.size() == 1) return segment + (line.has_displacement ? 9 : 5);
  const auto has = [&](Register r) {
    return std::ranges::any_of(line.bases, [r](RegisterName b) { return b.number == r; });
  };
  const bool is_quick = has(Register::bp) == has(Register::di);  // BP+DI and BX+SI
  return segment + (is_quick ? 7 : 8) + (line.has_displacement ? 4 : 0);
}

/// What two registers in an address add: on a 286 and 386 a clock if there is a displacement too.
/// The sources differ on a 386 without one, and on a 486.
Range index_clocks(Cpu cpu, const TimedLine& line) {
  if (line.bases.size() < 2 || cpu == Cpu::i8088) return {0, 0};
  if (cpu == Cpu::i486) return {0, 1};
  if (line.has_displacement) return {1, 1};
  return {0, cpu == Cpu::i386 ? 1U : 0U};
}

/// A 486 waits for an address register, or for SP, that the previous instruction has written.
Range address_wait(const TimedStep& step) {
  if (step.previous == nullptr) return {0, 0};
  const unsigned written = step.previous->writes;
  const std::string& m = step.line->mnemonic;
  constexpr unsigned sp = 1U << static_cast<unsigned>(Register::sp);
  const bool uses_stack =
      m.starts_with("push") || m.starts_with("pop") || m == "call" || m.starts_with("ret");
  if (uses_stack && (written & sp) != 0) return {1, 1};
  for (const RegisterName& base : step.line->bases) {
    if ((written >> static_cast<unsigned>(base.number) & 1U) != 0) return {1, 1};
  }
  return {0, 0};
}

/// The mnemonic of the model, or of an instruction that the manuals give the same times.
std::optional<Mnemonic> model_mnemonic(std::string_view name) {
  using enum Mnemonic;
  struct Name {
    std::string_view name;
    Mnemonic mnemonic;
  };
  constexpr std::array names{
      Name{"mov", mov},   Name{"push", push}, Name{"pop", pop},     Name{"add", add},
      Name{"adc", adc},   Name{"sub", sub},   Name{"sbb", sbb},     Name{"cmp", cmp},
      Name{"neg", neg},   Name{"not", neg},   Name{"inc", inc},     Name{"dec", dec},
      Name{"mul", mul},   Name{"imul", imul}, Name{"div", div},     Name{"idiv", idiv},
      Name{"and", and_},  Name{"or", xor_},   Name{"xor", xor_},    Name{"shl", shl},
      Name{"shr", shr},   Name{"sar", sar},   Name{"rol", rol},     Name{"ror", rol},
      Name{"shld", shld}, Name{"shrd", shrd}, Name{"stosb", stosb}, Name{"stosw", stosw}};
  for (const Name& one : names) {
    if (one.name == name) return one.mnemonic;
  }
  return std::nullopt;
}

/// The instruction as the model has it, with [BX] for any address. Nothing for forms whose times
/// the model would take for those of others.
std::optional<Instruction> model_instruction(const TimedLine& line) {
  const auto mnemonic = model_mnemonic(line.mnemonic);
  const std::string& shape = line.shape;
  const bool multiplies = line.mnemonic.ends_with("mul") || line.mnemonic.ends_with("div");
  const bool steps = line.mnemonic == "inc" || line.mnemonic == "dec";
  if (!mnemonic || shape.size() > 3 || ((multiplies || steps) && line.bits == 8) ||
      (multiplies && shape.size() != 1) || shape.find_first_of("s?c") != std::string::npos) {
    return std::nullopt;
  }
  const Size size = line.bits == 8 ? Size::byte : line.bits == 16 ? Size::word : Size::dword;
  Instruction instruction{.mnemonic = *mnemonic};
  for (std::size_t i = 0; i < shape.size(); ++i) {
    ModelOperand& o = instruction.operands.at(i);
    switch (shape[i]) {
      case 'r':
        o = {.kind = ModelOperand::Kind::reg, .size = size};
        break;
      case 'm':
        o = {.kind = ModelOperand::Kind::memory, .size = size, .reg = Register::bx};
        break;
      default:
        // Of a count only matters whether the opcode is that of a shift by one.
        o = {.kind = ModelOperand::Kind::immediate, .value = shape[i] == '1' ? 1 : 2};
    }
  }
  return instruction;
}

std::uint32_t part(std::uint32_t value, int bits) {
  return bits == 32 ? value : value & ((1U << static_cast<unsigned>(bits)) - 1);
}

/// The register of a one-operand instruction, from the text.
std::uint32_t operand_value(const TimedStep& step) {
  const TimedLine& line = *step.line;
  if (line.shape == "m") return step.memory;
  const auto operands = operands_of(line.line);
  if (!operands || operands->size() != 1) return 0;
  return step.registers.read(operands->front().reg);
}

std::optional<Range> model_clocks(Cpu cpu, const TimedStep& step) {
  const TimedLine& line = *step.line;
  const auto instruction = model_instruction(line);
  if (!instruction) return std::nullopt;
  x86model::Execution execution{.instruction = *instruction};
  if (line.mnemonic.ends_with("mul") || line.mnemonic.ends_with("div")) {
    execution.low = part(step.registers.general[0], line.bits);
    execution.high = part(step.registers.general[2], line.bits);
    execution.operand = part(operand_value(step), line.bits);
  }
  auto clocks = x86model::clocks(cpu, execution);
  if (!clocks) return std::nullopt;
  if (cpu == Cpu::i8088 && line.shape.find('m') != std::string::npos) {
    constexpr std::uint32_t assumed = 5;  // of [BX]
    std::uint32_t address = address_clocks(line);
    // MOV between AL or AX and memory takes 10 clocks in all.
    const bool moves_accumulator = line.mnemonic == "mov" && line.uses_accumulator;
    if (moves_accumulator) address = line.shape == "rm" ? 2 : 1;
    if (moves_accumulator && line.overrides_segment) address += 2;
    clocks = Range{clocks->min + address - assumed, clocks->max + address - assumed};
  }
  if (cpu == Cpu::i486) {
    const bool has_prefix = instruction->operands[0].size == Size::dword ||
                            instruction->operands[1].size == Size::dword;
    clocks->max -= has_prefix ? 1U : 0U;  // those that the code has are added later
  }
  return clocks;
}

std::optional<Range> row_clocks(Cpu cpu, const TimedStep& step) {
  const TimedLine& line = *step.line;
  const char size = line.bits == 8 ? 'b' : line.bits == 32 ? 'd' : 'w';
  const auto* row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
    return names_has(r.names, line.mnemonic) && r.shape == line.shape &&
           r.sizes.find(size) != std::string_view::npos;
  });
  if (row == rows.end()) return std::nullopt;
  const Cell cell = column(cpu, *row);
  if (cell.max == 0) return std::nullopt;
  std::uint32_t count = 0;
  if (cell.per_count > 0) {
    count = line.shape.ends_with('c') ? step.registers.general[1] & 0xFFU : line.immediate;
    if (cpu != Cpu::i8088) count &= 31U;
  }
  std::uint32_t more = cell.per_count * count;
  if (cpu == Cpu::i8088) {
    more += address_clocks(line) + (line.bits == 8 ? 0 : 4 * row->words);
    if (line.uses_accumulator && (line.mnemonic == "test" || line.mnemonic == "xchg")) --more;
  }
  return Range{cell.min + more, cell.max + more};
}

}  // namespace

bool is_too_wide(Cpu cpu, const TimedLine& line, int code_bits) {
  return cpu < Cpu::i386 && (code_bits == 32 || line.bits == 32);
}

std::optional<Range> clocks_of(Cpu cpu, const TimedStep& step, int code_bits) {
  const TimedLine& line = *step.line;
  if (is_too_wide(cpu, line, code_bits) || line.has_repeat) return std::nullopt;
  if (cpu < Cpu::i386 && line.needs_386) return std::nullopt;
  auto clocks = transfer_clocks(cpu, step);
  if (!clocks) clocks = model_clocks(cpu, step);
  if (!clocks) clocks = row_clocks(cpu, step);
  if (!clocks) return std::nullopt;
  *clocks += index_clocks(cpu, line);
  if (cpu != Cpu::i486) return clocks;
  // A 486 takes one clock per prefix, unless the previous instruction hides it.
  clocks->max += static_cast<std::uint32_t>(line.prefixes);
  *clocks += address_wait(step);
  return clocks;
}

}  // namespace fixproof::judge
