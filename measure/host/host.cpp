#include "measure/host/host.hpp"

#include <fmt/format.h>

#include <array>

#include "measure/accuracy/accuracy_run.hpp"
#include "measure/host/provenance.hpp"
#include "verify/parties/machines.hpp"

namespace fixproof::measure {

namespace {

using support::Json;

constexpr std::uint64_t default_host_cases = 100'000;

const char* name_of(HostKind kind) {
  static constexpr std::array names{"type", "plain", "library", "floating"};
  return names.at(static_cast<std::size_t>(kind));
}

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

Json json_of(const HostTable& table, const HostRow& row) {
  Json json;
  if (!table.of_vertices()) json["operation"] = table.operation.name;
  json["contender"] = row.contender.name;
  json["alike"] = row.contender.alike;
  json["kind"] = name_of(row.contender.kind);
  json["rounding"] = row.contender.rounding;
  if (table.of_vertices()) {
    json["ns"] = row.each;
    json["per_second"] = {{"most", 1e9 / row.each.min}, {"median", 1e9 / row.each.median}};
  } else {
    json["throughput_ns"] = row.each;
    json["chain_ns"] = row.chain;
  }
  json["cases"] = row.cases;
  json["exceptions"] = row.exceptions;
  json["accuracy"] = {{"max", row.errors.max()},
                      {"mean", row.errors.mean()},
                      {"rms", row.errors.root_mean_square()},
                      {"correct", row.errors.correct()}};
  return json;
}

}  // namespace

HostRow judge_contender(const HostOperation& operation, const HostContender& contender) {
  HostRow row{contender};
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

std::optional<HostResult> measure_host(const MeasureRequest& request, MeasureProgress& progress) {
  const std::uint64_t cases = request.cases.value_or(default_host_cases);
  HostResult result{request.seed, request.rounds, 0, {}};
  std::vector<TimedLoop> loops;
  progress.begin(request.rounds, "rounds");
  for (HostOperation& o : host_operations(request.seed, (cases - 1) / host_block + 1)) {
    HostTable& table = result.tables.emplace_back(HostTable{std::move(o), {}});
    const HostOperands& operands = table.operation.operands;
    for (const HostContender& contender : table.operation.contenders) {
      if (progress.stop()) return std::nullopt;
      table.rows.push_back(judge_contender(table.operation, contender));
      const auto loop = contender.loop;
      loops.push_back({[loop] { loop->apply_all(); }, operands.block / table.operation.words});
      if (table.operation.chain_is.empty()) continue;
      loops.push_back({[loop] { loop->apply_in_chain(); }, operands.taken.size()});
    }
  }
  const HostOperation& first = result.tables.front().operation;
  result.cases = first.operands.words.size() / first.words;
  const std::vector<Times> times = time_in_turn(loops, request.rounds, progress.stop(),
                                                [&](std::uint64_t timed) { progress.show(timed); });
  if (times.empty()) return std::nullopt;
  auto next = times.begin();
  for (HostTable& table : result.tables) {
    for (HostRow& row : table.rows) {
      row.each = *next++;
      if (!table.operation.chain_is.empty()) row.chain = *next++;
    }
  }
  return result;
}

void to_json(Json& json, const HostResult& result) {
  Json made = made_by_json("measure --host", result.seed);
  made["flags"] = compiler_flags();
  made["processor"] = parties::processor_name();
  json = {{"made", std::move(made)},
          {"libraries", {{"libfixmath", has_libfixmath()}, {"FreeType", has_freetype()}}},
          {"rounds", result.rounds},
          {"operands", {{"arrays", Json::object()}, {"chains", Json::object()}}},
          {"host", Json::array()},
          {"vertices", Json::array()}};
  for (const HostTable& table : result.tables) {
    const HostOperation& o = table.operation;
    json["operands"]["arrays"][o.name] = o.operands.block / o.words;
    if (!o.chain_is.empty()) json["operands"]["chains"][o.name] = o.operands.taken.size();
    Json& rows = json[table.of_vertices() ? "vertices" : "host"];
    for (const HostRow& row : table.rows) rows.push_back(json_of(table, row));
  }
}

}  // namespace fixproof::measure
