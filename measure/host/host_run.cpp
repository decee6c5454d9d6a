#include "measure/host/host_run.hpp"

#include <fmt/format.h>

#include "measure/accuracy/accuracy_run.hpp"

namespace fixproof::measure {

namespace {

/// The word of a whole number of units, otherwise the value.
std::string units_text(double units) {
  const auto whole = static_cast<std::int64_t>(units);
  if (static_cast<double>(whole) == units && whole >= INT32_MIN && whole <= INT32_MAX) {
    return fmt::format("{:08x}", static_cast<std::uint32_t>(whole));
  }
  return fmt::format("{:.17g}", units / 65536);
}

void judge_case(HostRow& row, const HostOperation& operation, const HostContender& contender,
                const HostCase& c) {
  const HostJudgement judgement = contender.judge(c);
  ++row.cases;
  if (judgement == HostJudgement::exception) ++row.exceptions;
  if (judgement != HostJudgement::wrong) return;
  const std::size_t operands = operation.results == 3 ? 7 : operation.words;
  std::string text = fmt::format("{} of {}:", operation.name, contender.name);
  for (std::size_t k = 0; k < operands; ++k) text += ' ' + units_text(c.operands[k]);
  throw WrongContender(fmt::format("{} gives {}, which is not rounded {}", text,
                                   units_text(c.result), contender.rounding));
}

}  // namespace

HostRow judge_contender(const HostOperation& operation, const HostContender& contender) {
  HostRow row{operation.name, contender.name, contender.alike, contender.kind, contender.rounding};
  HostLoop& loop = *contender.loop;
  const CaseWords words = operation.operands.words;
  const std::size_t block = operation.operands.block;
  // Ends with the first block, because that one is timed.
  for (std::size_t begin = words.size(); begin != 0;) {
    begin -= block;
    const CaseWords in = words.subspan(begin, block);
    loop.load(in);
    loop.apply_all();
    for (std::size_t i = 0; i < block / operation.words * operation.results; ++i) {
      const HostCase c = loop.result(i);
      judge_case(row, operation, contender, c);
      const CaseWords of_case =
          in.subspan(i / operation.results * operation.words, operation.words);
      add_error(row.errors, c.result, operation.exact(of_case, i % operation.results));
    }
  }
  if (operation.chain_is.empty()) return row;
  loop.load_chain(operation.operands.start, operation.operands.taken);
  loop.apply_in_chain();
  for (std::size_t i = 0; i < operation.operands.taken.size(); ++i) {
    judge_case(row, operation, contender, loop.chain_result(i));
  }
  return row;
}

std::vector<HostRow> measure_host_rows(const std::vector<HostOperation>& operations,
                                       std::uint64_t rounds, const std::atomic<bool>& stop,
                                       const std::function<void(std::uint64_t)>& timed) {
  std::vector<HostRow> rows;
  std::vector<TimedLoop> loops;
  for (const HostOperation& o : operations) {
    for (const HostContender& contender : o.contenders) {
      if (stop) return {};
      rows.push_back(judge_contender(o, contender));
      HostLoop* loop = contender.loop.get();
      loops.push_back({[loop] { loop->apply_all(); }, o.operands.block / o.words});
      if (o.chain_is.empty()) continue;
      rows.back().chain.emplace();
      loops.push_back({[loop] { loop->apply_in_chain(); }, o.operands.taken.size()});
    }
  }
  const std::vector<Times> times = time_in_turn(loops, rounds, stop, timed);
  if (times.empty()) return {};
  auto next = times.begin();
  for (HostRow& row : rows) {
    row.each = *next++;
    if (row.chain) row.chain = *next++;
  }
  return rows;
}

}  // namespace fixproof::measure
