// Single cases: one party asked, its answer as text.
#include <algorithm>
#include <array>

#include "verify/engine.hpp"
#include "verify/text.hpp"

namespace fixproof {

std::string Answer::text(int word_bits) const {
  switch (ending) {
    case Ending::divide_error:
      return "DE";
    case Ending::undefined_flag:
      return "reads an undefined flag";
    case Ending::broken:
      return "breaks down";
    case Ending::value:
      break;
  }
  return hex_words(words, word_bits);
}

Answer ask(const Party& party, const Variant& variant, std::span<const std::uint32_t> words) {
  std::array<std::uint32_t, most_words_out> out{};
  std::array<Ending, 1> ending{Ending::broken};
  const auto used = std::span(out).first(words_out(variant.operation));
  party.answer(variant, {words, used, ending});
  if (ending[0] != Ending::value) return {ending[0], {}};
  return {ending[0], {used.begin(), used.end()}};
}

bool agree(std::span<const Answer> answers) {
  return std::all_of(answers.begin(), answers.end(), [&](const Answer& answer) {
    return answer == answers.front() &&
           (answer.ending == Ending::value || answer.ending == Ending::divide_error);
  });
}

}  // namespace fixproof
