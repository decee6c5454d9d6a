#include "verify/chunk_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "verify/cases/streams.hpp"
#include "verify/parties/answer.hpp"

namespace fixproof::verify {

namespace {

/// Cases per batch: small enough for all their words to stay in the processor's caches.
constexpr std::size_t batch_cases = 1024;

}  // namespace

PartiesByRow parties_by_row(const cases::Plan& plan,
                            std::span<const parties::Party* const> parties) {
  PartiesByRow rows;
  for (const cases::Row& row : plan.rows()) {
    auto& row_parties = rows.emplace_back();
    for (const std::string& name : row.parties) {
      const auto found =
          std::find_if(parties.begin(), parties.end(),
                       [&](const parties::Party* party) { return party->name() == name; });
      if (found == parties.end()) {
        throw std::invalid_argument(fmt::format("there is no party '{}'", name));
      }
      row_parties.push_back(*found);
    }
  }
  return rows;
}

ChunkRunner::ChunkRunner(const cases::Plan& plan, const PartiesByRow& parties,
                         std::size_t max_shown)
    : plan_(plan),
      parties_(parties),
      max_shown_(max_shown),
      in_(batch_cases * cases::max_words_in),
      judged_{std::vector<std::uint32_t>(batch_cases * cases::max_words_out),
              std::vector<parties::Ending>(batch_cases)},
      other_(judged_),
      differs_(batch_cases) {}

ChunkFindings ChunkRunner::run(std::uint64_t number) {
  const cases::Chunk chunk = plan_.chunk(number);
  const cases::Variant& variant = plan_.rows()[chunk.job->row].variant;
  const std::size_t arity = cases::words_in(variant);
  Findings found;
  digest_ = {};
  for (std::uint64_t done = 0; done < chunk.cases; done += batch_cases) {
    const std::uint64_t first = chunk.first + done;
    const auto cases =
        static_cast<std::size_t>(std::min<std::uint64_t>(batch_cases, chunk.cases - done));
    const std::span in = std::span(in_).first(cases * arity);
    cases::make_cases(chunk.job->stream, variant, plan_.seed(), first, in);
    compare(variant, parties_[chunk.job->row], cases);

    found.cases += cases;
    const auto endings = std::span(judged_.endings).first(cases);
    found.faults += static_cast<std::uint64_t>(
        std::count(endings.begin(), endings.end(), parties::Ending::divide_error));
    for (std::size_t i = 0; i < cases; ++i) {
      if (differs_[i] == 0) continue;
      ++found.mismatches;
      if (found.shown.size() >= max_shown_) continue;
      const auto words = in.subspan(i * arity, arity);
      found.shown.push_back({number, first + i, {words.begin(), words.end()}, {}, {}});
    }
  }
  return {std::move(found), digest_.value()};
}

void ChunkRunner::compare(const cases::Variant& variant,
                          std::span<const parties::Party* const> parties, std::size_t cases) {
  const std::size_t out = cases::words_out(variant);
  const auto ask = [&](const parties::Party& party, Answers& answers) {
    party.answer(variant, {std::span(in_).first(cases * cases::words_in(variant)),
                           std::span(answers.out).first(cases * out),
                           std::span(answers.endings).first(cases)});
  };
  ask(*parties.front(), judged_);
  std::fill_n(differs_.begin(), cases, 0);
  const auto view = [out](const Answers& answers, std::size_t i) {
    return parties::AnswerView{answers.endings[i], std::span(answers.out).subspan(i * out, out)};
  };
  for (std::size_t party = 1; party < parties.size(); ++party) {
    ask(*parties[party], other_);
    for (std::size_t i = 0; i < cases; ++i) {
      if (parties::agree(view(judged_, i), view(other_, i))) continue;
      differs_[i] = 1;
      const std::array<std::uint64_t, 3> given{party, i,
                                               static_cast<std::uint64_t>(other_.endings[i])};
      digest_.add(std::span<const std::uint64_t>(given));
      if (other_.endings[i] == parties::Ending::value) digest_.add(view(other_, i).words);
    }
  }

  // The words of a case without a value are unspecified.
  const auto words = std::span(judged_.out).first(cases * out);
  const auto endings = std::span(judged_.endings).first(cases);
  const auto is_value = [](parties::Ending ending) { return ending == parties::Ending::value; };
  if (!std::all_of(endings.begin(), endings.end(), is_value)) {
    for (std::size_t i = 0; i < cases; ++i) {
      if (!is_value(endings[i])) std::fill_n(words.subspan(i * out).begin(), out, 0);
    }
  }
  digest_.add(std::span<const std::uint32_t>(words));
  digest_.add(std::span<const parties::Ending>(endings));
}

}  // namespace fixproof::verify
