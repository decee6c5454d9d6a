#include "app/cli/judge_program.hpp"

#include <fmt/format.h>

#include <cstring>
#include <iostream>

#include "app/cli/case_options.hpp"
#include "app/cli/json/judge_json.hpp"
#include "app/cli/judge_rules.hpp"
#include "app/cli/judge_text.hpp"
#include "judge/check/verdict_text.hpp"
#include "judge/program/verdict.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

/// The longest time in which a program neither reads nor writes.
constexpr int seconds_of_silence = 60;

cases::Variant judged_by_run(const JudgeOptions& options) {
  if (options.operation.empty() || options.operation == "?") {
    throw support::UsageError("--run: name with --as what the program computes, such as mul");
  }
  const bool is_short = options.operation == "muldiv";
  const cases::Operation operation =
      cases::operation_named(is_short ? "mul_div" : options.operation);
  if (!check::is_judged(operation)) {
    throw support::UsageError(fmt::format(
        "--as {}: with --run, choose an operation of check, such as mul; fixproof check --help "
        "lists them",
        options.operation));
  }
  return variant_in(operation, options.formats());
}

/// Returns how a program ended, such as "ends by signal 8 (Floating point exception)".
std::string ending_text(const std::optional<program::Child::Ending>& ending) {
  if (!ending) return "closes its output and does not end";
  if (ending->signal == 0) return fmt::format("ends with status {}", ending->status);
  return fmt::format("ends by signal {} ({})", ending->signal, ::strsignal(ending->signal));
}

/// The likely fix of a fault.
std::string fix_of(const program::Failure& failure) {
  switch (failure.fault->kind) {
    case program::Fault::Kind::ends:
      if (failure.is_alone)
        return "read cases from standard input, and write one line for each, DE where there is no "
               "result";
      return "read cases up to the end of the input, and write one line for each";
    case program::Fault::Kind::silent:
      return "end the loop at the end of the input, or give --timeout more seconds";
    case program::Fault::Kind::never_ends:
      return "end the program at the end of the input";
    default:
      return "write one line for each case, and begin any other line with #";
  }
}

std::string event_text(const program::Failure& failure) {
  if (!failure.fault) {
    return fmt::format("writes no result: {}; begin any other line with #", failure.defect);
  }
  const program::Fault& fault = *failure.fault;
  switch (fault.kind) {
    case program::Fault::Kind::ends:
      return ending_text(fault.ending) + " without a result";
    case program::Fault::Kind::silent:
      return "neither reads nor writes any more";
    case program::Fault::Kind::never_ends:
      return "does not end";
    default:
      return fmt::format("writes more lines than it has cases, first {}",
                         support::quoted(fault.said));
  }
}

/// Returns one line without its end: the case, what happens, what the program says, and the fix.
std::string failure_text(const program::Failure& failure, const check::Rules& rules) {
  std::string where = "after the last case";
  if (failure.at) {
    where = fmt::format("for {}", check::text_of_operands(*failure.at, rules));
    if (failure.is_alone) where += ", even alone,";
  }
  std::string text = fmt::format("BROKEN: {} the program {}", where, event_text(failure));
  if (failure.fault && !failure.is_alone) {
    text += fmt::format(", after {} result{}", support::grouped(failure.results),
                        failure.results == 1 ? "" : "s");
  }
  if (failure.fault && !failure.fault->error.empty()) {
    text += fmt::format("; it says {}", support::quoted(failure.fault->error));
  }
  return text + (failure.fault ? "; " + fix_of(failure) : "");
}

/// @throws support::UsageError if the shell found no program
void expect_started(const program::Verdict& verdict, const std::string& command) {
  constexpr int not_found = 127;
  constexpr int cannot_run = 126;
  if (!verdict.failure || !verdict.failure->fault || !verdict.failure->fault->ending) return;
  const program::Fault& fault = *verdict.failure->fault;
  if (fault.ending->status != not_found && fault.ending->status != cannot_run) return;
  const std::string said = fault.error.empty() ? "" : ": " + support::printable(fault.error);
  throw support::UsageError(
      fmt::format("--run {}: the shell cannot run it{}; give a command that "
                  "runs in this folder, such as './mine'",
                  support::quoted(command), said));
}

void print_judgement(const program::Verdict& verdict) {
  std::cout << fmt::format("{} case{} in {} process{} in {}\n",
                           support::grouped(verdict.judge->cases()),
                           verdict.judge->cases() == 1 ? "" : "s", verdict.processes,
                           verdict.processes == 1 ? "" : "es", support::duration(verdict.seconds));
  if (verdict.unsteady) {
    std::cout << fmt::format(
        "UNSTEADY: for {} the result differs from run to run: the program keeps something from "
        "case to case, or reads registers or memory that nothing sets\n",
        check::text_of_operands(*verdict.unsteady, verdict.rules));
  }
  std::cout << judgement_text(*verdict.judge, verdict.smallest);
}

}  // namespace

int judge_program(const JudgeOptions& options, const CLI::App& command, ResultFile& result) {
  const cases::Variant variant = judged_by_run(options);
  const RunOptions& of_run = options.run;
  std::optional<support::FrameProgress> progress;
  program::VerdictOptions use{
      .command = of_run.program,
      .rules = rules_of(options, variant),
      .cases = options.cases,
      .shown = options.shown,
      .silence = std::chrono::seconds(command.count("--timeout") > 0 ? options.solver.seconds
                                                                     : seconds_of_silence),
      .progress = [&](std::uint64_t done, std::uint64_t all) {
        if (!progress) progress.emplace(all, "cases");
        progress->show(done);
      }};
  if (of_run.processes > 0) use.processes = of_run.processes;
  use.rounding_is_open = is_open(options) && check::is_rounded(variant);
  const program::Verdict verdict = program::judge_program(use);
  progress.reset();
  expect_started(verdict, of_run.program);
  const bool has_verdict = verdict.judge && !verdict.failure && verdict.judge->cases() > 0;
  const Rounding rounding = !use.rounding_is_open ? Rounding::given
                            : has_verdict         ? Rounding::fitting
                                                  : Rounding::unknown;
  const std::string rules = rules_line(verdict.rules, rounding);
  const std::string failure =
      verdict.failure ? failure_text(*verdict.failure, verdict.rules) : std::string();
  std::cout << fmt::format("{}: a program\n{}\n", support::printable(of_run.program), rules)
            << failure << (failure.empty() ? "" : "\n");
  if (has_verdict) print_judgement(verdict);
  if (verdict.is_stopped && failure.empty()) {
    std::cout << fmt::format("\nSTOPPED after {} of {} cases\n",
                             support::grouped(has_verdict ? verdict.judge->cases() : 0),
                             support::grouped(verdict.cases));
  }
  const int status = !verdict.is_right() ? 1 : verdict.is_stopped ? support::interrupted_status : 0;
  return result.write(status,
                      [&] { return program_json(of_run.program, verdict, rules, failure); });
}

}  // namespace fixproof::cli
