#include "verify/proof/prove.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/json/proof_json.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/print_error.hpp"
#include "app/cli/prove_type.hpp"
#include "app/cli/selection.hpp"
#include "app/cli/solver_options.hpp"
#include "support/file.hpp"
#include "support/folder_lock.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"
#include "support/thread_pool.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/words.hpp"
#include "verify/machine_code/programs.hpp"
#include "verify/parties/interpreter.hpp"
#include "verify/proof/kill.hpp"
#include "verify/proof/lemmas.hpp"
#include "verify/proof/lost_carry.hpp"
#include "verify/proof/step_proof.hpp"
#include "verify/replay.hpp"

namespace fixproof::cli {

namespace {

struct ProveOptions {
  Selection selection;
  SolverOptions solver{.seconds = 60};
  std::string directory;
  std::size_t mutant = 0;  ///< from 1; 0 if none
  unsigned threads = support::processors();
  ResultFile result;
};

struct Tally {
  std::size_t proven = 0;
  std::size_t disproven = 0;
  std::size_t open = 0;
  std::size_t one_sided = 0;
  std::size_t disputed = 0;
  double seconds = 0;     ///< from the start to the end
  std::string failure{};  ///< what ended the proofs early
  SolverUse solver{};
  std::vector<GoalResult> goals{};

  [[nodiscard]] std::size_t undecided() const { return open + one_sided + disputed; }
  [[nodiscard]] std::size_t answered() const { return proven + disproven + undecided(); }
  void add(const GoalResult& goal) {
    ++count_of(goal.proof.standing);
    goals.push_back(goal);
  }

