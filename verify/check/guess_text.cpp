#include "verify/check/guess_text.hpp"

#include <fmt/format.h>

#include <functional>
#include <string_view>
#include <vector>

#include "verify/check/verdict_text.hpp"
#include "verify/text.hpp"

namespace fixproof {

namespace {

std::string_view phrase(Overflow rule) {
  switch (rule) {
    case Overflow::wrap:
      return "wraps";
    case Overflow::saturate:
      return "saturates to 7fffffff and 80000000";
    case Overflow::symmetric:
      return "saturates to 7fffffff and 80000001";
    case Overflow::maximum:
      return "gives 7fffffff whatever the sign";
    case Overflow::minimum:
      return "gives 80000000 whatever the sign";
    case Overflow::error:
      return "says DE";
    case Overflow::any:
      break;
  }
  return "gives anything";
}

std::string_view phrase(NoResult rule) {
  switch (rule) {
    case NoResult::error:
      return "says DE";
    case NoResult::saturate:
      return "gives 7fffffff or 80000000, by the sign of the dividend";
    case NoResult::symmetric:
      return "gives 7fffffff or 80000001, by the sign of the dividend";
    case NoResult::maximum:
      return "gives 7fffffff";
    case NoResult::minimum:
      return "gives 80000000";
    case NoResult::zero:
      return "gives 0";
    case NoResult::mirror:
      return "gives minus the root of the magnitude";
    case NoResult::any:
      break;
  }
  return "gives anything";
}

std::string joined(const std::vector<std::string_view>& names, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? last : std::string_view(", ");
    text += names[i];
  }
  return text;
}

/// In percent, or where that would be nothing but zeros, as one in so many.
std::string share_of(std::uint64_t part, std::uint64_t whole) {
  if (part * 1000 < whole) return fmt::format("1 in {}", grouped(whole / part));
  return fmt::format("{:.1f} %", 100 * static_cast<double>(part) / static_cast<double>(whole));
}

/// One line of the guess, with the exceptions below it.
/// @param what of which cases, such as "cases that overflow"
std::string line_of(std::string_view subject, const BestRules& best,
                    const std::vector<std::string_view>& names, std::string_view what,
                    const Rules& shown_under) {
  const std::string label = fmt::format("  {:<16} ", subject);
  if (best.cases == 0) return fmt::format("{}cannot be told: no {}\n", label, what);
  const std::uint64_t exceptions = best.exceptions.count();
  if (exceptions == 0) {
    std::string text =
        fmt::format("{}{} on all {} {}\n", label, joined(names, " or "), grouped(best.cases), what);
    if (names.size() > 1) text += "                   (which of these, no case tells)\n";
    return text;
  }
  // A rule that most cases break is no guess.
  const bool known = 2 * exceptions <= best.cases;
  std::string text =
      fmt::format("{}{}, but for {} of {} {} ({}):\n", label,
                  known ? joined(names, " or ")
                        : fmt::format("no known rule; nearest: {}", joined(names, ", ")),
                  grouped(exceptions), grouped(best.cases), what, share_of(exceptions, best.cases));
  for (const JudgedCase& one : best.exceptions.shown()) {
    text += fmt::format("    {}\n", text_of(one, shown_under));
  }
  return text;
}

}  // namespace

std::string guess_text(const Judge& judge) {
  const RuleTrial& trial = judge.trial();
  const Operation operation = judge.rules().operation;
  Rules followed{.operation = operation};
  std::string text = "What the subject does, all rules tried:\n";

  const BestRules rounding = trial.rounding();
  std::vector<std::string_view> names;
  for (const std::size_t i : rounding.rules) names.push_back(name_of(roundings()[i]));
  if (operation == Operation::sqrt && rounding.cases > 0) {
    // A root is never halfway: the rules are only two, to nearest and down.
    const bool down = roundings()[rounding.rules.front()] == oracle::Rounding::floor;
    names = {down ? "down" : "to nearest"};
  }
  const std::size_t rule = rounding.rules.front();
  followed.rounding = roundings()[rule];
  text += line_of("rounding", rounding, names, "cases in range", followed);

  const BestRules overflow = trial.overflow(rule);
  names.clear();
  for (const std::size_t i : overflow.rules) names.push_back(phrase(overflow_rules()[i]));
  followed.overflow = overflow_rules()[overflow.rules.front()];
  if (operation != Operation::sqrt) {
    text += line_of("overflow", overflow, names, "cases that overflow", followed);
  }

  if (const auto rules = no_result_rules(operation); !rules.empty()) {
    const BestRules none = trial.no_result(rule);
    names.clear();
    for (const std::size_t i : none.rules) names.push_back(phrase(rules[i]));
    followed.no_result = rules[none.rules.front()];
    const bool root = operation == Operation::sqrt;
    text += line_of(root ? "negative operand" : "divide by zero", none, names,
                    root ? "negative operands" : "zero divisors", followed);
  }

  if (const auto& error = judge.largest_error(); error && error->ulps > 0) {
    text += fmt::format("  largest error    {:.5f} ulp in range: {}\n", error->ulps,
                        text_of(error->at, followed));
  }
  return text;
}

}  // namespace fixproof
