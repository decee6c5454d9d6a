/// @file
/// Calls a routine as C does: arguments on the stack, results in DX:AX or in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "x86model/compiled.hpp"
#include "x86model/cosine_table.hpp"
#include "x86model/machine.hpp"
#include "x86model/routine.hpp"
#include "x86model/run.hpp"

namespace x86model {

namespace detail {

// The memory layout, in bytes for 16-bit words: the stack below 0x60, then operands and results.
inline constexpr std::int32_t stack_top = 0x60;
inline constexpr std::int32_t data = stack_top;
inline constexpr std::int32_t bytes_of_value = 4;

/// The number of memory words that a call needs. At half width these words are single bytes.
constexpr std::size_t words_of_memory(Routine routine) {
  const int operands = arity(routine).in + arity(routine).out;
  switch (routine) {
    case Routine::mul:
    case Routine::div:
      return stack_top / 2;
    case Routine::cossin:
    case Routine::xformvec:
    case Routine::concat:
      break;
  }
  return static_cast<std::size_t>(data + operands * bytes_of_value) / 2;
}

/// Word memory with the cosine table in the code segment.
template <int WordBits, std::size_t Words>
class MemoryAndTable : public WordMemory<WordBits, Words> {
 public:
  /// @return false if the table has no word at `address`
  X86MODEL_INLINE bool read_code(std::uint32_t address, std::uint32_t& value) const {
    constexpr std::uint32_t step = WordBits / 8;
    constexpr auto first = static_cast<std::uint32_t>(scaled_bytes<WordBits>(cos_table_address));
    // Wraps to more than any index if the address is below the table.
    const std::uint32_t index = (address - first) / step;
    if (address % step != 0 || index / 2 >= cosine_table.size()) return false;
    value = cosine_table[index / 2] >> (index % 2 == 0 ? 0 : WordBits) & mask(WordBits);
    return true;
  }
};

}  // namespace detail

/// A machine with exactly the memory that a call of `routine` needs.
template <Routine routine, int WordBits>
using CallMachine =
    Machine<WordBits,
            std::conditional_t<routine == Routine::cossin,
                               detail::MemoryAndTable<WordBits, detail::words_of_memory(routine)>,
                               WordMemory<WordBits, detail::words_of_memory(routine)>>>;

namespace detail {

template <class M>
X86MODEL_INLINE void store(M& m, std::int32_t address, std::uint32_t value) {
  constexpr int bits = M::word_bits;
  m.memory.write(static_cast<std::uint32_t>(scaled_bytes<bits>(address)), value);
  m.memory.write(static_cast<std::uint32_t>(scaled_bytes<bits>(address + 2)), value >> bits);
}

template <class M>
X86MODEL_INLINE std::uint32_t load(const M& m, std::int32_t address) {
  constexpr int bits = M::word_bits;
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  m.memory.read(static_cast<std::uint32_t>(scaled_bytes<bits>(address)), low);
  m.memory.read(static_cast<std::uint32_t>(scaled_bytes<bits>(address + 2)), high);
  return low | high << bits;
}

/// Pushes a pointer argument.
template <class M>
X86MODEL_INLINE void push_pointer(M& m, std::int32_t address) {
  m.push(static_cast<std::uint32_t>(scaled_bytes<M::word_bits>(address)));
}

}  // namespace detail

/// Fills the memory of the results with words that count up from `junk`, so that a routine that
/// fails to write one cannot be right by chance.
template <Routine routine, class M>
X86MODEL_INLINE void fill_results_with_junk(M& m, std::uint32_t junk) {
  if constexpr (routine == Routine::mul || routine == Routine::div) return;
  for (int i = 0; i < arity(routine).out; ++i) {
    detail::store(m, detail::data + (arity(routine).in + i) * detail::bytes_of_value,
                  junk + static_cast<std::uint32_t>(i));
  }
}

/// Fills the registers and the memory of the results with values that depend on the operands,
/// because no routine may depend on what its caller leaves there.
template <Routine routine, class M>
X86MODEL_INLINE void fill_with_junk(M& m, std::span<const std::uint32_t> in) {
  std::uint32_t word = 0x9E3779B9U;
  for (const std::uint32_t operand : in) word = (word ^ operand) * 0x01000193U + 1U;
  for (std::size_t r = 0; r < register_count; ++r) {
    m.registers.write(static_cast<Register>(r), Size::dword, word);
    word = word * 0x85EBCA6BU + 0xC2B2AE35U;
  }
  fill_results_with_junk<routine>(m, word);
}

/// Sets up the stack and the operands as a C caller of `routine` does, last argument first. Leaves
/// registers other than SP unchanged and all flags undefined.
/// @param in arity(routine).in words
template <Routine routine, class M>
X86MODEL_INLINE void enter(M& m, std::span<const std::uint32_t> in) {
  using namespace detail;
  constexpr std::int32_t out = data + arity(routine).in * bytes_of_value;
  m.flags = all_undefined;
  m.registers.write(Register::sp, Size::word,
                    static_cast<std::uint32_t>(scaled_bytes<M::word_bits>(stack_top)));
  if constexpr (routine == Routine::mul || routine == Routine::div) {
    for (const std::uint32_t value : {in[1], in[0]}) {
      m.push(value >> M::word_bits);
      m.push(value);
    }
  } else if constexpr (routine == Routine::cossin) {
    push_pointer(m, out + bytes_of_value);
    push_pointer(m, out);
    m.push(in[0]);
  } else {
    for (std::size_t i = 0; i < in.size(); ++i) {
      store(m, data + static_cast<std::int32_t>(i) * bytes_of_value, in[i]);
    }
    push_pointer(m, out);
    push_pointer(m, data + 12 * bytes_of_value);
    push_pointer(m, data);
  }
  m.push(return_to_caller<M::word_bits>);
}

/// Reads the results of `routine`.
/// @param out arity(routine).out words
template <Routine routine, class M>
X86MODEL_INLINE void leave(const M& m, std::span<std::uint32_t> out) {
  using namespace detail;
  if constexpr (routine == Routine::mul || routine == Routine::div) {
    out[0] = m.registers.read(Register::ax, Size::word) | m.registers.read(Register::dx, Size::word)
                                                              << M::word_bits;
  } else {
    for (std::size_t i = 0; i < out.size(); ++i) {
      const auto place = static_cast<std::int32_t>(i) + arity(routine).in;
      out[i] = load(m, data + place * bytes_of_value);
    }
  }
}

/// Calls `routine` by running `code` on the interpreter. `code` may be any program with the
/// routine's arguments, including a mutant.
template <Routine routine, int WordBits, class Observer>
Ending call(std::span<const Instruction> code, std::span<const std::uint32_t> in,
            std::span<std::uint32_t> out, Observer&& observe) {
  CallMachine<routine, WordBits> m;
  fill_with_junk<routine>(m, in);
  enter<routine>(m, in);
  const Ending ending = run(code, m, observe);
  leave<routine>(m, out);
  return ending;
}

template <Routine routine, int WordBits>
Ending call(std::span<const Instruction> code, std::span<const std::uint32_t> in,
            std::span<std::uint32_t> out) {
  return call<routine, WordBits>(code, in, out, [](std::size_t, const auto&) {});
}

/// Calls the compiled routine for a batch of cases.
/// @param in  cases * arity.in words
/// @param out cases * arity.out words; those of a faulting case are unspecified
/// @param outcomes one per case
template <Routine routine, Target target, Build build, int WordBits>
void call_compiled(std::span<const std::uint32_t> in, std::span<std::uint32_t> out,
                   std::span<Outcome> outcomes) {
  constexpr auto taken = static_cast<std::size_t>(arity(routine).in);
  constexpr auto given = static_cast<std::size_t>(arity(routine).out);
  CallMachine<routine, WordBits> ready;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if constexpr (routine == Routine::mul || routine == Routine::div) {
      // A new machine per case stays in processor registers.
      CallMachine<routine, WordBits> m;
      fill_with_junk<routine>(m, in.subspan(i * taken, taken));
      enter<routine>(m, in.subspan(i * taken, taken));
      outcomes[i] = run_compiled<program<routine, target, build>>(m);
      leave<routine>(m, out.subspan(i * given, given));
    } else {
      fill_with_junk<routine>(ready, in.subspan(i * taken, taken));
      enter<routine>(ready, in.subspan(i * taken, taken));
      outcomes[i] = run_compiled<program<routine, target, build>>(ready);
      leave<routine>(ready, out.subspan(i * given, given));
    }
  }
}

}  // namespace x86model
