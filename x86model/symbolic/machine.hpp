/// @file
/// Machines of terms, on which x86model/execute.hpp executes instructions for all operands at once.
#pragma once

#include <cstdint>
#include <optional>

#include "x86model/instruction.hpp"
#include "x86model/symbolic/state.hpp"

namespace x86model::symbolic {

/// What every machine of terms has: registers, flags, and divides that may fault. A machine for
/// some kind of code adds its operands and its stack.
class Machine {
 public:
  using Domain = symbolic::Domain;
  /// A divide that faults for some operands, with the state before it.
  struct Fault {
    Term condition;
    State state;
  };

  Machine(Terms& terms, State& state) : flags(state.flags), t_(terms), state_(state) {}

  [[nodiscard]] Domain domain() const { return t_; }
  [[nodiscard]] static int bits_of(Size size) {
    return size == Size::byte ? 8 : size == Size::word ? 16 : size == Size::dword ? 32 : 64;
  }
  [[nodiscard]] Term read(Register r, Size size) const { return state_.read(t_, r, size); }
  void write(Register r, Size size, Term value) { state_.write(t_, r, size, value); }

  /// Whether the instruction raises #DE for all operands. If it does so for some, sets `fault`, and
  /// the machine goes on with the others.
  bool faults_if(Term condition) {
    if (t_.is_constant(condition)) return t_.value(condition) != 0;
    fault = {condition, state_};
    return false;
  }

  // NOLINTBEGIN(*-non-private-member-variables-in-classes): as in the machine of words
  FlagTerms& flags;
  std::optional<Fault> fault;
  // NOLINTEND(*-non-private-member-variables-in-classes)

 protected:
  // NOLINTBEGIN(*-non-private-member-variables-in-classes)
  Terms& t_;
  State& state_;
  // NOLINTEND(*-non-private-member-variables-in-classes)
};

/// A machine for the listings: 16-bit words, whose memory is State::memory, or open; see
/// RunOptions::memory_is_open. Every read and write returns false if the address is not in memory.
class ListingMachine : public Machine {
 public:
  /// @param in_table whether all addresses in the cosine table so far are those of its words
  ListingMachine(Terms& terms, State& state, Term& in_table, bool memory_is_open)
      : Machine(terms, state), in_table_(in_table), memory_is_open_(memory_is_open) {}

  using Machine::read;
  using Machine::write;
  bool read(const Operand& o, Size size, Term& value);
  bool write(const Operand& o, Size size, Term value);
  bool push(Term value);
  bool pop(Term& value);
  /// STOSB and STOSW, by size: only with open memory.
  bool store_string(Size size);
  [[nodiscard]] static std::uint32_t count_in(const Operand& o);

  /// Reads the word at an address, which must be constant.
  bool read_word(Term where, Term& value) const;

 private:
  bool write_word(Term where, Term value);
  /// Reads a word of the cosine table.
  bool read_table(Term offset, Term& value);
  /// The address of a memory operand, 16 bits: `origin` is that of its named place, or 0 for an
  /// offset in that place.
  [[nodiscard]] Term address_in(const Operand& o, std::int32_t origin) const;
  /// The same in open memory, 32 bits.
  [[nodiscard]] Term open_address_in(const Operand& o) const;
  bool read_open(const Operand& o, Size size, Term& value);

  Term& in_table_;
  bool memory_is_open_;
};

}  // namespace x86model::symbolic
