#include "app/cli/judge_rules.hpp"

#include <fmt/format.h>

#include <optional>

#include "app/cli/check_rules.hpp"
#include "app/cli/port_option.hpp"
#include "app/cli/rule_named.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

bool is_whole(cases::Operation operation) {
  return operation == cases::Operation::cossin || operation == cases::Operation::xformvec;
}

bool is_open(const JudgeOptions& options) {
  return (options.rounding.empty() || options.rounding == best_rounding) && options.rule.empty() &&
         options.within.empty();
}

check::Rules rules_of(const JudgeOptions& options, const cases::Variant& variant) {
  if (!options.rule.empty()) {
    return port_rules_named(options.rule, variant);
  }
  check::Rules rules{.variant = variant};
  const bool rounds = !is_whole(variant.operation) && check::is_rounded(variant);
  if (!options.within.empty()) {
    if (!rounds) throw support::UsageError("--within applies only to results that are rounded");
    rules.within = within_of(options.within);
  } else if (options.rounding == check::faithful) {
    rules.faithful = true;
  } else if (!options.rounding.empty() && options.rounding != best_rounding) {
    if (!rounds) throw support::UsageError("--rounding applies only to results that are rounded");
    rules.rounding = rounding_named(options.rounding);
  }
  rules.overflow = rule_named("--overflow", options.overflow, check::overflow_rules(),
                              std::optional(check::Overflow::any));
  const auto no_result = check::no_result_rules(variant.operation);
  rules.no_result = no_result.empty() ? check::NoResult::any
                                      : rule_named("--no-result", options.no_result, no_result,
                                                   std::optional(check::NoResult::any));
  return rules;
}

std::string rules_line(const check::Rules& rules, Rounding rounding) {
  const cases::Variant& variant = rules.variant;
  std::string text = fmt::format("{} {}", cases::name_of(variant.operation),
                                 cases::name_of(cases::operand_format(variant)));
  if (variant.from) text += fmt::format(" to {}", cases::name_of(variant.format));
  text += ": ";
  if (is_whole(variant.operation)) return text + "every rule is tried";
  if (rules.port != nullptr) {
    return text + fmt::format("{}{}", port_text(*rules.port),
                              rounding == Rounding::fitting ? ", which fits" : "");
  }
  if (!check::is_rounded(variant)) {
    text += "exact";
  } else if (rounding == Rounding::unknown) {
    text += "any rounding";
  } else {
    text += fmt::format("{}{}", check::text_of_rounding(rules),
                        rounding == Rounding::fitting ? ", the rounding that fits best" : "");
  }
  if (check::can_overflow(variant)) {
    text += fmt::format("; overflow {}", check::name_of(rules.overflow));
  }
  if (check::can_lack_result(variant)) {
    text += fmt::format("; without a result {}", check::name_of(rules.no_result));
  }
  return text;
}

}  // namespace fixproof::cli
