#include "judge/code/verdict.hpp"

#include <algorithm>
#include <array>

#include "judge/check/case_words.hpp"
#include "judge/check/fitting.hpp"
#include "judge/code/answering.hpp"
#include "oracle/exact.hpp"
#include "support/interrupt.hpp"
#include "verify/shrink.hpp"

namespace fixproof::judge {

namespace {

/// As check::cases_for_guess, for results of several words, for which each rule takes longer.
constexpr std::uint64_t cases_for_choice = 2000;

bool is_right(const check::Rules& rules, const check::JudgedCase& one) {
  return check::keeps(rules, one.operands(), one.said);
}

/// Finds a wrong case that is at most as large as the smallest of those that ran, by shrinking it.
/// A case that has another result when it runs again is unsteady, even if the sample of such cases
/// lacks it.
void find_smallest(const Subject& subject, Verdict& verdict, std::vector<std::uint32_t> words) {
  const check::Rules& rules = verdict.rules;
  Runner runner(subject, verdict.machine);
  const auto judged = [&](std::span<const std::uint32_t> tried) {
    check::JudgedCase one = judged_case(subject.variant, tried, runner.answers(tried).front());
    one.read_by(rules);
    return one;
  };
  const auto note_unsteady = [&] {
    if (verdict.unsteady) return;
    verdict.unsteady =
        Incident{.words = words, .operands = text_of_operands(subject.variant, words)};
  };
  if (is_right(rules, judged(words))) return note_unsteady();
  const int bits = cases::operand_bits(subject.variant);
  if (bits <= 32) {
    // A case with fewer ones can have larger numbers.
    std::vector<std::uint32_t> simplest = verify::shrink(
        words, bits,
        [&](std::span<const std::uint32_t> tried) { return !is_right(rules, judged(tried)); });
    if (check::size_of(subject.variant, simplest) < check::size_of(subject.variant, words)) {
      words = std::move(simplest);
    }
  }
  check::JudgedCase smallest = judged(words);
  if (judged(words).said != smallest.said) note_unsteady();
  if (!is_right(rules, smallest)) verdict.smallest = std::move(smallest);
}

/// A case that ran, and its origin.
struct Ran {
  std::vector<std::uint32_t> words{};
  Answer answer{};
  std::string_view origin{};
};

struct Judging {
  const Subject& subject;
  const VerdictOptions& options;
  bool keeps_all = false;
  Verdict verdict{};
  std::optional<Ran> smallest{};
  int smallest_size = 0;
  std::vector<Ran> all{};  ///< if it keeps them

  void run() {
    run_cases(
        subject, options, verdict, [this] { begin(); },
        [this](std::span<const std::uint32_t> words, const Answer& answer,
               std::string_view origin) {
          const Ran ran{{words.begin(), words.end()}, answer, origin};
          add(ran);
          if (keeps_all) all.push_back(ran);
        });
  }

  /// Judges the cases that it kept, by other rules.
  void judge_again(const check::Rules& rules) {
    verdict.rules = rules;
    const std::vector<Ran> kept = std::move(all);
    begin();
    for (const Ran& ran : kept) add(ran);
  }

  /// Returns the wrong case with the smallest operands of those that ran.
  [[nodiscard]] check::JudgedCase smallest_that_ran() const {
    check::JudgedCase one = judged_case(subject.variant, smallest->words, smallest->answer);
    one.read_by(verdict.rules);
    return one;
  }

