#include "app/cli/json/desync_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <string_view>

#include "judge/desync/values.hpp"
#include "support/plain_text.hpp"

namespace fixproof::cli {

namespace {

using desync::LogFile;
using desync::Side;
using support::Json;

std::string_view word_of_kind(desync::Verdict kind) {
  using desync::Verdict;
  switch (kind) {
    case Verdict::block:
      return "block";
    case Verdict::input:
      return "input";
    case Verdict::evaluation:
      return "evaluation";
    case Verdict::swapped:
      return "swapped";
    case Verdict::moved:
      return "moved";
    case Verdict::integer:
      return "integer";
    case Verdict::operands:
      return "operands";
    case Verdict::accumulator:
      return "accumulator";
    case Verdict::arithmetic:
      return "arithmetic";
    case Verdict::order:
      return "order";
    case Verdict::type:
      return "type";
    case Verdict::path:
      return "path";
    case Verdict::equal:
    case Verdict::ended:
      break;
  }
  return "none";
}

Json or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json log_json(const LogFile& log) {
  Json json;
  json["file"] = support::printable(log.path());
  json["origin"] = Json::array();
  std::string_view rest = log.origin();
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    json["origin"] += support::printable(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  json["closed"] = log.is_complete();
  json["blocks"] = log.blocks();
  return json;
}

Json records_json(LogFile& log, const Side& side) {
  Json json = Json::array();
  for (const ShownRecord& record : records_around(log, side)) {
    json += Json{{"operation", record.operation},
                 {"text", support::printable(record.text)},
                 {"input", or_null(record.input)},
                 {"place", or_null(support::printable(record.place))},
                 {"differs", record.differs}};
  }
  return json;
}

Json origin_json(const desync::Origin& origin) {
  return Json::array(
      {{{"value", desync::text_of(origin.of_a)}, {"a", origin.of_a_in_a}, {"b", origin.of_a_in_b}},
       {{"value", desync::text_of(origin.of_b)},
        {"a", origin.of_b_in_a},
        {"b", origin.of_b_in_b}}});
}

}  // namespace

std::vector<ShownRecord> records_around(LogFile& log, const Side& side) {
  constexpr std::size_t context = 3;  // records before and after the one that differs
  std::vector<ShownRecord> shown;
  if (!side.index) return shown;
  const std::size_t end = std::min(side.records.size(), *side.index + 1 + context);
  for (std::size_t i = *side.index - std::min(*side.index, context); i < end; ++i) {
    const desync::Record& record = side.records[i];
    const desync::Operation operation = desync::operation_of(record.words);
    ShownRecord& one = shown.emplace_back();
    one.operation = record.operation;
    one.text = operation.kind == record::kind::mark ? "mark " + log.name_with_hash(record.words[1])
                                                    : desync::text_of(operation);
    if (record.input) {
      one.input = fmt::format("{} ({:016x})", std::bit_cast<double>(*record.input), *record.input);
    }
    if (record.line != 0 && record::is_operation(operation.kind)) {
      one.place = fmt::format("{}:{}", log.name(record.file), record.line);
    }
    one.differs = i == *side.index;
  }
  return shown;
}

std::string mark_of(LogFile& log, const Side& side) {
  const std::size_t index = side.index.value_or(0);
  if (index < side.records.size() && side.records[index].name != 0) {
    return log.name_with_hash(side.records[index].name);
  }
  return side.entry.name == 0 ? "" : log.name(side.entry.name);
}

std::string range_to_record(const desync::Comparison& found, bool rollback) {
  return rollback ? fmt::format("frames:{0}-{0}", found.a.entry.frame)
                  : fmt::format("{}-{}", found.a.block, found.a.block + 1);
}

Json desync_json(const desync::Comparison& found, LogFile& a, LogFile& b, bool rollback,
                 const std::string& explanation) {
  Json json;
  json["a"] = log_json(a);
  json["b"] = log_json(b);
  json["rollback"] = rollback;
  json["compared"] = found.blocks;
  json["difference"] = nullptr;
  if (word_of_kind(found.verdict) == "none") return json;
  const desync::Entry& entry = found.a.entry;
  const bool is_block = found.verdict == desync::Verdict::block;
  Json difference;
  difference["kind"] = word_of_kind(found.verdict);
  difference["block"] = found.a.block;
  difference["frame"] = entry.frame == record::no_frame ? Json() : Json(entry.frame);
  difference["mark"] = or_null(support::printable(mark_of(a, found.a)));
  difference["first_operation"] = entry.first_operation;
  difference["operations"] = entry.operations;
  difference["record_full"] = is_block ? Json(range_to_record(found, rollback)) : Json();
  difference["a"] = records_json(a, found.a);
  difference["b"] = records_json(b, found.b);
  difference["computed_in"] = found.origin ? origin_json(*found.origin) : Json();
  difference["text"] = explanation;
  std::ranges::replace(difference["text"].get_ref<std::string&>(), '\n', ' ');
  json["difference"] = difference;
  return json;
}

}  // namespace fixproof::cli
