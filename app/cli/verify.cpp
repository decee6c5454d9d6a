#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/json/verify_json.hpp"
#include "app/cli/print_error.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/selection.hpp"
#include "app/cli/table.hpp"
#include "app/cli/words.hpp"
#include "support/file.hpp"
#include "support/interrupt.hpp"
#include "support/output_file.hpp"
#include "support/plain_text.hpp"
#include "support/thread_pool.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/words.hpp"
#include "verify/engine.hpp"
#include "verify/parties/answer.hpp"
#include "verify/recheck.hpp"
#include "verify/report_file.hpp"

namespace fixproof::cli {

namespace {

/// A killed process loses little more work than this.
constexpr std::chrono::milliseconds checkpoint_every{500};

/// Finished chunks of a state that run again before the run goes on from it. Each takes some ten
/// milliseconds, or at level 3 up to a second.
constexpr std::size_t rechecked_chunks = 4;

/// How often --case asks each party, until two differ. A function of a library may be right when it
/// is called for the first time, or spoil what another party answers after it.
constexpr int calls_of_case = 3;

struct VerifyOptions {
  Selection selection;
  std::uint64_t seed = 1994;
  unsigned threads = support::processors();
  std::string shard = "1/1";
  std::string resume;
  bool accept_other_builds = false;
  std::string report;
  std::size_t max_reports = 10;
  std::string words;
  ResultFile result;
};

int compare_case(VerifyOptions& options, std::span<const cases::Row> rows) {
  if (options.selection.operations.size() != 1)
    throw support::UsageError("--case needs exactly one operation");
  int status = 0;
  std::vector<AskedCase> asked;
  for (const cases::Row& row : rows) {
    AskedCase& one = asked.emplace_back(AskedCase{row.variant, {}, {}, true});
    one.words.resize(cases::words_in(row.variant));
    read_words(options.words, row.variant, one.words);
    for (int call = 0; call < calls_of_case && one.equal; ++call) {
      std::vector<parties::Answer> answers;
      one.said.clear();
      for (const std::string& name : row.parties) {
        answers.push_back(parties::ask(parties::party_named(name), row.variant, one.words));
        one.said.emplace_back(name, answers.back().text(row.variant.format.word_bits));
      }
      one.equal = parties::agree(answers);
    }
    if (!one.equal) status = 1;
    std::cout << fmt::format("{}: {} ({}): {}: {}\n", cases::name_of(row.variant),
                             cases::hex_words(one.words, cases::operand_bits(row.variant)),
                             cases::decimal_words(row.variant, one.words),
                             grouped_answers(one.said), one.equal ? "equal" : "DIFFER");
  }
  return options.result.write(status, [&] { return asked_json(asked); });
}

/// Refuses a state that another build made, or whose chunks give other results here.
void check_made_here(const VerifyOptions& options, const verify::Report& kept,
                     std::span<const parties::Party* const> parties) {
  const verify::Maker here = verify::this_maker(kept.plan, parties);
  for (const verify::Maker& maker : kept.makers) {
    const std::string differs = verify::difference(maker, here);
    if (differs.empty() || options.accept_other_builds) continue;
    throw support::UsageError(verify::other_build(options.resume, differs));
  }
  try {
    verify::recheck(kept, parties, rechecked_chunks);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", options.resume, error.what()));
  }
}

verify::Report begin(const VerifyOptions& options, std::vector<cases::Row> rows,
                     std::span<const parties::Party* const> parties) {
  verify::Report fresh(cases::Plan(options.selection.level, options.seed, std::move(rows)),
                       cases::parse_shard(options.shard), options.max_reports);
  if (options.resume.empty() || !std::filesystem::exists(options.resume)) return fresh;
  verify::Report kept = verify::read_report(options.resume);
  std::string differs = verify::difference(kept, fresh);
  if (differs.empty() && kept.shard != fresh.shard) {
    differs = fmt::format("shard {}/{}, not {}", kept.shard.index, kept.shard.count, options.shard);
  }
  if (!differs.empty()) {
    throw support::UsageError(fmt::format(
        "--resume {}: this file belongs to another verification: {}", options.resume, differs));
  }
  check_made_here(options, kept, parties);
  return kept;
}

void print_heading(const VerifyOptions& options, const verify::Report& report) {
  const auto counted = [](std::size_t count, std::string_view thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
  };
  std::cout << fmt::format("Level {}, seed {}, {}: {}, {} cases\n", options.selection.level,
                           options.seed, counted(options.threads, "thread"),
                           counted(report.plan.rows().size(), "row"),
                           support::grouped(report.plan.cases()));
  if (options.selection.level == 3) {
    std::cout << (has_formats(options.selection)
                      ? "Level 3 tries all cases, and leaves out rows that have more than 2^32."
                      : "Level 3 tries all pairs of 8.8 words, all 16.16 words and all angles.");
    std::cout
        << (options.selection.to.empty()
                ? " Without\n--against, fast replaces oracle; levels 1 and 2 compare the two.\n"
                : "\n");
  }
  if (report.shard.count > 1) {
    std::cout << fmt::format("Shard {}: {} of {} chunks\n", options.shard,
                             support::grouped(report.chunks_in_shard()),
                             support::grouped(report.plan.chunks()));
  }
  if (report.chunks_done() > 0) {
    std::cout << fmt::format("{}: {} of {} chunks are done\n", support::printable(options.resume),
                             support::grouped(report.chunks_done()),
                             support::grouped(report.chunks_in_shard()));
  }
  std::cout << std::endl;
  if (!std::cout) throw OutputLost();
}

/// The files of a run, locked until it ends.
struct VerifyFiles {
  explicit VerifyFiles(const VerifyOptions& options) {
    if (!options.resume.empty()) {
      resume.emplace(options.resume, support::OutputFile::Use::overwriting);
    }
    if (!options.report.empty() &&
        (options.resume.empty() || !support::same_file(options.resume, options.report))) {
      report.emplace(options.report);
    }
  }

