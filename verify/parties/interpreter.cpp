#include "verify/parties/interpreter.hpp"

#include <array>
#include <stdexcept>
#include <utility>

#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/parties.hpp"
#include "x86model/call.hpp"

namespace fixproof {

namespace {

namespace x86 = x86model;

Ending ending_of(x86::Outcome outcome) {
  switch (outcome) {
    case x86::Outcome::returned:
      return Ending::value;
    case x86::Outcome::divide_error:
      return Ending::divide_error;
    case x86::Outcome::undefined_flag:
      return Ending::undefined_flag;
    default:
      return Ending::broken;
  }
}

/// What a C caller counts on finding again.
template <class M>
std::array<std::uint32_t, 3> kept_registers(const M& m) {
  using enum x86::Register;
  return {m.registers.read(si, x86::Size::dword), m.registers.read(di, x86::Size::dword),
          m.registers.read(bp, x86::Size::dword)};
}

/// Whether a transform has left its operands as they were. The divides need not: see finding 11.
template <x86::Routine routine, class M>
bool kept_operands(const M& m, std::span<const std::uint32_t> in) {
  if constexpr (routine == x86::Routine::xformvec || routine == x86::Routine::concat) {
    for (std::size_t i = 0; i < in.size(); ++i) {
      const auto at = static_cast<std::int32_t>(i) * x86::detail::bytes_of_value;
      if (x86::detail::load(m, x86::detail::data + at) != in[i]) return false;
    }
  }
  return true;
}

template <x86::Routine routine, int word_bits>
Ending answer(std::span<const x86::Instruction> code, x86::CallMachine<routine, word_bits>& m,
              std::span<const std::uint32_t> in, std::span<std::uint32_t> out) {
  constexpr auto low_bits = x86::alu::mask(word_bits);
  x86::leave_junk<routine>(m, in);
  x86::enter<routine>(m, in);
  const auto before = kept_registers(m);
  const std::uint32_t top = m.registers.read(x86::Register::sp, x86::Size::word);
  const Ending ending = ending_of(x86::run(code, m).outcome);
  x86::leave<routine>(m, out);
  const bool balanced =
      m.registers.read(x86::Register::sp, x86::Size::word) == ((top + word_bits / 8) & low_bits);
  if (ending != Ending::value) return ending;
  const bool kept = balanced && kept_registers(m) == before && kept_operands<routine>(m, in);
  return kept ? Ending::value : Ending::broken;
}

template <x86::Routine routine, int word_bits>
void answer_all(std::span<const x86::Instruction> code, const Batch& batch) {
  constexpr auto in = static_cast<std::size_t>(x86::arity(routine).in);
  constexpr auto out = static_cast<std::size_t>(x86::arity(routine).out);
  x86::CallMachine<routine, word_bits> fresh;
  if constexpr (routine == x86::Routine::cossin) x86::load_cosine_table(fresh);
  // The stack holds what earlier calls have left there.
  for (std::int32_t at = 0; at < x86::detail::stack_top; at += x86::detail::bytes_of_value) {
    x86::detail::store(fresh, at, 0x6D2B79F5U * static_cast<std::uint32_t>(at + 1));
  }
  for (std::size_t i = 0; i < batch.endings.size(); ++i) {
    // Nothing is left over from one case to the next, whatever a broken program has written.
    auto machine = fresh;
    batch.endings[i] = answer<routine, word_bits>(code, machine, batch.in.subspan(i * in, in),
                                                  batch.out.subspan(i * out, out));
  }
}

void answer(const Variant& v, std::span<const x86::Instruction> code, const Batch& batch) {
  using enum x86::Routine;
  const bool half = v.fraction_bits == 8;
  switch (key_of(v).routine) {
    case mul:
      return half ? answer_all<mul, 8>(code, batch) : answer_all<mul, 16>(code, batch);
    case div:
      return half ? answer_all<div, 8>(code, batch) : answer_all<div, 16>(code, batch);
    case cossin:
      return answer_all<cossin, 16>(code, batch);
    case xformvec:
      return answer_all<xformvec, 16>(code, batch);
    case concat:
      return answer_all<concat, 16>(code, batch);
  }
}

class Interpreter final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "interpreter"; }
  [[nodiscard]] bool answers(const Variant& v) const override { return has_program(v); }
  void answer(const Variant& v, const Batch& batch) const override {
    fixproof::answer(v, program_of(v).instructions(), batch);
  }
};

class InterpreterOf final : public Party {
 public:
  InterpreterOf(std::string name, const x86::Program& program)
      : name_(std::move(name)), program_(program) {}
  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] bool answers(const Variant& v) const override { return has_program(v); }
  void answer(const Variant& v, const Batch& batch) const override {
    fixproof::answer(v, program_.instructions(), batch);
  }

 private:
  std::string name_;
  x86::Program program_;
};

}  // namespace

x86::Program program_of(const Variant& v) {
  if (!is_routine(v)) throw std::invalid_argument("no routine of FIXED.ASM");
  const ProgramKey key = key_of(v);
  return x86::assemble(x86::listing(key.routine, key.target), key.build);
}

std::unique_ptr<Party> make_interpreter() { return std::make_unique<Interpreter>(); }

std::unique_ptr<Party> make_interpreter_of(std::string name, const x86::Program& program) {
  return std::make_unique<InterpreterOf>(std::move(name), program);
}

}  // namespace fixproof
