#include "verify/report_json.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "cases/plan.hpp"
#include "cases/words.hpp"
#include "support/json.hpp"

namespace fixproof::verify {

namespace {

using support::Json;

constexpr std::string_view format_name = "fixproof report";
/// Version 1 expected a carry in the printed 8088 ConcatXforms, so its rows differ.
constexpr int format_version = 2;

/// The maximum that `verify` accepts for --max-reports.
constexpr std::uint64_t max_reports = 1000;

[[noreturn]] void refuse(const std::string& reason) { throw std::runtime_error(reason); }

/// 64-bit numbers are strings because many JSON readers keep only 53 bits.
template <class Integer>
Integer integer_in(std::string_view text, int base, const char* what) {
  Integer value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc{} || end != text.data() + text.size()) {
    refuse(fmt::format("'{}' is not a {}", text, what));
  }
  return value;
}

/// Reads an unsigned count. The library would convert -1 to the largest value.
std::uint64_t count_in(const Json& json) {
  if (!json.is_number_unsigned()) refuse(fmt::format("{} is not a count", json.dump()));
  return json.get<std::uint64_t>();
}

/// Returns whether `json` is the second of two allowed values. Refuses any other value.
template <class Value>
bool is_second(const Json& json, const Value& first, const Value& second) {
  const auto value = json.get<Value>();
  if (value != first && value != second) {
    refuse(fmt::format("{} must be {} or {}", json.dump(), first, second));
  }
  return value == second;
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
          {"words", cases::hex_words(m.words, word_bits)},
          {"smallest", cases::hex_words(m.smallest, word_bits)},
          {"said", said}};
}

/// The streams of a row and their sizes, which reveal whether two builds generate the same cases.
Json streams_of(const cases::Plan& plan, std::size_t row) {
  Json streams = Json::object();
  for (const cases::Job& job : plan.jobs()) {
    if (job.row == row) streams[std::string(cases::name_of(job.stream))] = job.cases;
  }
  return streams;
}

Json json_of(const Report& report, std::size_t number) {
  const cases::Row& row = report.plan.rows()[number];
  const Findings& found = report.findings[number];
  const cases::Variant& v = row.variant;
  Json shown = Json::array();
  for (const Mismatch& m : found.shown) shown.push_back(json_of(m, cases::operand_bits(v)));
  return {{"operation", cases::name_of(v.operation)},
          {"target", cases::name_of(v.build.target)},
          {"mul_round", v.build.mul_round},
          {"div_round", v.build.div_round},
          {"chapter", v.build.chapter_52 ? 52 : 54},
          {"repaired", v.build.repaired},
          {"width", v.fraction_bits == 16 ? "full" : "half"},
          {"parties", row.parties},
          {"streams", streams_of(report.plan, number)},
          {"cases", found.cases},
          {"faults", found.faults},
          {"mismatches", found.mismatches},
          {"shown", shown}};
}

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
    const std::uint64_t first = count_in(range.at(0));
    const std::uint64_t last = count_in(range.at(1));
    if (first < next || last < first || last >= places) {
      refuse(fmt::format("the chunks {} to {} of \"done\" are not in the shard", first, last));
    }
    for (std::uint64_t place = first; place <= last; ++place) {
      report.done[report.shard.index - 1 + place * report.shard.count] = true;
    }
    next = last + 1;
  }
}

cases::Target target_named(const std::string& name) {
  for (const cases::Target t :
       {cases::Target::i386, cases::Target::i8088, cases::Target::standard}) {
    if (cases::name_of(t) == name) return t;
  }
  refuse(fmt::format("unknown target '{}'", name));
}

cases::Row row_in(const Json& json) {
  cases::Row row;
  cases::Variant& v = row.variant;
  v.operation = cases::operation_named(json.at("operation").get<std::string>());
  v.build.target = target_named(json.at("target").get<std::string>());
  v.build.mul_round = json.at("mul_round").get<bool>();
  v.build.div_round = json.at("div_round").get<bool>();
  v.build.chapter_52 = is_second<int>(json.at("chapter"), 54, 52);
  v.build.repaired = json.at("repaired").get<bool>();
  v.fraction_bits = is_second<std::string>(json.at("width"), "full", "half") ? 8 : 16;
  row.parties = json.at("parties").get<std::vector<std::string>>();
  return row;
}

Findings findings_in(const Json& json) {
  Findings found;
  found.cases = count_in(json.at("cases"));
  found.faults = count_in(json.at("faults"));
  found.mismatches = count_in(json.at("mismatches"));
  for (const Json& shown : json.at("shown")) {
    Mismatch& m = found.shown.emplace_back();
    m.chunk = count_in(shown.at("chunk"));
    m.index = count_in(shown.at("case"));
    m.words = words_in_text(shown.at("words").get<std::string>());
    m.smallest = words_in_text(shown.at("smallest").get<std::string>());
    for (const auto& [party, answer] : shown.at("said").items()) {
      m.said.emplace_back(party, answer.get<std::string>());
    }
  }
  return found;
}

