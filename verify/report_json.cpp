#include "verify/report_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "verify/text.hpp"

namespace fixproof {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view format_name = "fixproof report";
constexpr int format_version = 1;

[[noreturn]] void refuse(const std::string& reason) { throw std::runtime_error(reason); }

/// 64-bit numbers are written as text: many readers of JSON keep no more than 53 bits.
template <class Integer>
Integer integer_in(std::string_view text, int base, const char* what) {
  Integer value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc{} || end != text.data() + text.size()) {
    refuse(fmt::format("'{}' is no {}", text, what));
  }
  return value;
}

std::vector<std::uint32_t> words_in_text(std::string_view text) {
  std::vector<std::uint32_t> words;
  while (!text.empty()) {
    const auto space = std::min(text.find(' '), text.size());
    words.push_back(integer_in<std::uint32_t>(text.substr(0, space), 16, "word"));
    text.remove_prefix(std::min(space + 1, text.size()));
  }
  return words;
}

Json json_of(const Mismatch& m, int word_bits) {
  Json said = Json::object();
  for (const auto& [party, answer] : m.said) said[party] = answer;
  return {{"chunk", m.chunk},
          {"case", m.index},
          {"words", hex_words(m.words, word_bits)},
          {"smallest", hex_words(m.smallest, word_bits)},
          {"said", said}};
}

Json json_of(const Row& row, const Findings& found) {
  const Variant& v = row.variant;
  Json shown = Json::array();
  for (const Mismatch& m : found.shown) shown.push_back(json_of(m, operand_bits(v)));
  return {{"operation", name_of(v.operation)},
          {"target", name_of(v.target)},
          {"mul_round", v.mul_round},
          {"div_round", v.div_round},
          {"chapter", v.chapter_52 ? 52 : 54},
          {"width", v.fraction_bits == 16 ? "full" : "half"},
          {"parties", row.parties},
          {"cases", found.cases},
          {"faults", found.faults},
          {"mismatches", found.mismatches},
          {"shown", shown}};
}

/// The chunks of the report's shard, in order.
template <class Use>
void each_chunk(const Report& report, Use use) {
  for (std::uint64_t place = 0; place < report.chunks_in_shard(); ++place) {
    use(place, report.shard.index - 1 + place * report.shard.count);
  }
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

void read_done(const Json& ranges, Report& report) {
  const std::uint64_t places = report.chunks_in_shard();
  std::uint64_t next = 0;
  for (const Json& range : ranges) {
    const auto first = range.at(0).get<std::uint64_t>();
    const auto last = range.at(1).get<std::uint64_t>();
    if (first < next || last < first || last >= places) {
      refuse(fmt::format("the chunks done, {} to {}, do not fit", first, last));
    }
    for (std::uint64_t place = first; place <= last; ++place) {
      report.done[report.shard.index - 1 + place * report.shard.count] = true;
    }
    next = last + 1;
  }
}

Target target_named(const std::string& name) {
  for (const Target t : {Target::i386, Target::i8088, Target::standard}) {
    if (name_of(t) == name) return t;
  }
  refuse(fmt::format("unknown target '{}'", name));
}

Row row_in(const Json& json) {
  Row row;
  Variant& v = row.variant;
  v.operation = operation_named(json.at("operation").get<std::string>());
  v.target = target_named(json.at("target").get<std::string>());
  v.mul_round = json.at("mul_round").get<bool>();
  v.div_round = json.at("div_round").get<bool>();
  v.chapter_52 = json.at("chapter").get<int>() == 52;
  v.fraction_bits = json.at("width").get<std::string>() == "half" ? 8 : 16;
  row.parties = json.at("parties").get<std::vector<std::string>>();
  return row;
}

Findings findings_in(const Json& json) {
  Findings found;
  found.cases = json.at("cases").get<std::uint64_t>();
  found.faults = json.at("faults").get<std::uint64_t>();
  found.mismatches = json.at("mismatches").get<std::uint64_t>();
  for (const Json& shown : json.at("shown")) {
    Mismatch& m = found.shown.emplace_back();
    m.chunk = shown.at("chunk").get<std::uint64_t>();
    m.index = shown.at("case").get<std::uint64_t>();
    m.words = words_in_text(shown.at("words").get<std::string>());
    m.smallest = words_in_text(shown.at("smallest").get<std::string>());
    for (const auto& [party, answer] : shown.at("said").items()) {
      m.said.emplace_back(party, answer.get<std::string>());
    }
  }
  return found;
}

/// Refuses counts that cannot come from the chunks that are done.
void check_counts(const Report& report) {
  std::vector<std::uint64_t> cases(report.findings.size());
  each_chunk(report, [&](std::uint64_t, std::uint64_t number) {
    const Chunk chunk = report.plan.chunk(number);
    if (report.done[number]) cases[chunk.job->row] += chunk.cases;
  });
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Findings& found = report.findings[i];
    const std::size_t arity = words_in(report.plan.rows()[i].variant.operation);
    bool fits = found.cases == cases[i] && found.faults <= cases[i] &&
                found.mismatches <= cases[i] &&
                found.shown.size() == std::min<std::uint64_t>(found.mismatches, report.max_shown);
    for (const Mismatch& m : found.shown) {
      fits = fits && m.chunk < report.done.size() && report.done[m.chunk] &&
             m.words.size() == arity && (m.smallest.empty() || m.smallest.size() == arity);
    }
    if (!fits) refuse(fmt::format("the counts of row {} do not fit the chunks done", i + 1));
  }
}

