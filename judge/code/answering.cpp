#include "judge/code/answering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "support/interrupt.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/words.hpp"

namespace fixproof::judge {

namespace {

constexpr std::size_t cases_of_batch = 16384;
/// The number of cases that run a second time, with other noise, and on both machines.
constexpr std::uint64_t twice = 1024;
/// How often all cases run again if the one that failed does not fail step by step.
constexpr int most_tries = 2;

std::string_view why(Downfall downfall) {
  switch (downfall) {
    case Downfall::system_call:
      return "its process made a system call";
    case Downfall::out_of_time:
      return "its process ran out of time";
    case Downfall::out_of_memory:
      return "its process ran out of memory";
    case Downfall::crashed:
      return "its process was ended by a signal";
    case Downfall::false_reply:
      return "its process sent a false reply";
    default:
      return "its process ended";
  }
}

Incident incident(const Subject& subject, std::span<const std::uint32_t> words,
                  const Answer& answer) {
  return {.words = {words.begin(), words.end()},
          .operands = text_of_operands(subject.variant, words),
          .ending = answer.ending,
          .broken = answer.broken};
}

bool same_result(const Answer& a, const Answer& b) {
  return a.ending.end == b.ending.end && (a.ending.end != End::returned || a.words == b.words);
}

class Pass {
 public:
  Pass(const Subject& subject, const VerdictOptions& options, Verdict& verdict, On on)
      : subject_(subject), options_(options), verdict_(verdict), runner_(subject, on) {}

  /// @return false if a call got stuck
  /// @throws support::Stopped after an interrupt; then the cases so far are noted
  bool run(const OnAnswer& on_answer) {
    const std::size_t in = words_in(subject_.variant);
    check::GeneratedCases cases(subject_.variant, options_.cases);
    std::vector<std::uint32_t> batch;
    std::vector<std::string_view> origins;
    std::vector<std::uint32_t> one(in);
    const std::uint64_t all = cases.count().value_or(0);
    for (bool more = true; more;) {
      batch.clear();
      origins.clear();
      while (origins.size() < cases_of_batch && (more = cases.next(one))) {
        batch.insert(batch.end(), one.begin(), one.end());
        origins.push_back(cases.origin());
      }
      if (support::Interrupt::flag()) throw support::Stopped();
      const auto answers = runner_.answers(batch);
      for (std::size_t i = 0; i < answers.size(); ++i) {
        const auto words = std::span(batch).subspan(i * in, in);
        if (!note(words, answers[i])) return false;
        on_answer(words, answers[i], origins[i]);
      }
      sample(batch, answers, all);
      if (options_.progress) options_.progress(verdict_.cases, all);
    }
    return true;
  }

  [[nodiscard]] const std::vector<std::uint32_t>& sampled() const { return sampled_; }
  [[nodiscard]] const std::vector<Answer>& sampled_answers() const { return sampled_answers_; }
  Runner& runner() { return runner_; }

 private:
  bool note(std::span<const std::uint32_t> words, const Answer& answer) {
    if (!ended_well(answer)) {
      verdict_.stuck = incident(subject_, words, answer);
      return false;
    }
    ++verdict_.cases;
    if (answer.ending.end == End::divide_error) {
      if (verdict_.divide_errors++ == 0) {
        verdict_.first_divide_error = incident(subject_, words, answer);
      }
      return true;
    }
    verdict_.changed |= answer.changed;
    if (answer.broken != 0 && verdict_.not_preserved_count++ == 0) {
      verdict_.not_preserved = incident(subject_, words, answer);
    }
    return true;
  }

  /// Keeps evenly spread cases for the second run and for the other machine.
  void sample(const std::vector<std::uint32_t>& batch, const std::vector<Answer>& answers,
              std::uint64_t all) {
    const std::size_t in = words_in(subject_.variant);
    const std::uint64_t every = std::max<std::uint64_t>(1, all / twice);
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (seen_++ % every != 0) continue;
      const auto words = std::span(batch).subspan(i * in, in);
      sampled_.insert(sampled_.end(), words.begin(), words.end());
      sampled_answers_.push_back(answers[i]);
    }
  }

