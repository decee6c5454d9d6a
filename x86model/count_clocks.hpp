/// @file
/// Counts the clocks of a whole run: an observer for run(), and a call() that uses it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "x86model/bus.hpp"
#include "x86model/call.hpp"
#include "x86model/clocks.hpp"

namespace x86model {

namespace detail {

/// The instruction to which a return leads; null for the routine's caller.
template <class M>
const Instruction* return_target(std::span<const Instruction> code, const M& m) {
  std::uint32_t to = return_to_caller<M::word_bits>;
  m.read_top(to);
  return to < code.size() ? &code[to] : nullptr;
}

/// The instruction at `position`, with the inputs from the current state of the machine.
template <class M>
Execution execution_at(std::span<const Instruction> code, std::size_t position, const M& m) {
  Execution execution{.instruction = code[position]};
  const Mnemonic op = execution.instruction.mnemonic;
  const Operand& operand = execution.instruction.operands[0];
  if (is_control_flow(op)) {
    jump_taken(m.domain(), op, m.flags, execution.taken);
    if (op == Mnemonic::loop) {
      execution.taken = m.registers.read(Register::cx, Size::word) != 1;
      if (position + 1 < code.size()) execution.next = &code[position + 1];
    }
    if (op == Mnemonic::ret) {
      execution.next = return_target(code, m);
    } else if (execution.taken) {
      const std::size_t to =
          operand.kind == Operand::Kind::reg
              ? position_at(code, m.registers.read(operand.reg, operand.size) - code_address)
              : static_cast<std::size_t>(operand.value);
      if (to < code.size()) execution.next = &code[to];
    }
  } else if (is_multiply(op) || is_divide(op)) {
    execution.low = m.registers.read(Register::ax, operand.size);
    execution.high = m.registers.read(Register::dx, operand.size);
    m.read(operand, operand.size, execution.operand);
  }
  return execution;
}

}  // namespace detail

/// Adds up the clocks of the instructions that run() executes and, on an 8088, the bytes on its
/// bus. An instruction that faults adds none. Only for machines with 16-bit words: no other exists
/// to be timed.
///
/// Copies share what they have looked up, so a copy must not count in another thread.
class ClockCounter {
 public:
  /// @param code the code that runs; must outlive the counter
  ClockCounter(std::span<const Instruction> code, Cpu cpu)
      : code_(code), cpu_(cpu), known_(std::make_shared<std::vector<Known>>(code.size())) {}

  /// @throws std::invalid_argument if the processor does not have the instruction
  template <class M>
  void before(std::size_t position, const M& m) {
    static_assert(M::word_bits == 16);
    Execution execution = detail::execution_at(code_, position, m);
    execution.previous = previous_;
    previous_ = &code_[position];
    const Mnemonic op = previous_->mnemonic;
    Known& known = (*known_)[position];
    const bool by_operands = detail::is_multiply(op) || detail::is_divide(op);
    if (!by_operands && known.is_of(execution)) {
      pending_ = known.clocks;
      return;
    }
    const auto range = clocks(cpu_, execution);
    if (!range) {
      throw std::invalid_argument("no clocks on a " + std::string(name_of(cpu_)) +
                                  " for the instruction at " + std::to_string(position));
    }
    pending_ = *range;
    known = {.is_there = true,
             .previous = execution.previous,
             .next = execution.next,
             .taken = execution.taken,
             .clocks = *range,
             .bus = cpu_ == Cpu::i8088 ? bus_bytes(*previous_) : BusBytes{}};
  }

  template <class M>
  void operator()(std::size_t position, const M& /*after*/) {
    total_ += pending_;
    bus_ += (*known_)[position].bus;
  }

  [[nodiscard]] Range total() const { return total_; }
  /// Zero on processors other than the 8088; see bus.hpp.
  [[nodiscard]] const BusBytes& bus() const { return bus_; }

 private:
  /// The clocks and bytes of the last execution of an instruction, and what they depend on apart
  /// from factors and divisors.
  struct Known {
    bool is_there = false;
    const Instruction* previous = nullptr;
    const Instruction* next = nullptr;
    bool taken = false;
    Range clocks;
    BusBytes bus;

    [[nodiscard]] bool is_of(const Execution& e) const {
      return is_there && previous == e.previous && next == e.next && taken == e.taken;
    }
  };

  std::span<const Instruction> code_;
  Cpu cpu_;
  std::shared_ptr<std::vector<Known>> known_;  ///< one for each instruction
  const Instruction* previous_ = nullptr;
  Range pending_;
  Range total_;
  BusBytes bus_;
};

/// How a call ended, and its clocks and bytes from the first instruction to the end. Excludes the
/// caller's pushes and CALL.
struct ClockedEnding {
  Ending ending{};
  Range clocks;  ///< from the tables
  BusBytes bus;  ///< on an 8088
};

/// Calls `routine` at full width and counts clocks. `code` is as for call().
/// @throws std::invalid_argument if the processor cannot run the code
template <Routine routine>
ClockedEnding count_clocks(std::span<const Instruction> code, std::span<const std::uint32_t> in,
                           Cpu cpu) {
  std::array<std::uint32_t, 12> out{};
  ClockCounter counter(code, cpu);
  const Ending ending = call<routine, 16>(
      code, in, std::span(out).first(static_cast<std::size_t>(arity(routine).out)), counter);
  return {ending, counter.total(), counter.bus()};
}

}  // namespace x86model
