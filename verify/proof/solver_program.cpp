#include "verify/proof/solver_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

#include "support/interrupt.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "verify/proof/model.hpp"
#include "verify/proof/process.hpp"

namespace fixproof::proof {

namespace {

using std::chrono::seconds;

/// Time limit for `--version`.
constexpr seconds version_limit{10};
/// A solver enforces its time limit itself. If it does not, it is killed this much later.
constexpr seconds grace{2};

/// What a solver prints after each answer of ask_in_one_run(); cvc5 prints it in quotes.
constexpr std::string_view end_of_answer = "end of an answer";

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The first line of its output, or of its error output.
std::string first_output_line(const Output& output) {
  return first_line(output.out.empty() ? output.err : output.out);
}

std::vector<std::string> command_of(const std::string& solver, int max_seconds) {
  if (solver == "z3") {
    return {solver, "-smt2", "-in", "dump_models=true", fmt::format("-T:{}", max_seconds)};
  }
  return {solver, "--lang=smt2", "--dump-models", fmt::format("--tlimit={}", 1000 * max_seconds)};
}

/// @throws SolverError if the solver cannot run
Output output_for(const std::string& solver, int max_seconds, const std::string& script,
                  const std::atomic<bool>& cancelled) {
  try {
    return run_program(command_of(solver, max_seconds), script, seconds(max_seconds) + grace, {},
                       cancelled);
  } catch (const support::Stopped&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw SolverError(error.what());
  }
}

}  // namespace

std::string name_of(Satisfiability verdict) {
  switch (verdict) {
    case Satisfiability::unsatisfiable:
      return "unsat";
    case Satisfiability::satisfiable:
      return "sat";
    default:
      return "no answer";
  }
}

SolverProgram::SolverProgram(const std::string& name) : name_(name) {
  Output output;
  try {
    output = run_program({name, "--version"}, "", version_limit);
  } catch (const std::system_error& error) {
    throw support::UsageError(fmt::format("{} cannot be run: {}; install Debian's package {}", name,
                                          error.code().message(), name));
  }
  if (!output.in_time) {
    throw support::UsageError(
        fmt::format("{} --version does not end within {} s", name, version_limit.count()));
  }
  if (output.status != 0 || output.out.empty()) {
    throw support::UsageError(fmt::format("{} --version fails with status {}: {}", name,
                                          output.status,
                                          support::quoted(first_output_line(output))));
  }
  version_ = support::printable(first_line(output.out));
}

SolverAnswer SolverProgram::ask(const std::string& script, int max_seconds,
                                const std::atomic<bool>& cancelled) const {
  const auto begin = std::chrono::steady_clock::now();
  const Output output = output_for(name_, max_seconds, script, cancelled);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  SolverAnswer answer = answer_in(output, name_, script);
  answer.seconds = seconds;
  return answer;
}

std::vector<SolverAnswer> SolverProgram::ask_in_one_run(std::span<const std::string> scripts,
                                                        int max_seconds) const {
  std::string all;
  for (const std::string& script : scripts) {
    all += fmt::format("{}(echo \"{}\")\n(reset)\n", script, end_of_answer);
  }
  try {
    return answers_in(output_for(name_, max_seconds, all, never_cancelled), name_, scripts);
  } catch (const SolverError&) {
    return {};
  }
}

SolverAnswer SolverProgram::ask_together(std::span<const std::string> scripts,
                                         int max_seconds) const {
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<SolverAnswer> answers = ask_in_one_run(scripts, max_seconds);
  const bool are_all_unsatisfiable =
      !answers.empty() && std::all_of(answers.begin(), answers.end(), [](const SolverAnswer& one) {
        return one.verdict == Satisfiability::unsatisfiable;
      });
  SolverAnswer answer;
  if (are_all_unsatisfiable) answer.verdict = Satisfiability::unsatisfiable;
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return answer;
}

std::vector<SolverAnswer> answers_in(const Output& output, const std::string& name,
                                     std::span<const std::string> scripts) {
  if (!output.in_time || output.status != 0) return {};
  std::vector<SolverAnswer> answers;
  std::string_view rest = output.out;
  for (const std::string& script : scripts) {
    const std::size_t end = rest.find(end_of_answer);
    if (end == std::string_view::npos) return {};
    const std::size_t line = rest.rfind('\n', end) + 1;  // 0 if there is no answer
    Output one;
    one.out = rest.substr(0, line);
    answers.push_back(answer_in(one, name, script));
    const std::size_t next = rest.find('\n', end);
    rest = next == std::string_view::npos ? std::string_view() : rest.substr(next + 1);
  }
  return answers;
}

SolverAnswer answer_in(const Output& output, const std::string& name, const std::string& script) {
  SolverAnswer answer;
  if (!output.in_time) return answer;
  const std::string said = first_output_line(output);
  if (said == "unknown" || said == "timeout" || said == "cvc5 interrupted by timeout.") {
    return answer;
  }
  if (output.status != 0) {
    throw SolverError(
        fmt::format("{} fails with status {}: {}", name, output.status, support::quoted(said)));
  }
  if (said == "sat") {
    answer.verdict = Satisfiability::satisfiable;
    answer.model = output.out.substr(std::min(output.out.find('\n'), output.out.size()));
    const std::string fault = fault_of_model(script, answer.model);
    if (fault.empty()) return answer;
    throw SolverError(
        fmt::format("{} says sat, but its model is wrong: {}", name, support::printable(fault)));
  }
  if (output.out != "unsat\n") {
    constexpr std::size_t most = 100;
    throw SolverError(fmt::format("{} gives an unknown answer: {}", name,
                                  support::quoted(output.out.substr(0, most))));
  }
  answer.verdict = Satisfiability::unsatisfiable;
  return answer;
}

}  // namespace fixproof::proof
