#include <fmt/format.h>

#include <array>
#include <iostream>
#include <memory>
#include <utility>

#include "cases/words.hpp"
#include "cli/arguments.hpp"
#include "cli/case_options.hpp"
#include "cli/commands.hpp"
#include "cli/judge_listing.hpp"
#include "cli/judge_text.hpp"
#include "cli/port_option.hpp"
#include "cli/rule_named.hpp"
#include "cli/solver_options.hpp"
#include "judge/clocks.hpp"
#include "judge/inspection.hpp"
#include "judge/listing.hpp"
#include "judge/load.hpp"
#include "judge/prove.hpp"
#include "judge/verdict.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

struct JudgeOptions {
  std::string file;
  std::string operation;
  std::string format = "q16_16";
  std::string rule;
  std::string rounding;
  std::string overflow = "any";
  std::string no_result = "any";
  std::string frame = "c";
  int bits = 0;  ///< 0: what the container implies
  std::string at;
  std::string symbol;
  check::CaseOptions cases;
  std::size_t shown = 3;
  bool list = false;
  bool prove = false;
  bool clocks = false;
  SolverOptions solver{.seconds = 30};
  std::string trace;
  ListingOptions listing;
};

/// Shorter names of operations that only this command takes.
constexpr std::array<std::pair<std::string_view, std::string_view>, 3> short_names{
    {{"muldiv", "mul_div"}, {"sin_cos", "cossin"}, {"transform", "xformvec"}}};

bool is_whole(cases::Operation operation) {
  return operation == cases::Operation::cossin || operation == cases::Operation::xformvec;
}

cases::Operation operation_of(std::string_view name) {
  for (const auto& [shorter, known] : short_names) {
    if (name == shorter) name = known;
  }
  const cases::Operation operation = cases::operation_named(name);
  if (!is_whole(operation) && (!check::is_judged(operation) || cases::is_conversion(operation))) {
    throw support::UsageError(fmt::format(
        "--as {}: choose mul, div, sqrt, add, sub, muldiv, sin_cos, transform, or a function of "
        "docs/functions.md; ? tries them",
        name));
  }
  return operation;
}

judge::Image image_of(const JudgeOptions& options) {
  judge::LoadOptions load{.at = options.at, .symbol = options.symbol};
  if (options.bits != 0) load.bits = options.bits;
  if (!options.at.empty() && !options.symbol.empty()) {
    throw support::UsageError("--at and --symbol both name the routine; leave one out");
  }
  return judge::load(options.file, load);
}

cases::Variant variant_of(cases::Operation operation, const cases::Format& format) {
  cases::check_format(operation, format);
  if (is_whole(operation) && format != cases::q16_16) {
    throw support::UsageError(
        fmt::format("--as {} is for q16_16; leave out --format", cases::name_of(operation)));
  }
  cases::Variant variant = check::variant_of(operation, format);
  if (operation == cases::Operation::cossin) variant.build.target = cases::Target::i386;
  return variant;
}

check::Rules rules_of(const JudgeOptions& options, const cases::Variant& variant) {
  if (!options.rule.empty()) {
    return port_rules_named(options.rule, variant.operation, variant.format);
  }
  check::Rules rules{.operation = variant.operation, .format = variant.format};
  const bool rounds = !is_whole(variant.operation) && check::is_rounded(variant.operation);
  if (!options.rounding.empty()) {
    if (!rounds) throw support::UsageError("--rounding applies only to results that are rounded");
    rules.rounding = rule_named("--rounding", options.rounding, check::roundings());
  }
  rules.overflow = rule_named("--overflow", options.overflow, check::overflow_rules(),
                              std::optional(check::Overflow::any));
  const auto no_result = check::no_result_rules(variant.operation);
  rules.no_result = no_result.empty() ? check::NoResult::any
                                      : rule_named("--no-result", options.no_result, no_result,
                                                   std::optional(check::NoResult::any));
  return rules;
}

std::string rules_line(const check::Rules& rules, bool is_open) {
  std::string text =
      fmt::format("{} {}: ", cases::name_of(rules.operation), cases::name_of(rules.format));
  if (is_whole(rules.operation)) return text + "every rule is tried";
  if (rules.port != nullptr) {
    return text + fmt::format("{}{}", port_text(*rules.port), is_open ? ", which fits" : "");
  }
  if (!check::is_rounded(rules.operation)) {
    text += "exact";
  } else {
    text += fmt::format("{}{}", check::name_of(rules.rounding),
                        is_open ? ", the rounding that fits best" : "");
  }
  if (check::can_overflow(rules.operation, rules.format)) {
    text += fmt::format("; overflow {}", check::name_of(rules.overflow));
  }
  if (check::can_lack_result(rules.operation, rules.format)) {
    text += fmt::format("; without a result {}", check::name_of(rules.no_result));
  }
  return text;
}

