#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/json/mutate_json.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/selection.hpp"
#include "app/cli/solver_options.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"
#include "support/thread_pool.hpp"
#include "verify/cases/words.hpp"
#include "verify/machine_code/programs.hpp"
#include "verify/proof/kill.hpp"

namespace fixproof::cli {

namespace {

struct MutateOptions {
  Selection selection;
  SolverOptions solver{.seconds = 60};
  std::uint64_t seed = 1994;
  unsigned threads = support::processors();
  bool verbose = false;
  ResultFile result;
};

struct Trial {
  cases::Variant variant{};
  std::optional<x86model::LoopForm> loop{};  ///< if set, replaces `variant`
  std::size_t number = 0;                    ///< position among the mutants of its variant, from 1
  x86model::Mutant mutant;
  proof::MutantResult result{};
  bool done = false;
};

std::vector<Trial> trials_of(const Selection& selection) {
  std::vector<Trial> trials;
  const Programs programs = chosen_programs(selection);
  for (const cases::Variant& v : programs.routines) {
    std::size_t number = 0;
    for (x86model::Mutant& mutant : proof::mutants_of(v)) {
      trials.push_back({.variant = v, .number = ++number, .mutant = std::move(mutant)});
    }
  }
  for (const x86model::LoopForm& form : programs.loops) {
    std::size_t number = 0;
    const auto sound = x86model::assemble(x86model::listing(form), {});
    for (x86model::Mutant& mutant : x86model::mutants(sound)) {
      trials.push_back({.loop = form, .number = ++number, .mutant = std::move(mutant)});
    }
  }
  return trials;
}

std::string name_of_trial(const Trial& trial) {
  return trial.loop ? machine_code::name_of(*trial.loop) : cases::name_of(trial.variant);
}

void judge_all(std::vector<Trial>& trials, const MutateOptions& options,
               const proof::Solver& solver) {
  support::FrameProgress progress(std::max<std::size_t>(1, trials.size()), "mutants");
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::size_t done = 0;
  support::ThreadPool(options.threads).run([&](std::size_t /*worker*/) {
    try {
      for (std::size_t i = next++; i < trials.size() && !support::Interrupt::flag(); i = next++) {
        Trial& trial = trials[i];
        const auto judged = [&](const auto& subject) {
          return proof::judge(subject, trial.mutant.program, options.seed, solver,
                              options.solver.seconds);
        };
        trial.result = trial.loop ? judged(*trial.loop) : judged(trial.variant);
        const std::lock_guard lock(mutex);
        trial.done = true;
        progress.show(++done);
      }
    } catch (const support::Stopped&) {
      // An interrupt stopped the solver. This trial has no result, and every worker ends.
    } catch (...) {
      next = trials.size();
      throw;
    }
  });
}

std::string fate_of(const Trial& trial) {
  const proof::MutantResult& j = trial.result;
  switch (j.fate) {
    case proof::Fate::killed:
      return fmt::format("killed by case {}", support::grouped(j.cases));
    case proof::Fate::equivalent:
      return "equivalent";
    case proof::Fate::gap:
      break;
  }
  if (j.proof.standing != proof::Standing::disproven) {
    std::string why = j.failure;
    if (why.empty() && !j.proof.remarks.empty()) why = j.proof.remarks.front();
    const char* word = j.proof.standing == proof::Standing::disputed ? "DISPUTED"
                       : j.proof.standing == proof::Standing::one_sided
                           ? "one-sided"
                           : "the solver does not decide it";
    return fmt::format("GAP: survives level 1, {}{}{}", word, why.empty() ? "" : ": ",
                       support::printable(why));
  }
  if (trial.loop) return "GAP: survives all spans, but the proof of one iteration fails";
  return fmt::format("GAP: survives level 1, but fails at {}",
                     cases::hex_words(j.proof.counterexample, cases::operand_bits(trial.variant)));
}

MutationReport report_of(const std::vector<Trial>& trials, bool verbose) {
  MutationReport report;
  for (std::size_t i = 0; i < trials.size();) {
    MutantScore& score = report.programs.emplace_back(MutantScore{name_of_trial(trials[i])});
    for (; i < trials.size() && name_of_trial(trials[i]) == score.name; ++i) {
      const Trial& trial = trials[i];
      if (!trial.done) {
        ++report.left;
        continue;
      }
      score.add(trial.result);
      report.all.add(trial.result);
      if (verbose || trial.result.fate == proof::Fate::gap) {
        report.notable.push_back({score.name, trial.number, trial.mutant.change, fate_of(trial)});
      }
    }
  }
  return report;
}

std::string line_of(const MutantScore& score) {
  return fmt::format("{:<28}{:>8}{:>8}{:>12}{:>6}{:>16}\n", score.name,
                     support::grouped(score.mutants), support::grouped(score.killed),
                     support::grouped(score.equivalent), score.gaps,
                     support::grouped(score.slowest));
}

void print(const MutationReport& report) {
  for (const NotableMutant& one : report.notable) {
    std::cout << fmt::format("{}, mutant {}: {}: {}\n", one.program, one.number, one.change,
                             one.fate);
  }
  std::cout << (report.notable.empty() ? "" : "\n")
            << fmt::format("{:<28}{:>8}{:>8}{:>12}{:>6}{:>16}\n", "routine", "mutants", "killed",
                           "equivalent", "gaps", "slowest kill");
  for (const MutantScore& score : report.programs) std::cout << line_of(score);
  const MutantScore& all = report.all;
  const std::size_t mortal = all.killed + all.gaps;
  std::cout << line_of(all)
            << fmt::format(
                   "\nScore: {} of {} mutants that are not equivalent are killed by level 1"
                   " ({:.2f} %); {}\n",
                   support::grouped(all.killed), support::grouped(mortal),
                   mortal == 0
                       ? 100.0
                       : 100.0 * static_cast<double>(all.killed) / static_cast<double>(mortal),
                   support::duration(report.seconds));
  if (report.left > 0) {
    std::cout << fmt::format("Stopped. INCOMPLETE: {} mutants are not judged.\n",
                             support::grouped(report.left));
  }
}

int run(MutateOptions& options) {
  options.result.open();
  std::vector<Trial> trials;
  SolverUse use{{}, options.solver.seconds};
  const auto begin = std::chrono::steady_clock::now();
  {
    // Restore Ctrl-C before printing, because the output may block on its reader.
    const support::Interrupt interrupt;
    // Before the mutants, which take seconds to make.
    const proof::Solver solver(options.solver.name);
    use.version = solver.version();
    trials = trials_of(options.selection);
    std::cout << fmt::format("{} mutants, seed {}, {}\n\n", support::grouped(trials.size()),
                             options.seed, use.version)
              << std::flush;
    judge_all(trials, options, solver);
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  MutationReport report = report_of(trials, options.verbose);
  report.solver = use;
  report.seed = options.seed;
  report.seconds = passed.count();
  print(report);
  const int status = report.all.gaps > 0 ? 1 : report.left > 0 ? support::interrupted_status : 0;
  return options.result.write(status, [&] { return mutate_json(report); });
}

}  // namespace

void add_mutate(CLI::App& app, int& status) {
  auto options = std::make_shared<MutateOptions>();
  CLI::App* command = app.add_subcommand(
      "mutate", "change one instruction at a time, and test that level 1 detects the change");
  add_programs_to(*command, options->selection);
  add_seed(*command, options->seed);
  options->solver.add_to(*command);
  command
      ->add_option("--threads", options->threads, "number of threads; by default one per processor")
      ->transform(whole_number(1, 1024));
  command->add_flag("--verbose", options->verbose, "print the result of every mutant");
  options->result.add_to(*command);
  command->footer(
      R"(Changes every instruction of every routine and inner loop in every way that
x86model/mutants.hpp lists, one at a time. A mutant is killed by the first case of level 1 on
which it differs from the oracle or raises an unexpected error. One that survives a few cases of
every stream is equivalent if it computes the same terms as the routine. For one that survives all
cases, the solver proves that it is equivalent for all operands, or it is a gap in the
verification. Inner loops run spans of every length up to 320 pixels.

A mutant that the solver does not decide is a gap too. With --solver both, so is one on which z3
and cvc5 do not agree. `fixproof prove --help` says how solvers are tested.

Exit status: 0 no gap, 1 a gap, 2 bad usage or a solver is refused, 130 interrupted.

Examples:
  fixproof mutate mul div
  fixproof mutate div --target i8088 --round on --verbose)");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace fixproof::cli
