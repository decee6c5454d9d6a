#include "app/web/builds.hpp"

#include <array>
#include <span>

#include "app/web/words.hpp"
#include "fixed/fixed.hpp"
#include "oracle/exact.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/with_number.hpp"
#include "x86model/call.hpp"

namespace fixproof::web {

namespace {

using Answer = std::optional<std::uint64_t>;

template <x86model::Routine routine, int word_bits>
Answer by_model(const cases::Build& build, std::uint32_t a, std::uint32_t b) {
  const auto program =
      x86model::assemble(x86model::listing(routine, machine_code::model_target(build.target)),
                         machine_code::model_build(build));
  const std::array in{a, b};
  std::array<std::uint32_t, 1> out{};
  const auto ending = x86model::call<routine, word_bits>(program.instructions(), in, out);
  return ending.outcome == x86model::Outcome::returned ? Answer(out[0]) : std::nullopt;
}

template <int fraction_bits>
Answer by_type(const cases::Build& build, bool divides, std::uint32_t a, std::uint32_t b) {
  return parties::with_number<fraction_bits>(
      build, [&]<class N>(std::type_identity<N> /*type*/) -> Answer {
        const auto n = parties::number_of<N>(a);
        const auto d = parties::number_of<N>(b);
        if (!divides) return parties::word_of(n * d);
        const auto quotient = try_divide(n, d);
        return quotient ? Answer(parties::word_of(*quotient)) : std::nullopt;
      });
}

Answer by_oracle(const cases::Build& build, bool divides, std::uint32_t a, std::uint32_t b,
                 int fraction_bits) {
  const bool i386 = build.target == cases::Target::i386;
  if (!divides) {
    using enum oracle::Rounding;
    return oracle::mul(a, b,
                       build.mul_round ? (i386 ? half_up : half_away) : (i386 ? floor : truncate),
                       fraction_bits);
  }
  using enum oracle::DivideRule;
  const auto rule = build.div_round ? (i386 ? i386_rounded : i8088_rounded)
                                    : (i386 ? i386_unrounded : i8088_unrounded);
  const auto quotient = oracle::div(a, b, rule, fraction_bits);
  return quotient ? Answer(*quotient) : std::nullopt;
}

template <int word_bits>
Answer by_model(const cases::Build& build, bool divides, std::uint32_t a, std::uint32_t b) {
  return divides ? by_model<x86model::Routine::div, word_bits>(build, a, b)
                 : by_model<x86model::Routine::mul, word_bits>(build, a, b);
}

}  // namespace

std::vector<BuildAnswer> answers_of_builds(Operation operation, const cases::Format& format,
                                           std::uint32_t a, std::uint32_t b) {
  const bool divides = operation == Operation::div;
  const bool full = format == cases::q16_16;
  if ((!divides && operation != Operation::mul) || (!full && format != cases::q8_8)) return {};
  std::vector<BuildAnswer> answers;
  for (const cases::Build& build : cases::uniform_builds) {
    const bool i386 = build.target == cases::Target::i386;
    const Answer model =
        full ? by_model<16>(build, divides, a, b) : by_model<8>(build, divides, a, b);
    const Answer type = full ? by_type<16>(build, divides, a, b) : by_type<8>(build, divides, a, b);
    const Answer oracle = by_oracle(build, divides, a, b, format.fraction_bits);
    answers.push_back(
        {.name =
             std::string(i386 ? "386" : "8088") + (build.mul_round ? ", rounded" : ", not rounded"),
         .link =
             full ? std::string(i386 ? "i386" : "i8088") + (build.mul_round ? "-on" : "-off") : "",
         .word = model,
         .agrees = model == type && model == oracle});
  }
  return answers;
}

}  // namespace fixproof::web
