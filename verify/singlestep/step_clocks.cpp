#include "verify/singlestep/step_clocks.hpp"

#include <algorithm>

#include "x86model/execute.hpp"
#include "x86model/routine.hpp"

namespace fixproof::singlestep {

namespace {

namespace x86 = x86model;

/// The range of a taken jump over all possible targets.
std::optional<x86::Range> to_any_row(x86::Cpu cpu, const x86::Instruction& jump) {
  const auto target = cpu < x86::Cpu::i386 ? x86::Target::i8088 : x86::Target::i386;
  std::optional<x86::Range> all;
  for (int r = 0; r < x86::routine_count; ++r) {
    const x86::Listing& listing = x86::listing(static_cast<x86::Routine>(r), target);
    for (std::size_t i = 0; i < listing.size; ++i) {
      const x86::Instruction& row = listing.rows.at(i);
      if (row.directive != x86::Directive::none) continue;
      const auto range = x86::clocks(cpu, {.instruction = jump, .taken = true, .next = &row});
      if (!range) return std::nullopt;
      if (!all) all = range;
      all = x86::Range{std::min(all->min, range->min), std::max(all->max, range->max)};
    }
  }
  return all;
}

}  // namespace

std::optional<x86::Range> step_clocks(x86::Cpu cpu, const x86::Instruction& instruction,
                                      const StepMachine& before) {
  const x86::Mnemonic op = instruction.mnemonic;
  if (op == x86::Mnemonic::jmp) return to_any_row(cpu, instruction);
  x86::Execution execution{.instruction = instruction};
  if (x86::detail::is_multiply(op) || x86::detail::is_divide(op)) {
    const x86::Operand& operand = instruction.operands[0];
    execution.low = before.registers.read(x86::Register::ax, operand.size);
    execution.high = before.registers.read(x86::Register::dx, operand.size);
    execution.operand = before.registers.read(operand.reg, operand.size);
  }
  return x86::clocks(cpu, execution);
}

}  // namespace fixproof::singlestep
