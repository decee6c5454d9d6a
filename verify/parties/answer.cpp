#include "verify/parties/answer.hpp"

#include <algorithm>
#include <array>

#include "verify/cases/words.hpp"

namespace fixproof::parties {

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
  return cases::hex_words(words, word_bits);
}

Answer ask(const Party& party, const cases::Variant& variant,
           std::span<const std::uint32_t> words) {
  std::array<std::uint32_t, cases::max_words_out> out{};
  std::array<Ending, 1> ending{Ending::broken};
  const auto used = std::span(out).first(cases::words_out(variant));
  party.answer(variant, {words, used, ending});
  if (ending[0] != Ending::value) return {ending[0], {}};
  return {ending[0], {used.begin(), used.end()}};
}

bool agree(std::span<const Answer> answers) {
  return std::all_of(answers.begin(), answers.end(), [&](const Answer& answer) {
    return agree({answers.front().ending, answers.front().words}, {answer.ending, answer.words});
  });
}

cases::Row row_of(const cases::Variant& variant, std::span<const Party* const> candidates) {
  cases::Row row{variant, {}};
  for (const Party* party : candidates) {
    if (party->answers(variant)) row.parties.emplace_back(party->name());
  }
  return row;
}

}  // namespace fixproof::parties
