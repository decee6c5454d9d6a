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

/// Executes an instruction that is control flow.
/// @param target where it goes if it jumps; RET takes that from the stack
/// @param next before: the address of the instruction after it; after: of the one to execute next
template <class M>
X86MODEL_INLINE Outcome transfer(Mnemonic op, M& m, std::uint32_t target, std::uint32_t& next) {
  if (op == Mnemonic::ret) return detail::pop(m, next) ? Outcome::proceeds : Outcome::bad_address;
  bool taken = false;
  Outcome outcome = Outcome::proceeds;
  if (op == Mnemonic::loop) {
    taken = count_down(m);
  } else {
    outcome = jump_taken(op, m.flags, taken);
  }
  if (op == Mnemonic::call && !detail::push(m, next)) outcome = Outcome::bad_address;
  if (taken && outcome == Outcome::proceeds) next = target;
  return outcome;
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
    auto next = static_cast<std::uint32_t>(position + 1);
    Outcome outcome = Outcome::proceeds;
    if (is_control_flow(op)) {
      const Operand& to = instruction.operands[0];
      const auto target = static_cast<std::uint32_t>(
          to.kind == Operand::Kind::reg
              ? position_at(code, m.registers.read(to.reg, to.size) - code_address)
              : static_cast<std::size_t>(to.value));
      outcome = transfer(op, m, target, next);
      if (op == Mnemonic::ret && outcome == Outcome::proceeds &&
          next == return_to_caller<M::word_bits>) {
        observe(position, std::as_const(m));
        return {Outcome::returned, position, steps + 1};
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
