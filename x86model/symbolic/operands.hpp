/// @file
/// The operands of a symbolic run: reads and writes registers, memory and the stack.
#pragma once

#include <optional>

#include "x86model/instruction.hpp"
#include "x86model/symbolic/thread.hpp"

namespace x86model::symbolic {

/// Every read returns nothing, and every write false, if the address is not in memory.
class Operands {
 public:
  Operands(Terms& terms, bool memory_is_open) : t_(terms), memory_is_open_(memory_is_open) {}

  [[nodiscard]] bool memory_is_open() const { return memory_is_open_; }

  /// Reads an operand of any kind. A read of the cosine table adds to Thread::in_table.
  std::optional<Term> read(Thread& thread, const Operand& o, Size size) const;
  bool write(Thread& thread, const Operand& o, Size size, Term value) const;

  bool push(Thread& thread, Term value) const;
  std::optional<Term> pop(Thread& thread) const;

  /// The word at a constant address.
  [[nodiscard]] std::optional<Term> memory_word(const Thread& thread, Term where) const;

 private:
  [[nodiscard]] Term address(const Thread& thread, const Operand& o, std::int32_t origin) const;
  std::optional<Term> table_word(Thread& thread, Term offset) const;
  bool put(Thread& thread, Term where, Term value) const;

  Terms& t_;
  bool memory_is_open_;
};

}  // namespace x86model::symbolic
