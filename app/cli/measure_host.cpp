#include <fmt/format.h>

#include "app/cli/measure_text.hpp"
#include "measure/host/provenance.hpp"
#include "support/plain_text.hpp"
#include "verify/parties/machines.hpp"

namespace fixproof::cli {

namespace {

std::string accuracy_columns(const measure::HostRow& row) {
  return fmt::format("{:>11}{:>10}{:>11}  {}{}", largest_text(row.errors.max()),
                     error_text(row.errors.root_mean_square()), share_text(row.errors.correct()),
                     row.contender.rounding,
                     row.exceptions == 0
                         ? ""
                         : fmt::format(", but for {} of {}", support::grouped(row.exceptions),
                                       support::grouped(row.cases)));
}

std::string table_text(const measure::HostTable& table) {
  const bool vertices = table.of_vertices();
  const std::string& chain = table.operation.chain_is;
  std::string text = fmt::format("\n{}: {}\n", vertices ? "vertices" : table.operation.name,
                                 table.operation.operands_are);
  if (!chain.empty()) text += fmt::format("chain: {}\n", chain);
  text += fmt::format("{:<26}{:>9}{:>9}{:>9}", "", vertices ? "ns" : "ns each", "median", "spread");
  if (!chain.empty()) text += fmt::format("{:>9}{:>9}{:>9}", "chain", "median", "spread");
  if (vertices) text += fmt::format("{:>9}{:>9}", "M/s", "median");
  text += fmt::format("{:>11}{:>10}{:>11}  rounded\n", "max", "rms", "correct");
  for (const measure::HostRow& row : table.rows) {
    text += fmt::format("  {:<24}{}", row.contender.name, columns_of(row.each));
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
      "Nanoseconds of processor time per operation: over arrays in the first-level cache "
      "(throughput), and in\nchains where each result is an operand of the next (latency). They "
      "are "
      "the minimum and the median of {}\nrounds that time all implementations in turn. The spread "
      "is "
      "the interquartile range over the median.\nOperands repeat, so the branch predictor may have "
      "learnt them. Errors are in units of the last place\nof 16.16, of at least {} results, each "
      "checked against the rounding that its author documents. A result\nwithin half a unit is "
      "correct.\n{}",
      made_by(result.seed), measure::compiler_flags(), parties::processor_name(),
      support::grouped(result.rounds), support::grouped(result.cases), missing_libraries());
  for (const measure::HostTable& table : result.tables) text += table_text(table);
  return text;
}

}  // namespace fixproof::cli
