#include "judge/code/user_instructions.hpp"

#include <algorithm>
#include <array>

namespace fixproof::judge {

namespace {

namespace alu = x86model::alu;
using x86model::CF;
using x86model::OF;
using x86model::Register;
using Word = x86model::symbolic::Term;

// The instructions that move, extend and combine whole words. user_shifts.cpp, user_products.cpp
// and user_bits.cpp have the others.

void nothing(const Execution& /*e*/) {}

void leave(const Execution& e) {
  e.write_register(Register::sp, e.read_register(Register::bp, e.m.width()));
  e.write_register(Register::bp, e.m.pop(e.m.word()));
}

/// CBW, CWDE and CDQE: extends the lower half of the accumulator by its sign.
template <int width>
void extend_accumulator(const Execution& e) {
  const Word half = e.read_register(Register::ax, width / 2);
  e.write_register(Register::ax, e.t.sign_extend(half, width));
}

/// CWD, CDQ and CQO: fills another register with the sign of the accumulator.
template <int width>
void fill_with_sign(const Execution& e) {
  e.write_register(Register::dx, e.sign_of(e.read_register(Register::ax, width)));
}

void stc(const Execution& e) { e.m.flags.carry = e.t.truth(true); }
void clc(const Execution& e) { e.m.flags.carry = e.t.truth(false); }
void cmc(const Execution& e) { e.m.flags.carry = e.t.negation(e.carry()); }

void setcc(const Execution& e) {
  e.write(0, e.t.ite(holds(e.m, *e.code.condition), e.number(1), e.zero()));
}

void cmovcc(const Execution& e) {
  e.write(0, e.t.ite(holds(e.m, *e.code.condition), e.value(1), e.value(0)));
}

void complement(const Execution& e) { e.write(0, e.inverse(e.value(0))); }

void lea(const Execution& e) {
  const Word address = e.m.address_term(e.operand(1));
  const int given = e.t.width(address);
  e.write(0, given < e.bits ? e.t.zero_extend(address, e.bits) : e.t.extract(address, 0, e.bits));
}

void set_flags(const Execution& e, const alu::Result<Execution::Domain>& result) {
  e.m.flags = result.flags;
}

void logical_or(const Execution& e) {
  const Word a = e.value(0);
  const Word b = e.value(1);
  const Word either = e.d.bit_xor(e.d.bit_xor(a, b), e.d.bit_and(a, b));
  const auto result = alu::logic(e.d, either, e.bits);
  e.write(0, result.value);
  set_flags(e, result);
}

void test(const Execution& e) {
  set_flags(e, alu::logic(e.d, e.d.bit_and(e.value(0), e.value(1)), e.bits));
}

/// ADCX and ADOX add a flag, and change no other one.
template <x86model::Flag flag>
void add_with(const Execution& e) {
  std::optional<Word>& carry = flag == CF ? e.m.flags.carry : e.m.flags.overflow;
  if (!carry) throw Obstacle("it reads a flag that is undefined or not modelled");
  const auto result = alu::add(e.d, e.value(0), e.value(1), *carry, e.bits);
  e.write(0, result.value);
  carry = result.flags.carry;
}

void xchg(const Execution& e) {
  const Word old = e.value(0);
  e.write(0, e.value(1));
  e.write(1, old);
}

void movzx(const Execution& e) { e.write(0, e.t.zero_extend(e.narrow_value(1), e.bits)); }
void movsx(const Execution& e) { e.write(0, e.t.sign_extend(e.narrow_value(1), e.bits)); }

constexpr std::array rows{
    UserInstruction{"leave", 0, leave},
    UserInstruction{"cbw", 0, extend_accumulator<16>},
    UserInstruction{"cwde", 0, extend_accumulator<32>},
    UserInstruction{"cdqe", 0, extend_accumulator<64>},
    UserInstruction{"cwd", 0, fill_with_sign<16>},
    UserInstruction{"cdq", 0, fill_with_sign<32>},
    UserInstruction{"cqo", 0, fill_with_sign<64>},
    UserInstruction{"stc", 0, stc},
    UserInstruction{"clc", 0, clc},
    UserInstruction{"cmc", 0, cmc},
    // Conventions ask for a direction flag that is clear already.
    UserInstruction{"cld", 0, nothing},
    UserInstruction{"setcc", 1, setcc},
    UserInstruction{"cmovcc", 2, cmovcc},
    UserInstruction{"not", 1, complement},
    UserInstruction{"lea", 2, lea},
    UserInstruction{"or", 2, logical_or},
    UserInstruction{"test", 2, test},
    UserInstruction{"adcx", 2, add_with<CF>},
    UserInstruction{"adox", 2, add_with<OF>},
    UserInstruction{"xchg", 2, xchg},
    UserInstruction{"movzx", 2, movzx},
    UserInstruction{"movsx", 2, movsx},
    UserInstruction{"movsxd", 2, movsx},

    UserInstruction{"shl", 2, meaning::shl},
    UserInstruction{"shr", 2, meaning::shr},
    UserInstruction{"sar", 2, meaning::sar},
    UserInstruction{"rol", 2, meaning::rol},
    UserInstruction{"ror", 2, meaning::ror},
    UserInstruction{"rcl", 2, meaning::rcl},
    UserInstruction{"rcr", 2, meaning::rcr},
    UserInstruction{"shld", 3, meaning::shld},
    UserInstruction{"shrd", 3, meaning::shrd},
    UserInstruction{"shlx", 3, meaning::shlx},
    UserInstruction{"shrx", 3, meaning::shrx},
    UserInstruction{"sarx", 3, meaning::sarx},
    UserInstruction{"rorx", 3, meaning::rorx},

    UserInstruction{"mul", 1, meaning::mul},
    UserInstruction{"imul", 1, meaning::imul},
    UserInstruction{"imul", 2, meaning::imul_to_register},
    UserInstruction{"imul", 3, meaning::imul_to_register},
    UserInstruction{"mulx", 3, meaning::mulx},
    UserInstruction{"div", 1, meaning::div},
    UserInstruction{"idiv", 1, meaning::idiv},

    UserInstruction{"bt", 2, meaning::bt},
    UserInstruction{"bts", 2, meaning::bts},
    UserInstruction{"btr", 2, meaning::btr},
    UserInstruction{"btc", 2, meaning::btc},
    UserInstruction{"bsf", 2, meaning::bsf},
    UserInstruction{"bsr", 2, meaning::bsr},
    UserInstruction{"tzcnt", 2, meaning::tzcnt},
    UserInstruction{"lzcnt", 2, meaning::lzcnt},
    UserInstruction{"popcnt", 2, meaning::popcnt},
    UserInstruction{"bswap", 1, meaning::bswap},
    UserInstruction{"andn", 3, meaning::andn},
    UserInstruction{"blsr", 2, meaning::blsr},
    UserInstruction{"blsi", 2, meaning::blsi},
    UserInstruction{"blsmsk", 2, meaning::blsmsk},
};

}  // namespace

std::span<const UserInstruction> user_instructions() { return rows; }

const UserInstruction* user_instruction(std::string_view mnemonic, std::size_t operands) {
  const auto* const found = std::ranges::find_if(rows, [&](const UserInstruction& row) {
    return row.mnemonic == mnemonic && row.operands == operands;
  });
  return found == rows.end() ? nullptr : found;
}

}  // namespace fixproof::judge
