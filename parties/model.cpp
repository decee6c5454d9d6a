// The register-level model: the programs of the listings, compiled.
#include <algorithm>
#include <array>
#include <vector>

#include "parties/outcome.hpp"
#include "parties/parties.hpp"
#include "x86model/call.hpp"

namespace fixproof::parties {

namespace {

namespace x86 = x86model;

/// The chapter that prints the routine, or its repaired form.
enum class Form { chapter_54, chapter_52, repaired };

constexpr x86::Build build(x86::Routine routine, bool round, Form form) {
  x86::Build b{.chapter_52 = form == Form::chapter_52, .repaired = form == Form::repaired};
  if (routine == x86::Routine::div) b.div_rounding = round;
  if (routine != x86::Routine::div && routine != x86::Routine::cossin) b.mul_rounding = round;
  return b;
}

template <x86::Routine routine, x86::Target target, bool round, Form form, int word_bits>
void answer_compiled(const Batch& batch) {
  std::array<x86::Outcome, 256> outcomes;
  constexpr auto in = static_cast<std::size_t>(x86::arity(routine).in);
  constexpr auto out = static_cast<std::size_t>(x86::arity(routine).out);
  for (std::size_t done = 0; done < batch.endings.size(); done += outcomes.size()) {
    const std::size_t cases = std::min(outcomes.size(), batch.endings.size() - done);
    const auto ends = std::span(outcomes).first(cases);
    x86::call_compiled<routine, target, build(routine, round, form), word_bits>(
        batch.in.subspan(done * in, cases * in), batch.out.subspan(done * out, cases * out), ends);
    for (std::size_t i = 0; i < cases; ++i) batch.endings[done + i] = ending_of(ends[i]);
  }
}

template <x86::Routine routine, x86::Target target, bool round>
void answer_compiled(const cases::Variant& v, const Batch& batch) {
  if constexpr (target == x86::Target::i386 && round &&
                (routine == x86::Routine::mul || routine == x86::Routine::div ||
                 routine == x86::Routine::concat)) {
    if (v.build.chapter_52)
      return answer_compiled<routine, target, round, Form::chapter_52, 16>(batch);
  }
  if constexpr (target == x86::Target::i8088 && routine == x86::Routine::concat) {
    if (v.build.repaired) return answer_compiled<routine, target, round, Form::repaired, 16>(batch);
  }
  if constexpr (routine == x86::Routine::mul || routine == x86::Routine::div) {
    if (v.fraction_bits == 8)
      return answer_compiled<routine, target, round, Form::chapter_54, 8>(batch);
  }
  answer_compiled<routine, target, round, Form::chapter_54, 16>(batch);
}

template <x86::Routine routine>
void answer_compiled(const cases::Variant& v, const Batch& batch) {
  using enum x86::Target;
  if (v.build.target == cases::Target::i386) {
    cases::rounds(v) ? answer_compiled<routine, i386, true>(v, batch)
                     : answer_compiled<routine, i386, false>(v, batch);
  } else {
    cases::rounds(v) ? answer_compiled<routine, i8088, true>(v, batch)
                     : answer_compiled<routine, i8088, false>(v, batch);
  }
}

class Model final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "model"; }
  [[nodiscard]] bool answers(const cases::Variant& v) const override { return has_program(v); }
  void fill(const cases::Variant& v, const Batch& batch) const override {
    using enum x86::Routine;
    switch (v.operation) {
      case cases::Operation::mul:
        return answer_compiled<mul>(v, batch);
      case cases::Operation::div:
        return answer_compiled<div>(v, batch);
      case cases::Operation::cossin:
        return answer_compiled<cossin>(v, batch);
      case cases::Operation::xformvec:
        return answer_compiled<xformvec>(v, batch);
      default:
        return answer_compiled<concat>(v, batch);
    }
  }
};

}  // namespace

std::unique_ptr<Party> make_model() { return std::make_unique<Model>(); }

}  // namespace fixproof::parties
