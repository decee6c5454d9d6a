#include "judge/clock_table.hpp"

#include <algorithm>
#include <array>
#include <string_view>

// Intel's figures, for the forms that x86model/clocks.cpp does not have. One reader wrote them from
// memory. A second gathered published copies before seeing them, and compared row by row:
//   all   HelpPC 2.10 (D. Jurgens, 1991)
//   8088  M. Abrash, Zen of Assembly Language (1989), appendix A
//   286   the figures of Intel's manual in IBMulator's decoder/cycles.cpp
//   386   80386 Programmer's Reference Manual (1986), chapter 17; MAME's i386/cycles.h
//   486   MAME
// and more copies where these were too few or differed: Microsoft's Assembly Language Help
// (ALANG.HLP, all four), 86Box's codegen_timing_486.c, M. Abrash, Graphics Programming Black Book.
// Every figure is in two of them. A range has all figures where they differ and none is an evident
// misprint. LOOP on a 486 is 7 taken, 6 not; MAME and 86Box have 6 for both.

namespace fixproof::judge {

namespace {

using x86model::Cpu;
using x86model::Instruction;
using x86model::Mnemonic;
using x86model::Range;
using x86model::Register;
using x86model::Size;
using ModelOperand = x86model::Operand;

/// Clocks or their bounds, and what each bit of a shift count adds. A maximum of 0: there is none.
struct Cell {
  std::uint32_t min = 0;
  std::uint32_t max = 0;
  std::uint32_t per_count = 0;
  constexpr Cell() = default;
  constexpr Cell(std::uint32_t n) : min(n), max(n) {}  // NOLINT(google-explicit-constructor)
  constexpr Cell(std::uint32_t low, std::uint32_t high, std::uint32_t each = 0)
      : min(low), max(high), per_count(each) {}
};
constexpr Cell none{};
constexpr Cell counted(std::uint32_t n, std::uint32_t each) { return {n, n, each}; }

/// The forms that no listing has. The 8088 adds its address calculation and 4 clocks for each of
/// `words` that go over the bus.
struct Row {
  std::string_view names;  ///< between blanks
  std::string_view shape;
  std::string_view sizes;  ///< of the operand: b, w, d
  Cell i8088;
  std::uint32_t words;
  Cell i286;
  Cell i386;
  Cell i486;
};

constexpr std::string_view arithmetic = " add adc sub sbb and or xor ";
constexpr std::string_view add_or_and = " add adc and ";
constexpr std::string_view subtract_or_xor = " sub sbb or xor ";
constexpr std::string_view shifts = " shl shr sar rol ror ";
constexpr std::string_view by_carry = " rcl rcr ";
constexpr std::string_view all = "bwd";

constexpr std::array rows{
    // names, shape, sizes, 8088, words, 286, 386, 486
    Row{" mov ", "ri", all, 4, 0, 2, 2, 1},
    Row{" mov ", "mi", all, 10, 1, 3, 2, 1},
    Row{" mov ", "sr", all, 2, 0, 2, 2, 3},
    Row{" mov ", "rs", all, 2, 0, 2, 2, 3},
    Row{" mov ", "sm", all, 8, 1, 5, 5, {3, 9}},
    Row{" mov ", "ms", all, 9, 1, 3, 2, 3},
    Row{add_or_and, "mr", all, 16, 2, 7, 7, 3},
    // 6 in the 386 manual, 7 in tables that do not follow it.
    Row{subtract_or_xor, "mr", all, 16, 2, 7, {6, 7}, 3},
    Row{arithmetic, "mi", all, 17, 2, 7, 7, 3},
    Row{" cmp ", "mr", all, 9, 1, 7, 5, 2},
    Row{" cmp ", "mi", all, 10, 1, 6, 5, 2},
    Row{" test ", "rr", all, 3, 0, 2, 2, 1},
    Row{" test ", "mr", all, 9, 1, 6, 5, 2},
    Row{" test ", "ri", all, 5, 0, 3, 2, 1},
    Row{" test ", "mi", all, 11, 1, 6, 5, 2},
    Row{" inc dec ", "r", "b", 3, 0, 2, 2, 1},
    Row{" inc dec ", "m", all, 15, 2, 7, 6, 3},
    Row{shifts, "m1", all, 15, 2, 7, 7, 4},
    Row{shifts, "rc", all, counted(8, 4), 0, counted(5, 1), 3, 3},
    Row{shifts, "mc", all, counted(20, 4), 2, counted(8, 1), 7, 4},
    Row{shifts, "ri", all, none, 0, counted(5, 1), 3, 2},
    Row{shifts, "mi", all, none, 0, counted(8, 1), 7, 4},
    Row{by_carry, "r1", all, 2, 0, 2, 9, 3},
    Row{by_carry, "m1", all, 15, 2, 7, 10, 4},
    Row{by_carry, "rc", all, counted(8, 4), 0, counted(5, 1), 9, {8, 30}},
    Row{" shld shrd ", "rrc", "wd", none, 0, none, 3, 3},
    Row{" push ", "i", all, none, 0, 3, 2, 1},
    Row{" push ", "s", all, 10, 1, 3, 2, 3},
    Row{" pop ", "s", all, 8, 1, 5, 7, 3},
    Row{" pop ", "m", all, 17, 2, 5, 5, 6},
    Row{" lea ", "rm", "wd", 2, 0, 3, 2, 1},
    Row{" les lds ", "rm", "w", 16, 2, 7, 7, 6},
    Row{" xchg ", "rr", all, 4, 0, 3, 3, 3},
    Row{" xchg ", "rm", all, 17, 2, 5, 5, 5},
    Row{" xchg ", "mr", all, 17, 2, 5, 5, 5},
    Row{" movzx movsx ", "rr", "wd", none, 0, none, 3, 3},
    Row{" movzx movsx ", "rm", "wd", none, 0, none, 6, 3},
    Row{" nop ", "", all, 3, 0, 3, 3, 1},
    Row{" cwd ", "", all, 5, 0, 2, 2, 3},
    Row{" cdq ", "", all, none, 0, none, 2, 3},
    Row{" cbw ", "", all, 2, 0, 2, 3, 3},
    Row{" cwde ", "", all, none, 0, none, 3, 3},
    Row{" clc stc cmc cld std ", "", all, 2, 0, 2, 2, 2},
    Row{" lahf ", "", all, 4, 0, 2, 2, 3},
    Row{" sahf ", "", all, 4, 0, 2, 3, 2},
    Row{" leave ", "", all, none, 0, 5, 4, 5},
    Row{" lodsb ", "", all, 12, 0, 5, 5, 5},
    Row{" lodsw ", "", all, 12, 1, 5, 5, 5},
    Row{" movsb ", "", all, 18, 0, 5, 7, 7},
    Row{" movsw ", "", all, 18, 2, 5, 7, 7},
    Row{" mul ", "r", "b", {70, 77}, 0, 13, {9, 14}, {13, 18}},
    Row{" mul ", "m", "b", {76, 83}, 0, 16, {12, 17}, {13, 18}},
    Row{" mul ", "m", "w", {124, 139}, 1, 24, {12, 25}, {13, 26}},
    Row{" imul ", "r", "b", {80, 98}, 0, 13, {9, 14}, {13, 18}},
    Row{" imul ", "m", "b", {86, 104}, 0, 16, {12, 17}, {13, 18}},
    Row{" imul ", "r", "w", {128, 154}, 0, 21, {9, 22}, {13, 26}},
    Row{" imul ", "m", "w", {134, 160}, 1, 24, {12, 25}, {13, 26}},
    Row{" imul ", "rr", "w", none, 0, none, {9, 22}, {13, 26}},
    Row{" imul ", "rr", "d", none, 0, none, {9, 38}, {13, 42}},
    Row{" imul ", "rm", "w", none, 0, none, {12, 25}, {13, 26}},
    Row{" imul ", "rm", "d", none, 0, none, {12, 41}, {13, 42}},
    Row{" imul ", "rri", "w", none, 0, 21, {9, 22}, {13, 26}},
    Row{" imul ", "rri", "d", none, 0, none, {9, 38}, {13, 42}},
    Row{" imul ", "rmi", "w", none, 0, 24, {12, 25}, {13, 26}},
    Row{" imul ", "rmi", "d", none, 0, none, {12, 41}, {13, 42}},
    // A byte as the immediate operand: the 386 stops at its highest bit.
    Row{" imul ", "rrb", "w", none, 0, 21, {9, 14}, {13, 26}},
    Row{" imul ", "rrb", "d", none, 0, none, {9, 14}, {13, 42}},
    Row{" imul ", "rmb", "w", none, 0, 24, {12, 17}, {13, 26}},
    Row{" imul ", "rmb", "d", none, 0, none, {12, 17}, {13, 42}},
    Row{" div ", "r", "b", {80, 90}, 0, 14, 14, 16},
    Row{" div ", "m", "b", {86, 96}, 0, 17, 17, 16},
    Row{" div ", "m", "w", {150, 168}, 1, 25, 25, 24},
    Row{" div ", "m", "d", none, 0, none, 41, 40},
    Row{" idiv ", "r", "b", {101, 112}, 0, 17, 19, 19},
    Row{" idiv ", "m", "b", {107, 118}, 0, 20, 22, 20},
    Row{" idiv ", "r", "w", {165, 184}, 0, 25, 27, 27},
    Row{" idiv ", "m", "w", {171, 190}, 1, 28, 30, 28},
};

/// The clocks of transfers of control. `next` counts the next instruction's length, too.
struct Transfer {
  std::string_view names;
  std::string_view shape;
  std::uint32_t i8088;
  std::uint32_t i286;
  std::uint32_t i386;
  std::uint32_t i486;
};
constexpr std::array transfers{
    Transfer{" jcc ", "i", 16, 7, 7, 3},     Transfer{" jmp ", "i", 15, 7, 7, 3},
    Transfer{" jmp ", "r", 11, 7, 7, 5},     Transfer{" call ", "i", 23, 7, 7, 3},
    Transfer{" loop ", "i", 17, 8, 11, 7},   Transfer{" loope ", "i", 18, 8, 11, 9},
    Transfer{" loopne ", "i", 19, 8, 11, 9}, Transfer{" jcxz jecxz ", "i", 18, 8, 9, 8},
    Transfer{" ret ", "", 20, 11, 10, 5},    Transfer{" ret ", "i", 24, 11, 10, 5},
    Transfer{" retf ", "", 34, 15, 18, 13},  Transfer{" retf ", "i", 33, 15, 18, 14},
};
/// The same if the jump is not taken. A LOOP takes the same time on a 386.
constexpr std::array not_taken{
    Transfer{" jcc ", "i", 4, 3, 3, 1},        Transfer{" loop ", "i", 5, 4, 11, 6},
    Transfer{" loope ", "i", 6, 4, 11, 6},     Transfer{" loopne ", "i", 5, 4, 11, 6},
    Transfer{" jcxz jecxz ", "i", 6, 4, 5, 5},
};

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
  const bool may_pass = conditional || name.starts_with("loop") || name.ends_with("cxz");
  const bool passes = may_pass && !step.taken;
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
  if ((m == "push" || m == "pop" || m == "call" || m == "ret") && (written & sp) != 0)
    return {1, 1};
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
