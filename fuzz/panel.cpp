#include "fuzz/panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "verify/cases/plan.hpp"
#include "verify/cases/words.hpp"
#include "verify/engine.hpp"
#include "verify/parties/answer.hpp"
#include "verify/replay.hpp"
#include "verify/shrink.hpp"

namespace fixproof::fuzz {

namespace {

std::vector<parties::Answer> answers_of(const VariantParties& tested,
                                        std::span<const std::uint32_t> words) {
  std::vector<parties::Answer> answers;
  for (const parties::Party* party : tested.parties)
    answers.push_back(parties::ask(*party, tested.variant, words));
  return answers;
}

/// Whether all parties agree. Does not allocate, because it runs for every input.
bool all_agree(const VariantParties& tested, std::span<const std::uint32_t> words) {
  using Out = std::array<std::uint32_t, cases::max_words_out>;
  const std::size_t size = cases::words_out(tested.variant.operation);
  const auto ask = [&](const parties::Party& party, Out& out) {
    std::array<parties::Ending, 1> ending{parties::Ending::broken};
    const auto used = std::span(out).first(size);
    party.answer(tested.variant, {words, used, ending});
    return parties::AnswerView{ending[0], used};
  };
  Out first_out{};
  const parties::AnswerView first = ask(*tested.parties.front(), first_out);
  return std::all_of(tested.parties.begin() + 1, tested.parties.end(),
                     [&](const parties::Party* party) {
                       Out out{};
                       return parties::agree(first, ask(*party, out));
                     });
}

std::string text_of(const VariantParties& tested, std::span<const std::uint32_t> words) {
  const int bits = cases::operand_bits(tested.variant);
  const auto smallest = verify::shrink({words.begin(), words.end()}, bits, [&](auto fewer) {
    return !parties::agree(answers_of(tested, fewer));
  });
  const auto answers = answers_of(tested, smallest);
  const int result_bits = tested.variant.format.word_bits;
  std::string text = fmt::format("{}: not all parties agree\n", cases::name_of(tested.variant));
  cases::Row row{tested.variant, {}};
  verify::Mismatch mismatch;
  mismatch.smallest = smallest;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    row.parties.emplace_back(tested.parties[i]->name());
    mismatch.said.emplace_back(row.parties.back(), answers[i].text(result_bits));
    text += fmt::format("  {:<14} {}\n", row.parties.back(), mismatch.said.back().second);
  }
  const verify::Replay again = verify::replay(row, mismatch);
  text += fmt::format("  found with  {}\n  replay:     {}", cases::hex_words(words, bits),
                      again.verify);
  if (!again.trace.empty()) text += fmt::format("\n  trace:      {}", again.trace);
  return text;
}

}  // namespace

std::vector<VariantParties> parties_by_variant(std::span<const cases::Operation> operations,
                                               std::span<const std::string_view> names) {
  std::vector<VariantParties> variants;
  const auto add = [&](const cases::Variant& variant) {
    VariantParties tested{variant, {}};
    for (const std::string_view name : names) {
      const auto found = std::find_if(parties::parties().begin(), parties::parties().end(),
                                      [&](const auto& party) { return party->name() == name; });
      if (found != parties::parties().end() && (*found)->absence().empty() &&
          (*found)->answers(variant)) {
        tested.parties.push_back(found->get());
      }
    }
    if (tested.parties.size() > 1) variants.push_back(std::move(tested));
  };
  for (const cases::Variant& variant : cases::all_variants()) {
    if (std::find(operations.begin(), operations.end(), variant.operation) == operations.end()) {
      continue;
    }
    add(variant);
    const auto half = cases::at_level(3, variant);
    if (half && half->format == cases::q8_8) add(*half);
  }
  return variants;
}

std::optional<std::string> disagreement(const VariantParties& tested,
                                        std::span<const std::uint32_t> words) {
  std::array<std::uint32_t, cases::max_words_in> own{};
  const auto one_case = std::span(own).first(cases::words_in(tested.variant.operation));
  const std::uint32_t mask = ~std::uint32_t{0} >> (32 - cases::operand_bits(tested.variant));
  for (std::size_t i = 0; i < one_case.size() && i < words.size(); ++i) {
    one_case[i] = words[i] & mask;
  }
  if (all_agree(tested, one_case)) return std::nullopt;
  return text_of(tested, one_case);
}

std::optional<std::string> disagreement(std::span<const VariantParties> variants,
                                        std::span<const std::uint32_t> words) {
  for (const VariantParties& tested : variants) {
    if (auto found = disagreement(tested, words)) return found;
  }
  return std::nullopt;
}

}  // namespace fixproof::fuzz
