#include "judge/check/guess_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string_view>
#include <vector>

#include "judge/check/verdict_text.hpp"
#include "support/plain_text.hpp"

namespace fixproof::check {

namespace {

std::string phrase(Overflow rule, const cases::Format& format) {
  const std::string high = hex_text(highest(format), format);
  switch (rule) {
    case Overflow::wrap:
      return "wraps";
    case Overflow::saturate:
      return fmt::format("saturates to {} and {}", high, hex_text(lowest(format), format));
    case Overflow::symmetric:
      return fmt::format("saturates to {} and {}", high, hex_text(minus_highest(format), format));
    case Overflow::maximum:
      return fmt::format("gives {} whatever the sign", high);
    case Overflow::minimum:
      return fmt::format("gives {} whatever the sign", hex_text(lowest(format), format));
    case Overflow::error:
      return "says DE";
    case Overflow::any:
    case Overflow::word:
      break;
  }
  return "gives anything";
}

std::string phrase(NoResult rule, const cases::Variant& variant, std::string_view sign_of) {
  const cases::Format& format = variant.format;
  const std::string high = hex_text(highest(format), format);
  const auto by_sign = [&](std::uint64_t low) {
    if (!has_sign_without_result(variant)) return fmt::format("gives {}", high);
    return fmt::format("gives {} or {}, by the sign of the {}", high, hex_text(low, format),
                       sign_of);
  };
  switch (rule) {
    case NoResult::error:
      return "says DE";
    case NoResult::saturate:
      return by_sign(lowest(format));
    case NoResult::symmetric:
      return by_sign(minus_highest(format));
    case NoResult::maximum:
      return fmt::format("gives {}", high);
    case NoResult::minimum:
      return fmt::format("gives {}", hex_text(lowest(format), format));
    case NoResult::zero:
      return "gives 0";
    case NoResult::mirror:
      return "gives minus the root of the magnitude";
    case NoResult::any:
    case NoResult::word:
      break;
  }
  return "gives anything";
}

constexpr std::string_view mirrored_down =
    "gives minus the root of the magnitude, rounded down, away from zero";
constexpr std::string_view mirrored_toward_zero =
    "gives minus the root of the magnitude, rounded toward zero";

/// The names of operands without a result.
struct NoResultNames {
  std::string_view cases;
  std::string_view sign_of;  ///< the operand whose sign decides
};
NoResultNames no_result_names(cases::Operation operation) {
  if (operation == cases::Operation::sqrt) return {"negative operands", "operand"};
  if (operation == cases::Operation::from_binary64) return {"NaNs and infinities", "infinity"};
  if (cases::is_function(operation)) return {"operands outside the domain", "operand"};
  if (operation == cases::Operation::mul_div) return {"zero divisors", "product"};
  return {"zero divisors", "dividend"};
}

std::string joined(const std::vector<std::string>& names, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? last : std::string_view(", ");
    text += names[i];
  }
  return text;
}

/// Returns the share of cases that are exceptions, and whether all are negative: ` (2.4 %, all of
/// them negative)`. Empty for a single exception.
std::string share_of(const RuleScore& score) {
  const std::uint64_t part = score.exceptions.count();
  if (part == 1) return "";
  const double percent = 100 * static_cast<double>(part) / static_cast<double>(score.cases);
  return fmt::format(" ({}{})",
                     percent < 0.1 ? "1 in " + support::grouped(score.cases / part)
                                   : fmt::format("{:.1f} %", percent),
                     score.negative_exceptions == part ? ", all of them negative" : "");
}

/// Returns one line of the guess, with the exceptions below it.
/// @param what the cases that the rule applies to, such as "cases that overflow"
std::string line_of(std::string_view subject, const BestRules& best,
                    const std::vector<std::string>& names, std::string_view what,
                    const Rules& shown_under) {
  const std::string label = fmt::format("  {:<16} ", subject);
  if (best.first.cases == 0) return fmt::format("{}unknown: there are no {}\n", label, what);
  const std::uint64_t exceptions = best.first.exceptions.count();
  if (exceptions == 0) {
    std::string text = fmt::format("{}{} on all {} {}\n", label, joined(names, " or "),
                                   support::grouped(best.first.cases), what);
    if (names.size() > 1) text += "                   (no case distinguishes these)\n";
    return text;
  }
  // A rule that most cases break is not a guess, and no rule is near a handful of them.
  const bool known = 2 * exceptions <= best.first.cases;
  constexpr std::uint64_t handful = 20;
  if (!known && (best.first.cases < handful || exceptions == best.first.cases)) {
    return fmt::format("{}no known rule: {} of {} {} differ from each\n", label,
                       support::grouped(exceptions), support::grouped(best.first.cases), what);
  }
  std::string text = fmt::format(
      "{}{}, but for {} of {} {}{}:\n", label,
      known ? joined(names, " or ")
            : fmt::format("no known rule; nearest: {}", joined(names, ", ")),
      support::grouped(exceptions), support::grouped(best.first.cases), what, share_of(best.first));
  for (const JudgedCase& one : best.first.exceptions.shown()) {
    text += fmt::format("    {}\n", text_of(one, shown_under));
  }
  return text;
}

/// Returns the line of a subject that keeps to the two words around the exact result, where no
/// rounding does; empty for any other subject.
std::string faithful_line(const RuleTrial& trial) {
  // A subject that breaks a rounding in few cases has that rounding, and a defect.
  const std::uint64_t broken = trial.rounding().first.exceptions.count();
  const std::uint64_t inexact = trial.inexact();
  if (trial.faithful().exceptions.count() != 0 || 10 * broken <= inexact) return "";
  return fmt::format(
      "  {:<16} either neighbour, no rule, on all {} cases in range; the upper one in {:.1f} % of "
      "{} inexact ones\n",
      "rounding", support::grouped(trial.faithful().cases),
      100 * static_cast<double>(trial.upper()) / static_cast<double>(inexact),
      support::grouped(inexact));
}

/// Returns the line of the rounding, or of exact results in range.
std::string rounding_line(const RuleTrial& trial, const BestRules& best, const Rules& followed) {
  const cases::Operation operation = followed.variant.operation;
  if (!is_rounded(followed.variant)) {
    const bool text = operation == cases::Operation::to_decimal;
    if (text) return line_of("text", best, {"reads as the operand"}, "cases", followed);
    return line_of("in range", best, {"exact"},
                   is_remainder(operation) ? "cases with a result" : "cases that do not overflow",
                   followed);
  }
  if (std::string line = faithful_line(trial); !line.empty()) return line;
  std::vector<std::string> names;
  for (const std::size_t i : best.rules) names.emplace_back(name_of(roundings()[i]));
  if (operation == cases::Operation::sqrt && !followed.variant.from &&
      followed.variant.format.fraction_bits >= 0 && best.first.cases > 0) {
    // A root is never halfway, so the roundings act as three: to nearest, down and up.
    const oracle::Rounding rule = roundings()[best.rules.front()];
    names = {rule == oracle::Rounding::floor     ? "down"
             : rule == oracle::Rounding::ceiling ? "up"
                                                 : "to nearest"};
  }
  return line_of("rounding", best, names, "cases in range", followed);
}

/// Returns a line that names idioms like the subject; empty if there are none.
std::string idiom_line(const std::optional<Likeness>& likeness, const cases::Format& format) {
  constexpr std::size_t most_named = 3;
  if (!likeness || likeness->idioms.size() > most_named) return "";
  std::vector<std::string> names;
  for (const Idiom* idiom : likeness->idioms) names.push_back(idiom->text_in(format));
  std::string text = fmt::format("  {:<16} {}, ", "looks like", joined(names, " or "));
  if (likeness->exceptions > 0) {
    text += fmt::format("but for {} of {} cases in range\n", support::grouped(likeness->exceptions),
                        support::grouped(likeness->cases));
  } else {
    text += fmt::format("on all {} cases in range\n", support::grouped(likeness->cases));
  }
  return text;
}

/// Returns a line that names the programs whose rules have no exception; empty if there are none.
std::string ports_line(const Judge& judge) {
  std::vector<std::string> names;
  for (const PortRule* rule : judge.ports().followed()) names.emplace_back(rule->name);
  if (names.empty()) return "";
  return fmt::format("  follows the rule {} on all {} cases\n", joined(names, " or "),
                     support::grouped(judge.cases()));
}

}  // namespace

