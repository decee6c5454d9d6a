#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <iostream>
#include <memory>
#include <system_error>
#include <utility>

#include "app/cli/arguments.hpp"
#include "app/cli/case_options.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/port_option.hpp"
#include "app/cli/rule_named.hpp"
#include "judge/check/cases.hpp"
#include "judge/check/judge.hpp"
#include "judge/check/results.hpp"
#include "judge/check/verdict_text.hpp"
#include "support/file.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

struct CheckOptions {
  std::string operation;
  std::string format = "q16_16";
  std::string to;
  std::string rule;
  std::string rounding;
  std::string overflow;
  std::string divide_by_zero = "de";
  std::string negative_root = "de";
  std::string not_finite = "de";
  std::string outside_domain = "de";
  std::string results;
  std::string from;
  check::CaseOptions cases;
  std::size_t shown = 10;
};

constexpr std::string_view judged_operations =
    "mul, div, sqrt, add, sub, from_binary64, convert, from_decimal, to_decimal, or a function of "
    "docs/functions.md";

/// The option for operands without a result, and its value.
std::pair<std::string_view, std::string_view> no_result_option(const CheckOptions& options,
                                                               cases::Operation operation) {
  if (cases::is_function(operation)) return {"--outside-domain", options.outside_domain};
  if (operation == cases::Operation::sqrt) return {"--negative-root", options.negative_root};
  if (operation == cases::Operation::from_binary64) return {"--not-finite", options.not_finite};
  return {"--divide-by-zero", options.divide_by_zero};
}

check::Rules rules_of(const CheckOptions& options) {
  check::Rules rules;
  rules.operation = cases::operation_named(options.operation);
  if (!check::is_judged(rules.operation)) {
    throw support::UsageError(
        fmt::format("check {}: choose {}", options.operation, judged_operations));
  }
  const cases::Variant variant =
      variant_in(rules.operation, cases::format_named(options.format), options.to);
  rules.format = variant.format;
  rules.from = variant.from;
  if (!options.rule.empty()) {
    return port_rules_named(options.rule, rules.operation, rules.format);
  }
  if (check::is_rounded(rules.operation)) {
    if (options.rounding.empty()) {
      throw support::UsageError(
          fmt::format("check {}: --rounding or --rule is required; name the rule that results "
                      "should follow, such as half-up",
                      options.operation));
    }
    rules.rounding = rule_named("--rounding", options.rounding, check::roundings());
  }
  const bool is_function = cases::is_function(rules.operation);
  const std::string_view overflow = !options.overflow.empty() ? std::string_view(options.overflow)
                                    : is_function             ? "saturate"
                                                              : "wrap";
  rules.overflow = rule_named("--overflow", overflow, check::overflow_rules(),
                              std::optional(check::Overflow::any));
  if (is_function && rules.overflow == check::Overflow::wrap) {
    throw support::UsageError(
        fmt::format("--overflow wrap: {} is judged by results in range; choose another rule",
                    options.operation));
  }
  cases::check_format(rules.operation, rules.format);
  if (check::can_lack_result(rules.operation, rules.format)) {
    const auto [option, rule] = no_result_option(options, rules.operation);
    rules.no_result = rule_named(option, rule, check::no_result_rules(rules.operation),
                                 std::optional(check::NoResult::any));
  }
  return rules;
}

std::string formats_of(const check::Rules& rules) {
  if (rules.operation == cases::Operation::convert) {
    return fmt::format(" {} to {}", cases::name_of(rules.from), cases::name_of(rules.format));
  }
  return rules.format == cases::q16_16 ? "" : " " + cases::name_of(rules.format);
}

std::string heading(const check::Rules& rules, const std::string& cases) {
  if (rules.port != nullptr) {
    return fmt::format("{}{}: {}; cases of {}\n\n", cases::name_of(rules.operation),
                       formats_of(rules), port_text(*rules.port), cases);
  }
  const bool rounded = check::is_rounded(rules.operation);
  std::string text =
      fmt::format("{}{}: {}", cases::name_of(rules.operation), formats_of(rules),
                  rounded ? check::name_of(rules.rounding) : std::string_view("exact"));
  if (check::can_overflow(rules.operation, rules.format)) {
    text += fmt::format(", overflow {}", check::name_of(rules.overflow));
  }
  if (cases::divides(rules.operation)) {
    text += fmt::format(", divide by zero {}", check::name_of(rules.no_result));
  }
  if (rules.operation == cases::Operation::sqrt && rules.format.is_signed) {
    text += fmt::format(", negative root {}", check::name_of(rules.no_result));
  }
  if (rules.operation == cases::Operation::from_binary64) {
    text += fmt::format(", not finite {}", check::name_of(rules.no_result));
  }
  if (cases::is_function(rules.operation)) {
    text += fmt::format(", outside domain {}", check::name_of(rules.no_result));
  }
  return text + fmt::format("; cases of {}\n\n", cases);
}

