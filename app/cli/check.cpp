#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <system_error>
#include <vector>

#include "app/cli/arguments.hpp"
#include "app/cli/case_options.hpp"
#include "app/cli/check_rules.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/json/check_json.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/option_names.hpp"
#include "app/cli/port_option.hpp"
#include "judge/check/cases.hpp"
#include "judge/check/guess_text.hpp"
#include "judge/check/judge.hpp"
#include "judge/check/results.hpp"
#include "judge/check/verdict_text.hpp"
#include "support/file.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

struct CheckOptions {
  std::string operation;
  FormatOptions formats;
  RuleOptions rules;
  std::string results;
  std::string from;
  std::string json;
  check::CaseOptions cases;
  std::size_t shown = 10;
};

constexpr std::string_view judged_operations =
    "mul, div, sqrt, add, sub, mul_add, lerp, dot, from_binary64, convert, from_decimal, "
    "to_decimal, "
    "or a function of docs/functions.md";

std::string formats_of(const cases::Variant& v) {
  std::string text = v.operation == cases::Operation::dot ? fmt::format(" of {}", v.terms) : "";
  if (v.from || v.operation == cases::Operation::convert) {
    return text + fmt::format(" {} to {}", cases::name_of(cases::operand_format(v)),
                              cases::name_of(v.format));
  }
  return v.format == cases::q16_16 ? text : text + " " + cases::name_of(v.format);
}

std::string heading(const check::Rules& rules, const std::string& cases) {
  const cases::Variant& variant = rules.variant;
  std::string text = fmt::format("{}{}: ", cases::name_of(variant.operation), formats_of(variant));
  if (rules.port != nullptr) {
    return text + fmt::format("{}; cases of {}\n\n", port_text(*rules.port), cases);
  }
  text += check::text_of_rounding(rules);
  if (check::can_overflow(variant)) {
    text += fmt::format(", overflow {}", check::text_of_overflow(rules));
  }
  if (check::can_lack_result(variant)) {
    const std::string_view option = no_result_option(variant.operation);
    std::string what(option.substr(2));
    std::ranges::replace(what, '-', ' ');
    text += fmt::format(", {} {}", what, check::text_of_no_result(rules));
  }
  return text + fmt::format("; cases of {}\n\n", cases);
}

/// If only operands without a result have wrong results, names the option that accepts these.
std::string no_result_hint(const check::Judge& judge) {
  const check::Rules& rules = judge.rules();
  const std::uint64_t wrong = judge.wrong();
  if (wrong == 0 || rules.port != nullptr ||
      judge.tally(check::CaseKind::no_result, false).wrong != wrong) {
    return "";
  }
  const check::BestRules best = judge.trial().no_result(0);
  const bool is_kept = best.first.exceptions.count() == 0;
  return fmt::format("\nAll wrong results are in the row '{}'; {} {} accepts them.\n",
                     check::name_of(check::CaseKind::no_result, rules.variant.operation),
                     no_result_option(rules.variant.operation),
                     check::name_of(is_kept ? check::no_result_rules(rules.variant)[best.rules[0]]
                                            : check::NoResult::any));
}

/// Judges the result of every case, or stops early after an interrupt.
/// @throws UsageError for an invalid result, or if there are more or fewer results than cases
void judge_all(check::CaseSource& cases, check::Results& results, check::Judge& judge) {
  const support::Interrupt interrupt;
  support::FrameProgress progress(cases.count().value_or(1), "cases");
  const cases::Variant& variant = judge.rules().variant;
  const bool by_value = check::is_judged_by_value(variant);
  check::JudgedCase one;
  std::vector<std::uint32_t> parts(cases::words_in(variant));
  const auto next_case = [&] {
    if (by_value) {
      one.valued = cases.next_valued();
      if (!one.valued) return false;
      const auto& words = one.valued->words;
      std::copy_n(words.begin(), std::min(words.size(), one.words.size()), one.words.begin());
      return true;
    }
    if (!cases.next(parts)) return false;
    check::join_words(parts, variant.format, std::span(one.words).first(operands_of(variant)));
    return true;
  };
  while (!support::Interrupt::flag() && next_case()) {
    const auto said = results.next();
    if (support::Interrupt::flag()) return;
    if (!said) {
      throw support::UsageError(fmt::format(
          "{} ends after {} result{}, but there are {} cases; give check the same options as gen",
          results.name(), support::grouped(judge.cases()), judge.cases() == 1 ? "" : "s",
          cases.count() ? support::grouped(*cases.count()) : "more"));
    }
    ++one.number;
    one.origin = cases.origin();
    one.said = *said;
    if (by_value) one.said_text = results.text();
    judge.add(one);
    if (cases.count() && judge.cases() % 4096 == 0) progress.show(judge.cases());
  }
  if (!support::Interrupt::flag() && results.next()) {
    throw support::UsageError(fmt::format(
        "{}, line {}: one result too many for {} cases; give check the same options as gen",
        results.name(), results.line(), support::grouped(judge.cases())));
  }
}