 private:
  void begin() {
    verdict.judge.emplace(verdict.rules, options.shown);
    smallest.reset();
    all.clear();
  }
  void add(const Ran& ran) {
    check::JudgedCase one = judged_case(subject.variant, ran.words, ran.answer);
    one.number = verdict.judge->cases() + 1;
    one.origin = ran.origin;
    const std::uint64_t before = verdict.judge->wrong();
    verdict.judge->add(one);
    if (verdict.judge->wrong() == before) return;
    const int size = check::size_of(subject.variant, ran.words);
    if (smallest && size >= smallest_size) return;
    smallest = ran;
    smallest_size = size;
  }
};

}  // namespace

check::JudgedCase judged_case(const cases::Variant& variant, std::span<const std::uint32_t> words,
                              const Answer& answer) {
  check::JudgedCase one = check::case_of(variant, words);
  if (answer.ending.end == End::returned) {
    std::array<std::uint64_t, 1> said{};
    check::join_words(answer.words, variant.format, said);
    one.said = said[0];
  }
  return one;
}

Verdict judge_routine(const Subject& subject, const VerdictOptions& options) {
  VerdictOptions used = options;
  if (options.rounding_is_open) {
    used.cases.cases =
        std::min(options.cases.cases.value_or(check::cases_for_guess), check::cases_for_guess);
    used.progress = {};
    Judging guess{.subject = subject, .options = used, .keeps_all = true};
    guess.verdict.rules = options.rules;
    guess.run();
    if (guess.verdict.stuck || guess.verdict.state) return std::move(guess.verdict);
    if (guess.verdict.is_stopped) {
      if (guess.verdict.cases > 0) guess.judge_again(check::fitting_rules(*guess.verdict.judge));
      if (guess.smallest) guess.verdict.smallest = guess.smallest_that_ran();
      return std::move(guess.verdict);
    }
    used = options;
    used.rules = check::fitting_rules(*guess.verdict.judge);
  }
  Judging judging{.subject = subject, .options = used};
  Verdict& verdict = judging.verdict;
  verdict.rules = used.rules;
  judging.run();
  if (!judging.smallest) return std::move(verdict);
  try {
    if (!verdict.is_stopped) find_smallest(subject, verdict, judging.smallest->words);
  } catch (const support::Stopped&) {
    verdict.is_stopped = true;
  }
  if (verdict.is_stopped) verdict.smallest = judging.smallest_that_ran();
  return std::move(verdict);
}

namespace {

std::vector<Candidate> candidates_for(cases::Operation operation) {
  std::vector<Candidate> all;
  if (operation == cases::Operation::cossin) {
    all.push_back({"the nearest words", [](auto in, auto out) {
                     const auto turn = oracle::cos_sin(static_cast<std::int16_t>(in[0] & 0xFFFFU));
                     out[0] = turn.cos;
                     out[1] = turn.sin;
                   }});
    return all;
  }
  for (const oracle::Rounding rounding : check::roundings()) {
    const std::string name(check::name_of(rounding));
    all.push_back({"each product " + name, [rounding](auto in, auto out) {
                     const auto result = oracle::xform_vec(
                         in.template first<12>(), in.template subspan<12, 3>(), rounding, 16);
                     std::copy(result.begin(), result.end(), out.begin());
                   }});
    all.push_back({"each sum " + name + " once", [rounding](auto in, auto out) {
                     const std::array point{in[12], in[13], in[14], std::uint32_t{1} << 16U};
                     for (std::size_t row = 0; row < 3; ++row) {
                       out[row] = oracle::dot(in.subspan(4 * row, 4), point, rounding, 16);
                     }
                   }});
  }
  return all;
}

}  // namespace

WholeVerdict judge_whole(const Subject& subject, const VerdictOptions& options) {
  std::vector<std::uint32_t> expected(words_out(subject.variant));
  const auto judged = [&](const VerdictOptions& use, const std::vector<Candidate>& candidates) {
    WholeVerdict whole;
    run_cases(
        subject, use, whole.verdict, [&] { whole.candidates = candidates; },
        [&](std::span<const std::uint32_t> words, const Answer& answer, std::string_view) {
          for (Candidate& candidate : whole.candidates) {
            candidate.results(words, expected);
            const bool kept = answer.ending.end == End::returned &&
                              std::equal(expected.begin(), expected.end(), answer.words.begin());
            if (kept || candidate.exceptions++ > 0) continue;
            candidate.first_exception =
                Incident{.words = {words.begin(), words.end()},
                         .operands = text_of_operands(subject.variant, words),
                         .ending = answer.ending};
          }
        });
    std::ranges::stable_sort(whole.candidates, {}, &Candidate::exceptions);
    return whole;
  };
  VerdictOptions guess = options;
  guess.cases.cases = std::min(options.cases.cases.value_or(cases_for_choice), cases_for_choice);
  guess.progress = {};
  WholeVerdict first = judged(guess, candidates_for(subject.variant.operation));
  if (first.verdict.stuck || first.verdict.state || first.verdict.is_stopped) return first;
  const std::uint64_t least = first.candidates.front().exceptions;
  std::vector<Candidate> best;
  for (const Candidate& candidate : first.candidates) {
    if (candidate.exceptions == least) best.push_back({candidate.name, candidate.results});
  }
  return judged(options, best);
}

}  // namespace fixproof::judge
