#include "app/cli/prove_type.hpp"

#include <fmt/format.h>

#include <atomic>
#include <boost/process/search_path.hpp>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "app/cli/arguments.hpp"
#include "app/cli/json/proof_json.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/print_error.hpp"
#include "app/cli/solver_options.hpp"
#include "judge/code/load.hpp"
#include "judge/code/machine.hpp"
#include "judge/type/answers.hpp"
#include "judge/type/compiled.hpp"
#include "judge/type/prove_goal.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"
#include "support/thread_pool.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

using judge::Goal;
using judge::GoalProof;
using proof::Standing;

struct TypeOptions {
  std::vector<std::string> compilers{"g++", "clang++"};
  std::vector<std::string> levels{"-O1", "-O2", "-O3", "-Os"};
  std::vector<std::string> only;
  std::string headers;
  std::string answers;
  std::size_t threads = 0;
  bool quick = false;
  bool lists = false;
  bool prints_source = false;
  SolverOptions solver{.seconds = 60};
};

/// The folder with fixed/fixed.hpp: next to the command, where it was built or installed.
std::string headers_of(const TypeOptions& options) {
  const auto has_type = [](const std::filesystem::path& folder) {
    return std::filesystem::exists(folder / "fixed" / "fixed.hpp");
  };
  if (!options.headers.empty()) {
    if (has_type(options.headers)) return options.headers;
    throw support::UsageError(fmt::format("--headers {}: there is no fixed/fixed.hpp in it",
                                          support::quoted(options.headers)));
  }
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const char* const near : {"../include", "../..", "."}) {
    if (has_type(program / near)) return (program / near).lexically_normal().string();
  }
  throw support::UsageError(
      "the headers of the type are not where the command is; name their folder with --headers");
}

/// One function of one object.
struct Task {
  const Goal* goal;
  std::size_t object;
};

struct Object {
  judge::Compilation how;
  std::string bytes;
};

struct Cell {
  std::size_t asked = 0;
  std::size_t proven = 0;
};

std::string line_of(const Goal& goal) {
  return fmt::format("{:<13} {}", goal.operation, goal.type);
}

bool is_wanted(const Goal& goal, const TypeOptions& options) {
  if (options.quick && goal.body.find('/') != std::string::npos) return false;
  if (options.quick && goal.body.find("_divide") != std::string::npos) return false;
  if (options.only.empty()) return true;
  return std::any_of(options.only.begin(), options.only.end(), [&](const std::string& text) {
    return goal.operation == text || line_of(goal).find(text) != std::string::npos;
  });
}

class Run {
 public:
  Run(const TypeOptions& options, const std::vector<Goal>& goals)
      : options_(options),
        solver_(options.solver.name),
        answers_(options.answers, fmt::format("{}", solver_.version())) {
    for (const std::string& compiler : options.compilers) {
      for (const std::string& level : options.levels) {
        const judge::Compilation how{compiler, level, headers_of(options)};
        objects_.push_back({how, judge::compiled(how, goals)});
        for (const Goal& goal : goals) tasks_.push_back({&goal, objects_.size() - 1});
      }
    }
  }

  int run() {
    std::cout << fmt::format("{}, at most {} s per question; {} functions in {} objects\n\n",
                             solver_.version(), options_.solver.seconds, tasks_.size(),
                             objects_.size())
              << std::flush;
    support::FrameProgress progress(tasks_.size(), "functions");
    std::atomic<std::size_t> next = 0;
    std::string failure;
    support::ThreadPool pool(options_.threads > 0 ? options_.threads : support::processors());
    pool.run([&](std::size_t /*worker*/) {
      for (std::size_t i = next++; i < tasks_.size(); i = next++) {
        try {
          const GoalProof proof = proof_of(tasks_[i]);
          const std::lock_guard lock(mutex_);
          add(tasks_[i], proof);
          progress.show(++done_);
        } catch (const support::Stopped&) {
          return;
        } catch (const std::exception& error) {
          const std::lock_guard lock(mutex_);
          failure = error.what();
          next = tasks_.size();
        }
      }
    });
    answers_.save();
    return summarize(failure);
  }

