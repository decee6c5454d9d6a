#include "verify/report_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "support/json.hpp"
#include "support/sha256.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/words.hpp"
#include "verify/report_format.hpp"

namespace fixproof::verify {

namespace {

using support::Json;

Json json_of(const Mismatch& m, int word_bits) {
  Json said = Json::object();
  for (const auto& [party, answer] : m.said) said[party] = answer;
  return {{"chunk", m.chunk},
          {"case", m.index},
          {"words", cases::hex_words(m.words, word_bits)},
          {"smallest", cases::hex_words(m.smallest, word_bits)},
          {"said", said}};
}

Json json_of(const Maker& maker) {
  return {{"version", maker.version},       {"commit", maker.commit},
          {"build_type", maker.build_type}, {"compiler", maker.compiler},
          {"executable", maker.executable}, {"parties", maker.parties}};
}

Json json_of(const Report& report, std::size_t number, const Json& streams) {
  const cases::Row& row = report.plan.rows()[number];
  const Findings& found = report.findings[number];
  const cases::Variant& v = row.variant;
  Json shown = Json::array();
  for (const Mismatch& m : found.shown) shown.push_back(json_of(m, cases::operand_bits(v)));
  const bool routine_format = cases::has_routine_format(v);
  const std::string format = !routine_format             ? cases::name_of(cases::operand_format(v))
                             : v.format == cases::q16_16 ? "full"
                                                         : "half";
  Json json{{"operation", cases::name_of(v.operation)},
            {"target", cases::name_of(v.build.target)},
            {"mul_round", v.build.mul_round},
            {"div_round", v.build.div_round},
            {"chapter", v.build.chapter_52 ? 52 : 54},
            {"repaired", v.build.repaired},
            {routine_format ? "width" : "format", format},
            {"parties", row.parties},
            {"streams", streams},
            {"cases", found.cases},
            {"faults", found.faults},
            {"mismatches", found.mismatches},
            {"shown", shown}};
  if (v.from) json["to"] = cases::name_of(v.format);
  return json;
}

Json done_ranges(const Report& report) {
  Json ranges = Json::array();
  bool before = false;
  each_chunk(report, [&](std::uint64_t place, std::uint64_t chunk) {
    const bool done = report.done[chunk];
    if (done && before) ranges.back()[1] = place;
    if (done && !before) ranges.push_back({place, place});
    before = done;
  });
  return ranges;
}

/// One line for each finished chunk: its faults, its mismatches and the digest of its answers.
Json chunk_lines(const Report& report) {
  Json lines = Json::array();
  each_chunk(report, [&](std::uint64_t, std::uint64_t chunk) {
    if (!report.done[chunk]) return;
    const ChunkResult& result = report.chunks[chunk];
    lines.push_back(fmt::format("{} {} {:016x}", result.faults, result.mismatches, result.answers));
  });
  return lines;
}

}  // namespace

std::string seal_of(std::string_view text) {
  return fmt::format(" \"digest\": \"{}\"\n}}\n", support::sha256_hex(text));
}

std::string to_json(const Report& report) {
  Json rows = Json::array();
  const auto streams = streams_by_row<Json>(report.plan);
  for (std::size_t i = 0; i < report.findings.size(); ++i) {
    rows.push_back(json_of(report, i, streams[i]));
  }
  Json makers = Json::array();
  for (const Maker& maker : report.makers) makers.push_back(json_of(maker));
  const Json json{{"format", format_name},
                  {"version", format_version},
                  {"level", report.plan.level()},
                  {"seed", fmt::to_string(report.plan.seed())},
                  {"shard", {report.shard.index, report.shard.count}},
                  {"max_reports", report.max_shown},
                  {"complete", report.complete()},
                  {"seconds", report.seconds},
                  {"cases", report.cases()},
                  {"mismatches", report.mismatches()},
                  {"made_by", makers},
                  {"rows", rows},
                  {"done", done_ranges(report)},
                  {"chunks", chunk_lines(report)}};
  std::string text = json.dump(1);
  text.replace(text.size() - std::string_view("\n}").size(), std::string::npos, ",\n");
  return text + seal_of(text);
}

std::string difference(const Report& a, const Report& b) {
  const auto differ = [](std::string_view what, auto of_a, auto of_b) {
    return of_a == of_b ? std::string() : fmt::format("{} {}, not {}", what, of_a, of_b);
  };
  std::string first = differ("level", a.plan.level(), b.plan.level());
  if (first.empty()) first = differ("seed", a.plan.seed(), b.plan.seed());
  if (first.empty()) first = differ("--max-reports", a.max_shown, b.max_shown);
  if (first.empty()) first = differ("rows:", a.plan.rows().size(), b.plan.rows().size());
  for (std::size_t i = 0; first.empty() && i < a.plan.rows().size(); ++i) {
    const cases::Row& of_a = a.plan.rows()[i];
    const cases::Row& of_b = b.plan.rows()[i];
    if (of_a.variant != of_b.variant) first = fmt::format("row {} has another variant", i + 1);
    if (of_a.parties == of_b.parties) continue;
    first = fmt::format("row {} compares {}, not {}", i + 1, fmt::join(of_a.parties, " "),
                        fmt::join(of_b.parties, " "));
  }
  return first;
}

}  // namespace fixproof::verify