/// Returns whether a finished chunk of the row, with the row's parties, can produce the mismatch.
bool fits(const Mismatch& m, const Report& report, std::size_t row) {
  if (m.chunk >= report.done.size() || !report.done[m.chunk]) return false;
  const cases::Chunk chunk = report.plan.chunk(m.chunk);
  const cases::Row& of = report.plan.rows()[row];
  const std::size_t arity = cases::words_in(of.variant.operation);
  const int bits = cases::operand_bits(of.variant);
  const auto too_wide = [bits](std::uint32_t word) { return bits < 32 && word >> bits != 0; };
  const auto is_case = [&](const std::vector<std::uint32_t>& words) {
    return words.size() == arity && std::none_of(words.begin(), words.end(), too_wide);
  };
  const auto plain = [](const std::pair<std::string, std::string>& said) {
    return std::all_of(said.second.begin(), said.second.end(),
                       [](char c) { return c >= ' ' && c <= '~'; });
  };
  const auto names_match = [](const std::pair<std::string, std::string>& said,
                              const std::string& party) { return said.first == party; };
  return chunk.job->row == row && m.index >= chunk.first && m.index - chunk.first < chunk.cases &&
         is_case(m.words) && (m.smallest.empty() || is_case(m.smallest)) &&
         std::all_of(m.said.begin(), m.said.end(), plain) &&
         (m.said.empty() || std::equal(m.said.begin(), m.said.end(), of.parties.begin(),
                                       of.parties.end(), names_match));
}

/// Refuses counts that the finished chunks cannot produce.
void check_counts(const Report& report) {
  std::vector<std::uint64_t> cases(report.findings.size());
  each_chunk(report, [&](std::uint64_t, std::uint64_t number) {
    const cases::Chunk chunk = report.plan.chunk(number);
    if (report.done[number]) cases[chunk.job->row] += chunk.cases;
  });
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Findings& found = report.findings[i];
    const bool counted =
        found.cases == cases[i] && found.faults <= cases[i] && found.mismatches <= cases[i] &&
        found.shown.size() == std::min<std::uint64_t>(found.mismatches, report.max_shown);
    if (!counted || !std::all_of(found.shown.begin(), found.shown.end(),
                                 [&](const Mismatch& m) { return fits(m, report, i); })) {
      refuse(fmt::format("the counts of row {} do not fit the chunks done", i + 1));
    }
  }
}

cases::Shard shard_in(const Json& json) {
  const cases::Shard shard{count_in(json.at(0)), count_in(json.at(1))};
  if (shard.index < 1 || shard.index > shard.count)
    refuse("the shard is not i of n with 1 <= i <= n");
  return shard;
}

Report report_in(const Json& json) {
  const auto format = json.is_object() ? json.find("format") : json.end();
  if (format == json.end() || *format != std::string(format_name))
    refuse("not a report of fixproof");
  if (const int version = json.at("version").get<int>(); version != format_version) {
    refuse(fmt::format(
        "the report has version {}, but this fixproof reads version {}; run verify again", version,
        format_version));
  }
  std::vector<cases::Row> rows;
  for (const Json& row : json.at("rows")) rows.push_back(row_in(row));
  cases::Plan plan(json.at("level").get<int>(),
                   integer_in<std::uint64_t>(json.at("seed").get<std::string>(), 10, "seed"),
                   std::move(rows));
  for (std::size_t i = 0; i < plan.rows().size(); ++i) {
    if (json.at("rows")[i].at("streams") != streams_of(plan, i)) {
      refuse("made by a fixproof that runs other cases; run verify again");
    }
  }
  const std::uint64_t max_shown = count_in(json.at("max_reports"));
  if (max_shown > max_reports) refuse(fmt::format("max_reports {} is too large", max_shown));
  Report report(std::move(plan), shard_in(json.at("shard")), max_shown);
  read_done(json.at("done"), report);
  for (std::size_t i = 0; i < report.findings.size(); ++i) {
    report.findings[i] = findings_in(json.at("rows")[i]);
  }
  report.seconds = json.at("seconds").get<double>();
  if (!(report.seconds >= 0)) refuse("negative seconds");
  check_counts(report);
  if (count_in(json.at("cases")) != report.cases() ||
      count_in(json.at("mismatches")) != report.mismatches() ||
      json.at("complete").get<bool>() != report.complete()) {
    refuse("the totals do not fit the rows");
  }
  return report;
}

}  // namespace

std::string to_json(const Report& report) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < report.findings.size(); ++i) {
    rows.push_back(json_of(report, i));
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
                  {"done", done_ranges(report)},
                  {"rows", rows}};
  return json.dump(1) + "\n";
}

Report from_json(std::string_view text) {
  // The library would take one for the end.
  if (text.find('\0') != std::string_view::npos) refuse("no JSON: a zero byte");
  try {
    return report_in(Json::parse(text));
  } catch (const Json::parse_error&) {
    refuse(text.empty() ? "empty" : "not JSON, or cut short");
  } catch (const Json::exception& error) {
    // The library's message begins with its own error number in brackets.
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
