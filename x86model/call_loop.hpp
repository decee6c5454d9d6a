/// @file
/// Calls an inner loop as the source has it called: operands in registers.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "x86model/call.hpp"
#include "x86model/loop.hpp"
#include "x86model/machine.hpp"
#include "x86model/run.hpp"

namespace x86model {

/// A machine that runs the loops, its memory that of the caller.
using LoopMachine = Machine<16, ByteMemory>;

/// Words as the loop's registers hold them. What a loop does not have is ignored.
struct LoopCall {
  /// At least 1, for a counted loop with 0 goes on for 65,536 turns or more; unrolled 0 to
  /// loops::most_pixels. For GouraudWords an even number, and a counted one at least 2.
  std::uint32_t pixels = 1;
  /// DI or EDI: the address of the first pixel, for DepthTest its index.
  std::uint32_t place = 0;
  std::uint32_t value = 0;     ///< EDX: intensity, depth, or column
  std::uint32_t step = 0;      ///< EBP
  std::uint32_t row = 0;       ///< ESI, of a texture
  std::uint32_t row_step = 0;  ///< its step: in memory at IncJ, or unrolled in ECX
  std::uint8_t colour = 0;     ///< AL, of DepthTest
};

/// Sets up registers, IncJ and the return address. What the loop does not take stays as it is;
/// flags become undefined.
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
  detail::push(m, return_to_caller<16>);
}

/// Calls a loop on the plain interpreter. `code` is code_of() the form, or of a broken program.
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

/// A form, and a call of it.
struct LoopPart {
  LoopForm form;
  LoopCall call;
};

/// The calls that draw a span of 1 to loops::most_pixels pixels: the span in one, but for words,
/// whose odd first pixel and odd last one are drawn as bytes.
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