std::unique_ptr<check::CaseSource> cases_of(const cases::Variant& variant,
                                            const CheckOptions& options) {
  if (!options.from.empty()) return std::make_unique<check::FileCases>(variant, options.from);
  return std::make_unique<check::GeneratedCases>(variant, options.cases);
}

/// Returns the rounding that the results in range follow best. Sets `in` to its beginning again.
oracle::Rounding fitting_rounding(const check::Rules& rules, check::CaseSource& cases,
                                  std::stringstream& in, const std::string& name) {
  check::Results results(in, name, rules.variant.format);
  check::Judge judge(rules, 0);
  try {
    judge_all(cases, results, judge);
  } catch (const support::UsageError&) {
    // The second reading meets the same error, and reports it with what it has judged.
  }
  in.clear();
  in.seekg(0);
  return check::roundings()[check::best_rounding(judge)];
}

int check(const CLI::App& command, const CheckOptions& options) {
  const cases::Operation operation = cases::operation_named(options.operation);
  if (!check::is_judged(operation)) {
    throw support::UsageError(
        fmt::format("check {}: choose {}", options.operation, judged_operations));
  }
  const cases::Variant variant = variant_in(operation, options.formats);
  check::Rules rules = rules_of(command, options.rules, variant);
  const bool finds_rounding = options.rules.rounding == best_rounding && check::is_rounded(variant);
  if (finds_rounding && std::filesystem::exists(options.from) &&
      !std::filesystem::is_regular_file(options.from)) {
    throw support::UsageError(fmt::format(
        "--from {}: --rounding best reads the cases twice; name a regular file", options.from));
  }
  std::unique_ptr<check::CaseSource> cases = cases_of(variant, options);
  std::optional<support::OutputFile> json;
  if (!options.json.empty()) {
    for (const std::string& input : {options.from, options.results}) {
      if (!input.empty() && support::same_file(input, options.json)) {
        throw support::UsageError(fmt::format(
            "--json {}: this is also a file that check reads; name another file", options.json));
      }
    }
    json.emplace(options.json == "-" ? "/dev/stdout" : options.json);
  }
  std::ifstream file;
  if (!options.results.empty()) {
    if (!options.from.empty() && support::same_file(options.from, options.results)) {
      throw support::UsageError(fmt::format(
          "--from {}: this is also the file of results; name the file of cases", options.from));
    }
    file.open(options.results);
    if (!file) {
      throw support::UsageError(fmt::format("cannot read {}: {}", options.results,
                                            std::generic_category().message(errno)));
    }
  }
  const bool piped = options.results.empty();
  const std::string name = piped ? "standard input" : options.results;
  std::istream* input = piped ? &std::cin : &file;
  std::stringstream kept;
  if (finds_rounding) {
    kept << input->rdbuf();
    kept.clear();
    input = &kept;
    rules.rounding = fitting_rounding(rules, *cases_of(variant, options), kept, name);
  }
  check::Results results(*input, name, variant.format,
                         variant.operation == cases::Operation::to_decimal);
  check::Judge judge(rules, options.shown);
  std::string failure;
  try {
    judge_all(*cases, results, judge);
  } catch (const support::UsageError& error) {
    failure = error.what();
  }
  // Show the verdict on the results judged so far, even after an error.
  std::string text;
  if (judge.cases() > 0) {
    text = heading(rules, options.from.empty() ? options.cases.command_line(variant)
                                               : support::printable(options.from)) +
           check::verdict_text(judge) + no_result_hint(judge);
  }
  const bool stopped = support::Interrupt::flag();
  if (stopped) {
    text += fmt::format("\nSTOPPED after {}{} cases\n", support::grouped(judge.cases()),
                        cases->count() ? " of " + support::grouped(*cases->count()) : "");
  }
  if (options.json != "-") std::cout << text;
  const int status = !judge.is_right() ? 1 : stopped ? support::interrupted_status : 0;
  if (json && judge.cases() > 0 && failure.empty()) {
    const std::string document =
        support::json_text(result_json("check", status, check_json(judge, text, !stopped)));
    json->replace(document);
  }
  if (stopped) return status;
  if (!failure.empty()) throw support::UsageError(failure);
  if (judge.cases() == 0) {
    throw support::UsageError(
        "nothing was judged, because there are no cases; check --from, --shard and --cases");
  }
  return status;
}

