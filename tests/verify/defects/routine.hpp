/// @file
/// Runs the model's routines, step by step, in any build.
#pragma once

#include <array>
#include <cstdint>
#include <ostream>
#include <vector>

#include "verify/parties/answer.hpp"
#include "x86model/call.hpp"

namespace defects {

namespace x86 = x86model;
using Words = std::vector<std::uint32_t>;

inline constexpr std::array targets{x86::Target::i386, x86::Target::i8088};

struct Answer {
  x86::Outcome outcome = x86::Outcome::returned;
  Words words;

  friend bool operator==(const Answer&, const Answer&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Answer& answer) {
    out << "outcome " << static_cast<int>(answer.outcome) << std::hex;
    for (const std::uint32_t word : answer.words) out << ' ' << word;
    return out << std::dec;
  }
};

inline Answer value(std::uint32_t word) { return {x86::Outcome::returned, {word}}; }
inline Answer values(Words words) { return {x86::Outcome::returned, std::move(words)}; }
inline const Answer divide_error{x86::Outcome::divide_error, {}};
inline const Answer undefined_flag{x86::Outcome::undefined_flag, {}};

template <x86::Routine routine>
Answer ask(const x86::Program& program, const Words& in) {
  Answer answer;
  answer.words.resize(static_cast<std::size_t>(x86::arity(routine).out));
  answer.outcome = x86::call<routine, 16>(program.instructions(), in, answer.words).outcome;
  if (answer.outcome != x86::Outcome::returned) answer.words.clear();
  return answer;
}

template <x86::Routine routine>
Answer ask(x86::Target target, const x86::Build& build, const Words& in) {
  return ask<routine>(x86::assemble(x86::listing(routine, target), build), in);
}

inline constexpr x86::Build rounded{};
inline constexpr x86::Build unrounded{.mul_rounding = false, .div_rounding = false};

}  // namespace defects
