// fixproof measure --host.
//
// The file that --json names:
//
//   made       {command, seed, compiler, date} as of --accuracy, and {flags, processor}
//   libraries  {libfixmath, FreeType}: whether each was built in
//   rounds     how often every loop was timed
//   operands   {arrays, chains}: by operation, how many cases the arrays of its loop have (of
//              "vertex" how many vertices), and how many steps its chain, where there is one
//   host       a list of {operation: mul, div, sqrt or cos; contender; alike: presets that run the
//              same code; kind: type, plain, library or floating; rounding: as its maker states it;
//              throughput_ns: {min, median, spread}; chain_ns: the same, or null where there is no
//              chain; cases, exceptions: results judged, and those of them that break the rule
//              within what is known of the contender; accuracy: {max, mean, rms, correct}}
//   vertices   a list of {contender, alike, kind, rounding; ns: {min, median, spread} of a vertex;
//              per_second: {most, median}; cases, exceptions, accuracy: of its coordinates}
//
// Times are nanoseconds of processor time of one operation; spread is the third quartile less the
// first, by the median. Errors are in units of the last place of 16.16; correct is the share, 0 ...
// 1, within half of one.
#include <fmt/format.h>

#include <iostream>

#include "support/file.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/json.hpp"
#include "support/plain_text.hpp"
#include "trade/figures.hpp"
#include "trade/host/host_run.hpp"
#include "trade/host/provenance.hpp"
#include "trade/measure.hpp"

