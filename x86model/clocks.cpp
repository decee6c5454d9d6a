#include "x86model/clocks.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "x86model/clock_rows.hpp"
#include "x86model/encoding.hpp"
#include "x86model/execute.hpp"
#include "x86model/text.hpp"

// MUL and DIV on an 8088 are as measured on the processor; clock_rows.hpp has the other sources.

namespace x86model {

namespace {

using figures::Cell;
constexpr Cell absent = figures::no_figure;

bool reads_or_writes_memory(const Instruction& i) {
  return std::any_of(i.operands.begin(), i.operands.end(),
                     [](const Operand& o) { return o.kind == Operand::Kind::memory; });
}

/// The 8088 transfers a word in two bytes: one bus cycle more than the 8086.
constexpr std::uint32_t second_byte = 4;

bool is_of_bytes(const Instruction& i) {
  return i.mnemonic == Mnemonic::stosb || i.operands[0].size == Size::byte;
}

/// The 8088's address calculation for [displacement], [base] or [base+displacement], with or
/// without a segment override. The tables of later processors give an override no time in the
/// instruction: the prefix takes 0 clocks on the 286 and 386, and 1 on the 486, as every prefix
/// does.
std::uint32_t effective_address_clocks(const Instruction& i) {
  if (!reads_or_writes_memory(i)) return 0;
  const std::uint32_t segment = overrides_segment(i) ? 2 : 0;
  if (i.operands[1].addressing == Addressing::direct) return segment + 6;
  return segment + (encoding_of(i).displacement > 0 ? 9 : 5);
}

/// Depends only on AX, except for one clock if the high half of the result is 0. The microcode
/// takes 134 clocks for AX = FFFFh times 0 or 1, one more than the maximum in Intel's table.
std::uint32_t mul_on_8088(const Execution& e) {
  const bool high_is_zero = std::uint64_t{e.low} * e.operand >> 16 == 0;
  return 117 + static_cast<std::uint32_t>(std::popcount(e.low)) + (high_is_zero ? 1 : 0);
}

/// The microcode shifts DX:AX left and subtracts the divisor from DX if possible. If a bit was
/// shifted out of DX, it skips the comparison. The last step leaves the loop.
std::uint32_t div_on_8088(const Execution& e) {
  constexpr int steps = 16;
  std::uint32_t clocks = 17;
  std::uint32_t remainder = e.high;
  for (int step = 1; step <= steps; ++step) {
    const std::uint32_t next_bit = (e.low >> (steps - step)) & 1U;
    remainder = remainder << 1 | next_bit;
    const bool carry = remainder > 0xFFFF;
    const bool subtracts = remainder >= e.operand;
    const bool last = step == steps;
    if (carry) {
      clocks += last ? 9 : 8;
    } else if (subtracts) {
      clocks += last ? 10 : 9;
    } else {
      clocks += last ? 7 : 8;
    }
    if (subtracts) remainder -= e.operand;
  }
  return clocks;
}

bool operand_is(const Execution& e, Operand::Kind kind) {
  return e.instruction.operands[0].kind == kind;
}
bool is_dword(const Execution& e) { return e.instruction.operands[0].size == Size::dword; }

bool multiplies_by_negative(const Execution& e) {
  return e.instruction.mnemonic == Mnemonic::imul && e.operand >> 31 != 0;
}

/// The base-2 logarithm of the multiplier's magnitude, rounded down and up. It is 0 for 0, for
/// which the formulas below use their minimum.
struct Log2 {
  std::uint32_t down;
  std::uint32_t up;
};
Log2 log2_of_multiplier(const Execution& e) {
  const std::uint32_t magnitude = multiplies_by_negative(e) ? 0 - e.operand : e.operand;
  if (magnitude == 0) return {0, 0};
  return {static_cast<std::uint32_t>(31 - std::countl_zero(magnitude)),
          static_cast<std::uint32_t>(32 - std::countl_zero(magnitude - 1))};
}

/// The formula of the 386 manual: multiplication stops at the highest bit of the multiplier. The
/// ranges printed beside it are one clock wider for IMUL. The manual treats the operand as the
/// multiplier: it adds 3 clocks if the multiplier is in memory. A published reading of the 386's
/// microcode (nand2mario, "80386 Multiplication and Division", 2026) contradicts it: there the
/// accumulator is shifted out and the operand is the multiplicand.
std::uint32_t multiply_on_386(const Execution& e) {
  constexpr std::uint32_t least = 3;
  const std::uint32_t clocks = 6 + std::max(log2_of_multiplier(e).up, least);
  return clocks + (operand_is(e, Operand::Kind::memory) ? 3 : 0);
}

/// Note 3 of the manual's appendix E: 10 + max(log2|m|, n), with n = 3 for a positive multiplier m
/// and 5 for a negative one. The note does not say how the logarithm is rounded: rounding down
/// gives the minimum, rounding up the maximum. The multiplier is taken to be the operand, as in the
/// 386 manual.
Cell multiply_on_486(const Execution& e) {
  const std::uint32_t least = multiplies_by_negative(e) ? 5 : 3;
  const Log2 log2 = log2_of_multiplier(e);
  return {10 + std::max(log2.down, least), 10 + std::max(log2.up, least)};
}

/// MUL by a register, IMUL by a dword.
Cell multiply(Cpu cpu, const Execution& e) {
  const bool mul_by_register =
      e.instruction.mnemonic == Mnemonic::mul && operand_is(e, Operand::Kind::reg);
  if (!mul_by_register && !is_dword(e)) return absent;
  switch (cpu) {
    case Cpu::i8088:
      return mul_on_8088(e);
    case Cpu::i286:
      return 21;
    case Cpu::i386:
      return multiply_on_386(e);
    case Cpu::i486:
      break;
  }
  return multiply_on_486(e);
}

/// IDIV by a dword.
Cell signed_divide(Cpu cpu, const Execution& e) {
  if (!is_dword(e)) return absent;
  const bool by_memory = operand_is(e, Operand::Kind::memory);
  // The 386 manual gives 43 for both; its data sheet has a separate time for memory.
  if (cpu == Cpu::i386) return by_memory ? 46 : 43;
  return by_memory ? 44 : 43;
}

/// DIV by a register, or IDIV by a dword.
Cell divide(Cpu cpu, const Execution& e) {
  if (e.instruction.mnemonic == Mnemonic::idiv) return signed_divide(cpu, e);
  if (!operand_is(e, Operand::Kind::reg)) return absent;
  switch (cpu) {
    case Cpu::i8088:
      return div_on_8088(e);
    case Cpu::i286:
      return 22;
    case Cpu::i386:
      return is_dword(e) ? 38 : 22;
    case Cpu::i486:
      break;
  }
  return is_dword(e) ? 40 : 24;
}

/// ADD SP,n with an 8-bit n.
constexpr Encoding caller_next{.mod_rm = 1, .immediate = 1};

Cell control_flow(Cpu cpu, const Execution& e) {
  const Mnemonic op = e.instruction.mnemonic;
  const bool is_loop = op == Mnemonic::loop;
  const bool is_conditional = detail::condition_of(op).has_value();
  const bool taken = e.taken || !(is_conditional || is_loop);
  const auto* row =
      figures::transfer_of(is_conditional ? "jcc" : name_of(op), shape_of(e.instruction), taken);
  if (row == nullptr) return absent;
  const std::uint32_t clocks = figures::column(cpu, *row);
  // The next instruction's length counts after a taken jump, and after every LOOP of a 386.
  const Encoding next = e.next == nullptr ? caller_next : encoding_of(*e.next);
  if (cpu == Cpu::i286 && taken) return clocks + static_cast<std::uint32_t>(next.bytes());
  if (cpu == Cpu::i386 && (taken || is_loop)) {
    return clocks + static_cast<std::uint32_t>(next.components());
  }
  return clocks;
}

/// Found once, because profiles of scenes time many millions of instructions.
std::span<const figures::Row* const> rows_of(Mnemonic mnemonic) {
  static const auto all = [] {
    std::array<std::vector<const figures::Row*>, mnemonic_count> rows;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows.at(i) = figures::rows_of(name_of(static_cast<Mnemonic>(i)));
    }
    return rows;
  }();
  return all.at(static_cast<std::size_t>(mnemonic));
}

Cell look_up(Cpu cpu, const Instruction& i) {
  const Size operands = i.operands[0].size;
  const char size = operands == Size::byte ? 'b' : operands == Size::dword ? 'd' : 'w';
  const auto* row = figures::row_of(rows_of(i.mnemonic), shape_of(i), size);
  if (row == nullptr) return absent;
  const Cell cell = figures::column(cpu, *row);
  if (cell.max == 0) return absent;
  const auto count = static_cast<std::uint32_t>(i.operands[1].value);
  std::uint32_t more = cell.per_count * count;
  if (cpu == Cpu::i8088) {
    more += effective_address_clocks(i) + (is_of_bytes(i) ? 0 : second_byte * row->words);
  }
  return {cell.min + more, cell.max + more};
}

Cell cell_of(Cpu cpu, const Execution& e) {
  const Mnemonic op = e.instruction.mnemonic;
  if (is_control_flow(op)) return control_flow(cpu, e);
  if (detail::is_multiply(op)) return multiply(cpu, e);
  if (detail::is_divide(op)) return divide(cpu, e);
  return look_up(cpu, e.instruction);
}

/// The register that contains `operand`.
Register whole_register(const Operand& operand) {
  if (operand.size != Size::byte) return operand.reg;
  // AH to BH are numbered after AL to BL.
  return static_cast<Register>(static_cast<unsigned>(operand.reg) % 4);
}

/// Whether the instruction writes the register or a part of it. SP counts only as an explicit
/// operand: a 486 does not wait after PUSH, POP, CALL and RET.
bool writes(const Instruction& i, Register r) {
  const Mnemonic op = i.mnemonic;
  if (detail::is_multiply(op) || detail::is_divide(op)) {
    return r == Register::ax || r == Register::dx;
  }
  if (detail::is_store_string(op)) return r == Register::di;
  if (op == Mnemonic::loop) return r == Register::cx;
  if (is_control_flow(op) || op == Mnemonic::cmp || op == Mnemonic::push) return false;
  return i.operands[0].kind == Operand::Kind::reg && whole_register(i.operands[0]) == r;
}

bool uses_stack(Mnemonic op) {
  return op == Mnemonic::push || op == Mnemonic::pop || op == Mnemonic::call || op == Mnemonic::ret;
}

/// A 486 waits a clock if the previous instruction has written the base register of an address, or
/// SP before a stack access (appendix E). The manual does not say whether it also waits for a
/// scaled index: 0 or 1. One further clock after a write of a part of the register is not counted;
/// it is published (E. Toth, "Penalties on the 486"), but not by Intel.
Range address_wait(const Execution& e) {
  if (e.previous == nullptr) return {0, 0};
  if (uses_stack(e.instruction.mnemonic) && writes(*e.previous, Register::sp)) return {1, 1};
  for (const Operand& o : e.instruction.operands) {
    if (o.kind != Operand::Kind::memory || o.addressing == Addressing::direct) continue;
    if (!writes(*e.previous, o.reg)) continue;
    return {o.addressing == Addressing::index_twice ? 0U : 1U, 1};
  }
  return {0, 0};
}

}  // namespace

