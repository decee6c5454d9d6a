/// @file
/// The state of a symbolic run: a machine whose registers, flags and memory are terms.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "x86model/instruction.hpp"
#include "x86model/symbolic/domain.hpp"

namespace x86model::symbolic {

/// A write to open memory: 8, 16 or 32 bits.
struct Store {
  bool extra = false;  ///< to the extra segment, by STOS; otherwise to the data segment
  Term address;        ///< 32 bits
  Term value;

  friend bool operator==(const Store&, const Store&) = default;
};

/// Registers, flags and memory of 16-bit words, as terms. Registers have 32 bits, or in the 64-bit
/// code of users 64. Memory has only the words that were put
/// there; a read elsewhere ends a path as bad_address, unless memory is open. Addresses are
/// constants, except in the cosine table and in open memory.
struct State {
  std::array<Term, 16> registers;  ///< the listings have the first register_count
  FlagTerms flags;
  std::map<std::uint32_t, Term> memory;
  std::vector<Store> stores{};  ///< to open memory, in order

  [[nodiscard]] Term read(Terms& terms, Register r, Size size) const;
  void write(Terms& terms, Register r, Size size, Term value);
};

}  // namespace x86model::symbolic
