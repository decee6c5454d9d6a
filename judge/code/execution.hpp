/// @file
/// An instruction of users' code at work on a machine of terms.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "judge/code/decoded.hpp"
#include "judge/code/symbolic_machine.hpp"
#include "x86model/alu.hpp"

namespace fixproof::judge {

/// A disassembled instruction as x86model/execute.hpp takes it.
struct Instruction {
  std::array<Operand, 3> operands{};
  std::size_t count = 0;
  x86model::Mnemonic mnemonic{};  ///< if a listing has it
};

[[noreturn]] void not_modelled();

/// Whether a condition of a jump, SETcc or CMOVcc holds.
/// @throws Obstacle if it reads a flag that is undefined or not modelled
x86model::symbolic::Term holds(const ImageMachine& machine, x86model::alu::ConditionCode condition);

/// What the meaning of an instruction works on. `bits` is the size of its first operand.
class Execution {
 public:
  using Term = x86model::symbolic::Term;
  using Flags = x86model::symbolic::FlagTerms;
  using Domain = x86model::symbolic::Domain;

  Execution(ImageMachine& machine, const Decoded& decoded, const Instruction& with_operands,
            x86model::Size operand_size)
      : m(machine),
        t(machine.terms()),
        d(machine.domain()),
        code(decoded),
        instruction(with_operands),
        size(operand_size),
        bits(bits_of(operand_size)) {}

  [[nodiscard]] std::size_t count() const { return instruction.count; }
  [[nodiscard]] const Operand& operand(std::size_t n) const { return instruction.operands.at(n); }
  /// An operand as wide as the first.
  [[nodiscard]] Term value(std::size_t n) const {
    Term term;
    m.read(operand(n), size, term);
    return term;
  }
  /// An operand of its own width.
  [[nodiscard]] Term narrow_value(std::size_t n) const;
  void write(std::size_t n, Term value) const { m.write(operand(n), size, value); }
  /// Writes the whole register of operand `n`, whatever its width.
  void write_whole(std::size_t n, Term value) const;
  /// The low bits of a register: of AX to BX, if they are 8.
  [[nodiscard]] Term read_register(x86model::Register number, int width) const {
    return m.read(part_of(number, width));
  }
  void write_register(x86model::Register number, Term value) const {
    m.write(part_of(number, t.width(value)), value);
  }

  [[nodiscard]] Term number(std::uint64_t value) const { return t.constant(value, bits); }
  [[nodiscard]] Term zero() const { return number(0); }
  [[nodiscard]] Term is_zero(Term value) const {
    return t.equal(value, t.constant(0, t.width(value)));
  }
  [[nodiscard]] Term inverse(Term value) const {
    return t.bit_xor(value, t.constant(~std::uint64_t{0}, t.width(value)));
  }
  /// A word of copies of a term's sign.
  [[nodiscard]] Term sign_of(Term value) const {
    const int width = t.width(value);
    return t.sign_extend(t.extract(value, width - 1, 1), width);
  }
  /// A new unknown value.
  [[nodiscard]] Term anything(int width) const;
  /// CF. @throws Obstacle if it is undefined
  [[nodiscard]] Term carry() const;

  static RegisterName part_of(x86model::Register number, int width) {
    if (width == 8) return {number, x86model::Size::byte};
    return whole_register(static_cast<std::size_t>(number), width);
  }

  // NOLINTBEGIN(*-non-private-member-variables-in-classes,*-ref-data-members): it lives for one
  // instruction, as the code that carries it out
  ImageMachine& m;
  x86model::symbolic::Terms& t;
  Domain d;
  const Decoded& code;
  const Instruction& instruction;
  x86model::Size size;
  int bits;
  // NOLINTEND(*-non-private-member-variables-in-classes,*-ref-data-members)
};

/// Carries out an instruction that is no jump, call or return.
/// @throws Obstacle if it is not modelled, or reads a flag that is undefined or not modelled
void execute_on(ImageMachine& machine, const Decoded& code);

}  // namespace fixproof::judge
