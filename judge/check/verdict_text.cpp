#include "judge/check/verdict_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>

#include "judge/check/cases.hpp"
#include "judge/check/guess_text.hpp"
#include "support/plain_text.hpp"

namespace fixproof::check {

namespace {

std::string table_line(std::string_view name, KindTally all, KindTally negative) {
  return fmt::format("{:<16} {:>13} {:>12}  {:>13} {:>12}\n", name, support::grouped(all.cases),
                     support::grouped(all.wrong), support::grouped(negative.cases),
                     support::grouped(negative.wrong));
}

void add_to(KindTally& sum, KindTally other) {
  sum.cases += other.cases;
  sum.wrong += other.wrong;
}

std::string table_of(const Judge& judge) {
  std::string text = fmt::format("{:<16} {:>13} {:>12}  {:>13} {:>12}\n", "exact result", "cases",
                                 "wrong", "of them < 0", "wrong");
  KindTally sum;
  KindTally negative_sum;
  for (std::size_t i = 0; i < case_kinds; ++i) {
    const auto kind = static_cast<CaseKind>(i);
    const KindTally all = judge.tally(kind, false);
    const KindTally negative = judge.tally(kind, true);
    add_to(sum, all);
    add_to(negative_sum, negative);
    if (all.cases == 0) continue;
    text += table_line(name_of(kind, judge.rules().variant.operation), all, negative);
  }
  return text + table_line("all", sum, negative_sum);
}

std::string wrong_cases(const Judge& judge) {
  if (judge.wrong() == 0) return "";
  const std::vector<JudgedCase> shown = judge.shown();
  std::string text = "\n";
  for (const JudgedCase& one : shown) text += text_of(one, judge.rules()) + '\n';
  if (shown.size() < judge.wrong()) {
    text += fmt::format("Shown: {} of {} wrong results; --show N shows more.\n", shown.size(),
                        support::grouped(judge.wrong()));
  }
  return text;
}

std::string common_text(const Judge& judge) {
  std::string text;
  if (const int bits = judge.idle_bits(); bits > 0) {
    text +=
        fmt::format("  every result in range is a multiple of {} units: {} always 0\n",
                    support::grouped(std::uint64_t{1} << bits),
                    bits == 1 ? "its lowest bit is" : fmt::format("its lowest {} bits are", bits));
  }
  for (const std::string& line : judge.common().lines()) text += fmt::format("  {}\n", line);
  return text.empty() ? "" : "\nWhat the wrong cases have in common:\n" + text;
}

}  // namespace

std::string text_of_operands(const JudgedCase& one, const Rules& rules) {
  if (one.valued) return text_of(*one.valued, rules.variant);
  std::string decimal;
  const auto values = one.values().words();
  for (std::size_t i = 0; i < cases::words_in(rules.variant.operation); ++i) {
    decimal +=
        fmt::format("{}{}", i == 0 ? "" : " ", decimal_text(values[i], rules.variant.format));
  }
  return fmt::format("{} ({})", line_of_operands(one, rules), decimal);
}

std::string line_of_operands(const JudgedCase& one, const Rules& rules) {
  if (one.valued) return one.valued->text;
  std::string hex;
  for (std::size_t i = 0; i < cases::words_in(rules.variant.operation); ++i) {
    hex += fmt::format("{}{}", i == 0 ? "" : " ", hex_text(one.words.at(i), rules.variant.format));
  }
  return hex;
}

std::string line_of_result(Said said, const cases::Format& format) {
  return said ? hex_text(*said, format) : std::string("DE");
}

CaseKind kind_of(const JudgedCase& one, const Rules& rules) {
  const auto rounded = rounded_result(rules.variant, one.values(), rules.rounding);
  return exact_place(rules.variant, one.values()).kind(rounded && !rounded->fits);
}

Expected expected_of(const JudgedCase& one, const Rules& rules) {
  return expected_of(rules, rules.port != nullptr ? one.operands() : one.values());
}

std::string text_of(const JudgedCase& one, const Rules& rules) {
  const cases::Operation operation = rules.variant.operation;
  const cases::Format& format = rules.variant.format;
  const Expected expected = expected_of(one, rules);
  const ExactPlace place = exact_place(rules.variant, one.values());
  const auto rounded = rounded_result(rules.variant, one.values(), rules.rounding);
  std::string text = fmt::format("case {} ({}): {}: ", support::grouped(one.number),
                                 support::printable(one.origin), text_of_operands(one, rules));
  if (operation == cases::Operation::to_decimal) {
    return text + fmt::format("{} expected, {} said", decimal_text(*expected.said, format),
                              support::printable(one.said_text));
  }
  const bool in_range = rounded && rounded->fits;
  if (expected.judged) {
    text += line_of_result(expected.said, format);
    if (in_range && rules.within) text += fmt::format(" {}", text_of_rounding(rules));
    if (in_range && rules.faithful) text += " or its neighbour beyond the exact result";
    text += " expected, ";
  }
  text += fmt::format("{} said; ", line_of_result(one.said, format));
  if (place.has_result)
    text += fmt::format("exact {} ulp, ", exact_text(rules.variant, one.values()));
  return text + std::string(name_of(kind_of(one, rules), operation));
}

std::string verdict_text(const Judge& judge) {
  std::string text = table_of(judge);
  if (judge.not_judged() > 0) {
    text += fmt::format("{} cases accept any result and are not judged.\n",
                        support::grouped(judge.not_judged()));
  }
  return text + wrong_cases(judge) + common_text(judge) + '\n' + guess_text(judge);
}

}  // namespace fixproof::check