std::optional<Range> clocks(Cpu cpu, const Execution& execution) {
  const Instruction& i = execution.instruction;
  const int prefixes = encoding_of(i).prefixes;
  // Every other prefix makes an operand or an address 32 bits wide.
  const int prefixes_of_386 = prefixes - (overrides_segment(i) ? 1 : 0);
  if (prefixes_of_386 > 0 && cpu < Cpu::i386) return std::nullopt;
  const Cell cell = cell_of(cpu, execution);
  if (cell.max == 0) return std::nullopt;
  // A 486 takes one clock per prefix, unless the previous instruction hides it. A 386 takes none.
  if (cpu != Cpu::i486) return Range{cell.min, cell.max};
  // Scaling an index register may take one more clock.
  const bool scales = std::any_of(i.operands.begin(), i.operands.end(), [](const Operand& o) {
    return o.addressing == Addressing::index_twice;
  });
  return Range{cell.min, cell.max + static_cast<std::uint32_t>(prefixes) + (scales ? 1U : 0U)} +
         address_wait(execution);
}

std::string shape_of(const Instruction& i) {
  std::string shape;
  for (const Operand& o : i.operands) {
    if (o.kind == Operand::Kind::reg) shape += 'r';
    if (o.kind == Operand::Kind::memory) shape += 'm';
    if (o.kind == Operand::Kind::immediate || o.kind == Operand::Kind::label) shape += 'i';
  }
  const bool by_one = detail::is_shift(i.mnemonic) && encoding_of(i).immediate == 0;
  if (by_one) shape.back() = '1';
  return shape;
}

std::string_view name_of(Cpu cpu) {
  constexpr std::array<std::string_view, cpu_count> names{"8088", "286", "386", "486"};
  return names.at(static_cast<std::size_t>(cpu));
}

}  // namespace x86model
