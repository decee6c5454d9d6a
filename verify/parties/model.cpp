// The register-level model: the programs of the listings, compiled.
#include <algorithm>
#include <array>
#include <vector>

#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/outcome.hpp"
#include "verify/parties/parties.hpp"
#include "x86model/call.hpp"
#include "x86model/with_routine.hpp"

namespace fixproof::parties {

namespace {

namespace x86 = x86model;

template <x86::Routine routine, cases::Build build, int word_bits>
void answer_compiled(const Cases& asked) {
  std::array<x86::Outcome, 256> outcomes;
  constexpr auto in = static_cast<std::size_t>(x86::arity(routine).in);
  constexpr auto out = static_cast<std::size_t>(x86::arity(routine).out);
  for (std::size_t done = 0; done < asked.endings.size(); done += outcomes.size()) {
    const std::size_t cases = std::min(outcomes.size(), asked.endings.size() - done);
    const auto ends = std::span(outcomes).first(cases);
    x86::call_compiled<routine, machine_code::model_target(build.target),
                       machine_code::model_build(build), word_bits>(
        asked.in.subspan(done * in, cases * in), asked.out.subspan(done * out, cases * out), ends);
    for (std::size_t i = 0; i < cases; ++i) asked.endings[done + i] = ending_of(ends[i]);
  }
}

template <x86::Routine routine, cases::Target target, bool round>
void answer_compiled(const cases::Variant& v, const Cases& asked) {
  // CosSin has no switch, so it needs only one program.
  constexpr bool rounds = round || routine == x86::Routine::cossin;
  constexpr cases::Build build{target, rounds, rounds};
  if constexpr (target == cases::Target::i386 && round &&
                (routine == x86::Routine::mul || routine == x86::Routine::div ||
                 routine == x86::Routine::concat)) {
    constexpr cases::Build chapter_52{.target = target, .chapter_52 = true};
    if (v.build.chapter_52) return answer_compiled<routine, chapter_52, 16>(asked);
  }
  if constexpr (target == cases::Target::i8088 && routine == x86::Routine::concat) {
    constexpr cases::Build repaired{
        .target = target, .mul_round = round, .div_round = round, .repaired = true};
    if (v.build.repaired) return answer_compiled<routine, repaired, 16>(asked);
  }
  if constexpr (routine == x86::Routine::mul || routine == x86::Routine::div) {
    if (v.format == cases::q8_8) return answer_compiled<routine, build, 8>(asked);
  }
  answer_compiled<routine, build, 16>(asked);
}

template <x86::Routine routine>
void answer_compiled(const cases::Variant& v, const Cases& asked) {
  using enum cases::Target;
  if (v.build.target == i386) {
    cases::rounds(v) ? answer_compiled<routine, i386, true>(v, asked)
                     : answer_compiled<routine, i386, false>(v, asked);
  } else {
    cases::rounds(v) ? answer_compiled<routine, i8088, true>(v, asked)
                     : answer_compiled<routine, i8088, false>(v, asked);
  }
}

class Model final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "model"; }
  [[nodiscard]] std::string identity() const override { return "the listings, compiled"; }
  [[nodiscard]] bool answers(const cases::Variant& v) const override { return has_program(v); }
  void fill(const cases::Variant& v, const Cases& asked) const override {
    x86::with_routine(machine_code::key_of(v).routine,
                      [&]<x86::Routine routine> { answer_compiled<routine>(v, asked); });
  }
};

}  // namespace

std::unique_ptr<Party> make_model() { return std::make_unique<Model>(); }

}  // namespace fixproof::parties