  [[nodiscard]] support::Json json() const {
    return functions_json({solver_.version(), options_.solver.seconds}, results_, tasks_.size());
  }

 private:
  GoalProof proof_of(const Task& task) {
    const Object& object = objects_[task.object];
    const judge::Image image =
        judge::load_bytes("type.o", object.bytes, {.symbol = task.goal->symbol});
    const judge::Ask ask = [this](const std::string& script, int max_seconds) {
      return answers_(script, [&]() -> proof::SolverAnswer {
        try {
          return solver_.ask(script, std::min(max_seconds, options_.solver.seconds));
        } catch (const proof::SolverError& error) {
          return {.remark = error.what()};  // there may be another way to ask
        }
      });
    };
    return judge::prove(*task.goal, image, ask);
  }

  void add(const Task& task, const GoalProof& proof) {
    const Goal& goal = *task.goal;
    const judge::Compilation& how = objects_[task.object].how;
    results_.push_back({how.compiler, how.level, goal.operation, goal.type, proof});
    Cell& cell = tallies_[goal.operation][goal.format];
    ++cell.asked;
    ++all_.asked;
    if (proof.seconds > slowest_) {
      slowest_ = proof.seconds;
      slowest_one_ = line_of(goal);
    }
    if (proof.standing == Standing::proven) {
      ++cell.proven;
      ++all_.proven;
      return;
    }
    std::string text = fmt::format("{} {}  {}: ", how.compiler, how.level, line_of(goal));
    if (proof.standing == Standing::disproven) {
      ++disproven_;
      text += "DISPROVEN for";
      for (const std::uint64_t word : proof.counterexample) text += fmt::format(" {:x}h", word);
      text += ": it " + proof.given;
    } else {
      text += "not proven: " + support::printable(proof.why);
    }
    std::cout << text << '\n' << std::flush;
  }

  int summarize(const std::string& failure) {
    std::vector<std::string> columns;
    for (const auto& [operation, formats] : tallies_) {
      for (const auto& [format, cell] : formats) {
        if (std::find(columns.begin(), columns.end(), format) == columns.end()) {
          columns.push_back(format);
        }
      }
    }
    std::string text = fmt::format("\n| {:<14} |", "proven / asked");
    for (const std::string& format : columns) text += fmt::format(" {:>9} |", format);
    text += "\n| -------------- |";
    for (std::size_t i = 0; i < columns.size(); ++i) text += " --------: |";
    for (const auto& [operation, formats] : tallies_) {
      text += fmt::format("\n| {:<14} |", "`" + operation + "`");
      for (const std::string& format : columns) {
        const auto found = formats.find(format);
        text += fmt::format(
            " {:>9} |", found == formats.end()
                            ? std::string()
                            : fmt::format("{} / {}", found->second.proven, found->second.asked));
      }
    }
    text += fmt::format(
        "\n\n{} proven, {} disproven, {} not decided; {} questions were asked before\n",
        all_.proven, disproven_, all_.asked - all_.proven - disproven_, answers_.remembered());
    if (slowest_ > 0) text += fmt::format("the slowest, {:.1f} s: {}\n", slowest_, slowest_one_);
    const std::size_t left = tasks_.size() - all_.asked;
    if (left > 0) {
      text +=
          fmt::format("Stopped. INCOMPLETE: {} of {} functions have no answer{}\n", left,
                      tasks_.size(), options_.answers.empty() ? "" : "; the same command goes on");
    }
    std::cout << text << std::flush;
    if (!failure.empty()) print_error(failure);
    if (disproven_ > 0) return 1;
    if (!failure.empty()) return 2;
    if (left > 0) return support::interrupted_status;
    return all_.proven == all_.asked ? 0 : 2;
  }