/// If only operands without a result have wrong results, names the option that accepts these.
std::string no_result_hint(const check::Judge& judge, const CheckOptions& options) {
  const check::Rules& rules = judge.rules();
  const std::uint64_t wrong = judge.wrong().count();
  if (wrong == 0 || rules.port != nullptr ||
      judge.tally(check::CaseKind::no_result, false).wrong != wrong) {
    return "";
  }
  const check::BestRules best = judge.trial().no_result(0);
  const bool is_kept = best.first.exceptions.count() == 0;
  return fmt::format(
      "\nAll wrong results are in the row '{}'; {} {} accepts them.\n",
      check::name_of(check::CaseKind::no_result, rules.operation),
      no_result_option(options, rules.operation).first,
      check::name_of(is_kept ? check::no_result_rules(rules.operation, rules.format)[best.rules[0]]
                             : check::NoResult::any));
}

/// Judges the result of every case, or stops early after an interrupt.
/// @throws UsageError for an invalid result, or if there are more or fewer results than cases
void judge_all(check::CaseSource& cases, check::Results& results, check::Judge& judge) {
  const support::Interrupt interrupt;
  support::FrameProgress progress(cases.count().value_or(1), "cases");
  const cases::Format& format = judge.rules().format;
  const cases::Operation operation = judge.rules().operation;
  const bool converts = check::is_judged_by_value(operation);
  const auto arity = cases::words_in(judge.rules().operation);
  check::JudgedCase one;
  std::array<std::uint32_t, 6> room{};  // three operands of 64 bits
  const auto parts = std::span(room).first(arity * cases::words_per_number(format));
  const auto next_case = [&] {
    if (converts) return (one.converted = cases.next_converted()).has_value();
    if (!cases.next(parts)) return false;
    check::join_words(parts, format, std::span(one.words).first(arity));
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
    if (converts) one.said_text = results.text();
    judge.add(one);
    if (cases.count() && judge.cases() % 4096 == 0) progress.show(judge.cases());
  }
  if (!support::Interrupt::flag() && results.next()) {
    throw support::UsageError(fmt::format(
        "{}, line {}: one result too many for {} cases; give check the same options as gen",
        results.name(), results.line(), support::grouped(judge.cases())));
  }
}

/// Rejects options that have no effect on the operation, because they are probably mistakes.
void refuse_idle_options(const CLI::App& command, cases::Operation operation,
                         const cases::Format& format) {
  const auto refuse = [&command](const char* option, bool applies, std::string_view operations) {
    if (applies || command.count(option) == 0) return;
    throw support::UsageError(
        fmt::format("{} applies only to {}; leave it out", option, operations));
  };
  refuse("--rounding", check::is_rounded(operation), "results that are rounded");
  refuse("--overflow", check::can_overflow(operation, format), "results that can overflow");
  refuse("--not-finite", operation == cases::Operation::from_binary64, "from_binary64");
  refuse("--outside-domain", cases::is_function(operation), "functions of real numbers");
  refuse("--divide-by-zero", cases::divides(operation), "div, mul_div, fmod and remainder");
  refuse("--negative-root", operation == cases::Operation::sqrt && format.is_signed,
         "sqrt of a signed format");
}

