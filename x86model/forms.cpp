#include "x86model/forms.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "x86model/execute.hpp"

namespace x86model {

namespace {

/// Kind and size of an operand, as far as they make a form.
enum class OperandForm : std::uint8_t { none, word, dword, immediate, one, label };

OperandForm form_of(const Operand& o, bool is_count) {
  switch (o.kind) {
    case Operand::Kind::reg:
    case Operand::Kind::memory:
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

std::vector<Form> forms_of(Target target) {
  std::vector<Form> forms;
  for (int r = 0; r < routine_count; ++r) {
    const Listing& rows = listing(static_cast<Routine>(r), target);
    for (std::size_t i = 0; i < rows.size; ++i) {
      if (rows.rows.at(i).directive == Directive::none) forms.push_back(form_of(rows.rows.at(i)));
    }
  }
  return forms;
}

bool contains(const std::vector<Form>& forms, const Form& form) {
  return std::find(forms.begin(), forms.end(), form) != forms.end();
}

}  // namespace

bool is_modelled(const Instruction& instruction, Target processor) {
  static const std::vector<Form> i8088 = forms_of(Target::i8088);
  static const std::vector<Form> i386 = forms_of(Target::i386);
  const Form form = form_of(instruction);
  return contains(i8088, form) || (processor == Target::i386 && contains(i386, form));
}

}  // namespace x86model
