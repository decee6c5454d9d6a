#include "verify/proof/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <optional>

#include "support/edits.hpp"
#include "support/usage_error.hpp"
#include "verify/proof/known_answers.hpp"

namespace fixproof::proof {

namespace {

std::vector<std::string> names_in(const std::string& name) {
  if (name == "both" || name == "any") return {"z3", "cvc5"};
  if (name == "z3" || name == "cvc5") return {name};
  throw support::UsageError(fmt::format("unknown solver '{}'; choose z3, cvc5, both or any{}", name,
                                        support::suggestion(name, {"z3", "cvc5", "both", "any"})));
}

/// Either decides each of these questions in a fraction of a second.
constexpr int seconds_for_known = 60;

/// Asks them in one run, which takes a tenth of the time.
bool gives_known_answers_together(const SolverProgram& solver) {
  const std::span<const KnownAnswer> known = known_answers();
  std::vector<std::string> scripts;
  for (const KnownAnswer& one : known) scripts.push_back(one.script);
  const std::vector<SolverAnswer> answers = solver.ask_in_one_run(scripts, seconds_for_known);
  return std::equal(answers.begin(), answers.end(), known.begin(), known.end(),
                    [](const SolverAnswer& answer, const KnownAnswer& one) {
                      return answer.verdict == one.verdict;
                    });
}

/// A solver that lies, such as one that always says unsat, would prove anything.
void expect_known_answers(const SolverProgram& solver) {
  if (gives_known_answers_together(solver)) return;
  for (const KnownAnswer& known : known_answers()) {
    std::string reply;
    try {
      const Satisfiability verdict = solver.ask(known.script, seconds_for_known).verdict;
      if (verdict == known.verdict) continue;
      reply = fmt::format("{} says {}", solver.name(), name_of(verdict));
    } catch (const SolverError& error) {
      reply = error.what();
    }
    throw SolverError(fmt::format("{} is refused: a test question ({}) is known to be {}, but {}",
                                  solver.name(), known.subject, name_of(known.verdict), reply));
  }
}

bool decides(const SolverAnswer& answer) { return answer.verdict != Satisfiability::unknown; }

/// The common verdict of two solvers.
SolverAnswer combined(const SolverAnswer& first, const SolverAnswer& second) {
  if (first.verdict == second.verdict) return first;
  if (decides(first) && decides(second)) return {.verdict = Satisfiability::disputed};
  return {.verdict = Satisfiability::one_sided};
}

}  // namespace

Solver::Solver(const std::string& name) : must_agree_(name == "both") {
  for (const std::string& program : names_in(name)) programs_.emplace_back(program);
  for (const SolverProgram& program : programs_) expect_known_answers(program);
}

std::string Solver::version() const {
  std::string versions;
  for (const SolverProgram& program : programs_) {
    versions += (versions.empty() ? "" : must_agree_ ? " and " : " or ") + program.version();
  }
  return versions;
}

SolverAnswer Solver::ask(const std::string& script, int max_seconds) const {
  if (programs_.size() == 1) return programs_.front().ask(script, max_seconds);
  return must_agree_ ? ask_both(script, max_seconds) : ask_any(script, max_seconds);
}

SolverAnswer Solver::ask_together(std::span<const std::string> scripts, int max_seconds) const {
  if (programs_.size() > 1) return {};
  return programs_.front().ask_together(scripts, max_seconds);
}

SolverAnswer Solver::ask_both(const std::string& script, int max_seconds) const {
  std::vector<SolverAnswer> answers;
  std::string remark;
  double seconds = 0;
  for (const SolverProgram& program : programs_) {
    std::string said;
    try {
      answers.push_back(program.ask(script, max_seconds));
      said = fmt::format("{}: {}", program.name(), name_of(answers.back().verdict));
    } catch (const SolverError& error) {
      answers.emplace_back();
      said = error.what();
    }
    seconds += answers.back().seconds;
    remark += (remark.empty() ? "" : "; ") + said;
  }
  SolverAnswer answer = combined(answers.front(), answers.back());
  answer.seconds = seconds;
  if (answer.verdict != Satisfiability::unsatisfiable &&
      answer.verdict != Satisfiability::satisfiable) {
    answer.remark = remark;
  }
  return answer;
}

SolverAnswer Solver::ask_any(const std::string& script, int max_seconds) const {
  // Most questions take z3 less; for some it takes a hundred times as long as for others like them.
  constexpr std::chrono::seconds head_start{1};
  std::atomic<bool> is_decided = false;
  const auto ask_one = [&](const SolverProgram& program) {
    SolverAnswer answer;
    try {
      answer = program.ask(script, max_seconds, is_decided);
      if (decides(answer)) is_decided = true;
    } catch (const SolverError& error) {
      answer.remark = error.what();
    }
    return answer;
  };
  auto first = std::async(std::launch::async, ask_one, std::cref(programs_.front()));
  std::optional<SolverAnswer> second;
  if (first.wait_for(head_start) == std::future_status::timeout) second = ask_one(programs_.back());
  const SolverAnswer answer = first.get();
  if (decides(answer)) return answer;
  if (!second) second = ask_one(programs_.back());
  if (second->remark.empty()) second->remark = answer.remark;
  return *second;
}

}  // namespace fixproof::proof
