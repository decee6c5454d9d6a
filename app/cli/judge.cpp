#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <iostream>
#include <memory>
#include <tuple>
#include <utility>

#include "app/cli/case_options.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/json/judge_json.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/judge_listing.hpp"
#include "app/cli/judge_options.hpp"
#include "app/cli/judge_program.hpp"
#include "app/cli/judge_rules.hpp"
#include "app/cli/judge_text.hpp"
#include "app/cli/option_names.hpp"
#include "app/cli/proof_progress.hpp"
#include "app/cli/words.hpp"
#include "judge/code/clocks.hpp"
#include "judge/code/code_width.hpp"
#include "judge/code/inspection.hpp"
#include "judge/code/listing.hpp"
#include "judge/code/load.hpp"
#include "judge/code/prove.hpp"
#include "judge/code/verdict.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

/// Shorter names of operations that only this command takes.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> short_names{
    {{"muldiv", "mul_div"}, {"cos_sin", "cossin"}, {"transform", "xformvec"}}};

cases::Operation operation_of(std::string_view name) {
  for (const auto& [shorter, known] : short_names) {
    if (name == shorter) name = known;
  }
  const cases::Operation operation = cases::operation_named(name);
  const bool is_of_words = check::is_judged(operation) && (!cases::is_conversion(operation) ||
                                                           operation == cases::Operation::convert);
  if (!is_whole(operation) && !is_of_words) {
    throw support::UsageError(fmt::format(
        "--as {}: choose mul, div, sqrt, add, sub, muldiv, mul_add, lerp, dot, convert, cos_sin, "
        "transform, or a function of docs/functions.md; ? tries them",
        name));
  }
  return operation;
}

/// Takes FILE:FUNCTION apart, unless there is a file of that name. A name of C++ has colons, too.
JudgeOptions with_symbol(JudgeOptions options) {
  std::error_code none;
  if (std::filesystem::exists(options.file, none)) return options;
  std::size_t colon = options.file.rfind(':');
  while (colon != std::string::npos && colon > 0 &&
         !std::filesystem::is_regular_file(options.file.substr(0, colon), none)) {
    colon = options.file.rfind(':', colon - 1);
  }
  if (colon == std::string::npos || colon == 0 || colon + 1 == options.file.size()) return options;
  if (!options.symbol.empty()) {
    throw support::UsageError(fmt::format("{} and --symbol both name the routine; leave one out",
                                          support::quoted(options.file)));
  }
  options.symbol = options.file.substr(colon + 1);
  options.file.resize(colon);
  return options;
}

judge::Image image_of(const JudgeOptions& options) {
  judge::LoadOptions load{.at = options.at, .symbol = options.symbol};
  if (options.bits != 0) load.bits = options.bits;
  if (!options.at.empty() && !options.symbol.empty()) {
    throw support::UsageError(
        "--at and --symbol, or FILE:FUNCTION, both name the routine; leave one out");
  }
  return judge::load(options.file, load);
}

/// @throws support::UsageError for what is there for x86 only
void expect_x86(const JudgeOptions& options, const judge::Image& image) {
  if (image.architecture == nullptr) return;
  for (const auto& [is_given, name, instead] :
       {std::tuple{options.list, "--list", "; the toolchain's objdump -d disassembles it"},
        std::tuple{options.prove, "--prove", ""},
        std::tuple{options.clocks, "--clocks", "; the number of instructions is always printed"}}) {
    if (!is_given) continue;
    throw support::UsageError(fmt::format("{} is for x86, and this is code for {}{}", name,
                                          judge::code_name(image), instead));
  }
}

cases::Variant judged_variant(cases::Operation operation, const JudgeOptions& options) {
  cases::Variant variant = variant_in(operation, options.formats());
  if (is_whole(operation) && variant.format != cases::q16_16) {
    throw support::UsageError(
        fmt::format("--as {} is for q16_16; leave out --format", cases::name_of(operation)));
  }
  if (operation == cases::Operation::cossin) variant.build.target = cases::Target::i386;
  return variant;
}

