#include "x86model/encoding.hpp"

#include <algorithm>

#include "x86model/machine.hpp"

namespace x86model {

namespace {

bool fits_byte(std::int32_t value) { return value >= -128 && value <= 127; }

bool is_indexed(const Operand& o) {
  return o.addressing == Addressing::index || o.addressing == Addressing::index_twice;
}

std::int32_t value_of(const Operand& o) { return static_cast<std::int32_t>(immediate<16>(o)); }

int displacement_bytes(const Operand& o) {
  if (is_indexed(o)) return 4;
  if (o.addressing == Addressing::direct || o.symbol != Symbol::none) return 2;
  // [BP] alone has no encoding.
  if (o.value == 0 && o.reg != Register::bp) return 0;
  return fits_byte(o.value) ? 1 : 2;
}

int immediate_bytes(Encoded encoded, Size size) {
  switch (encoded) {
    case Encoded::rm_count:
    case Encoded::rm_r_count:
    case Encoded::rm_imm8:
      return 1;
    case Encoded::rm_imm:
    case Encoded::a_imm:
      return size == Size::byte ? 1 : size == Size::word ? 2 : 4;
    default:
      return 0;
  }
}

int prefixes_of(const Instruction& i) {
  const auto& all = i.operands;
  const auto is_dword = [](const Operand& o) { return o.size == Size::dword; };
  return (std::any_of(all.begin(), all.end(), is_dword) ? 1 : 0) +
         (std::any_of(all.begin(), all.end(), is_indexed) ? 1 : 0) + (overrides_segment(i) ? 1 : 0);
}

Encoding encoding_by(const EncodingRow& row, const Instruction& i) {
  Encoding encoding{.prefixes = prefixes_of(i),
                    .opcode = row.follows_0f ? 2 : 1,
                    .mod_rm = has_mod_rm(row.operands) ? 1 : 0,
                    .immediate = immediate_bytes(row.operands, i.operands[0].size)};
  if (row.operands == Encoded::rel8) encoding.displacement = 1;
  if (row.operands == Encoded::rel16) encoding.displacement = 2;
  for (const Operand& o : i.operands) {
    if (o.kind == Operand::Kind::memory) encoding.displacement = displacement_bytes(o);
    if (o.addressing == Addressing::index_twice) ++encoding.mod_rm;
  }
  return encoding;
}

}  // namespace

bool fits(Encoded encoded, const Instruction& i) {
  using Kind = Operand::Kind;
  const auto& [a, b, c] = i.operands;
  const bool a_is_rm = a.kind == Kind::reg || a.kind == Kind::memory;
  const bool a_is_accumulator = a.kind == Kind::reg && a.reg == Register::ax;
  const bool b_is_immediate = b.kind == Kind::immediate;
  const bool is_near = a.size == Size::word || i.mnemonic == Mnemonic::call;
  switch (encoded) {
    case Encoded::nothing:
      return a.kind == Kind::none;
    case Encoded::rm_r:
      return a_is_rm && b.kind == Kind::reg;
    case Encoded::r_rm:
      return a.kind == Kind::reg && (b.kind == Kind::reg || b.kind == Kind::memory);
    case Encoded::rm_r_count:
      return a_is_rm && c.kind == Kind::immediate;
    case Encoded::rm:
      return a_is_rm && b.kind == Kind::none;
    case Encoded::rm_of_words:
      return a_is_rm && b.kind == Kind::none && a.size != Size::byte;
    case Encoded::rm_1:
      return a_is_rm && b_is_immediate && value_of(b) == 1;
    case Encoded::rm_count:
    case Encoded::rm_imm:
      return a_is_rm && b_is_immediate;
    case Encoded::rm_imm8:
      return a_is_rm && b_is_immediate && a.size != Size::byte && fits_byte(value_of(b));
    case Encoded::a_imm:
      return a_is_accumulator && b_is_immediate;
    case Encoded::a_offset:
      return a_is_accumulator && b.addressing == Addressing::direct;
    case Encoded::offset_a:
      return b.kind == Kind::reg && b.reg == Register::ax && a.addressing == Addressing::direct;
    case Encoded::r:
      return a.kind == Kind::reg && a.size != Size::byte;
    case Encoded::rel8:
      return a.kind == Kind::label && !is_near;
    case Encoded::rel16:
      return a.kind == Kind::label && is_near;
  }
  return false;
}

bool overrides_segment(const Instruction& instruction) {
  const auto& all = instruction.operands;
  return std::any_of(all.begin(), all.end(),
                     [](const Operand& o) { return o.segment != SegmentOverride::none; });
}

Encoding encoding_of(const Instruction& instruction) {
  Encoding shortest;
  bool is_known = false;
  for (const EncodingRow& row : encodings_of(instruction.mnemonic)) {
    if (!fits(row.operands, instruction)) continue;
    const Encoding encoding = encoding_by(row, instruction);
    if (!is_known || encoding.bytes() < shortest.bytes()) shortest = encoding;
    is_known = true;
  }
  return shortest;
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
