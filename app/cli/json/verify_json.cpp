#include "app/cli/json/verify_json.hpp"

#include <span>

#include "verify/cases/words.hpp"
#include "verify/replay.hpp"

namespace fixproof::cli {

namespace {

using support::Json;

Json case_json(const cases::Variant& variant, std::span<const std::uint32_t> words,
               const std::vector<std::pair<std::string, std::string>>& said) {
  Json json;
  json["variant"] = cases::name_of(variant);
  json["operands"] = cases::hex_words(words, cases::operand_bits(variant));
  json["values"] = cases::decimal_words(variant, words);
  json["answers"] = Json::object();
  for (const auto& [party, answer] : said) json["answers"][party] = answer;
  return json;
}

Json mismatch_json(const cases::Row& row, const verify::Mismatch& mismatch,
                   const verify::RowCases& among) {
  const auto& words = mismatch.smallest.empty() ? mismatch.words : mismatch.smallest;
  const verify::Replay again = verify::replay(row, mismatch, among);
  Json json = case_json(row.variant, words, mismatch.said);
  json["differs_alone"] = again.differs;
  json["replay"] = again.verify;
  json["trace"] = again.trace.empty() ? Json() : Json(again.trace);
  return json;
}

Json row_json(const cases::Row& row, const verify::Findings& found) {
  return {{"variant", cases::name_of(row.variant)},
          {"operation", cases::name_of(row.variant.operation)},
          {"parties", row.parties},
          {"cases", found.cases},
          {"faults", found.faults},
          {"mismatches", found.mismatches}};
}

}  // namespace

Json verify_json(const verify::Report& report) {
  const auto& rows = report.plan.rows();
  Json json;
  json["level"] = report.plan.level();
  json["seed"] = report.plan.seed();
  json["shard"] = {{"index", report.shard.index}, {"count", report.shard.count}};
  json["complete"] = report.complete();
  json["cases"] = report.cases();
  json["mismatches"] = report.mismatches();
  json["seconds"] = report.seconds;
  json["rows"] = Json::array();
  json["examples"] = Json::array();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    json["rows"] += row_json(rows[i], report.findings[i]);
    for (const verify::Mismatch& mismatch : report.findings[i].shown) {
      json["examples"] +=
          mismatch_json(rows[i], mismatch, {report.plan.level(), report.plan.seed()});
    }
  }
  return json;
}

Json asked_json(const std::vector<AskedCase>& asked) {
  Json json;
  json["asked"] = Json::array();
  for (const AskedCase& one : asked) {
    Json answer = case_json(one.variant, one.words, one.said);
    answer["equal"] = one.equal;
    json["asked"] += answer;
  }
  return json;
}

}  // namespace fixproof::cli