Shard shard_in(const Json& json) {
  const Shard shard{json.at(0).get<std::uint64_t>(), json.at(1).get<std::uint64_t>()};
  if (shard.index < 1 || shard.index > shard.count) refuse("impossible shard");
  return shard;
}

Report report_in(const Json& json) {
  if (!json.is_object() || json.value("format", "") != format_name) refuse("no report of fixproof");
  if (const int version = json.at("version").get<int>(); version != format_version) {
    refuse(fmt::format("a report of version {}; this is version {}", version, format_version));
  }
  std::vector<Row> rows;
  for (const Json& row : json.at("rows")) rows.push_back(row_in(row));
  Plan plan(json.at("level").get<int>(),
            integer_in<std::uint64_t>(json.at("seed").get<std::string>(), 10, "seed"),
            std::move(rows));
  if (json.at("chunks").get<std::uint64_t>() != plan.chunks()) {
    refuse("made by a fixproof that runs other cases");
  }
  Report report(std::move(plan), shard_in(json.at("shard")),
                json.at("max_reports").get<std::size_t>());
  read_done(json.at("done"), report);
  for (std::size_t i = 0; i < report.findings.size(); ++i) {
    report.findings[i] = findings_in(json.at("rows")[i]);
  }
  report.seconds = json.at("seconds").get<double>();
  check_counts(report);
  if (json.at("cases").get<std::uint64_t>() != report.cases() ||
      json.at("mismatches").get<std::uint64_t>() != report.mismatches() ||
      json.at("complete").get<bool>() != report.complete()) {
    refuse("the totals do not fit the rows");
  }
  return report;
}

}  // namespace

std::string to_json(const Report& report) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < report.findings.size(); ++i) {
    rows.push_back(json_of(report.plan.rows()[i], report.findings[i]));
  }
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
                  {"chunks", report.plan.chunks()},
                  {"done", done_ranges(report)},
                  {"rows", rows}};
  return json.dump(1) + "\n";
}

Report from_json(std::string_view text) {
  try {
    return report_in(Json::parse(text));
  } catch (const Json::parse_error&) {
    refuse(text.empty() ? "empty" : "no JSON, or cut short");
  } catch (const Json::exception& error) {
    // The library's message begins with its own number in brackets.
    const std::string_view message = error.what();
    refuse(fmt::format("damaged report: {}", message.substr(message.find("] ") + 2)));
  } catch (const std::invalid_argument& error) {
    refuse(fmt::format("damaged report: {}", error.what()));
  }
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
    const Row& of_a = a.plan.rows()[i];
    const Row& of_b = b.plan.rows()[i];
    if (of_a.variant != of_b.variant) first = fmt::format("another variant in row {}", i + 1);
    if (of_a.parties == of_b.parties) continue;
    first = fmt::format("row {} compares {}, not {}", i + 1, fmt::join(of_a.parties, " "),
                        fmt::join(of_b.parties, " "));
  }
  return first;
}

}  // namespace fixproof
