#include "judge/code/execution.hpp"

#include <algorithm>

#include "judge/code/user_instructions.hpp"
#include "x86model/run.hpp"
#include "x86model/text.hpp"

namespace fixproof::judge {

namespace {

using x86model::Mnemonic;
using x86model::Size;

constexpr const char* unknown_flag = "it reads a flag that is undefined or not modelled";

/// The size of the operands: that of the first one. What is pushed has that of the code.
Size size_of(const Instruction& i, const std::string& mnemonic, int code_bits) {
  const int bits = i.count == 0 || mnemonic == "push" ? code_bits : i.operands[0].bits;
  return bits == 8 ? Size::byte : whole_register(0, bits).size;
}

/// Whether the meaning that the listings share covers the sizes and counts of an instruction.
bool is_shared(const ImageMachine& machine, Mnemonic op, const Instruction& i) {
  using namespace x86model::detail;
  const Size size = i.operands[0].size;
  if (is_multiply(op) || is_divide(op)) {
    return i.count == 1 && size != Size::byte && size != Size::qword;
  }
  if (!is_shift(op) && !is_double_shift(op)) return true;
  const auto given = machine.constant_in(i.operands.at(i.count - 1));
  if (!given) return false;
  const std::uint32_t count = *given & (size == Size::qword ? 63U : 31U);
  // A shift of 32 bits by 0 clears the upper half of a register, though it changes nothing else.
  return count != 0 && (!is_double_shift(op) || size != Size::word || count < 16);
}

/// The instructions that the listings use too. @return whether it is one of them
bool execute_shared(ImageMachine& machine, const std::string& mnemonic, Instruction& i) {
  using x86model::Outcome;
  const auto op = x86model::mnemonic_named(mnemonic);
  if (!op || x86model::is_control_flow(*op) || !is_shared(machine, *op, i)) return false;
  i.mnemonic = *op;
  const Outcome outcome = x86model::execute_any(i, machine);
  if (outcome == Outcome::undefined_flag) throw Obstacle(unknown_flag);
  return outcome == Outcome::proceeds;
}

/// The name of the row of an instruction.
std::string row_of(const Decoded& code) {
  if (!code.condition) return code.mnemonic;
  for (const char* const all : {"set", "cmov"}) {
    if (code.mnemonic.starts_with(all)) return std::string(all) + "cc";
  }
  return code.mnemonic;
}

}  // namespace

void not_modelled() { throw Obstacle("this instruction is not modelled"); }

x86model::symbolic::Term holds(const ImageMachine& machine,
                               x86model::alu::ConditionCode condition) {
  if (!machine.flags.are_defined(x86model::alu::flags_read(condition))) {
    throw Obstacle(unknown_flag);
  }
  return x86model::alu::holds(machine.domain(), condition, machine.flags);
}

Execution::Term Execution::narrow_value(std::size_t n) const {
  const Operand& from = operand(n);
  Term term;
  m.read(from, from.bits == 8 ? Size::byte : whole_register(0, from.bits).size, term);
  return term;
}

void Execution::write_whole(std::size_t n, Term value) const {
  m.write(whole_register(operand(n).reg.holder(), t.width(value)), value);
}

Execution::Term Execution::anything(int width) const {
  return t.variable(x86model::symbolic::numbered("undefined", t.size()), width);
}

Execution::Term Execution::carry() const {
  if (!m.flags.carry) throw Obstacle(unknown_flag);
  return *m.flags.carry;
}

void execute_on(ImageMachine& machine, const Decoded& code) {
  if (code.has_repeat || code.overrides_segment || code.operands.size() > 3) not_modelled();
  Instruction i{.count = code.operands.size()};
  std::copy(code.operands.begin(), code.operands.end(), i.operands.begin());
  const Size size = size_of(i, code.mnemonic, machine.width());
  for (std::size_t n = 0; n < i.count; ++n) {
    Operand& operand = i.operands.at(n);
    if (operand.kind == Operand::Kind::other || operand.kind == Operand::Kind::segment) {
      not_modelled();
    }
    operand.size = size;
  }
  if (execute_shared(machine, code.mnemonic, i)) return;
  const UserInstruction* const row = user_instruction(row_of(code), i.count);
  if (row == nullptr) not_modelled();
  row->meaning(Execution(machine, code, i, size));
}

}  // namespace fixproof::judge
