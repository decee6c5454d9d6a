#include "measure/host/host.hpp"

#include <array>
#include <utility>

#include "measure/host/provenance.hpp"
#include "parties/machines.hpp"

namespace fixproof::measure {

namespace {

using support::Json;

constexpr std::uint64_t default_host_cases = 100'000;

const char* name_of(HostKind kind) {
  static constexpr std::array names{"type", "plain", "library", "floating"};
  return names.at(static_cast<std::size_t>(kind));
}

Json to_json(const HostRow& row, bool vertices) {
  Json json;
  if (!vertices) json["operation"] = row.operation;
  json["contender"] = row.name;
  json["alike"] = row.alike;
  json["kind"] = name_of(row.kind);
  json["rounding"] = row.rounding;
  if (vertices) {
    json["ns"] = to_json(row.each);
    json["per_second"] = {{"most", 1e9 / row.each.min}, {"median", 1e9 / row.each.median}};
  } else {
    json["throughput_ns"] = to_json(row.each);
    json["chain_ns"] = row.chain ? to_json(*row.chain) : Json(nullptr);
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

std::optional<HostResult> measure_host(const MeasureRequest& request, MeasureProgress& progress) {
  const std::uint64_t cases = request.cases.value_or(default_host_cases);
  const auto operations = host_operations(request.seed, (cases - 1) / host_block + 1);
  progress.begin(request.rounds, "rounds");
  const auto rows = measure_host_rows(operations, request.rounds, progress.stop(),
                                      [&](std::uint64_t timed) { progress.show(timed); });
  if (rows.empty()) return std::nullopt;
  const HostOperation& first = operations.front();
  HostResult result{request.seed, request.rounds, first.operands.words.size() / first.words, {}};
  for (const HostOperation& o : operations) {
    HostTable table{
        o.name, o.operands_are, o.chain_is, o.operands.block / o.words, o.operands.taken.size(),
        {}};
    for (const HostRow& row : rows) {
      if (row.operation == o.name) table.rows.push_back(row);
    }
    result.tables.push_back(std::move(table));
  }
  return result;
}

Json to_json(const HostResult& result) {
  Json json{{"made", made_by_json(result.seed, "measure --host")}};
  json["made"]["flags"] = compiler_flags();
  json["made"]["processor"] = parties::processor_name();
  json["libraries"] = {{"libfixmath", has_libfixmath()}, {"FreeType", has_freetype()}};
  json["rounds"] = result.rounds;
  json["operands"] = {{"arrays", Json::object()}, {"chains", Json::object()}};
  json["host"] = Json::array();
  json["vertices"] = Json::array();
  for (const HostTable& table : result.tables) {
    json["operands"]["arrays"][table.operation] = table.array_cases;
    if (!table.chain.empty()) json["operands"]["chains"][table.operation] = table.chain_steps;
    Json& rows = json[table.of_vertices() ? "vertices" : "host"];
    for (const HostRow& row : table.rows) rows.push_back(to_json(row, table.of_vertices()));
  }
  return json;
}

}  // namespace fixproof::measure
