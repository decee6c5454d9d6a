#include "x86model/forms.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "x86model/machine.hpp"
#include "x86model/run.hpp"
#include "x86model/text.hpp"

namespace x86model {

namespace {

/// The kind and size of an operand, as used in a form.
enum class OperandForm : std::uint8_t { none, byte, word, dword, immediate, one, label };

OperandForm form_of(const Operand& o, bool is_count) {
  switch (o.kind) {
    case Operand::Kind::reg:
    case Operand::Kind::memory:
      if (o.size == Size::byte) return OperandForm::byte;
      return o.size == Size::word ? OperandForm::word : OperandForm::dword;
    case Operand::Kind::immediate:
      return is_count && o.scaling == Scaling::literal && o.value == 1 ? OperandForm::one
                                                                       : OperandForm::immediate;
    case Operand::Kind::label:
      return OperandForm::label;
    case Operand::Kind::none:
      break;
  }
  return OperandForm::none;
}

using Form = std::tuple<Mnemonic, OperandForm, OperandForm, OperandForm>;

Form form_of(const Instruction& i) {
  const auto& [first, second, third] = i.operands;
  return {i.mnemonic, form_of(first, false), form_of(second, detail::is_shift(i.mnemonic)),
          form_of(third, false)};
}

void append(std::vector<Instruction>& all, const Program& program) {
  const auto code = program.instructions();
  all.insert(all.end(), code.begin(), code.end());
}

/// The instructions of the routines for one processor. The 8088 cannot run SHL BX,2, so the printed
/// CosSin is not included.
std::vector<Instruction> instructions_of(Target target) {
  constexpr std::array builds{Build{}, Build{.mul_rounding = false, .div_rounding = false},
                              Build{.chapter_52 = true}};
  std::vector<Instruction> all;
  for (int r = 0; r < routine_count; ++r) {
    for (const Build& build : builds) {
      append(all, assemble(listing(static_cast<Routine>(r), target), build));
    }
  }
  return all;
}

/// The same with those of the loops.
std::vector<Instruction> all_instructions_of(Target target) {
  std::vector<Instruction> all = instructions_of(target);
  for (const LoopForm& form : all_loop_forms()) {
    if (form.target == target) append(all, assemble(listing(form), {}));
  }
  return all;
}

/// Their forms, sorted and without duplicates.
std::vector<Form> forms_of(Target target) {
  std::vector<Form> forms;
  for (const Instruction& i : all_instructions_of(target)) forms.push_back(form_of(i));
  std::sort(forms.begin(), forms.end());
  forms.erase(std::unique(forms.begin(), forms.end()), forms.end());
  return forms;
}

bool contains(const std::vector<Form>& forms, const Form& form) {
  return std::binary_search(forms.begin(), forms.end(), form);
}

}  // namespace

bool is_modelled(const Instruction& instruction, Target processor) {
  static const std::vector<Form> i8088 = forms_of(Target::i8088);
  static const std::vector<Form> i386 = forms_of(Target::i386);
  const Form form = form_of(instruction);
  return contains(i8088, form) || (processor == Target::i386 && contains(i386, form));
}

std::string form_text(const Instruction& instruction) {
  static constexpr std::array<const char*, 7> names{"",    "r/m8", "r/m16", "r/m32",
                                                    "imm", "1",    "label"};
  const auto [mnemonic, first, second, third] = form_of(instruction);
  std::string text(name_of(mnemonic));
  const char* between = " ";
  for (const OperandForm form : {first, second, third}) {
    if (form == OperandForm::none) break;
    text.append(between).append(names.at(static_cast<std::size_t>(form)));
    between = ", ";
  }
  return text;
}

std::vector<std::string> form_texts(Target target) {
  std::set<std::string> texts;
  for (const Instruction& i : instructions_of(target)) texts.insert(form_text(i));
  return {texts.begin(), texts.end()};
}

std::vector<Instruction> form_examples() {
  using Kinds = std::array<Operand::Kind, 3>;
  std::map<std::pair<Form, Kinds>, Instruction> examples;
  for (const Target target : {Target::i8088, Target::i386}) {
    for (const Instruction& i : all_instructions_of(target)) {
      const auto& [a, b, c] = i.operands;
      examples.try_emplace({form_of(i), Kinds{a.kind, b.kind, c.kind}}, i);
    }
  }
  std::vector<Instruction> result;
  for (const auto& [form, example] : examples) result.push_back(example);
  return result;
}

FlagUse flag_use(const Instruction& instruction) {
  const Mnemonic op = instruction.mnemonic;
  FlagUse use;
  if (detail::adds_carry(op)) use.reads = CF;
  if (const auto condition = detail::condition_of(op)) use.reads = alu::flags_read(*condition);
  if (is_control_flow(op)) return use;
  Instruction on_registers = instruction;
  for (Operand& o : on_registers.operands) {
    if (o.kind == Operand::Kind::memory) o = {.kind = Operand::Kind::reg, .size = o.size};
  }
  // Once with all flags undefined but those that it reads, once with all defined. With 0 in (E)DX
  // and 1 elsewhere no divide by another register faults.
  Machine<16, WordMemory<16, 1>> unknown{};
  for (std::size_t r = 0; r < register_count; ++r) {
    const auto reg = static_cast<Register>(r);
    unknown.write(reg, Size::dword, reg == Register::dx ? 0 : 1);
  }
  auto known = unknown;
  unknown.flags.undefined &= static_cast<std::uint16_t>(~use.reads);
  known.flags = {};
  execute_any(on_registers, unknown);
  execute_any(on_registers, known);
  use.sets = arithmetic_flags & static_cast<std::uint16_t>(~unknown.flags.undefined);
  use.leaves_undefined = known.flags.undefined;
  return use;
}

}  // namespace x86model