  std::optional<support::OutputFile> resume;
  std::optional<support::OutputFile> report;  ///< none if it is the same
};

void run_remaining(const VerifyOptions& options, VerifyFiles& files, verify::Report& report) {
  const auto parties = chosen_parties(options.selection);
  Progress progress;
  auto kept = std::chrono::steady_clock::now();
  const auto observe = [&](const verify::Report& state) {
    progress.show(state);
    const auto now = std::chrono::steady_clock::now();
    if (!files.resume || now - kept < checkpoint_every) return;
    kept = now;
    try {
      files.resume->replace(verify::to_json(state));
    } catch (const std::runtime_error&) {
      // A failed checkpoint is no error: the disk may have space again for the final write.
    }
  };
  verify::run(
      report, parties,
      {.threads = options.threads, .stop = &support::Interrupt::flag(), .observe = observe});
}

std::string resume_hint(const VerifyOptions& options) {
  if (!options.resume.empty()) {
    return fmt::format("Stopped. The same command continues from {}.\n",
                       support::printable(options.resume));
  }
  if (!options.report.empty()) {
    return fmt::format("Stopped. The same command with --resume {} continues the run.\n",
                       support::printable(options.report));
  }
  return "Stopped. The results are lost; with --resume FILE a stopped run can continue.\n";
}

/// The exit status of a run that kept its findings.
int status_of(const verify::Report& report, bool has_failed) {
  // A mismatch counts even if the run is incomplete.
  if (report.mismatches() > 0) return 1;
  if (has_failed) return 2;
  return report.complete() ? 0 : support::interrupted_status;
}

int verify(VerifyOptions& options) {
  const auto parties = chosen_parties(options.selection);
  auto rows = chosen_rows(options.selection, parties);
  options.result.open({options.resume, options.report}, "--resume or --report");
  if (!options.words.empty()) return compare_case(options, rows);

  // Before the state is read: until then another run may write it.
  VerifyFiles files(options);
  verify::Report report = begin(options, std::move(rows), parties);
  print_heading(options, report);

  // Print and keep the findings even if a party fails or a file cannot be written.
  std::string party_failure;
  try {
    // Restore Ctrl-C before printing, because a write to a pipe may block on its reader.
    const support::Interrupt interrupt;
    run_remaining(options, files, report);
  } catch (const std::bad_alloc&) {
    party_failure = "out of memory";
  } catch (const std::exception& error) {
    party_failure = error.what();
  }
  std::vector<std::string> failures;
  for (auto* file : {&files.resume, &files.report}) {
    if (!*file) continue;
    try {
      (*file)->replace(verify::to_json(report));
    } catch (const std::runtime_error& error) {
      failures.emplace_back(error.what());
    }
  }
  std::cout << table(report);
  if (!report.complete()) std::cout << resume_hint(options);
  std::cout.flush();
  if (!party_failure.empty()) print_error(party_failure);
  for (const std::string& failure : failures) print_error(failure);
  if (!failures.empty()) return 2;
  return options.result.write(status_of(report, !party_failure.empty()),
                              [&] { return verify_json(report); });
}

void add_options(CLI::App& command, VerifyOptions& options) {
  Selection& selection = options.selection;
  command.add_option(
      "operations", selection.operations,
      "mul, div, cossin, xformvec, concat, sqrt, sin, cos, decimal, binary64; with --format also "
      "add, sub and, if named, the functions of docs/functions.md; by default all");
  command
      .add_option("--format", selection.formats,
                  "compare in these formats, such as q2_30,u8_8, or in all that fixed/formats.hpp "
                  "names: all")
      ->delimiter(',')
      ->check(not_empty());
  command
      .add_option(
          "--to", selection.to,
          "format of the results, such as q2_30; by default that of the words, which is then "
          "q16_16")
      ->check(not_empty());
  command
      .add_option("--level", selection.level,
                  "1 takes seconds, 2 takes minutes, 3 is exhaustive; see below")
      ->transform(whole_number(1, 3))
      ->capture_default_str();
  add_seed(command, options.seed);
  selection.variant.add_to(command, true);
  command
      .add_option_function<std::string>(
          "--width", [&](const std::string& width) { selection.half_width = width == "half"; },
          "full: 16.16; half: 8.8, where the routines run on 8-bit registers and cossin is left "
          "out")
      ->check(one_of({"full", "half"}));
  command
      .add_option("--by", selection.by,
                  "the judged party; by default model, or oracle against a function of yours")
      ->check(not_empty());
  command
      .add_option("--against", selection.against,
                  "the parties to compare it with; by default oracle,fast,type")
      ->delimiter(',')
      ->check(not_empty());
  command
      .add_option("--threads", options.threads, "number of threads; by default one per processor")
      ->transform(whole_number(1, 1024))
      ->capture_default_str();
  auto* shard = command.add_option("--shard", options.shard, "i/n: run only the i-th of n parts");
  auto* resume = command
                     .add_option("--resume", options.resume,
                                 "save the state to this file, and continue from it if it exists")
                     ->check(not_empty());
  auto* accept = command.add_flag("--accept-other-builds", options.accept_other_builds,
                                  "resume even if another build or other parties made the state");
  accept->needs(resume);
  auto* report = command
                     .add_option("--report", options.report,
                                 "write the results to this file as JSON; - is standard output")
                     ->transform(output_file());
  command.add_option("--max-reports", options.max_reports, "number of mismatches to show per row")
      ->transform(whole_number(0, verify::max_reports))
      ->capture_default_str();
  command.add_option("--case", options.words, "compare only this case, given as for eval")
      ->check(not_empty())
      ->excludes(shard)
      ->excludes(resume)
      ->excludes(report);
  options.result.add_to(command);
}

}  // namespace

void add_verify(CLI::App& app, int& status) {
  auto options = std::make_shared<VerifyOptions>();
  CLI::App* command =
      app.add_subcommand("verify", "compare the answers of the parties, case by case");
  add_options(*command, *options);
  command->footer(
      R"(Parties:
  model           the listings, compiled
  interpreter     the listings, step by step
  oracle          big integers
  fast            the same answers from 64-bit integers
  type            fixproof::number
  silicon         the assembled listings, on this processor
  unicorn         the assembled listings, on an emulator
  batch           fixed/batch/batch.hpp and radian.hpp on the fastest path;
                  mul, div, xformvec, sqrt, sin and cos
  batch-portable, batch-neon, batch-avx2, batch-avx512    one path of batch
  ./libmine.so:my_mul     your function: int32_t my_mul(int32_t a, int32_t b);
                  my_mul[] takes arrays. docs/verify.md has the signatures.
With --format, oracle, fast (up to 32 bits) and type (the named formats) answer add, sub, mul, div,
sqrt, decimal and binary64 and, if they are named, the functions of docs/functions.md (remainder in
signed formats). With --to, oracle answers all but the round trips decimal and binary64, and type what docs/functions.md lists, between
q8_8, q24_8, q16_16, q2_30 and u16_16.
Levels 1 and 2 run constructed and random cases. Level 3 is exhaustive: multiply and divide
for all pairs of 8.8 words, the unary operations for all words, with fast in place of oracle.
With --format it has all words of up to 32 bits, all pairs of up to 16 and all triples of 8.
On two processors level 2 takes some minutes and level 3 a quarter of an hour.
An option that selects a rule leaves out the rows that follow another rule. It is an error to
name a party that cannot run or does not answer every selected row.

A state or report names the builds and parties that made it and has a digest of all answers of
each chunk. --resume runs a few finished chunks again and compares the digests.

Exit status: 0 all answers are equal, 1 a mismatch, 2 bad usage or input, or a party failed,
130 interrupted. The chunk in which a party fails is not counted; the rest is kept for --resume.

Examples:
  fixproof verify                                   # every row, in seconds
  fixproof verify mul div --target i8088 --level 2  # two routines, longer
  fixproof verify --target both --against silicon   # every routine, on this processor
  fixproof verify mul div --by oracle --against batch  # the batch operations
  fixproof verify mul --target standard --against ./libmine.so:my_mul  # your function
  fixproof verify --format all                      # the type in every named format
  fixproof verify mul --format q2_30 --level 2      # one operation in one format
  fixproof verify fmod hypot3 --format q16_16       # functions run only in a format
  fixproof verify sin --to q2_30                    # an angle in 16.16, a sine in 2.30
  fixproof verify --level 3 --resume sweep.json     # everything; resumes after Ctrl-C
  fixproof verify --shard 1/4 --report 1.json       # a quarter; see fixproof merge
  fixproof verify div --case '00010000 00000003'    # every party's answer to one case)");
  command->callback([command, options, &status] {
    if (options->selection.level == 3 && command->count("--width") > 0) {
      throw support::UsageError(
          "--width: level 3 sets the width of each operation; leave --width out");
    }
    status = verify(*options);
  });
}

}  // namespace fixproof::cli
