#include "judge/program/verdict.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "judge/check/case_words.hpp"
#include "judge/check/fitting.hpp"
#include "judge/check/verdict_text.hpp"
#include "judge/program/walk.hpp"
#include "support/interrupt.hpp"
#include "support/thread_pool.hpp"
#include "support/usage_error.hpp"

namespace fixproof::program {

namespace {

using Clock = std::chrono::steady_clock;

/// If one process takes longer for all cases, several run.
constexpr double seconds_for_one = 2;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Returns the next result; empty at the end of the results.
using NextResult = std::function<std::optional<std::string_view>()>;

class Judging {
 public:
  explicit Judging(const VerdictOptions& options) : options_(options) {
    verdict_.rules = options.rules;
    verdict_.cases = check::GeneratedCases(variant(), options.cases).count().value_or(0);
    // Odd, because rows of cases often have an even length.
    stride_ = (verdict_.cases + check::cases_for_guess - 1) / check::cases_for_guess;
    if (stride_ % 2 == 0) ++stride_;
  }

  Verdict run() {
    if (verdict_.cases == 0) {
      throw support::UsageError("--shard: this part has no cases; use fewer parts");
    }
    if (!run_first()) return std::move(verdict_);
    const Walk first{variant(), options_.cases, stride_};
    if (options_.rounding_is_open) {
      judge(first, stored());
      if (verdict_.failure) return std::move(verdict_);
      verdict_.rules = check::fitting_rules(*verdict_.judge);
    }
    if (stride_ == 1) {
      judge(first, stored());
    } else {
      run_all();
    }
    return std::move(verdict_);
  }

 private:
  [[nodiscard]] const cases::Variant& variant() const { return options_.rules.variant; }

  /// Runs one process on every stride-th case. Returns false if it fails or is stopped.
  bool run_first() {
    const Walk walk{variant(), options_.cases, stride_};
    Relay relay({.command = options_.command, .silence = options_.silence}, walk.lines());
    const auto start = Clock::now();
    while (const auto line = relay.next()) first_.emplace_back(*line);
    verdict_.seconds = seconds_since(start);
    if (!relay.fault()) return true;
    // A line that is no result explains more than what followed it.
    judge(walk, stored());
    if (!verdict_.failure) explain(walk, relay, first_.size());
    return false;
  }

  void run_all() {
    verdict_.processes = options_.processes.value_or(processes_that_pay());
    const Walk walk{variant(), options_.cases, 1};
    Relay relay(
        {.command = options_.command, .processes = verdict_.processes, .silence = options_.silence},
        walk.lines());
    const auto start = Clock::now();
    judge(walk, [&relay] { return relay.next(); });
    verdict_.seconds = seconds_since(start);
    if (relay.fault()) explain(walk, relay, verdict_.judge->cases());
  }

  /// Returns the number of processes, from the time of the first run without that of the start.
  [[nodiscard]] std::size_t processes_that_pay() const {
    const auto takes_long = [this](double seconds) {
      return seconds * static_cast<double>(stride_) > seconds_for_one;
    };
    if (!takes_long(verdict_.seconds)) return 1;
    const auto start = Clock::now();
    static_cast<void>(fault_of({variant(), options_.cases, stride_}, 0, 0));
    if (!takes_long(verdict_.seconds - seconds_since(start))) return 1;
    return support::processors();
  }

  /// The results of the first run.
  [[nodiscard]] NextResult stored() const {
    return [this, i = std::size_t{0}]() mutable -> std::optional<std::string_view> {
      if (i == first_.size()) return std::nullopt;
      return first_[i++];
    };
  }

  void judge(const Walk& walk, const NextResult& next_result) {
    verdict_.judge.emplace(verdict_.rules, options_.shown);
    verdict_.smallest.reset();
    int smallest_size = std::numeric_limits<int>::max();
    auto steps = walk.steps();
    while (!support::Interrupt::flag()) {
      const auto line = next_result();
      if (!line || !steps.next()) break;
      auto one = said_by(steps, *line);
      if (!one) return;
      const std::uint64_t before = verdict_.judge->wrong();
      verdict_.judge->add(*one);
      note_unsteady(*one, walk, *line);
      if (options_.progress && verdict_.judge->cases() % 4096 == 0) {
        options_.progress(verdict_.judge->cases(), verdict_.cases);
      }
      if (verdict_.judge->wrong() == before) continue;
      const int size = check::size_of(variant(), steps.words());
      if (size >= smallest_size) continue;
      smallest_size = size;
      verdict_.smallest = std::move(one);
      verdict_.smallest->read_by(verdict_.rules);
    }
    verdict_.is_stopped = support::Interrupt::flag();
  }