namespace fixproof::trade {

namespace {

using support::Json;

constexpr std::uint64_t default_host_cases = 100'000;
constexpr const char* vertex = "vertex";

const char* kind_text(HostKind kind) {
  switch (kind) {
    case HostKind::type:
      return "type";
    case HostKind::plain:
      return "plain";
    case HostKind::library:
      return "library";
    case HostKind::floating:
      return "floating";
  }
  return "";
}

std::string columns_of(const Times& times) {
  return fmt::format("{:>9.3f}{:>9.3f}{:>7.1f} %", times.min, times.median, 100 * times.spread);
}

std::string accuracy_columns(const HostRow& row) {
  return fmt::format(
      "{:>11}{:>10}{:>11}  {}{}", largest_text(row.errors.max()),
      error_text(row.errors.root_mean_square()), share_text(row.errors.correct()), row.rounding,
      row.exceptions == 0 ? ""
                          : fmt::format(", but for {} of {}", support::grouped(row.exceptions),
                                        support::grouped(row.cases)));
}

void print_operation(const HostOperation& operation, const std::vector<HostRow>& rows) {
  const bool vertices = operation.name == vertex;
  std::cout << fmt::format("\n{}: {}\n", vertices ? "vertices" : operation.name,
                           operation.operands_are);
  if (!operation.chain_is.empty()) std::cout << fmt::format("chain: {}\n", operation.chain_is);
  std::cout << fmt::format("{:<26}{:>9}{:>9}{:>9}", "", vertices ? "ns" : "ns each", "median",
                           "spread");
  if (!operation.chain_is.empty()) {
    std::cout << fmt::format("{:>9}{:>9}{:>9}", "chain", "median", "spread");
  }
  if (vertices) std::cout << fmt::format("{:>9}{:>9}", "M a s", "median");
  std::cout << fmt::format("{:>11}{:>10}{:>11}  rounded\n", "max", "rms", "correct");
  for (const HostRow& row : rows) {
    if (row.operation != operation.name) continue;
    std::cout << fmt::format("  {:<24}{}", row.name, columns_of(row.each));
    if (row.chain) std::cout << columns_of(*row.chain);
    if (vertices) {
      std::cout << fmt::format("{:>9.1f}{:>9.1f}", 1e3 / row.each.min, 1e3 / row.each.median);
    }
    std::cout << accuracy_columns(row) << '\n';
  }
}

Json json_of(const Times& times) {
  return {{"min", times.min}, {"median", times.median}, {"spread", times.spread}};
}

/// What rows of operations and of vertices end with.
void add_judged(Json& json, const HostRow& row) {
  json["cases"] = row.cases;
  json["exceptions"] = row.exceptions;
  json["accuracy"] = {{"max", row.errors.max()},
                      {"mean", row.errors.mean()},
                      {"rms", row.errors.root_mean_square()},
                      {"correct", row.errors.correct()}};
}

Json json_of(const HostRow& row) {
  Json json;
  const bool vertices = row.operation == vertex;
  if (!vertices) json["operation"] = row.operation;
  json["contender"] = row.name;
  json["alike"] = row.alike;
  json["kind"] = kind_text(row.kind);
  json["rounding"] = row.rounding;
  if (vertices) {
    json["ns"] = json_of(row.each);
    json["per_second"] = {{"most", 1e9 / row.each.min}, {"median", 1e9 / row.each.median}};
  } else {
    json["throughput_ns"] = json_of(row.each);
    json["chain_ns"] = row.chain ? json_of(*row.chain) : Json(nullptr);
  }
  add_judged(json, row);
  return json;
}

void print_host(const MeasureRequest& request, const std::vector<HostOperation>& operations,
                const std::vector<HostRow>& rows) {
  std::cout << fmt::format(
      "{} {}, {}\n\n"
      "Nanoseconds of processor time of one operation, over arrays in the first-level cache, and "
      "in chains\nwhere each result is an operand of the next; the least and the median of {} "
      "rounds, in which all are\ntimed in turn. The spread is the third quartile less the first, "
      "by the median. Operands come again\nand again: a processor may have learnt what branches. "
      "Errors in units of the last place of 16.16, of\n{} results or more, each held to the "
      "rounding that its maker states; correct is one within half a\nunit.\n{}",
      made_by(request.seed), compiler_flags(), processor_name(), support::grouped(request.rounds),
      support::grouped(operations.front().operands.words.size() / operations.front().words),
      libraries_left_out());
  for (const HostOperation& operation : operations) print_operation(operation, rows);
}

Json json_of(const std::vector<HostOperation>& operations) {
  Json json{{"arrays", Json::object()}, {"chains", Json::object()}};
  for (const HostOperation& o : operations) {
    json["arrays"][o.name] = o.operands.block / o.words;
    if (!o.chain_is.empty()) json["chains"][o.name] = o.operands.taken.size();
  }
  return json;
}

void write_host_json(const MeasureRequest& request, const std::vector<HostOperation>& operations,
                     const std::vector<HostRow>& rows) {
  Json json{{"made", made_by_json(request.seed, "measure --host")}};
  json["made"]["flags"] = compiler_flags();
  json["made"]["processor"] = processor_name();
  json["libraries"] = {{"libfixmath", has_libfixmath()}, {"FreeType", has_freetype()}};
  json["rounds"] = request.rounds;
  json["operands"] = json_of(operations);
  json["host"] = Json::array();
  json["vertices"] = Json::array();
  for (const HostRow& row : rows) {
    json[row.operation == vertex ? "vertices" : "host"].push_back(json_of(row));
  }
  support::replace_file(request.json, support::json_text(json));
}

}  // namespace

int measure_host(const MeasureRequest& request) {
  if (!request.json.empty()) support::check_replaceable(request.json);
  const std::uint64_t cases = request.cases.value_or(default_host_cases);
  const auto operations = host_operations(request.seed, (cases - 1) / host_block + 1);
  std::vector<HostRow> rows;
  std::uint64_t rounds = 0;
  try {
    const support::Interrupt interrupt;
    support::FrameProgress progress(request.rounds, "rounds");
    rows = measure_host_rows(operations, request.rounds, support::Interrupt::flag(),
                             [&](std::uint64_t timed) { progress.show(rounds = timed); });
  } catch (const WrongContender& wrong) {
    fmt::print(stderr, "fixproof: {}\n", wrong.what());
    return 1;
  }
  if (rows.empty()) {
    std::cout << fmt::format("STOPPED after {} of {} rounds{}\n", rounds, request.rounds,
                             request.json.empty() ? "" : "; " + request.json + " is not written");
    return support::interrupted_status;
  }
  print_host(request, operations, rows);
  if (!request.json.empty()) write_host_json(request, operations, rows);
  return 0;
}

}  // namespace fixproof::trade
