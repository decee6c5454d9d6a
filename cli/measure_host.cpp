#include <fmt/format.h>

#include "cli/measure_text.hpp"
#include "measure/host/provenance.hpp"
#include "parties/machines.hpp"
#include "support/plain_text.hpp"

namespace fixproof::cli {

namespace {

std::string accuracy_columns(const measure::HostRow& row) {
  return fmt::format(
      "{:>11}{:>10}{:>11}  {}{}", largest_text(row.errors.max()),
      error_text(row.errors.root_mean_square()), share_text(row.errors.correct()), row.rounding,
      row.exceptions == 0 ? ""
                          : fmt::format(", but for {} of {}", support::grouped(row.exceptions),
                                        support::grouped(row.cases)));
}

std::string text_of(const measure::HostTable& table) {
  const bool vertices = table.of_vertices();
  std::string text =
      fmt::format("\n{}: {}\n", vertices ? "vertices" : table.operation, table.operands);
  if (!table.chain.empty()) text += fmt::format("chain: {}\n", table.chain);
  text += fmt::format("{:<26}{:>9}{:>9}{:>9}", "", vertices ? "ns" : "ns each", "median", "spread");
  if (!table.chain.empty()) text += fmt::format("{:>9}{:>9}{:>9}", "chain", "median", "spread");
  if (vertices) text += fmt::format("{:>9}{:>9}", "M a s", "median");
  text += fmt::format("{:>11}{:>10}{:>11}  rounded\n", "max", "rms", "correct");
  for (const measure::HostRow& row : table.rows) {
    text += fmt::format("  {:<24}{}", row.name, columns_of(row.each));
    if (row.chain) text += columns_of(*row.chain);
    if (vertices) {
      text += fmt::format("{:>9.1f}{:>9.1f}", 1e3 / row.each.min, 1e3 / row.each.median);
    }
    text += accuracy_columns(row) + '\n';
  }
  return text;
}

}  // namespace

std::string text_of(const measure::HostResult& result) {
  std::string text = fmt::format(
      "{} {}, {}\n\n"
      "Nanoseconds of processor time of one operation, over arrays in the first-level cache, and "
      "in chains\nwhere each result is an operand of the next; the least and the median of {} "
      "rounds, in which all are\ntimed in turn. The spread is the third quartile less the first, "
      "by the median. Operands come again\nand again: a processor may have learnt what branches. "
      "Errors in units of the last place of 16.16, of\n{} results or more, each held to the "
      "rounding that its maker states; correct is one within half a\nunit.\n{}",
      made_by(result.seed), measure::compiler_flags(), parties::processor_name(),
      support::grouped(result.rounds), support::grouped(result.cases), missing_libraries());
  for (const measure::HostTable& table : result.tables) text += text_of(table);
  return text;
}

}  // namespace fixproof::cli