std::size_t best_rounding(const Judge& judge) {
  const RuleTrial& trial = judge.trial();
  const bool lacks = can_lack_result(judge.rules().variant);
  const BestRules rounding = trial.rounding();
  return *std::ranges::min_element(rounding.rules, {}, [&](std::size_t r) {
    return lacks ? trial.no_result(r).first.exceptions.count() : 0;
  });
}

std::string guess_text(const Judge& judge) {
  const RuleTrial& trial = judge.trial();
  const cases::Variant& variant = judge.rules().variant;
  const cases::Operation operation = variant.operation;
  const cases::Format format = variant.format;
  Rules followed{.variant = variant};  // the rules below are found
  std::string text = "What the subject does, all rules tried:\n" + ports_line(judge);

  const BestRules rounding = trial.rounding();
  const std::size_t rule = best_rounding(judge);
  followed.rounding = roundings()[rule];
  text += rounding_line(trial, rounding, followed);
  text += idiom_line(judge.idioms().likeness(), format);

  const BestRules overflow = trial.overflow(rule);
  std::vector<std::string> names;
  const auto overflows = overflow_rules(format);
  for (const std::size_t i : overflow.rules) names.push_back(phrase(overflows[i], format));
  followed.overflow = overflows[overflow.rules.front()];
  if (can_overflow(variant)) {
    text += line_of("overflow", overflow, names, "cases that overflow", followed);
  }

  if (const auto rules = no_result_rules(variant); !rules.empty()) {
    const BestRules none = trial.no_result(rule);
    names.clear();
    const NoResultNames called = no_result_names(operation);
    for (const std::size_t i : none.rules) {
      names.push_back(phrase(rules[i], variant, called.sign_of));
    }
    followed.no_result = rules[none.rules.front()];
    if (followed.no_result == NoResult::mirror && names.size() == 1) {
      if (followed.rounding == oracle::Rounding::floor) names = {std::string(mirrored_down)};
      if (followed.rounding == oracle::Rounding::truncate)
        names = {std::string(mirrored_toward_zero)};
    }
    text += line_of(name_of(CaseKind::no_result, operation), none, names, called.cases, followed);
  }

  if (const auto& error = judge.largest_error(); error && error->ulps > 0) {
    text += fmt::format("  largest error    {:.5f} ulp in range", error->ulps);
    // The case tells nothing about a subject that keeps its rule.
    if (rounding.first.exceptions.count() > 0) text += ": " + text_of(error->at, followed);
    text += '\n';
  }
  if (judge.curve()) {
    if (const auto figures = judge.curve()->figures()) text += text_of(*figures);
  }
  return text;
}

}  // namespace fixproof::check