judge::Subject subject_of(const JudgeOptions& options, const judge::Image& image,
                          const cases::Variant& variant) {
  judge::Subject subject{image, judge::frame_for(image, options.frame, variant), variant};
  judge::expect_fit(subject.frame, variant, image.bits);
  return subject;
}

/// What `--as ?` tries, in order of preference.
constexpr std::array asked{
    cases::Operation::mul,  cases::Operation::div,   cases::Operation::add,
    cases::Operation::sub,  cases::Operation::sqrt,  cases::Operation::mul_div,
    cases::Operation::fmod, cases::Operation::hypot, cases::Operation::atan2,
    cases::Operation::sin,  cases::Operation::cos,   cases::Operation::exp2,
    cases::Operation::log2, cases::Operation::rsqrt, cases::Operation::reciprocal};
constexpr std::uint64_t cases_to_ask = 2000;

/// Prints how well each operation fits, and returns the one whose rounding fits most cases in
/// range.
/// @throws support::UsageError if none fits half of them
cases::Operation ask_operation(const JudgeOptions& options, const judge::Image& image) {
  const cases::Format format = cases::judged_format_named(options.format);
  std::optional<cases::Operation> best;
  double least = 0.5;
  for (const cases::Operation operation : asked) {
    if (!cases::is_in_format(operation, format)) continue;
    judge::VerdictOptions trial;
    std::optional<judge::Subject> fitting;
    try {
      fitting.emplace(subject_of(options, image, judged_variant(operation, options)));
    } catch (const support::UsageError&) {
      continue;  // another number of operands, or no results in the format of --to
    }
    const judge::Subject& subject = *fitting;
    trial.rules = {.variant = subject.variant,
                   .overflow = check::Overflow::any,
                   .no_result = check::NoResult::any};
    trial.cases.cases = cases_to_ask;
    const judge::Verdict verdict = judge::judge_routine(subject, trial);
    if (verdict.is_stopped) throw support::Stopped();
    if (verdict.stuck) continue;
    const check::RuleScore score = verdict.judge->trial().rounding().first;
    if (score.cases == 0) continue;
    const double share =
        static_cast<double>(score.exceptions.count()) / static_cast<double>(score.cases);
    std::cout << fmt::format("{:<12} {:5.1f} % of {} cases in range\n", cases::name_of(operation),
                             100 * (1 - share), support::grouped(score.cases));
    if (share >= least) continue;
    least = share;
    best = operation;
  }
  if (!best) {
    throw support::UsageError(
        "--as ?: no operation fits half of its cases; check --frame, --format and --bits");
  }
  std::cout << '\n';
  return *best;
}

int trace_case(const judge::Subject& subject, const std::string& operands) {
  if (const std::string reason = judge::absence_on_unicorn(); !reason.empty()) {
    throw support::UsageError(fmt::format("--trace: {}", reason));
  }
  std::vector<std::uint32_t> words(words_in(subject.variant));
  read_words(operands, subject.variant, words);
  const judge::TraceText trace = judge::trace_text(subject, words);
  std::cout << trace.steps;
  if (trace.ending.end != judge::End::returned) {
    std::cout << text_of(trace.ending, subject.image) << '\n';
  }
  return 0;
}

/// Prints what single calls show. Returns whether they have no defect.
bool print_inspection(const judge::Subject& subject, RoutineFindings& found) {
  if (const std::string reason = judge::absence_on_unicorn(); !reason.empty()) {
    std::cout << fmt::format("\nno calls step by step: {}\n", reason);
    return true;
  }
  const judge::Inspection& inspection = found.inspection.emplace(judge::inspect(subject));
  std::cout << '\n' << inspection_text(inspection, subject.image);
  // Code for older processors has a table of clocks, which counts instructions, too.
  if (subject.image.bits == 64 || subject.image.architecture != nullptr) {
    std::cout << instructions_text(inspection);
  }
  return inspection.is_clean();
}

