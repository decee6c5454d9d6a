/// @file
/// Calls an inner loop as its source does: operands in registers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "x86model/call.hpp"
#include "x86model/loop.hpp"
#include "x86model/machine.hpp"
#include "x86model/run.hpp"

namespace x86model {

/// A machine that runs the loops in the caller's memory.
using LoopMachine = Machine<16, ByteMemory>;

/// The operands of a loop. A loop ignores those that it does not use.
struct LoopCall {
  /// At least 1: with 0 a counted loop runs for 65,536 iterations or more. Unrolled: 0 to
  /// loops::max_pixels. For GouraudWords an even number, at least 2 if counted.
  std::uint32_t pixels = 1;
  /// DI or EDI: the address of the first pixel; for DepthTest its index.
  std::uint32_t place = 0;
  std::uint32_t value = 0;     ///< EDX: intensity, depth, or column
  std::uint32_t step = 0;      ///< EBP
  std::uint32_t row = 0;       ///< ESI, of a texture
  std::uint32_t row_step = 0;  ///< step of `row`: in memory at IncJ, or in ECX if unrolled
  std::uint8_t colour = 0;     ///< AL, of DepthTest
};

/// Sets up registers, IncJ and the return address. Leaves unused registers unchanged and all flags
/// undefined.
template <class M>
void enter_loop(const LoopForm& form, M& m, const LoopCall& call) {
  static_assert(M::word_bits == 16, "the loops exist at full width only");
  const auto set = [&](Register r, std::uint32_t value) {
    m.registers.write(r, Size::dword, value);
  };
  m.flags = all_undefined;
  set(Register::cx, call.pixels);
  set(Register::dx, call.value);
  set(Register::bp, call.step);
  set(Register::di, call.place);
  if (form.loop == Loop::texture) {
    set(Register::si, call.row);
    detail::store(m, address_of(Symbol::inc_j), call.row_step);
  }
  if (form.loop == Loop::depth_test) m.registers.write(Register::ax, Size::byte, call.colour);
  if (form.counting == Counting::unrolled) {
    set(Register::bx, code_address + entry_of(form, call.pixels));
    set(Register::cx, call.row_step);
  }
  m.registers.write(Register::sp, Size::word, detail::stack_top);
  m.push(return_to_caller<16>);
}

/// Calls a loop on the interpreter. `code` is code_of() the form, or a mutant of it.
template <class Observer>
Ending call_loop(const LoopForm& form, std::span<const Instruction> code, LoopMachine& m,
                 const LoopCall& call, Observer&& observe, std::uint64_t limit = 100'000) {
  enter_loop(form, m, call);
  return run(code, m, observe, limit);
}

inline Ending call_loop(const LoopForm& form, std::span<const Instruction> code, LoopMachine& m,
                        const LoopCall& call) {
  return call_loop(form, code, m, call, [](std::size_t, const LoopMachine&) {});
}

/// A form and one call of it.
struct LoopPart {
  LoopForm form;
  LoopCall call;
};

/// The calls that draw a span of 1 to loops::max_pixels pixels: one call, except that for words an
/// odd first or last pixel is drawn as a byte.
inline std::vector<LoopPart> parts_of(const LoopForm& form, const LoopCall& span) {
  if (form.loop != Loop::gouraud_word) return {{form, span}};
  LoopForm bytes = form;
  bytes.loop = Loop::gouraud_byte;
  std::vector<LoopPart> parts;
  LoopCall rest = span;
  const auto take = [&](const LoopForm& by, std::uint32_t pixels) {
    if (pixels == 0) return;
    parts.push_back({by, rest});
    parts.back().call.pixels = pixels;
    rest.pixels -= pixels;
    rest.place += pixels;
    rest.value += pixels * rest.step;
  };
  take(bytes, span.place % 2);
  take(form, rest.pixels / 2 * 2);
  take(bytes, rest.pixels);
  return parts;
}

}  // namespace x86model