  /// Returns the case with its result. Notes the failure, and returns nothing, if there is none.
  std::optional<check::JudgedCase> said_by(const Steps& steps, std::string_view line) {
    const bool is_decimal = variant().operation == cases::Operation::to_decimal;
    check::JudgedCase one = steps.judged();
    one.number = verdict_.judge->cases() + 1;
    try {
      one.said = is_decimal ? check::parse_decimal_result(line, variant().format)
                            : check::parse_result(line, variant().format);
      if (is_decimal) one.said_text = line;
      return one;
    } catch (const support::UsageError& error) {
      verdict_.failure =
          Failure{.defect = error.what(), .at = std::move(one), .results = verdict_.judge->cases()};
      return std::nullopt;
    }
  }

  /// Compares a result with that of the first run.
  void note_unsteady(const check::JudgedCase& one, const Walk& walk, std::string_view line) {
    const std::uint64_t index = one.number - 1;
    if (walk.stride != 1 || verdict_.unsteady || index % stride_ != 0) return;
    if (first_.at(index / stride_) != line) verdict_.unsteady = one;
  }

  /// Names the case that a fault comes from. Several processes read different cases from run to
  /// run, so one process looks for it.
  void explain(const Walk& walk, const Relay& relay, std::uint64_t results) {
    const Fault& fault = *relay.fault();
    if (fault.kind == Fault::Kind::interrupted) {
      verdict_.is_stopped = true;
      return;
    }
    Failure failure{.fault = fault, .results = results};
    std::uint64_t index = results;
    const bool can_be_alone =
        fault.kind == Fault::Kind::ends || fault.kind == Fault::Kind::too_many;
    if (can_be_alone) {
      if (const auto found = failing_case(walk, fault.kind, results, relay.given())) {
        index = *found;
        failure.is_alone = true;
      }
    }
    if (support::Interrupt::flag()) verdict_.is_stopped = true;
    auto steps = walk.steps();
    std::uint64_t i = 0;
    while (i <= index && steps.next()) ++i;
    if (i == index + 1) failure.at = steps.judged();
    verdict_.failure = std::move(failure);
  }

  /// Returns the first case on which the program fails alone; empty if there is none.
  std::optional<std::uint64_t> failing_case(const Walk& walk, Fault::Kind kind, std::uint64_t next,
                                            std::uint64_t end) {
    const auto fails = [&](std::uint64_t first, std::uint64_t last) {
      return fault_of(walk, first, last) == kind;
    };
    // One that ends at once has answered all cases before.
    if (kind == Fault::Kind::ends && next < end && fails(next, next + 1)) return next;
    std::uint64_t first = 0;
    while (end - first > 1) {
      const std::uint64_t middle = first + (end - first) / 2;
      (fails(first, middle) ? end : first) = middle;
    }
    if (first < end && fails(first, end)) return first;
    return std::nullopt;
  }

  /// Returns the fault of a process that runs on these cases.
  [[nodiscard]] std::optional<Fault::Kind> fault_of(const Walk& walk, std::uint64_t first,
                                                    std::uint64_t end) const {
    if (support::Interrupt::flag()) return Fault::Kind::interrupted;
    Relay relay({.command = options_.command, .silence = options_.silence}, walk.lines(first, end));
    while (relay.next()) {
    }
    return relay.fault() ? std::optional(relay.fault()->kind) : std::nullopt;
  }

  const VerdictOptions& options_;
  Verdict verdict_{};
  std::uint64_t stride_ = 1;
  std::vector<std::string> first_;
};

}  // namespace

Verdict judge_program(const VerdictOptions& options) { return Judging(options).run(); }

}  // namespace fixproof::program