void print_clocks(const judge::Subject& subject, RoutineFindings& found) {
  if (subject.image.bits == 64) {
    std::cout << "\nclocks are not counted: none of the four processors has 64-bit code\n";
    return;
  }
  const std::string reason = judge::absence_on_unicorn();
  std::cout << '\n'
            << (reason.empty() ? clocks_text(found.clocks.emplace(judge::count_clocks(subject)))
                               : fmt::format("clocks are not counted: {}\n", reason));
}

/// Prints a proof, a counterexample, or why there is neither. Returns false for a counterexample.
bool print_proof(const JudgeOptions& options, const judge::Subject& subject,
                 RoutineFindings& found) {
  const judge::Verdict& verdict = found.verdict();
  const proof::Solver solver(options.solver.name);
  found.solver = solver.version();
  const auto prove = [&] {
    ProofProgress progress;
    return judge::prove(subject, verdict.rules, verdict.machine, solver, options.solver.seconds,
                        [&](const judge::ProofStep& step) { progress.show(step); });
  };
  const judge::RoutineProof& proof = found.proof.emplace(prove());
  std::cout << '\n' << proof_text(proof, verdict.rules, found.solver);
  return proof.standing != proof::Standing::disproven;
}

/// Tells whether a routine fails as code for another width does.
bool fails_widely(const judge::Verdict& verdict) {
  if (verdict.stuck) return verdict.stuck->ending.end != judge::End::endless;
  return verdict.judge && 2 * verdict.judge->wrong() > verdict.judge->cases();
}

/// Returns the exit status. If the routine fails, it may be code that the machine misreads.
int status_of(bool right, const judge::Image& image, const judge::Verdict& verdict) {
  if (right) return 0;
  if (image.architecture == nullptr && image.bits < 64 && judge::looks_like_64_bits(image)) {
    std::cout << fmt::format(
        "\nThe code looks like 64-bit code, and ran as {}-bit code: add --bits 64.\n", image.bits);
  } else if (image.has_assumed_bits && fails_widely(verdict)) {
    std::cout << "\nThe code ran as 16-bit code: add --bits 32 if it has 32 bits.\n";
    if (image.container == judge::flat_container) {
      std::cout << "If it is not for x86, give the ELF file that it was made from.\n";
    }
  }
  return 1;
}

/// Says after how many cases an interrupt came, and returns the exit status.
int status_of_stopped(const judge::Verdict& verdict, const cases::Variant& variant,
                      const check::CaseOptions& cases, bool right) {
  const std::uint64_t all = check::GeneratedCases(variant, cases).count().value_or(0);
  std::cout << fmt::format("\nSTOPPED after {} of {} cases\n", support::grouped(verdict.cases),
                           support::grouped(all));
  return right ? support::interrupted_status : 1;
}

/// Judges a routine whose results have several words, and returns the exit status.
int judge_whole_results(const JudgeOptions& options, const judge::Subject& subject,
                        const judge::VerdictOptions& use,
                        std::optional<support::FrameProgress>& progress, RoutineFindings& found) {
  if (options.prove) throw support::UsageError("--prove is for a routine with one result");
  const judge::WholeVerdict& whole = found.of_whole.emplace(judge::judge_whole(subject, use));
  progress.reset();
  found.rules = rules_line(use.rules, Rounding::given);
  std::cout << heading_text(subject, options.file, found.rules)
            << (whole.verdict.cases > 0 || whole.verdict.stuck ? whole_text(subject, whole) : "");
  if (whole.verdict.stuck) return status_of(false, subject.image, whole.verdict);
  bool right = whole.verdict.is_right() && whole.candidates.front().exceptions == 0;
  if (whole.verdict.is_stopped) {
    return status_of_stopped(whole.verdict, subject.variant, use.cases, right);
  }
  right = print_inspection(subject, found) && right;
  if (options.clocks) print_clocks(subject, found);
  return status_of(right, subject.image, whole.verdict);
}

