#include "verify/parties/interpreter.hpp"

#include <stdexcept>
#include <utility>

#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/not_kept.hpp"
#include "verify/parties/outcome.hpp"
#include "verify/parties/parties.hpp"
#include "x86model/call.hpp"
#include "x86model/with_routine.hpp"

namespace fixproof::parties {

namespace {

namespace x86 = x86model;

template <x86::Routine routine, int word_bits>
Ending answer(std::span<const x86::Instruction> code, x86::CallMachine<routine, word_bits>& m,
              std::span<const std::uint32_t> in, std::span<std::uint32_t> out) {
  x86::fill_with_junk<routine>(m, in);
  x86::enter<routine>(m, in);
  const auto entered = m.registers;
  const Ending ending = ending_of(x86::run(code, m).outcome);
  x86::leave<routine>(m, out);
  if (ending != Ending::value) return ending;
  return not_kept<routine>(entered, m, in).empty() ? Ending::value : Ending::broken;
}

template <x86::Routine routine, int word_bits>
void answer_all(std::span<const x86::Instruction> code, const Cases& asked) {
  constexpr auto in = static_cast<std::size_t>(x86::arity(routine).in);
  constexpr auto out = static_cast<std::size_t>(x86::arity(routine).out);
  x86::CallMachine<routine, word_bits> fresh;
  // The stack holds junk, as if from earlier calls.
  for (std::int32_t at = 0; at < x86::detail::stack_top; at += x86::detail::bytes_of_value) {
    x86::detail::store(fresh, at, 0x6D2B79F5U * static_cast<std::uint32_t>(at + 1));
  }
  for (std::size_t i = 0; i < asked.endings.size(); ++i) {
    // Each case starts from a fresh machine, because a broken program can write anywhere.
    auto machine = fresh;
    asked.endings[i] = answer<routine, word_bits>(code, machine, asked.in.subspan(i * in, in),
                                                  asked.out.subspan(i * out, out));
  }
}

void answer(const cases::Variant& v, std::span<const x86::Instruction> code, const Cases& asked) {
  x86::with_routine(machine_code::key_of(v).routine, [&]<x86::Routine routine> {
    if constexpr (routine == x86::Routine::mul || routine == x86::Routine::div) {
      if (v.format == cases::q8_8) return answer_all<routine, 8>(code, asked);
    }
    answer_all<routine, 16>(code, asked);
  });
}

class Interpreter final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "interpreter"; }
  [[nodiscard]] std::string identity() const override { return "the listings, step by step"; }
  [[nodiscard]] bool answers(const cases::Variant& v) const override { return has_program(v); }
  void fill(const cases::Variant& v, const Cases& asked) const override {
    parties::answer(v, program_of(v).instructions(), asked);
  }
};

class InterpreterOf final : public Party {
 public:
  InterpreterOf(std::string name, const x86::Program& program)
      : name_(std::move(name)), program_(program) {}
  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] std::string identity() const override { return "one program, step by step"; }
  [[nodiscard]] bool answers(const cases::Variant& v) const override { return has_program(v); }
  void fill(const cases::Variant& v, const Cases& asked) const override {
    parties::answer(v, program_.instructions(), asked);
  }

 private:
  std::string name_;
  x86::Program program_;
};

}  // namespace

x86::Program program_of(const cases::Variant& v) {
  if (!is_routine(v)) throw std::invalid_argument("no routine of FIXED.ASM");
  const machine_code::ProgramKey key = machine_code::key_of(v);
  return x86::assemble(x86::listing(key.routine, key.target), key.build);
}

std::unique_ptr<Party> make_interpreter() { return std::make_unique<Interpreter>(); }

std::unique_ptr<Party> make_interpreter_of(std::string name, const x86::Program& program) {
  return std::make_unique<InterpreterOf>(std::move(name), program);
}

}  // namespace fixproof::parties
