#include "x86model/symbolic/execute.hpp"

#include "x86model/symbolic/alu.hpp"
#include "x86model/symbolic/open_memory.hpp"

namespace x86model::symbolic {

namespace {

using Word = Machine<16, WordMemory<16, 0>>;

Outcome done(bool well) { return well ? Outcome::proceeds : Outcome::bad_address; }

/// Executes the instructions that replace their first operand.
Outcome computed(Terms& t, const Operands& operands, Thread& thread, const Instruction& i) {
  using namespace x86model::detail;
  const Mnemonic op = i.mnemonic;
  const Size size = i.operands[0].size;
  FlagTerms& flags = thread.state.flags;
  const bool with_carry = op == Mnemonic::adc || op == Mnemonic::sbb;
  if (with_carry && !flags.carry) return Outcome::undefined_flag;
  const auto a = operands.read(thread, i.operands[0], size);
  if (!a) return Outcome::bad_address;
  const Term none = t.truth(false);
  Result result{*a, {}};
  if (is_shift(op) || is_double_shift(op)) {
    const Operand& amount = i.operands[is_shift(op) ? 1 : 2];
    const int count = static_cast<int>(immediate<Word>(amount) & 31U);
    if (count == 0) return Outcome::proceeds;
    if (is_shift(op)) {
      result = shift(t, op, *a, count);
    } else {
      const auto fill = operands.read(thread, i.operands[1], size);
      if (!fill) return Outcome::bad_address;
      result = double_shift(t, op, *a, *fill, count);
    }
  } else if (is_one_operand(op)) {
    const Term one = t.constant(1, t.width(*a));
    if (op == Mnemonic::neg) result = sub(t, t.constant(0, t.width(*a)), *a, none);
    if (op == Mnemonic::inc) result = add(t, *a, one, none);
    if (op == Mnemonic::dec) result = sub(t, *a, one, none);
  } else {
    const auto b = operands.read(thread, i.operands[1], size);
    if (!b) return Outcome::bad_address;
    if (op == Mnemonic::add) result = add(t, *a, *b, none);
    if (op == Mnemonic::adc) result = add(t, *a, *b, *flags.carry);
    if (op == Mnemonic::sub || op == Mnemonic::cmp) result = sub(t, *a, *b, none);
    if (op == Mnemonic::sbb) result = sub(t, *a, *b, *flags.carry);
    if (op == Mnemonic::and_) result = logic(t, t.bit_and(*a, *b));
    if (op == Mnemonic::xor_) result = logic(t, t.bit_xor(*a, *b));
  }
  if (op != Mnemonic::cmp && !operands.write(thread, i.operands[0], size, result.value)) {
    return Outcome::bad_address;
  }
  if (op == Mnemonic::inc || op == Mnemonic::dec) result.flags.carry = flags.carry;
  if (op == Mnemonic::rol) {
    result.flags.zero = flags.zero;
    result.flags.sign = flags.sign;
  }
  flags = result.flags;
  return Outcome::proceeds;
}

Outcome multiplied(Terms& t, const Operands& operands, Thread& thread, const Instruction& i) {
  const Size size = i.operands[0].size;
  const auto b = operands.read(thread, i.operands[0], size);
  if (!b) return Outcome::bad_address;
  const Term a = thread.state.read(t, Register::ax, size);
  const Result result = multiply(t, i.mnemonic, a, *b);
  const int bits = t.width(a);
  thread.state.write(t, Register::ax, size, t.extract(result.value, 0, bits));
  thread.state.write(t, Register::dx, size, t.extract(result.value, bits, bits));
  thread.state.flags = result.flags;
  return Outcome::proceeds;
}

}  // namespace

Outcome execute(Terms& t, const Operands& operands, Thread& thread, const Instruction& i) {
  using namespace x86model::detail;
  const Mnemonic op = i.mnemonic;
  const Operand& first = i.operands[0];
  const Size size = first.size;
  if (op == Mnemonic::mov) {
    const auto value = operands.read(thread, i.operands[1], size);
    return done(value && operands.write(thread, first, size, *value));
  }
  if (op == Mnemonic::push) {
    const auto value = operands.read(thread, first, size);
    return done(value && operands.push(thread, *value));
  }
  if (op == Mnemonic::pop) {
    const auto value = operands.pop(thread);
    return done(value && operands.write(thread, first, size, *value));
  }
  if (is_store_string(op)) {
    if (!operands.memory_is_open()) return Outcome::bad_address;
    open_memory::store_string(t, thread.state, op == Mnemonic::stosb ? Size::byte : Size::word);
    return Outcome::proceeds;
  }
  if (is_multiply(op)) return multiplied(t, operands, thread, i);
  return computed(t, operands, thread, i);
}

}  // namespace x86model::symbolic
