/// @file
/// The interpreter: executes one instruction after another and notifies an observer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include "x86model/encoding.hpp"
#include "x86model/execute.hpp"
#include "x86model/inline.hpp"
#include "x86model/words.hpp"

namespace x86model {

/// The return address of the routine's caller; no routine is this long.
template <int WordBits>
inline constexpr std::uint32_t return_to_caller = mask(WordBits);

/// The offset of the first instruction in the code segment, used by computed jumps. Elsewhere code
/// addresses are positions.
inline constexpr std::uint32_t code_address = 0x4000;

/// How and where a run ended, and the number of instructions executed.
struct Ending {
  Outcome outcome;
  std::size_t position;
  std::uint64_t steps;
};

namespace detail {

template <class I, class M>
using Handler = Outcome (*)(const I&, M&);

template <Mnemonic op, class I, class M>
Outcome execute_on_any(const I& instruction, M& m) {
  return execute<op>(instruction, m);
}

/// Executes an instruction whose first operand is a word register and whose second is of `kind`, as
/// in most rows of the listings. Stating both again leaves the compiler no other case to test for.
template <Mnemonic op, Operand::Kind kind, class M>
Outcome execute_on_word_register(const Instruction& instruction, M& m) {
  Instruction known = instruction;
  known.operands[0].kind = Operand::Kind::reg;
  known.operands[0].size = Size::word;
  known.operands[1].kind = kind;
  return execute<op>(known, m);
}

/// Whether there are instructions with this mnemonic, a word register, and a second operand of this
/// kind. Only these get a handler of their own.
constexpr bool takes_word_register(Mnemonic op, Operand::Kind second) {
  using Kind = Operand::Kind;
  if (op == Mnemonic::mov || is_two_operand(op)) {
    return second == Kind::reg || second == Kind::memory || second == Kind::immediate;
  }
  if (is_shift(op)) return second == Kind::immediate;
  if (is_double_shift(op)) return second == Kind::reg;
  return !is_store_string(op) && second == Kind::none;
}

template <Mnemonic op, Operand::Kind second, class M>
constexpr Handler<Instruction, M> handler_on_word_register() {
  if constexpr (takes_word_register(op, second)) return &execute_on_word_register<op, second, M>;
  return &execute_on_any<op, Instruction, M>;
}

/// The number of kinds of operands, rounded up to a power of two, which is faster to index.
inline constexpr std::size_t kinds = 8;
static_assert(static_cast<std::size_t>(Operand::Kind::label) < kinds);

}  // namespace detail

/// Executes an instruction, chosen at run time, that is not control flow.
template <class I, class M>
Outcome execute_any(const I& instruction, M& m) {
  using detail::kinds;
  constexpr auto straight = static_cast<std::size_t>(Mnemonic::jmp);  // those before control flow
  const auto op = static_cast<std::size_t>(instruction.mnemonic);
  constexpr bool computes_words = std::is_same_v<typename M::Domain, Words>;
  if constexpr (computes_words && !detail::prefers_small_code) {
    static constexpr auto on_word_register = []<std::size_t... N>(std::index_sequence<N...>) {
      return std::array<detail::Handler<Instruction, M>, sizeof...(N)>{
          detail::handler_on_word_register<static_cast<Mnemonic>(N / kinds),
                                           static_cast<Operand::Kind>(N % kinds), M>()...};
    }
    (std::make_index_sequence<straight * kinds>{});
    const Operand& first = instruction.operands[0];
    if (first.kind == Operand::Kind::reg && first.size == Size::word) [[likely]] {
      const auto second = static_cast<std::size_t>(instruction.operands[1].kind);
      return on_word_register[op * kinds + second](instruction, m);
    }
  }
  static constexpr auto on_any = []<std::size_t... N>(std::index_sequence<N...>) {
    return std::array<detail::Handler<I, M>, sizeof...(N)>{
        &detail::execute_on_any<static_cast<Mnemonic>(N), I, M>...};
  }
  (std::make_index_sequence<straight>{});
  return on_any[op](instruction, m);
}

/// Executes an instruction that is control flow.
/// @param target where it goes if it jumps; RET takes that from the stack
/// @param next before: the address of the instruction after it; after: of the one to execute next
template <class M>
X86MODEL_INLINE Outcome transfer(Mnemonic op, M& m, std::uint32_t target, std::uint32_t& next) {
  if (op == Mnemonic::ret) return m.pop(next) ? Outcome::proceeds : Outcome::bad_address;
  bool taken = false;
  Outcome outcome = Outcome::proceeds;
  if (op == Mnemonic::loop) {
    taken = count_down(m);
  } else {
    outcome = jump_taken(m.domain(), op, m.flags, taken);
  }
  if (op == Mnemonic::call && !m.push(next)) outcome = Outcome::bad_address;
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
  for (std::uint64_t left = limit; left > 0; --left) {
    if (position >= code.size()) return {Outcome::bad_address, position, limit - left};
    if constexpr (requires { observe.before(position, std::as_const(m)); }) {
      observe.before(position, std::as_const(m));
    }
    const Instruction& instruction = code[position];
    const Mnemonic op = instruction.mnemonic;
    std::size_t next = position + 1;
    Outcome outcome = Outcome::proceeds;
    if (!is_control_flow(op)) [[likely]] {
      outcome = execute_any(instruction, m);
    } else {
      const Operand& to = instruction.operands[0];
      const auto target = static_cast<std::uint32_t>(
          to.kind == Operand::Kind::reg
              ? position_at(code, m.registers.read(to.reg, to.size) - code_address)
              : static_cast<std::size_t>(to.value));
      auto address = static_cast<std::uint32_t>(next);
      outcome = transfer(op, m, target, address);
      if (op == Mnemonic::ret && outcome == Outcome::proceeds &&
          address == return_to_caller<M::word_bits>) {
        observe(position, std::as_const(m));
        return {Outcome::returned, position, limit - left + 1};
      }
      next = address;
    }
    if (outcome != Outcome::proceeds) return {outcome, position, limit - left};
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