  const Subject& subject_;
  const VerdictOptions& options_;
  Verdict& verdict_;
  Runner runner_;
  std::uint64_t seen_ = 0;
  std::vector<std::uint32_t> sampled_;
  std::vector<Answer> sampled_answers_;
};

/// Looks for a case whose answer differs in a second run.
void compare_again(const Subject& subject, const Pass& pass, Runner& runner, Verdict& verdict) {
  const auto again = runner.answers(pass.sampled());
  const std::size_t in = words_in(subject.variant);
  for (std::size_t i = 0; i < again.size() && !verdict.unsteady; ++i) {
    if (same_result(again[i], pass.sampled_answers()[i])) continue;
    verdict.unsteady = incident(subject, std::span(pass.sampled()).subspan(i * in, in), again[i]);
  }
}

}  // namespace

std::string text_of_operands(const cases::Variant& variant, std::span<const std::uint32_t> words) {
  if (variant.operation == cases::Operation::xformvec) {
    return cases::hex_words(words, variant.format.word_bits);
  }
  std::string text;
  cases::append_operands(text, variant, words);
  return fmt::format("{} ({})", text, cases::decimal_words(variant, words));
}

namespace {

/// @throws support::Stopped after an interrupt, with a verdict on the cases so far
void run_all(const Subject& subject, const VerdictOptions& options, Verdict& verdict,
             const std::function<void()>& begin, const OnAnswer& on_answer) {
  const std::string no_processor = absence_on_processor(subject.image);
  const std::string no_unicorn = absence_on_unicorn();
  if (!no_processor.empty() && !no_unicorn.empty()) {
    throw support::UsageError(
        fmt::format("no machine runs this code: {}; {}", no_processor, no_unicorn));
  }
  verdict.machine = no_processor.empty() ? On::processor : On::unicorn;
  verdict.note = no_processor;
  begin();
  auto pass = std::make_unique<Pass>(subject, options, verdict, verdict.machine);
  bool done = pass->run(on_answer);
  for (int tries = 0; !done && no_unicorn.empty() && tries < most_tries; ++tries) {
    // The trace shows what happened, and where. If the call ends well there, the trouble is only
    // the processor's, or the machine was too busy to run the process for seconds.
    const auto call = Tracer(subject).call(verdict.stuck->words);
    if (!call) break;
    if (!ended_well(call->answer)) {
      verdict.stuck->ending = call->answer.ending;
      break;
    }
    std::string note = verdict.note;
    if (verdict.machine == On::processor) {
      const Downfall downfall = pass->runner().downfall();
      note = fmt::format("{} on this processor, but not on Unicorn",
                         downfall == Downfall::none ? "it faults" : why(downfall));
    }
    verdict = Verdict{.machine = On::unicorn, .note = std::move(note), .rules = verdict.rules};
    begin();
    pass = std::make_unique<Pass>(subject, options, verdict, On::unicorn);
    done = pass->run(on_answer);
  }
  if (done) {
    compare_again(subject, *pass, pass->runner(), verdict);
    if (verdict.unsteady && no_unicorn.empty()) {
      verdict.state = find_kept_state(subject, verdict.unsteady->words);
    }
    if (verdict.machine == On::processor && no_unicorn.empty() && !verdict.unsteady) {
      Runner unicorn(subject, On::unicorn);
      compare_again(subject, *pass, unicorn, verdict);
      verdict.on_both = pass->sampled_answers().size();
      verdict.is_steady_on_processor = verdict.unsteady.has_value();
    }
  }
}

}  // namespace

void run_cases(const Subject& subject, const VerdictOptions& options, Verdict& verdict,
               const std::function<void()>& begin, const OnAnswer& on_answer) {
  const auto start = std::chrono::steady_clock::now();
  try {
    run_all(subject, options, verdict, begin, on_answer);
  } catch (const support::Stopped&) {
    verdict.is_stopped = true;
    // What failed on the processor may end well on Unicorn, where it did not run any more.
    verdict.stuck.reset();
  }
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace fixproof::judge