judge::Subject subject_of(const JudgeOptions& options, const judge::Image& image,
                          const cases::Variant& variant) {
  judge::Subject subject{image, judge::frame_named(options.frame, image.bits), variant};
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
  const cases::Format format = cases::format_named(options.format);
  std::optional<cases::Operation> best;
  double least = 0.5;
  for (const cases::Operation operation : asked) {
    if (!cases::is_in_format(operation, format)) continue;
    judge::VerdictOptions trial;
    judge::Subject subject{image, judge::frame_named(options.frame, image.bits),
                           variant_of(operation, format)};
    try {
      judge::expect_fit(subject.frame, subject.variant, image.bits);
    } catch (const support::UsageError&) {
      continue;  // another number of operands
    }
    trial.rules = {.operation = operation,
                   .overflow = check::Overflow::any,
                   .no_result = check::NoResult::any,
                   .format = format};
    trial.cases.cases = cases_to_ask;
    const judge::Verdict verdict = judge::judge_routine(subject, trial);
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
  cases::parse_words(operands, subject.variant, words);
  std::cout << judge::trace_text(subject, words);
  return 0;
}

/// Prints what single calls show. Returns whether they have no defect.
bool print_inspection(const judge::Subject& subject) {
  if (const std::string reason = judge::absence_on_unicorn(); !reason.empty()) {
    std::cout << fmt::format("\nno calls step by step: {}\n", reason);
    return true;
  }
  const judge::Inspection inspection = judge::inspect(subject);
  std::cout << '\n' << inspection_text(inspection);
  return inspection.is_clean();
}

void print_clocks(const judge::Subject& subject) {
  const std::string reason = judge::absence_on_unicorn();
  std::cout << '\n'
            << (reason.empty() ? clocks_text(judge::count_clocks(subject))
                               : fmt::format("clocks are not counted: {}\n", reason));
}

/// Prints a proof, a counterexample, or why there is neither. Returns false for a counterexample.
bool print_proof(const JudgeOptions& options, const judge::Subject& subject,
                 const judge::Verdict& verdict) {
  const proof::Solver solver(options.solver.name);
  const judge::RoutineProof proof =
      judge::prove(subject, verdict.rules, verdict.machine, solver, options.solver.seconds);
  std::cout << '\n' << proof_text(proof, verdict.rules, solver.version());
  return proof.standing != proof::Standing::disproven;
}

int judge_file(const JudgeOptions& options) {
  const support::Interrupt interrupt;
  if (!options.listing.routines.empty()) {
    return judge_against_listings(options.file, options.at, options.listing);
  }
  const judge::Image image = image_of(options);
  if (options.list) {
    std::cout << judge::source_of(image);
    return 0;
  }
  if (options.operation.empty()) {
    throw support::UsageError("--as is required; name what the routine computes, or ? to find out");
  }
  const cases::Operation operation =
      options.operation == "?" ? ask_operation(options, image) : operation_of(options.operation);
  const cases::Variant variant = variant_of(operation, cases::format_named(options.format));
  const judge::Subject subject = subject_of(options, image, variant);
  if (!options.trace.empty()) return trace_case(subject, options.trace);
  judge::VerdictOptions use{
      .rules = rules_of(options, variant), .cases = options.cases, .shown = options.shown};
  std::optional<support::FrameProgress> progress;
  use.progress = [&](std::uint64_t done, std::uint64_t all) {
    if (!progress) progress.emplace(all, "cases");
    progress->show(done);
  };
  if (is_whole(operation)) {
    if (options.prove) throw support::UsageError("--prove is for a routine with one result");
    const judge::WholeVerdict whole = judge::judge_whole(subject, use);
    progress.reset();
    std::cout << heading_text(subject, options.file, rules_line(use.rules, false))
              << whole_text(subject, whole);
    if (whole.verdict.stuck) return 1;
    const bool right = print_inspection(subject) && whole.verdict.is_right() &&
                       whole.candidates.front().exceptions == 0;
    if (options.clocks) print_clocks(subject);
    return right ? 0 : 1;
  }
  use.rounding_is_open =
      options.rounding.empty() && options.rule.empty() && check::is_rounded(operation);
  const judge::Verdict verdict = judge::judge_routine(subject, use);
  progress.reset();
  std::cout << heading_text(subject, options.file,
                            rules_line(verdict.rules, use.rounding_is_open && !verdict.stuck))
            << verdict_text(subject, verdict);
  if (verdict.stuck) return 1;
  bool right = print_inspection(subject) && verdict.is_right();
  if (options.clocks) print_clocks(subject);
  if (options.prove) right = print_proof(options, subject, verdict) && right;
  return right ? 0 : 1;
}

void add_judge_options(CLI::App& command, JudgeOptions& options) {
  command
      .add_option("file", options.file,
                  "the file with the routine: a .COM, MZ .EXE, ELF object (i386), NASM source or "
                  "flat binary")
      ->required()
      ->check(not_empty());
  command
      .add_option(
          "--as", options.operation,
          "what the routine computes: mul, div, sqrt, add, sub, muldiv, sin_cos, transform, a "
          "function of docs/functions.md, or ? to find out; required unless --list is given")
      ->check(not_empty());
  command
      .add_option("--frame", options.frame,
                  "calling convention: c, c-far, pascal, pascal-far, stdcall, or registers such as "
                  "'eax, ebx -> eax' or 'dx:ax, cx:bx -> dx:ax keeps si'")
      ->check(not_empty())
      ->capture_default_str();
  command
      .add_option("--at", options.at,
                  "where the routine is: OFFSET, OFFSET..END or, in hex, SEGMENT:OFFSET")
      ->check(not_empty());
  command
      .add_option("--symbol", options.symbol,
                  "the name of the routine in an ELF object or NASM source")
      ->check(not_empty());
  command
      .add_option("--bits", options.bits,
                  "width of the code, 16 or 32; by default 32 for an ELF object, else 16")
      ->check(CLI::IsMember({16, 32}));
  command
      .add_option("--format", options.format,
                  "format of the words: qW_F signed or uW_F unsigned, 8, 16, 32 or 64 bits in all")
      ->capture_default_str();
  command
      .add_option("--rounding", options.rounding,
                  "expected rounding: half-up, half-away, half-even, floor or toward-zero; by "
                  "default the one that fits best")
      ->check(not_empty());
  command
      .add_option("--overflow", options.overflow,
                  "expected result of an overflow: wrap, saturate, symmetric, maximum, minimum, de "
                  "or any")
      ->check(not_empty())
      ->capture_default_str();
  command
      .add_option("--no-result", options.no_result,
                  "expected result where there is none, as in a division by 0: any, or a value of "
                  "--divide-by-zero, --negative-root or --outside-domain of check")
      ->check(not_empty())
      ->capture_default_str();
  add_port_option(command, options.rule, {"--rounding", "--overflow", "--no-result"});
  add_case_options(command, options.cases);
  command.add_option("--show", options.shown, "number of wrong results to show")
      ->transform(whole_number(0, 1'000'000))
      ->capture_default_str();
  command.add_flag("--prove", options.prove,
                   "also prove the routine for all operands, or find a case that fails");
  options.solver.add_to(command);
  command.add_flag(
      "--clocks", options.clocks,
      "also count the clocks of calls on an 8088, 286, 386 and 486, by Intel's tables, "
      "and the bytes fetched");
  command.add_flag("--list", options.list,
                   "only disassemble the routine, to NASM source of the same bytes");
  command
      .add_option(
          "--trace", options.trace,
          "only run one case step by step; write its operands as gen does, such as '00018000 "
          "00020000'")
      ->check(not_empty());
  options.listing.add_to(command);
  CLI::Option* const against = command.get_option("--against-listing");
  for (const char* name :
       {"--as", "--frame", "--symbol", "--bits", "--prove", "--clocks", "--list", "--trace",
        "--format", "--rounding", "--overflow", "--no-result", "--rule", "--cases", "--level",
        "--seed", "--shard", "--show", "--timeout"}) {
    against->excludes(command.get_option(name));
  }
}

}  // namespace