int check(const CheckOptions& options) {
  const check::Rules rules = rules_of(options);
  const cases::Variant variant = check::variant_of(rules.operation, rules.format, rules.from);
  std::unique_ptr<check::CaseSource> cases;
  if (options.from.empty()) {
    cases = std::make_unique<check::GeneratedCases>(variant, options.cases);
  } else {
    cases = std::make_unique<check::FileCases>(variant, options.from);
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
  check::Results results(piped ? std::cin : file, piped ? "standard input" : options.results,
                         rules.format, rules.operation == cases::Operation::to_decimal);
  check::Judge judge(rules, options.shown);
  std::string failure;
  try {
    judge_all(*cases, results, judge);
  } catch (const support::UsageError& error) {
    failure = error.what();
  }
  // Show the verdict on the results judged so far, even after an error.
  if (judge.cases() > 0) {
    std::cout << heading(rules, options.from.empty() ? options.cases.command_line(variant)
                                                     : support::printable(options.from))
              << check::verdict_text(judge) << no_result_hint(judge, options);
  }
  if (support::Interrupt::flag()) {
    std::cout << fmt::format("\nSTOPPED after {}{} cases\n", support::grouped(judge.cases()),
                             cases->count() ? " of " + support::grouped(*cases->count()) : "");
    return judge.wrong().count() > 0 ? 1 : support::interrupted_status;
  }
  if (!failure.empty()) throw support::UsageError(failure);
  if (judge.cases() == 0) {
    throw support::UsageError(
        "nothing was judged, because there are no cases; check --from, --shard and --cases");
  }
  return judge.wrong().count() > 0 ? 1 : 0;
}

void add_check_options(CLI::App& command, CheckOptions& options) {
  command.add_option("operation", options.operation, std::string(judged_operations))->required();
  command.add_option("results", options.results, "file of results; by default standard input")
      ->check(not_empty());
  command
      .add_option("--format", options.format,
                  "format of the words: qW_F signed or uW_F unsigned, with W bits before the point "
                  "and F after it, 8, 16, 32 or 64 in all")
      ->capture_default_str();
  command.add_option("--rounding", options.rounding,
                     "expected rounding: half-up, half-away, half-even, floor or toward-zero; "
                     "required unless there is a --rule or results are exact (add, sub, fmod, "
                     "remainder, to_decimal)");
  command
      .add_option(
          "--overflow", options.overflow,
          "expected result of an overflow: wrap, saturate, symmetric, maximum, minimum, de or any; "
          "by default wrap, or saturate for functions of real numbers")
      ->check(not_empty());
  command
      .add_option(
          "--divide-by-zero", options.divide_by_zero,
          "expected result of div, mul_div, fmod and remainder by 0: de, saturate, symmetric, "
          "maximum, minimum, zero or any")
      ->capture_default_str();
  command
      .add_option("--negative-root", options.negative_root,
                  "expected result of sqrt below 0: de, maximum, minimum, zero, mirror or any")
      ->capture_default_str();
  command
      .add_option("--outside-domain", options.outside_domain,
                  "expected result of a function outside its domain: de, maximum, minimum, zero or "
                  "any")
      ->capture_default_str();
  command
      .add_option(
          "--not-finite", options.not_finite,
          "expected result of from_binary64 of NaN and infinities: de, saturate, symmetric, "
          "maximum, minimum, zero or any")
      ->capture_default_str();
  add_port_option(command, options.rule, {"--rounding", "--overflow", "--divide-by-zero"});
  add_result_format(command, options.to);
  auto* from = command
                   .add_option("--from", options.from,
                               "file of cases; by default check makes the cases of gen")
                   ->check(not_empty());
  add_case_options(command, options.cases);
  for (const char* of_gen : {"--level", "--seed", "--shard", "--cases"}) {
    from->excludes(command.get_option(of_gen));
  }
  command.add_option("--show", options.shown, "number of wrong results to show")
      ->transform(whole_number(0, 1'000'000))
      ->capture_default_str();
}

}  // namespace

void add_check(CLI::App& app, int& status) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand(
      "check", "judge another program's results, and find the rules that it follows");
  add_check_options(*command, *options);
  command->footer(
      R"(The judged program reads the lines of `fixproof gen` and writes one result per line: 8 lower-case
hex digits (no 0x), or DE for a divide error; 2, 4 or 16 digits in a --format of 8, 16 or 64 bits.
Give check the same --format, --level, --seed, --shard and --cases as gen, so that both have the
same cases. With --from it reads your own cases. It skips lines that start with #, in results and
in cases.

from_binary64 takes a double as 16 hex digits, convert a word of --format and results of --to,
from_decimal a decimal number such as -1.5, and to_decimal a word. A result of to_decimal is a
decimal number such as -1.5 or 2e-3, right if the nearest word is the operand.

--overflow, --divide-by-zero, --negative-root and --not-finite say what to expect if the result does not fit a
word or does not exist. The words are those of 16.16; another --format has its own highest and
lowest, and an unsigned one saturates a negative difference to 0:
  wrap        modulo 2^32
  saturate    7fffffff, or 80000000 if negative
  symmetric   7fffffff, or 80000001 if negative
  maximum     always 7fffffff
  minimum     always 80000000
  mirror      -sqrt(-x)
  zero        0
  de          DE, a divide error
  any         every result is accepted and counted
A square root is never a tie, so half-up, half-away and half-even agree. floor and toward-zero
agree too, except under mirror, where floor rounds away from zero. Under saturate and
symmetric, 0 / 0 and NaN may also be 0.

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
  fixproof gen add | ./mine | fixproof check add --overflow saturate
  ./mine < few.txt | fixproof check mul --from few.txt --rounding floor --overflow any)");
  command->callback([options, command, &status] {
    refuse_idle_options(*command, cases::operation_named(options->operation),
                        cases::format_named(options->format));
    status = check(*options);
  });
}

}  // namespace fixproof::cli