  const TypeOptions& options_;
  proof::Solver solver_;
  judge::Answers answers_;
  std::vector<Object> objects_;
  std::vector<Task> tasks_;
  std::vector<FunctionResult> results_;  ///< in the order in which they come
  std::mutex mutex_;
  std::map<std::string, std::map<std::string, Cell>> tallies_;
  Cell all_;
  std::size_t disproven_ = 0;
  std::size_t done_ = 0;
  double slowest_ = 0;
  std::string slowest_one_;
};

int run(TypeOptions options, ResultFile& result) {
  if (const std::string absence = judge::absence_on_unicorn(); !absence.empty()) {
    throw support::UsageError("each function also runs on Unicorn: " + absence);
  }
  if (options.quick) options.levels = {"-O2"};
  std::vector<Goal> goals = judge::goals();
  std::erase_if(goals, [&](const Goal& goal) { return !is_wanted(goal, options); });
  if (goals.empty()) throw support::UsageError("--only: no function has such a text");
  if (options.lists) {
    for (const Goal& goal : goals) std::cout << line_of(goal) << '\n';
    return 0;
  }
  if (options.prints_source) {
    std::cout << judge::source_of(goals);
    return 0;
  }
  for (const std::string& compiler : options.compilers) {
    std::cout << judge::version_of(compiler) << '\n';
  }
  result.open({options.answers}, "--answers");
  const support::Interrupt interrupt;
  Run proofs(options, goals);
  const int status = proofs.run();
  return result.write(status, [&] { return proofs.json(); });
}

}  // namespace

void add_prove_type(CLI::App& prove, int& status) {
  auto options = std::make_shared<TypeOptions>();
  auto result = std::make_shared<ResultFile>();
  CLI::App* command = prove.add_subcommand(
      "type", "prove the type as compilers translate it for x86-64, for all operands");
  command->add_option("--compiler", options->compilers, "compilers: names on the PATH, or paths")
      ->check(not_empty())
      ->capture_default_str();
  command->add_option("--level", options->levels, "levels of optimisation, such as --level=-O2")
      ->check(not_empty())
      ->capture_default_str();
  command->add_option("--only", options->only, "functions whose line in --list has this text")
      ->check(not_empty());
  command->add_flag("--quick", options->quick, "-O2 only, and no quotients");
  command->add_flag("--list", options->lists, "print what is proven, and ask nothing");
  command->add_flag("--source", options->prints_source,
                    "print the C++ functions that are compiled, and ask nothing");
  command
      ->add_option("--answers", options->answers,
                   "keep what is proven in this file; a later run with it goes on from there")
      ->check(not_empty());
  command->add_option("--headers", options->headers, "the folder that holds fixed/fixed.hpp")
      ->check(not_empty());
  command->add_option("--threads", options->threads, "functions at a time; by default, all cores")
      ->transform(whole_number(1, 1'024));
  options->solver.add_to(*command);
  result->add_to(*command);
  for (const char* text : {"--list", "--source"}) {
    command->get_option("--json")->excludes(command->get_option(text));
  }
  command->footer(
      R"(Compiles a function for each operation, format, rounding and rule for overflow, and proves that
its object code returns what docs/formats.md says for all operands, or raises an error exactly
where it must. Each function first runs on Unicorn, which must agree with the model of the
instructions. docs/proofs.md says what such a proof rests on.

Exit status: 0 all are proven, 1 a counterexample, 2 some are not decided, a solver or compiler
fails, or bad usage, 130 interrupted.

Examples:
  fixproof prove type --quick
  fixproof prove type --only q16_16 --compiler clang++ --level=-O3
  fixproof prove type --answers proven.txt --solver both)");
  command->callback([options, result, &status] { status = run(*options, *result); });
}

}  // namespace fixproof::cli