void add_judge(CLI::App& app, int& status) {
  auto options = std::make_shared<JudgeOptions>();
  CLI::App* command =
      app.add_subcommand("judge", "judge a machine-code routine of your own, for 16 or 32 bits");
  add_judge_options(*command, *options);
  command->footer(
      R"(The routine runs on every case of `fixproof gen`, in a process of its own that can open no file and
start no program. It runs on this processor, or on Unicorn if the processor cannot run it.

--frame says where the operands and the result are. Name the registers in the order of the
operands, a pair with its upper half first, a pointer in brackets. In the stack conventions, the
routine must preserve (E)BP, (E)SI and (E)DI, and also EBX in 32-bit code. After registers, `keeps`
names those that it must preserve.
  mul, div, add, sub  two numbers          -> a number
  sqrt                a number             -> a number
  muldiv              a, b, c              -> a * b / c
  sin_cos             tenths of a degree (16 bits) -> cosine and sine, or pointers to them
  transform           pointers to 12, 3 and 3 numbers: matrix, vector, result

Exit status: 0 if all results are right and there is no defect, 1 if there is one, 2 for bad usage
or input, 130 if interrupted.

Examples:
  fixproof judge fixmul.asm --as mul --frame 'eax, ebx -> eax' --bits 32
  fixproof judge game.exe --as mul --at 0:1f40 --frame c-far
  fixproof judge doom.o --symbol FixedDiv --as div --rule doom
  fixproof judge fixed.o --symbol fix_div --as div --rounding toward-zero
  fixproof judge old.com --at 1a0h --as '?' --frame 'dx:ax, cx:bx -> dx:ax'
  fixproof judge demo1.exe --against-listing all --mul-round on --div-round off)");
  command->callback([options, &status] { status = judge_file(*options); });
}

}  // namespace fixproof::cli