 private:
  std::size_t& count_of(proof::Standing standing) {
    switch (standing) {
      case proof::Standing::proven:
        return proven;
      case proof::Standing::disproven:
        return disproven;
      case proof::Standing::one_sided:
        return one_sided;
      case proof::Standing::disputed:
        return disputed;
      case proof::Standing::open:
        break;
    }
    return open;
  }
};

std::string_view word_for(proof::Standing standing) {
  switch (standing) {
    case proof::Standing::proven:
      return "proven";
    case proof::Standing::disproven:
      return "DISPROVEN";
    case proof::Standing::one_sided:
      return "one-sided";
    case proof::Standing::disputed:
      return "DISPUTED";
    case proof::Standing::open:
      break;
  }
  return "not decided";
}

/// The line of a goal, and why some of its questions are not decided.
std::string text_of(std::string_view name, const proof::Proof& proof) {
  std::string text =
      fmt::format("{:<41}{:<11}{:6.1f} s\n", name, word_for(proof.standing), proof.seconds);
  for (const std::string& remark : proof.remarks) {
    text += fmt::format("  {}\n", support::printable(remark));
  }
  return text;
}

x86model::Program sound_program(const x86model::LoopForm& form) {
  return x86model::assemble(x86model::listing(form), {});
}

/// Returns the lemmas that the proofs of routines need. The proofs of loops need none.
std::span<const proof::Lemma> lemmas_for(const Programs& programs) {
  return programs.routines.empty() ? std::span<const proof::Lemma>{} : proof::lemmas();
}

/// Returns the roundings for which the lost-carry proof runs: one per selected repaired
/// ConcatXforms, none for a mutant.
std::vector<bool> lost_carries(const ProveOptions& options, const Programs& programs) {
  std::vector<bool> roundings;
  for (const cases::Variant& v : programs.routines) {
    if (v.build.repaired && options.mutant == 0) roundings.push_back(v.build.mul_round);
  }
  return roundings;
}

std::string name_of_lost_carry(bool mul_round) {
  return fmt::format("lost carry, i8088 {}", mul_round ? "on" : "off");
}

std::string file_name(std::string name) {
  for (char& c : name) {
    if (c == ' ') c = '-';
  }
  std::erase(name, ',');
  return name + ".smt2";
}

void write_scripts(const ProveOptions& options, const Programs& programs) {
  const std::string& directory = options.directory;
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    throw support::UsageError(
        fmt::format("--write {}: cannot create this folder: {}", directory, error.message()));
  }
  const support::FolderLock lock("--write", directory);
  std::size_t written = 0;
  const auto write = [&](const std::string& name, const std::string& script) {
    support::replace_file((std::filesystem::path(directory) / file_name(name)).string(), script);
    ++written;
  };
  for (const proof::Lemma& lemma : lemmas_for(programs)) {
    write(lemma.name, fmt::format("; {}\n{}", lemma.meaning, lemma.smt));
  }
  const auto write_all = [&](const std::string& name, const std::vector<std::string>& scripts) {
    for (std::size_t i = 0; i < scripts.size(); ++i) {
      write(fmt::format("{} {}", name, i + 1),
            fmt::format(
                "; question {} of {}: {} meets its specification if all are unsatisfiable\n{}",
                i + 1, scripts.size(), name, scripts[i]));
    }
  };
  for (const cases::Variant& v : programs.routines) {
    write_all(cases::name_of(v), proof::questions(v, parties::program_of(v).instructions()));
  }
  for (const bool mul_round : lost_carries(options, programs)) {
    write_all(name_of_lost_carry(mul_round), proof::lost_carry_questions(mul_round));
  }
  for (const x86model::LoopForm& form : programs.loops) {
    write_all(machine_code::name_of(form), proof::step_questions(form, sound_program(form)));
  }
  std::cout << fmt::format("{} scripts written to {}; the proof holds if each is unsatisfiable\n",
                           written, support::printable(directory));
}

struct GoalOutcome {
  GoalResult result;
  std::string text;
};

/// What is to be proven, by a solver. May run on any thread.
using SolverGoal = std::function<GoalOutcome(const proof::Solver&)>;

GoalOutcome prove_lemma(const proof::Lemma& lemma, int seconds, const proof::Solver& solver) {
  const proof::SolverAnswer answer = solver.ask(lemma.smt, seconds);
  proof::Proof proof;
  proof.standing = proof::standing_of(answer.verdict);
  proof.seconds = answer.seconds;
  if (!answer.remark.empty()) proof.remarks.push_back(answer.remark);
  const std::string name = fmt::format("lemma {}", lemma.name);
  return {{name, proof}, text_of(name, proof)};
}

std::string with_questions(std::string_view name, const proof::Proof& proof) {
  return fmt::format("{}, {} question{}", name, proof.questions, proof.questions == 1 ? "" : "s");
}

GoalOutcome outcome_of(const std::string& name, const proof::Proof& proof) {
  return {{name, proof}, text_of(with_questions(name, proof), proof)};
}

GoalOutcome prove_routine(const cases::Variant& v, const ProveOptions& options,
                          const proof::Solver& solver) {
  x86model::Program program = parties::program_of(v);
  std::string which;
  std::string change;
  if (options.mutant != 0) {
    const x86model::Mutant mutant = proof::mutant_of(v, options.mutant);
    change = fmt::format("mutant {}: {}\n", options.mutant, mutant.change);
    program = mutant.program;
    which = fmt::format(" --mutant {}", options.mutant);
  }
  const proof::Proof proof = proof::prove(v, program, solver, options.solver.seconds);
  GoalOutcome outcome = outcome_of(cases::name_of(v), proof);
  outcome.result.variant = v;
  outcome.text = change + outcome.text;
  if (proof.standing == proof::Standing::disproven) {
    outcome.result.replay = verify::trace_line(v, proof.counterexample) + which;
    const int bits = v.format.word_bits;
    outcome.text +=
        fmt::format("  {}: the program {}, the oracle {}\n  replay: {}\n",
                    cases::hex_words(proof.counterexample, cases::operand_bits(v)),
                    proof.given.text(bits), proof.wanted.text(bits), outcome.result.replay);
  }
  return outcome;
}

/// Uses the options as long as the goals live.
std::vector<SolverGoal> goals_of(const Programs& programs, const ProveOptions& options) {
  const int seconds = options.solver.seconds;
  std::vector<SolverGoal> goals;
  for (const proof::Lemma& lemma : lemmas_for(programs)) {
    goals.emplace_back([&lemma, seconds](const proof::Solver& solver) {
      return prove_lemma(lemma, seconds, solver);
    });
  }
  for (const cases::Variant& v : programs.routines) {
    goals.emplace_back(
        [v, &options](const proof::Solver& solver) { return prove_routine(v, options, solver); });
  }
  for (const bool mul_round : lost_carries(options, programs)) {
    goals.emplace_back([mul_round, seconds](const proof::Solver& solver) {
      return outcome_of(name_of_lost_carry(mul_round),
                        proof::prove_lost_carry(mul_round, solver, seconds));
    });
  }
  for (const x86model::LoopForm& form : programs.loops) {
    goals.emplace_back([form, seconds](const proof::Solver& solver) {
      return outcome_of(machine_code::name_of(form),
                        proof::prove(form, sound_program(form), solver, seconds));
    });
  }
  return goals;
}

/// Proves several goals at a time, and prints them in their order.
Tally prove_all(const std::vector<SolverGoal>& goals, const ProveOptions& options) {
  const support::Interrupt interrupt;
  const auto begin = std::chrono::steady_clock::now();
  const proof::Solver solver(options.solver.name);
  std::cout << fmt::format("{}, at most {} s per question\n\n", solver.version(),
                           options.solver.seconds)
            << std::flush;
  Tally tally;
  tally.solver = {solver.version(), options.solver.seconds};
  std::vector<std::optional<GoalOutcome>> outcomes(goals.size());
  std::size_t shown = 0;
  const auto show = [&] {
    std::cout << outcomes[shown]->text << std::flush;
    tally.add(outcomes[shown]->result);
  };
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  support::ThreadPool(options.threads).run([&](std::size_t /*worker*/) {
    for (std::size_t i = next++; i < goals.size(); i = next++) {
      try {
        GoalOutcome outcome = goals[i](solver);
        const std::lock_guard lock(mutex);
        outcomes[i] = std::move(outcome);
        for (; shown < goals.size() && outcomes[shown]; ++shown) show();
      } catch (const support::Stopped&) {
        return;  // and so does every other worker
      } catch (const std::runtime_error& error) {
        const std::lock_guard lock(mutex);
        if (tally.failure.empty()) tally.failure = error.what();
        next = goals.size();
      }
    }
  });
  // Behind a goal without an answer. The summary counts those.
  for (; shown < goals.size(); ++shown) {
    if (outcomes[shown]) show();
  }
  tally.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return tally;
}

int summarize(const Tally& tally, std::size_t goals) {
  std::string others;
  if (tally.one_sided > 0) others += fmt::format(", {} one-sided", tally.one_sided);
  if (tally.disputed > 0) others += fmt::format(", {} DISPUTED", tally.disputed);
  std::cout << fmt::format("\n{} proven, {} disproven, {} not decided{}; {}\n", tally.proven,
                           tally.disproven, tally.open, others, support::duration(tally.seconds));
  const std::size_t left = goals - tally.answered();
  if (left > 0) {
    std::cout << fmt::format("Stopped. INCOMPLETE: {} of {} goals have no answer.\n", left, goals);
  }
  std::cout << std::flush;
  if (!tally.failure.empty()) print_error(tally.failure);
  // A counterexample counts even if goals remain.
  if (tally.disproven > 0) return 1;
  if (!tally.failure.empty() || (left == 0 && tally.undecided() > 0)) return 2;
  return left > 0 ? support::interrupted_status : 0;
}

int run(ProveOptions& options) {
  const Programs programs = chosen_programs(options.selection);
  if (options.mutant != 0 && !options.directory.empty()) {
    throw support::UsageError("--mutant excludes --write; leave one out");
  }
  if (options.mutant != 0 && (programs.routines.size() != 1 || !programs.loops.empty())) {
    throw support::UsageError(
        "--mutant needs a single variant: name one routine, --target and --round (and --chapter "
        "54)");
  }
  if (!options.directory.empty()) {
    write_scripts(options, programs);
    return 0;
  }
  options.result.open();
  const std::vector<SolverGoal> goals = goals_of(programs, options);
  const Tally tally = prove_all(goals, options);
  return options.result.write(summarize(tally, goals.size()),
                              [&] { return goals_json(tally.solver, tally.goals, goals.size()); });
}

}  // namespace

