#include "app/cli/check_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "app/cli/arguments.hpp"
#include "app/cli/port_option.hpp"
#include "app/cli/rule_named.hpp"
#include "app/input/number.hpp"
#include "oracle/format.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

/// Sets a rule by its name, or to the word of a number.
template <class Rule>
void set_rule(std::string_view option, const std::string& text, std::span<const Rule> rules,
              const cases::Format& format, Rule& rule, std::uint64_t& word) {
  // DE is a result, never the word de of eight bits.
  const std::string_view name = text == "DE" ? std::string_view("de") : text;
  const bool is_name = name == "any" || std::ranges::any_of(rules, [&](Rule known) {
                         return check::name_of(known) == name;
                       });
  const input::Number number = input::number_of(text, format, input::Bare::word);
  if (is_name || !number.error.empty()) {
    rule = rule_named(option, name, rules, std::optional(Rule::any), "a word or number");
    return;
  }
  const auto units = cases::to_ulps(number.exact, oracle::Rounding::floor, format);
  const auto wide = format.as<oracle::Format>();
  if (!oracle::fits(units, wide) ||
      units != cases::to_ulps(number.exact, oracle::Rounding::ceiling, format)) {
    throw support::UsageError(
        fmt::format("{} {}: {} has no such number", option, text, cases::name_of(format)));
  }
  rule = Rule::word;
  word = oracle::wrap(units, wide);
}

void set_rounding(const RuleOptions& options, check::Rules& rules) {
  if (!options.within.empty()) {
    rules.within = within_of(options.within);
    return;
  }
  if (options.rounding == check::faithful) {
    rules.faithful = true;
    return;
  }
  if (!options.rounding.empty() && options.rounding != best_rounding) {
    rules.rounding = rounding_named(options.rounding);
    return;
  }
  if (!check::is_rounded(rules.variant) || options.rounding == best_rounding) return;
  throw support::UsageError(fmt::format(
      "check {}: --rounding, --within or --rule is required; name the rule that results should "
      "follow, such as half-up",
      cases::name_of(rules.variant.operation)));
}

/// Rejects options that have no effect on the operation, because they are probably mistakes.
void refuse_idle_options(const CLI::App& command, const RuleOptions& options,
                         const cases::Variant& variant) {
  const cases::Operation operation = variant.operation;
  const auto refuse = [&command](const char* option, bool applies, std::string_view operations) {
    if (applies || command.count(option) == 0) return;
    throw support::UsageError(
        fmt::format("{} applies only to {}; leave it out", option, operations));
  };
  // Products and conversions are rounded in most formats, so naming a rounding is no mistake.
  const bool may_round = check::is_rounded(variant) || operation == cases::Operation::mul ||
                         operation == cases::Operation::convert || cases::is_sum(operation);
  // Who leaves the rounding open need not know which operations round.
  refuse("--rounding", may_round || options.rounding == best_rounding, "results that are rounded");
  refuse("--within", may_round, "results that are rounded");
  refuse("--overflow", check::can_overflow(variant), "results that can overflow");
  refuse("--not-finite", operation == cases::Operation::from_binary64, "from_binary64");
  refuse("--outside-domain", cases::is_function(operation), "functions of real numbers");
  refuse("--divide-by-zero", cases::divides(operation), "div, mul_div, fmod and remainder");
  refuse("--negative-root",
         operation == cases::Operation::sqrt && operand_format(variant).is_signed,
         "sqrt of a signed format");
}

}  // namespace

oracle::Rounding rounding_named(std::string_view text) {
  constexpr std::array<std::string_view, 4> to_nearest{"nearest", "to-nearest", "round", "half"};
  if (std::ranges::find(to_nearest, text) != to_nearest.end()) {
    throw support::UsageError(
        fmt::format("--rounding {}: to nearest needs a rule for ties; choose half-up, half-away or "
                    "half-even",
                    text));
  }
  return rule_named("--rounding", text, check::roundings(), {},
                    fmt::format("{}, {}", check::faithful, best_rounding));
}

check::Within within_of(std::string_view text) {
  const std::string whole(text);
  const bool is_relative = text.ends_with('%');
  if (is_relative) text.remove_suffix(1);
  try {
    check::Within within{check::parse_decimal(text), is_relative, whole};
    if (within.bound.numerator < 0) throw support::UsageError("a bound is not negative");
    if (is_relative) within.bound.denominator *= 100;
    return within;
  } catch (const support::UsageError& error) {
    throw support::UsageError(fmt::format(
        "--within: write a number of ulps such as 2, or a share such as 0.5%; {}", error.what()));
  }
}

std::string_view no_result_option(cases::Operation operation) {
  if (cases::is_function(operation)) return "--outside-domain";
  if (operation == cases::Operation::sqrt) return "--negative-root";
  return operation == cases::Operation::from_binary64 ? "--not-finite" : "--divide-by-zero";
}

check::Rules rules_of(const CLI::App& command, const RuleOptions& options,
                      const cases::Variant& variant) {
  const cases::Operation operation = variant.operation;
  refuse_idle_options(command, options, variant);
  if (!options.rule.empty()) return port_rules_named(options.rule, variant);
  check::Rules rules{.variant = variant};
  set_rounding(options, rules);
  const bool is_function = cases::is_function(operation);
  const std::string overflow = !options.overflow.empty() ? options.overflow
                               : is_function             ? "saturate"
                                                         : "wrap";
  set_rule("--overflow", overflow, check::overflow_rules(), variant.format, rules.overflow,
           rules.overflow_word);
  if (is_function && rules.overflow == check::Overflow::wrap) {
    throw support::UsageError(
        fmt::format("--overflow wrap: {} is judged by results in range; choose another rule",
                    cases::name_of(operation)));
  }
  if (check::can_lack_result(variant)) {
    const std::string_view option = no_result_option(operation);
    const std::string& rule = option == "--outside-domain"  ? options.outside_domain
                              : option == "--negative-root" ? options.negative_root
                              : option == "--not-finite"    ? options.not_finite
                                                            : options.divide_by_zero;
    set_rule(option, rule, check::no_result_rules(operation), variant.format, rules.no_result,
             rules.no_result_word);
  }
  return rules;
}

void add_rule_options(CLI::App& command, RuleOptions& options) {
  command.add_option("--rounding", options.rounding,
                     "expected rounding: half-up, half-away, half-even, floor, ceiling, "
                     "toward-zero, faithful for either neighbour, or best for the one that fits "
                     "best; required unless there is a "
                     "--within or --rule, or results are exact");
  command
      .add_option(
          "--within", options.within,
          "largest error that is right, in ulps (2), or of the exact result (0.5%); results "
          "in the wrong order or that break a symmetry are then wrong, too")
      ->check(not_empty())
      ->excludes(command.get_option("--rounding"));
  command
      .add_option("--overflow", options.overflow,
                  "expected result of an overflow: wrap, saturate, symmetric, maximum, minimum, "
                  "de, any, or "
                  "a word or number; "
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
  add_port_option(command, options.rule,
                  {"--rounding", "--within", "--overflow", "--divide-by-zero"});
}

}  // namespace fixproof::cli
