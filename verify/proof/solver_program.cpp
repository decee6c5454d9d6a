#include "verify/proof/solver_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>
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

SolverAnswer SolverProgram::ask_together(std::span<const std::string> scripts,
                                         int max_seconds) const {
  std::string all;
  std::string expected;
  for (const std::string& script : scripts) {
    all += script + "(reset)\n";
    expected += "unsat\n";
  }
  const auto begin = std::chrono::steady_clock::now();
  SolverAnswer answer;
  try {
    const Output output = output_for(name_, max_seconds, all, never_cancelled);
    if (output.in_time && output.status == 0 && output.out == expected) {
      answer.verdict = Satisfiability::unsatisfiable;
    }
  } catch (const SolverError&) {
    // No answer.
  }
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return answer;
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
