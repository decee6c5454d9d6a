// The register-level model: the listings' programs, compiled or step by step.
#include <algorithm>
#include <array>
#include <vector>

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

/// The build for one setting of the switch that matters.
constexpr x86::Build build(x86::Routine routine, bool round, bool chapter_52) {
  x86::Build b{.chapter_52 = chapter_52};
  if (routine == x86::Routine::div) b.div_rounding = round;
  if (routine != x86::Routine::div && routine != x86::Routine::cossin) b.mul_rounding = round;
  return b;
}

template <x86::Routine routine, x86::Target target, bool round, bool chapter_52, int word_bits>
void answer_compiled(const Batch& batch) {
  std::array<x86::Outcome, 256> outcomes;  // filled below
  constexpr auto in = static_cast<std::size_t>(x86::arity(routine).in);
  constexpr auto out = static_cast<std::size_t>(x86::arity(routine).out);
  for (std::size_t done = 0; done < batch.endings.size(); done += outcomes.size()) {
    const std::size_t cases = std::min(outcomes.size(), batch.endings.size() - done);
    const auto ends = std::span(outcomes).first(cases);
    x86::call_compiled<routine, target, build(routine, round, chapter_52), word_bits>(
        batch.in.subspan(done * in, cases * in), batch.out.subspan(done * out, cases * out), ends);
    for (std::size_t i = 0; i < cases; ++i) batch.endings[done + i] = ending_of(ends[i]);
  }
}

template <x86::Routine routine, x86::Target target, bool round>
void answer_compiled(const Variant& v, const Batch& batch) {
  if constexpr (target == x86::Target::i386 && round &&
                (routine == x86::Routine::mul || routine == x86::Routine::div ||
                 routine == x86::Routine::concat)) {
    if (v.chapter_52) return answer_compiled<routine, target, round, true, 16>(batch);
  }
  if constexpr (routine == x86::Routine::mul || routine == x86::Routine::div) {
    if (v.fraction_bits == 8) return answer_compiled<routine, target, round, false, 8>(batch);
  }
  answer_compiled<routine, target, round, false, 16>(batch);
}

template <x86::Routine routine>
void answer_compiled(const Variant& v, const Batch& batch) {
  using enum x86::Target;
  if (v.target == Target::i386) {
    rounds(v) ? answer_compiled<routine, i386, true>(v, batch)
              : answer_compiled<routine, i386, false>(v, batch);
  } else {
    rounds(v) ? answer_compiled<routine, i8088, true>(v, batch)
              : answer_compiled<routine, i8088, false>(v, batch);
  }
}

bool model_answers(const Variant& v) {
  if (!is_routine(v)) return false;
  const bool has_half_width = v.operation == Operation::mul || v.operation == Operation::div;
  const bool has_chapter_52 = v.target == Target::i386 && rounds(v) && v.fraction_bits == 16 &&
                              (has_half_width || v.operation == Operation::concat);
  return (v.fraction_bits == 16 || has_half_width) && (!v.chapter_52 || has_chapter_52);
}

class Model final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "model"; }
  [[nodiscard]] bool answers(const Variant& v) const override { return model_answers(v); }
  void answer(const Variant& v, const Batch& batch) const override {
    using enum x86::Routine;
    switch (v.operation) {
      case Operation::mul:
        return answer_compiled<mul>(v, batch);
      case Operation::div:
        return answer_compiled<div>(v, batch);
      case Operation::cossin:
        return answer_compiled<cossin>(v, batch);
      case Operation::xformvec:
        return answer_compiled<xformvec>(v, batch);
      default:
        return answer_compiled<concat>(v, batch);
    }
  }
};

template <x86::Routine routine, int word_bits>
void answer_stepwise(const Variant& v, const Batch& batch) {
  const auto target = v.target == Target::i386 ? x86::Target::i386 : x86::Target::i8088;
  const x86::Program program =
      x86::assemble(x86::listing(routine, target), build(routine, rounds(v), v.chapter_52));
  constexpr auto in = static_cast<std::size_t>(x86::arity(routine).in);
  constexpr auto out = static_cast<std::size_t>(x86::arity(routine).out);
  for (std::size_t i = 0; i < batch.endings.size(); ++i) {
    const x86::Ending ending = x86::call<routine, word_bits>(
        program.instructions(), batch.in.subspan(i * in, in), batch.out.subspan(i * out, out));
    batch.endings[i] = ending_of(ending.outcome);
  }
}

class Interpreter final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "interpreter"; }
  [[nodiscard]] bool answers(const Variant& v) const override { return model_answers(v); }
  void answer(const Variant& v, const Batch& batch) const override {
    using enum x86::Routine;
    const bool half = v.fraction_bits == 8;
    switch (v.operation) {
      case Operation::mul:
        return half ? answer_stepwise<mul, 8>(v, batch) : answer_stepwise<mul, 16>(v, batch);
      case Operation::div:
        return half ? answer_stepwise<div, 8>(v, batch) : answer_stepwise<div, 16>(v, batch);
      case Operation::cossin:
        return answer_stepwise<cossin, 16>(v, batch);
      case Operation::xformvec:
        return answer_stepwise<xformvec, 16>(v, batch);
      default:
        return answer_stepwise<concat, 16>(v, batch);
    }
  }
};

}  // namespace

std::unique_ptr<Party> make_model() { return std::make_unique<Model>(); }
std::unique_ptr<Party> make_interpreter() { return std::make_unique<Interpreter>(); }

}  // namespace fixproof