void add_prove(CLI::App& app, int& status) {
  auto options = std::make_shared<ProveOptions>();
  CLI::App* command = app.add_subcommand(
      "prove", "prove the routines, and one iteration of each inner loop, for all operands");
  add_programs_to(*command, options->selection);
  options->solver.add_to(*command);
  command
      ->add_option("--write", options->directory,
                   "write the questions as SMT-LIB files to this folder, without running a solver")
      ->check(not_empty());
  command
      ->add_option("--mutant", options->mutant,
                   "use this mutant of the routine; see fixproof mutate")
      ->transform(whole_number(1, 100'000));
  command
      ->add_option("--threads", options->threads, "goals at a time; by default one per processor")
      ->transform(whole_number(1, 1024));
  options->result.add_to(*command);
  command->get_option("--json")->excludes(command->get_option("--write"));
  command->footer(
      R"(Runs each routine symbolically along all its paths and proves that it returns the specified
result, raises the divide error exactly where specified, reads no undefined flag, stays in its
memory and preserves the caller's registers. Products and quotients stay abstract; lemmas
about integers justify this. For the repaired 8088 concat it also proves where the printed
routine differs. docs/proofs.md says what is proven and what is not.

Before the first question, each solver answers test questions whose answers are known. Every
model that it returns must satisfy its question. With --solver both a goal is proven only if
z3 and cvc5 agree. It is one-sided if only one of them decides a question, and DISPUTED if they
contradict each other.

Exit status: 0 all goals are proven, 1 a counterexample, 2 a goal is not decided, one-sided or
disputed, a solver fails or is refused, or bad usage, 130 interrupted.

Examples:
  fixproof prove
  fixproof prove div --target i8088 --solver cvc5
  fixproof prove mul div --solver both
  fixproof prove div --target i8088 --round on --mutant 3
  fixproof prove --write proofs && z3 proofs/mul-i386-on-1.smt2)");
  add_prove_type(*command, status);
  command->callback([options, command, &status] {
    if (command->get_subcommands().empty()) status = run(*options);
  });
}

}  // namespace fixproof::cli
