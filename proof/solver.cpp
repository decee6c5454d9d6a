#include "proof/solver.hpp"

#include <fmt/format.h>

#include <chrono>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "proof/process.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

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

}  // namespace

Solver::Solver(const std::string& name) : name_(name) {
  if (name != "z3" && name != "cvc5") {
    throw support::UsageError(fmt::format("unknown solver '{}'; choose z3 or cvc5", name));
  }
  Output output;
  try {
    output = run_program({name, "--version"}, "", version_limit);
  } catch (const std::system_error& error) {
    throw support::UsageError(fmt::format("{} cannot be run: {}; install Debian's package {}", name,
                                          error.code().message(), name));
  }
  if (!output.in_time)
    throw support::UsageError(
        fmt::format("{} --version does not end within {} s", name, version_limit.count()));
  if (output.status != 0 || output.out.empty()) {
    throw support::UsageError(fmt::format("{} --version fails with status {}: {}", name,
                                          output.status,
                                          fixproof::support::quoted(first_output_line(output))));
  }
  version_ = support::printable(first_line(output.out));
}

SolverAnswer Solver::ask(const std::string& script, int max_seconds) const {
  const auto begin = std::chrono::steady_clock::now();
  const Output output =
      run_program(command_of(name_, max_seconds), script, seconds(max_seconds) + grace);
  SolverAnswer answer;
  answer.text = output.out;
  answer.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!output.in_time) return answer;
  const std::string line = first_output_line(output);
  if (line == "unknown" || line.find("timeout") != std::string::npos) return answer;
  if (output.status != 0) {
    throw std::runtime_error(fmt::format("{} fails with status {}: {}", name_, output.status,
                                         fixproof::support::quoted(line)));
  }
  if ((line != "unsat" && line != "sat") || output.out.find("(error") != std::string::npos) {
    throw std::runtime_error(
        fmt::format("{} gives an unknown answer: {}", name_, fixproof::support::quoted(line)));
  }
  answer.verdict = line == "sat" ? Satisfiability::satisfiable : Satisfiability::unsatisfiable;
  return answer;
}

}  // namespace fixproof::proof