/// Judges a routine with one result, and returns the exit status.
int judge_numbers(const JudgeOptions& options, const judge::Subject& subject,
                  judge::VerdictOptions& use, std::optional<support::FrameProgress>& progress,
                  RoutineFindings& found) {
  const cases::Variant& variant = subject.variant;
  use.rounding_is_open = is_open(options) && check::is_rounded(variant);
  const judge::Verdict& verdict = found.of_numbers.emplace(judge::judge_routine(subject, use));
  progress.reset();
  const bool has_verdict = verdict.cases > 0 || verdict.stuck;
  const Rounding rounding = !use.rounding_is_open                            ? Rounding::given
                            : verdict.stuck || verdict.state || !has_verdict ? Rounding::unknown
                                                                             : Rounding::fitting;
  found.rules = rules_line(verdict.rules, rounding);
  std::cout << heading_text(subject, options.file, found.rules)
            << (has_verdict ? verdict_text(subject, verdict) : "");
  if (verdict.stuck) return status_of(false, subject.image, verdict);
  if (verdict.is_stopped) {
    return status_of_stopped(verdict, variant, use.cases, verdict.is_right());
  }
  bool right = print_inspection(subject, found) && verdict.is_right();
  if (options.clocks) print_clocks(subject, found);
  if (options.prove && !verdict.state) right = print_proof(options, subject, found) && right;
  return status_of(right, subject.image, verdict);
}

int judge_file(const JudgeOptions& given, const CLI::App& command, ResultFile& result) {
  const support::Interrupt interrupt;
  expect_effects(command);
  if (!given.run.program.empty()) {
    result.open();
    return judge_program(given, command, result);
  }
  if (!given.listing.routines.empty()) {
    result.open({given.file}, "the code");
    return judge_against_listings(given.file, given.at, given.listing, result);
  }
  const JudgeOptions options = with_symbol(given);
  result.open({options.file}, "the code");
  const judge::Image image = image_of(options);
  expect_x86(options, image);
  if (options.list) {
    std::cout << judge::source_of(image);
    return 0;
  }
  if (options.operation.empty()) {
    throw support::UsageError(
        "--as is required; name what the routine computes, such as --as mul, or --as '?' to find "
        "out");
  }
  const cases::Operation operation =
      options.operation == "?" ? ask_operation(options, image) : operation_of(options.operation);
  const cases::Variant variant = judged_variant(operation, options);
  const judge::Subject subject = subject_of(options, image, variant);
  if (!options.trace.empty()) return trace_case(subject, options.trace);
  judge::VerdictOptions use{
      .rules = rules_of(options, variant), .cases = options.cases, .shown = options.shown};
  std::optional<support::FrameProgress> progress;
  use.progress = [&](std::uint64_t done, std::uint64_t all) {
    if (!progress) progress.emplace(all, "cases");
    progress->show(done);
  };
  RoutineFindings found;
  const int status = is_whole(operation)
                         ? judge_whole_results(options, subject, use, progress, found)
                         : judge_numbers(options, subject, use, progress, found);
  return result.write(status, [&] { return routine_json(subject, options.file, found); });
}

}  // namespace

void add_judge(CLI::App& app, int& status) {
  auto options = std::make_shared<JudgeOptions>();
  CLI::App* command = app.add_subcommand(
      "judge", "judge your code: a function in C, machine code, or a program in any language");
  auto result = std::make_shared<ResultFile>();
  options->add_to(*command);
  result->add_to(*command);
  put_under(*command, "Cases", {"--json"});
  command->callback(
      [options, result, command, &status] { status = judge_file(*options, *command, *result); });
}

}  // namespace fixproof::cli