void add_check_options(CLI::App& command, CheckOptions& options) {
  command.add_option("operation", options.operation, std::string(judged_operations))->required();
  command.add_option("results", options.results, "file of results; by default standard input")
      ->check(not_empty());
  add_format_options(command, options.formats, "");
  add_rule_options(command, options.rules);
  auto* from = command
                   .add_option("--from", options.from,
                               "file of cases; by default check makes the cases of gen")
                   ->check(not_empty());
  add_case_options(command, options.cases);
  for (const char* of_gen : {"--level", "--seed", "--shard", "--cases"}) {
    from->excludes(command.get_option(of_gen));
  }
  command
      .add_option("--json", options.json,
                  "also write the verdict as JSON to this file, or, as -, to standard output in "
                  "place of the text; docs/json.md has the members")
      ->check(not_empty());
  command.add_option("--show", options.shown, "number of wrong results to show")
      ->transform(whole_number(0, 1'000'000))
      ->capture_default_str();
}

}  // namespace

void add_check(CLI::App& app, int& status) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand(
      "check", "judge results in a file or a pipe, and find the rules that they follow");
  add_check_options(*command, *options);
  put_under(*command, "What is judged", {"--format", "--to", "--terms", "--from"});
  put_under(*command, "What is right",
            {"--rounding", "--within", "--overflow", "--divide-by-zero", "--negative-root",
             "--outside-domain", "--not-finite", "--rule"});
  put_under(*command, "Cases", {"--level", "--seed", "--shard", "--cases"});
  put_under(*command, "Verdict", {"--json", "--show"});
  command->footer(
      R"(Write the cases, make the results, judge them:
  fixproof gen mul -o cases
  ./mine <cases >results
  fixproof check mul results --rounding half-up
`fixproof judge --run './mine' --as mul` does all three, and needs no rounding. docs/judge.md shows
verdicts, and docs/judging.md explains every line.

The judged program reads the lines of `fixproof gen` and writes one result per line: 8 lower-case
hex digits (no 0x), or DE for a divide error. With --format and --to it writes the digits of the
integer of 8, 16, 32 or 64 bits that stores a word, with its sign in the bits above.
Give check the same --format, --to, --terms, --level, --seed, --shard and --cases as gen, so that
both have the same cases. With --from it reads your own cases. It skips lines that start with #, in
results and in cases.

from_binary64 takes a double as 16 hex digits, convert a word of --format and results of --to,
from_decimal a decimal number such as -1.5, and to_decimal a word. A result of to_decimal is a
decimal number such as -1.5 or 2e-3, right if the nearest word is the operand.

--overflow, --divide-by-zero, --negative-root, --outside-domain and --not-finite say what to expect
if the result does not fit a word or does not exist. The words are those of 16.16; another --format
has its own highest and lowest, and an unsigned one saturates a negative difference to 0:
  wrap        modulo 2^32
  saturate    7fffffff, or 80000000 if negative
  symmetric   7fffffff, or 80000001 if negative
  maximum     always 7fffffff
  minimum     always 80000000
  mirror      -sqrt(-x)
  zero        0
  de          DE, a divide error
  any         every result is accepted and counted
  00000000    this word, or -1.5, the word of this number
A square root can be a tie only if a unit of its results is coarser than one of its operands, or
above 1; else half-up, half-away and half-even agree. floor and toward-zero agree too, except under
mirror, where floor rounds away from zero.
Under saturate and symmetric, 0 / 0 and NaN may also be 0.

--rule names the program whose routine the results should be those of, for every operand, faults
included. Those of build are for every format with 32 bits, sign and fraction:
)" + check::port_rules_text() +
      R"(
Exit status: 0 all results are right, 1 a wrong result, 2 bad usage or input, 130 interrupted.

Examples:
  fixproof gen mul | ./mine | fixproof check mul --rounding half-up
  fixproof gen div --level 2 -o cases && ./mine < cases > results
  fixproof check div results --level 2 --rounding toward-zero --overflow saturate
  fixproof gen mul --format q1_15 | ./mine | fixproof check mul --format q1_15 --rounding floor
  fixproof gen from_binary64 --format q8_24 | ./mine |
    fixproof check from_binary64 --format q8_24 --rounding half-even --overflow saturate
  fixproof gen div | ./mine | fixproof check div --rule doom
  fixproof gen mul | ./mine | fixproof check mul --rounding best --json -
  fixproof gen add | ./mine | fixproof check add --overflow saturate
  fixproof gen sin | ./mine | fixproof check sin --within 2
  fixproof gen mul --format q2_16 --to q4_32 | ./mine | fixproof check mul --format q2_16 --to q4_32
  fixproof gen dot --terms 8 --format q1_15 | ./mine |
    fixproof check dot --terms 8 --format q1_15 --rounding floor --overflow saturate
  ./mine < few.txt | fixproof check mul --from few.txt --rounding floor --overflow any)");
  command->callback([options, command, &status] { status = check(*command, *options); });
}

}  // namespace fixproof::cli
