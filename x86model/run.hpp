/// @file
/// The interpreter: executes one instruction after another and notifies an observer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "x86model/encoding.hpp"
#include "x86model/execute.hpp"

namespace x86model {

/// The return address of the routine's caller; no routine is this long.
template <int WordBits>
inline constexpr std::uint32_t return_to_caller = alu::mask(WordBits);

/// The offset of the first instruction in the code segment, used by computed jumps. Elsewhere code
/// addresses are positions.
inline constexpr std::uint32_t code_address = 0x4000;

/// How and where a run ended, and the number of instructions executed.
struct Ending {
  Outcome outcome;
  std::size_t position;
  std::uint64_t steps;
};

/// Executes an instruction, chosen at run time, that is not control flow.
template <class M>
Outcome execute_any(const Instruction& instruction, M& m) {
  using Handler = Outcome (*)(const Instruction&, M&);
  static constexpr auto handlers = []<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Handler, sizeof...(I)>{+[](const Instruction& i, M& machine) {
      return execute<static_cast<Mnemonic>(I)>(i, machine);
    }...};
  }
  (std::make_index_sequence<static_cast<std::size_t>(Mnemonic::jmp)>{});
  return handlers[static_cast<std::size_t>(instruction.mnemonic)](instruction, m);
}

/// Runs `code` from its first instruction until it returns to its caller, faults, reads an
/// undefined flag, leaves memory, or has taken `limit` steps. The caller sets up stack, arguments
/// and SP.
///
/// @param observe called as observe(position, machine) after each executed instruction; if it has a
/// member `before`, also as observe.before(position, machine) before each instruction, including
/// one that then faults
template <class M, class Observer>
Ending run(std::span<const Instruction> code, M& m, Observer&& observe,
           std::uint64_t limit = 100'000) {
  std::size_t position = 0;
  for (std::uint64_t steps = 0; steps < limit; ++steps) {
    if (position >= code.size()) return {Outcome::bad_address, position, steps};
    if constexpr (requires { observe.before(position, std::as_const(m)); }) {
      observe.before(position, std::as_const(m));
    }
    const Instruction& instruction = code[position];
    const Mnemonic op = instruction.mnemonic;
    std::size_t next = position + 1;
    Outcome outcome = Outcome::proceeds;
    if (op == Mnemonic::ret) {
      std::uint32_t to = 0;
      if (!detail::pop(m, to)) return {Outcome::bad_address, position, steps};
      if (to == return_to_caller<M::word_bits>) {
        observe(position, std::as_const(m));
        return {Outcome::returned, position, steps + 1};
      }
      next = to;
    } else if (is_control_flow(op)) {
      const Operand& to = instruction.operands[0];
      bool taken = false;
      if (op == Mnemonic::loop) {
        taken = count_down(m);
      } else {
        outcome = jump_taken(op, m.flags, taken);
      }
      if (op == Mnemonic::call && !detail::push(m, static_cast<std::uint32_t>(next))) {
        outcome = Outcome::bad_address;
      }
      if (taken) {
        next = to.kind == Operand::Kind::reg
                   ? position_at(code, m.registers.read(to.reg, to.size) - code_address)
                   : static_cast<std::size_t>(to.value);
      }
    } else {
      outcome = execute_any(instruction, m);
    }
    if (outcome != Outcome::proceeds) return {outcome, position, steps};
    observe(position, std::as_const(m));
    position = next;
  }
  return {Outcome::step_limit, position, limit};
}

template <class M>
Ending run(std::span<const Instruction> code, M& m) {
  return run(code, m, [](std::size_t, const M&) {});
}

}  // namespace x86model
