#include "judge/code/clock_table.hpp"

#include <algorithm>
#include <string_view>

#include "x86model/clock_rows.hpp"
#include "x86model/execute.hpp"
#include "x86model/text.hpp"

namespace fixproof::judge {

namespace {

namespace figures = x86model::figures;
using x86model::Cpu;
using x86model::Range;
using x86model::Register;
using x86model::Size;

/// What follows the return to a caller: ADD SP,n with an 8-bit n.
constexpr int caller_bytes = 3;

/// The name that the rows have for it. Those of a condition are the same for all.
std::string_view row_name(const TimedLine& line) {
  if (is_conditional(line)) return "jcc";
  if (line.condition && line.mnemonic.starts_with("set")) return "setcc";
  return line.mnemonic;
}

std::optional<Range> transfer_clocks(Cpu cpu, const TimedStep& step) {
  const TimedLine& line = *step.line;
  const std::string_view name = row_name(line);
  const bool passes = may_pass(line) && !step.taken;
  const auto* row = figures::transfer_of(name, line.shape, !passes);
  if (row == nullptr) return std::nullopt;
  std::uint32_t clocks = figures::column(cpu, *row);
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
    if ((written >> base.holder() & 1U) != 0) return {1, 1};
  }
  return {0, 0};
}

std::uint32_t part(std::uint64_t value, int bits) {
  return static_cast<std::uint32_t>(value & ((std::uint64_t{1} << bits) - 1));
}

/// The operand of a one-operand instruction.
std::uint64_t operand_value(const TimedStep& step) {
  const TimedLine& line = *step.line;
  if (line.shape == "m") return step.memory;
  return step.registers.read(line.operands.front().reg);
}

/// The multiplies and divides that the model times by their operands.
std::optional<Range> operand_clocks(Cpu cpu, const TimedStep& step) {
  using ModelOperand = x86model::Operand;
  const TimedLine& line = *step.line;
  const auto op = x86model::mnemonic_named(line.mnemonic);
  const bool multiplies =
      op && (x86model::detail::is_multiply(*op) || x86model::detail::is_divide(*op));
  if (!multiplies || line.bits == 8 || (line.shape != "r" && line.shape != "m")) {
    return std::nullopt;
  }
  const auto kind = line.shape == "r" ? ModelOperand::Kind::reg : ModelOperand::Kind::memory;
  x86model::Execution execution{.instruction = {.mnemonic = *op}};
  execution.instruction.operands[0] = {
      .kind = kind, .size = line.bits == 16 ? Size::word : Size::dword, .reg = Register::bx};
  execution.low = part(step.registers.general[0], line.bits);
  execution.high = part(step.registers.general[2], line.bits);
  execution.operand = part(operand_value(step), line.bits);
  auto clocks = x86model::clocks(cpu, execution);
  // The model counts the prefix of a dword in 16-bit code; those that the code has are added later.
  if (clocks && cpu == Cpu::i486 && line.bits == 32) --clocks->max;
  return clocks;
}

std::optional<Range> row_clocks(Cpu cpu, const TimedStep& step) {
  const TimedLine& line = *step.line;
  const char size = line.bits == 8 ? 'b' : line.bits == 32 ? 'd' : 'w';
  const auto* row = figures::row_of(figures::rows_of(row_name(line)), line.shape, size);
  if (row == nullptr) return std::nullopt;
  const figures::Cell cell = figures::column(cpu, *row);
  if (cell.max == 0) return std::nullopt;
  std::uint32_t count = 0;
  if (cell.per_count > 0) {
    count = line.shape.ends_with('c') ? part(step.registers.general[1], 8) : line.immediate;
    if (cpu != Cpu::i8088) count &= 31U;
  }
  std::uint32_t more = cell.per_count * count;
  if (cpu == Cpu::i8088) {
    // MOV between AL or AX and memory takes 10 clocks in all.
    const bool moves_accumulator = line.mnemonic == "mov" && line.uses_accumulator &&
                                   (line.shape == "rm" || line.shape == "mr");
    more +=
        moves_accumulator ? 10 - cell.min + (line.overrides_segment ? 2 : 0) : address_clocks(line);
    more += line.bits == 8 ? 0 : 4 * row->words;
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
  if (!clocks) clocks = operand_clocks(cpu, step);
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
