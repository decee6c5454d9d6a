#include "x86model/encoding.hpp"

#include <algorithm>

#include "x86model/execute.hpp"
#include "x86model/machine.hpp"

namespace x86model {

namespace {

bool fits_byte(std::int32_t value) { return value >= -128 && value <= 127; }

bool is_register(const Operand& o) { return o.kind == Operand::Kind::reg; }

/// Whether a ModR/M byte encodes an operand. PUSH, POP, INC and DEC encode registers in the opcode.
bool has_mod_rm(const Instruction& i) {
  switch (i.mnemonic) {
    case Mnemonic::push:
    case Mnemonic::pop:
    case Mnemonic::inc:
    case Mnemonic::dec:
      return !is_register(i.operands[0]);
    default:
      if (i.mnemonic == Mnemonic::jmp) return is_register(i.operands[0]);
      return !is_control_flow(i.mnemonic) && !detail::is_store_string(i.mnemonic);
  }
}

int displacement_bytes(const Operand& o) {
  if (o.addressing == Addressing::index || o.addressing == Addressing::index_twice) return 4;
  if (o.symbol != Symbol::none) return 2;
  // [BP] alone has no encoding.
  if (o.value == 0 && o.reg != Register::bp) return 0;
  return fits_byte(o.value) ? 1 : 2;
}

/// Two-operand arithmetic: an immediate is a sign-extended byte if possible, otherwise as wide as
/// the register; for AX or EAX it then needs no ModR/M byte.
void encode_immediate(const Operand& reg, std::int32_t value, Encoding& encoding) {
  if (fits_byte(value)) {
    encoding.immediate = 1;
    return;
  }
  encoding.immediate = reg.size == Size::dword ? 4 : 2;
  if (reg.reg == Register::ax) encoding.mod_rm = 0;
}

int prefixes_of(const Instruction& i) {
  const auto& all = i.operands;
  const auto is_dword = [](const Operand& o) { return o.size == Size::dword; };
  const auto is_indexed = [](const Operand& o) {
    return o.addressing == Addressing::index || o.addressing == Addressing::index_twice;
  };
  return (std::any_of(all.begin(), all.end(), is_dword) ? 1 : 0) +
         (std::any_of(all.begin(), all.end(), is_indexed) ? 1 : 0) + (overrides_segment(i) ? 1 : 0);
}

}  // namespace

bool overrides_segment(const Instruction& instruction) {
  const auto& all = instruction.operands;
  return std::any_of(all.begin(), all.end(),
                     [](const Operand& o) { return o.segment != SegmentOverride::none; });
}

Encoding encoding_of(const Instruction& instruction) {
  Encoding encoding;
  encoding.prefixes = prefixes_of(instruction);
  encoding.mod_rm = has_mod_rm(instruction) ? 1 : 0;
  if (detail::is_double_shift(instruction.mnemonic)) encoding.opcode = 2;
  for (const Operand& o : instruction.operands) {
    if (o.kind == Operand::Kind::memory) encoding.displacement = displacement_bytes(o);
    if (o.addressing == Addressing::index_twice) encoding.mod_rm = 2;
    if (o.kind == Operand::Kind::label) {
      const bool is_near = instruction.mnemonic == Mnemonic::call || o.size == Size::word;
      encoding.displacement = is_near ? 2 : 1;
    }
    if (o.kind != Operand::Kind::immediate) continue;
    const auto value = static_cast<std::int32_t>(immediate<16>(o));
    if (detail::is_two_operand(instruction.mnemonic)) {
      encode_immediate(instruction.operands[0], value, encoding);
    } else if (detail::is_double_shift(instruction.mnemonic) || value != 1) {
      encoding.immediate = 1;  // a shift count; shift by one has its own opcode
    }
  }
  return encoding;
}

std::size_t position_at(std::span<const Instruction> code, std::uint32_t offset) {
  std::size_t position = 0;
  std::uint32_t here = 0;
  while (position < code.size() && here < offset) {
    here += static_cast<std::uint32_t>(encoding_of(code[position++]).bytes());
  }
  return here == offset ? position : code.size();
}

}  // namespace x86model
