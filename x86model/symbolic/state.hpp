/// @file
/// What a symbolic run works on: a machine whose registers, flags and memory are terms.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "x86model/machine.hpp"
#include "x86model/symbolic/alu.hpp"

namespace x86model::symbolic {

/// What an instruction writes to memory that is left open: 8, 16 or 32 bits.
struct Store {
  bool extra;    ///< to the extra segment, by STOS; else to the data segment
  Term address;  ///< 32 bits
  Term value;

  friend bool operator==(const Store&, const Store&) = default;
};

/// Registers, flags and memory of 16-bit words, as terms. Memory is where it has been put: to read
/// elsewhere ends a path as bad_address, unless memory is left open. Addresses are constants, but
/// for those in the cosine table and in open memory.
struct State {
  std::array<Term, register_count> registers;  ///< 32 bits each
  FlagTerms flags;
  std::map<std::uint32_t, Term> memory;
  std::vector<Store> stores{};  ///< to open memory, in their order

  [[nodiscard]] Term read(Terms& terms, Register r, Size size) const;
  void write(Terms& terms, Register r, Size size, Term value);
};

}  // namespace x86model::symbolic
