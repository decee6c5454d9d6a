/// @file
/// The compiled run: a program unrolled at compile time, for sweeps.
///
/// Instructions are laid out in their order and every jump becomes "skip until": a pass goes
/// through all instructions once and leaves out those before the pending target. Whether an
/// instruction can be left out at all is known at compile time, so straight-line code has no test.
/// A jump backwards starts another pass.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "x86model/assemble.hpp"
#include "x86model/execute.hpp"
#include "x86model/run.hpp"

namespace x86model {

namespace detail {

/// Past the routine that starts at `entry`: after its RET.
constexpr std::size_t end_of_routine(const Program& program, std::size_t entry) {
  while (program.code[entry].mnemonic != Mnemonic::ret) ++entry;
  return entry + 1;
}

constexpr bool jumps(const Instruction& i) {
  return is_control_flow(i.mnemonic) && i.mnemonic != Mnemonic::call && i.mnemonic != Mnemonic::ret;
}

/// For each instruction of the routine that starts at `entry`, whether a pass can come by with its
/// target still ahead: a jump from before leads past it, or any jump leads backwards.
template <const Program& program, std::size_t entry>
inline constexpr auto can_be_skipped = [] {
  constexpr std::size_t end = end_of_routine(program, entry);
  std::array<bool, end> skippable{};
  std::size_t farthest = 0;
  bool backwards = false;
  for (std::size_t i = entry; i < end; ++i) {
    const Instruction& row = program.code[i];
    skippable[i] = farthest > i;
    if (!jumps(row)) continue;
    const auto to = static_cast<std::size_t>(row.operands[0].value);
    if (to <= i) backwards = true;
    if (to > farthest) farthest = to;
  }
  if (backwards) skippable.fill(true);
  return skippable;
}();

/// `instruction` as a template argument: its names are string literals, which cannot be part of
/// one.
constexpr Instruction without_names(Instruction instruction) {
  instruction.label = nullptr;
  for (Operand& operand : instruction.operands) operand.name = nullptr;
  return instruction;
}

/// One instruction in a function of its own, which all long programs share.
template <Instruction instruction, class M>
[[gnu::noinline]] Outcome execute_shared(M& m) {
  return execute<instruction.mnemonic>(instruction, m);
}

/// The longest program whose instructions are inlined. Inlined, a transform of 450 instructions
/// takes a compiler seconds; called, it is still fast enough for sweeps.
inline constexpr std::size_t max_inlined = 70;

template <const Program& program, std::size_t entry, class M>
Outcome run_routine(M& m);

/// One instruction of a pass. @return false where the pass ends here, with `outcome` set.
template <const Program& program, std::size_t entry, std::size_t position, class M>
[[gnu::always_inline]] inline bool pass_over(M& m, std::size_t& target, Outcome& outcome) {
  constexpr const Instruction& instruction = program.code[position];
  constexpr Mnemonic op = instruction.mnemonic;
  if constexpr (can_be_skipped<program, entry>[position]) {
    if (position < target) return true;
  }
  if constexpr (op == Mnemonic::ret) {
    std::uint32_t to = 0;
    outcome = m.pop(to) ? Outcome::returned : Outcome::bad_address;
    return false;
  } else if constexpr (op == Mnemonic::call) {
    if (!m.push(position + 1)) {
      outcome = Outcome::bad_address;
      return false;
    }
    outcome = run_routine<program, static_cast<std::size_t>(instruction.operands[0].value)>(m);
    if (outcome != Outcome::returned) return false;
    outcome = Outcome::proceeds;
    return true;
  } else if constexpr (jumps(instruction)) {
    static_assert(instruction.operands[0].kind == Operand::Kind::label,
                  "only the interpreter jumps to computed places");
    constexpr auto to = static_cast<std::size_t>(instruction.operands[0].value);
    bool taken = false;
    if constexpr (op == Mnemonic::loop) {
      taken = count_down(m);
    } else {
      outcome = jump_taken(m.domain(), op, m.flags, taken);
    }
    // Backwards: skip all that is left, and let the next pass start there.
    if (taken) target = to > position ? to : program.size + to;
    return outcome == Outcome::proceeds;
  } else if constexpr (program.size > max_inlined) {
    outcome = execute_shared<without_names(instruction)>(m);
    return outcome == Outcome::proceeds;
  } else {
    outcome = execute<op>(instruction, m);
    return outcome == Outcome::proceeds;
  }
}

template <const Program& program, std::size_t entry, std::size_t first, class M, std::size_t... I>
[[gnu::always_inline]] inline bool pass_over_block(M& m, std::size_t& target, Outcome& outcome,
                                                   std::index_sequence<I...> /*positions*/) {
  return (pass_over<program, entry, first + I>(m, target, outcome) && ...);
}

/// A block in a function of its own: compilers limit how long a fold may be.
template <const Program& program, std::size_t entry, std::size_t first, std::size_t count, class M>
[[gnu::noinline]] bool pass_over_long_block(M& m, std::size_t& target, Outcome& outcome) {
  return pass_over_block<program, entry, first>(m, target, outcome,
                                                std::make_index_sequence<count>{});
}

/// One pass from `first` to the routine's end, in blocks where the routine is long.
template <const Program& program, std::size_t entry, std::size_t first, class M>
[[gnu::always_inline]] inline bool pass(M& m, std::size_t& target, Outcome& outcome) {
  constexpr std::size_t end = end_of_routine(program, entry);
  constexpr std::size_t block = 32;
  if constexpr (program.size <= max_inlined) {
    return pass_over_block<program, entry, first>(m, target, outcome,
                                                  std::make_index_sequence<end - first>{});
  } else if constexpr (first < end) {
    constexpr std::size_t count = first + block < end ? block : end - first;
    return pass_over_long_block<program, entry, first, count>(m, target, outcome) &&
           pass<program, entry, first + count>(m, target, outcome);
  } else {
    return true;
  }
}

template <const Program& program, std::size_t entry, class M>
[[gnu::always_inline]] inline Outcome passes(M& m) {
  std::size_t target = entry;
  Outcome outcome = Outcome::proceeds;
  while (pass<program, entry, entry>(m, target, outcome)) target -= program.size;
  return outcome;
}

template <const Program& program, std::size_t entry, class M>
[[gnu::noinline]] Outcome run_routine(M& m) {
  return passes<program, entry>(m);
}

}  // namespace detail

/// Runs `program` (a variable of static storage) from its first instruction, inlined into the
/// caller. The same outcome and the same machine as run(), at near native speed; for whole programs
/// only, which end by themselves.
template <const Program& program, class M>
[[gnu::always_inline]] inline Outcome run_compiled(M& m) {
  return detail::passes<program, 0>(m);
}

}  // namespace x86model
