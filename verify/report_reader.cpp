#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "support/strict_json.hpp"
#include "verify/report_format.hpp"
#include "verify/report_json.hpp"

namespace fixproof::verify {

namespace {

/// Its keys are sorted, so that finding one of many is fast.
using Document = nlohmann::json;

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
std::uint64_t count_in(const Document& json) {
  if (!json.is_number_unsigned()) refuse(fmt::format("{} is not a count", json.dump()));
  return json.get<std::uint64_t>();
}

/// Returns whether `json` is the second of two allowed values. Refuses any other value.
template <class Value>
bool is_second(const Document& json, const Value& first, const Value& second) {
  const bool is = json == Document(second);
  if (!is && json != Document(first)) {
    refuse(fmt::format("{} must be {} or {}", json.dump(), first, second));
  }
  return is;
}

/// Reads numbers in hex. One of 64 bits is stored in two words, the low half first.
std::vector<std::uint32_t> words_in_text(std::string_view text, const cases::Format& format) {
  std::vector<std::uint32_t> words;
  while (!text.empty()) {
    const auto space = std::min(text.find(' '), text.size());
    const std::string_view number = text.substr(0, space);
    if (cases::words_per_number(format) == 2) {
      const auto both = integer_in<std::uint64_t>(number, 16, "word");
      words.push_back(static_cast<std::uint32_t>(both));
      words.push_back(static_cast<std::uint32_t>(both >> 32U));
    } else {
      words.push_back(integer_in<std::uint32_t>(number, 16, "word"));
    }
    text.remove_prefix(std::min(space + 1, text.size()));
  }
  return words;
}

void read_done(const Document& ranges, Report& report) {
  const std::uint64_t places = report.chunks_in_shard();
  std::uint64_t next = 0;
  for (const Document& range : ranges) {
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

ChunkResult chunk_in(std::string_view line) {
  const auto first = line.find(' ');
  const auto second = line.rfind(' ');
  if (first == second) refuse(fmt::format("'{}' is not the result of a chunk", line));
  return {integer_in<std::uint64_t>(line.substr(0, first), 10, "count"),
          integer_in<std::uint64_t>(line.substr(first + 1, second - first - 1), 10, "count"),
          integer_in<std::uint64_t>(line.substr(second + 1), 16, "digest")};
}

void read_chunks(const Document& lines, Report& report) {
  if (lines.size() != report.chunks_done()) {
    refuse(fmt::format("{} chunks are done, but there are {} results", report.chunks_done(),
                       lines.size()));
  }
  auto line = lines.begin();
  each_chunk(report, [&](std::uint64_t, std::uint64_t chunk) {
    if (report.done[chunk]) report.chunks[chunk] = chunk_in((line++)->get<std::string>());
  });
}

Maker maker_in(const Document& json, const cases::Plan& plan) {
  Maker maker;
  for (const auto& [key, text] : {std::pair{"version", &maker.version},
                                  {"commit", &maker.commit},
                                  {"build_type", &maker.build_type},
                                  {"compiler", &maker.compiler},
                                  {"executable", &maker.executable}}) {
    *text = json.at(key).get<std::string>();
  }
  maker.parties = json.at("parties").get<std::map<std::string, std::string>>();
  std::set<std::string> wanted;
  for (const cases::Row& row : plan.rows()) {
    wanted.insert(row.parties.begin(), row.parties.end());
  }
  const auto same_name = [](const auto& party, const std::string& name) {
    return party.first == name;
  };
  if (!std::equal(maker.parties.begin(), maker.parties.end(), wanted.begin(), wanted.end(),
                  same_name)) {
    refuse("a build does not describe the parties of the rows");
  }
  return maker;
}

cases::Target target_named(const std::string& name) {
  for (const cases::Target t :
       {cases::Target::i386, cases::Target::i8088, cases::Target::standard}) {
    if (cases::name_of(t) == name) return t;
  }
  refuse(fmt::format("unknown target '{}'", name));
}

/// Reads the formats of a row that has no width.
void read_formats(const Document& json, cases::Variant& v) {
  const auto named = [&](const char* key) {
    return cases::format_named(json.at(key).get<std::string>());
  };
  v.format = named("format");
  if (json.contains("to")) v.from = std::exchange(v.format, named("to"));
  if (v.from == v.format) refuse("a row has one format twice");
  if (cases::has_routine_format(v)) {
    refuse(fmt::format("{} is a width", cases::name_of(v.format)));
  }
}

cases::Row row_in(const Document& json) {
  cases::Row row;
  cases::Variant& v = row.variant;
  v.operation = cases::operation_named(json.at("operation").get<std::string>());
  v.build.target = target_named(json.at("target").get<std::string>());
  v.build.mul_round = json.at("mul_round").get<bool>();
  v.build.div_round = json.at("div_round").get<bool>();
  v.build.chapter_52 = is_second(json.at("chapter"), 54, 52);
  v.build.repaired = json.at("repaired").get<bool>();
  if (json.contains("format")) {
    read_formats(json, v);
  } else {
    v.format =
        is_second<std::string>(json.at("width"), "full", "half") ? cases::q8_8 : cases::q16_16;
  }
  row.parties = json.at("parties").get<std::vector<std::string>>();
  return row;
}

std::vector<cases::Row> rows_in(const Document& json) {
  std::vector<cases::Row> rows;
  for (const Document& one : json) {
    cases::Row row = row_in(one);
    const auto same = [&](const cases::Row& other) { return other.variant == row.variant; };
    if (std::any_of(rows.begin(), rows.end(), same)) {
      refuse(fmt::format("row {} repeats {}", rows.size() + 1, cases::name_of(row.variant)));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Findings findings_in(const Document& json, const cases::Row& row) {
  Findings found;
  found.cases = count_in(json.at("cases"));
  found.faults = count_in(json.at("faults"));
  found.mismatches = count_in(json.at("mismatches"));
  for (const Document& shown : json.at("shown")) {
    Mismatch& m = found.shown.emplace_back();
    m.chunk = count_in(shown.at("chunk"));
    m.index = count_in(shown.at("case"));
    m.words =
        words_in_text(shown.at("words").get<std::string>(), cases::operand_format(row.variant));
    m.smallest =
        words_in_text(shown.at("smallest").get<std::string>(), cases::operand_format(row.variant));
    const Document& said = shown.at("said");
    if (said.empty()) continue;
    for (const std::string& party : row.parties) {
      m.said.emplace_back(party, said.at(party).get<std::string>());
    }
  }
  return found;
}

/// Returns whether a finished chunk of the row, with the row's parties, can produce the mismatch.
bool fits(const Mismatch& m, const Report& report, std::size_t row) {
  if (m.chunk >= report.done.size() || !report.done[m.chunk]) return false;
  const cases::Chunk chunk = report.plan.chunk(m.chunk);
  const cases::Row& of = report.plan.rows()[row];
  const std::size_t arity = cases::words_in(of.variant);
  const int bits = cases::stored_bits(of.variant);
  const auto too_wide = [bits](std::uint32_t word) { return bits < 32 && word >> bits != 0; };
  const auto is_case = [&](const std::vector<std::uint32_t>& words) {
    return words.size() == arity && std::none_of(words.begin(), words.end(), too_wide);
  };
  const auto plain = [](const std::pair<std::string, std::string>& said) {
    return std::all_of(said.second.begin(), said.second.end(),
                       [](char c) { return c >= ' ' && c <= '~'; });
  };
  return chunk.job->row == row && m.index >= chunk.first && m.index - chunk.first < chunk.cases &&
         is_case(m.words) && (m.smallest.empty() || is_case(m.smallest)) &&
         std::all_of(m.said.begin(), m.said.end(), plain);
}

/// Returns whether the mismatches follow the order of the plan without repetition, and no chunk
/// shows more of them than it counts.
bool in_order(const std::vector<Mismatch>& shown, const Report& report) {
  std::uint64_t of_chunk = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const bool same_chunk = i > 0 && shown[i].chunk == shown[i - 1].chunk;
    if (i > 0 && shown[i].chunk < shown[i - 1].chunk) return false;
    if (same_chunk && shown[i].index <= shown[i - 1].index) return false;
    of_chunk = same_chunk ? of_chunk + 1 : 1;
    if (of_chunk > report.chunks[shown[i].chunk].mismatches) return false;
  }
  return true;
}

/// Refuses counts that the finished chunks cannot produce.
void check_counts(const Report& report) {
  std::vector<Findings> sums(report.findings.size());
  each_chunk(report, [&](std::uint64_t, std::uint64_t number) {
    if (!report.done[number]) return;
    const cases::Chunk chunk = report.plan.chunk(number);
    const ChunkResult& result = report.chunks[number];
    if (result.faults > chunk.cases || result.mismatches > chunk.cases) {
      refuse(fmt::format("chunk {} counts more than its cases", number));
    }
    Findings& sum = sums[chunk.job->row];
    sum.cases += chunk.cases;
    sum.faults += result.faults;
    sum.mismatches += result.mismatches;
  });
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const Findings& found = report.findings[i];
    const bool counted =
        found.cases == sums[i].cases && found.faults == sums[i].faults &&
        found.mismatches == sums[i].mismatches &&
        found.shown.size() == std::min<std::uint64_t>(found.mismatches, report.max_shown);
    if (!counted ||
        !std::all_of(found.shown.begin(), found.shown.end(),
                     [&](const Mismatch& m) { return fits(m, report, i); }) ||
        !in_order(found.shown, report)) {
      refuse(fmt::format("the counts of row {} do not fit the chunks done", i + 1));
    }
  }
}

cases::Shard shard_in(const Document& json) {
  const cases::Shard shard{count_in(json.at(0)), count_in(json.at(1))};
  if (shard.index < 1 || shard.index > shard.count)
    refuse("the shard is not i of n with 1 <= i <= n");
  return shard;
}

int level_in(const Document& json) {
  const std::uint64_t level = count_in(json);
  if (level > 3) refuse(fmt::format("no level {}", level));
  return static_cast<int>(level);
}

/// Refuses other files, other formats, and a text that does not match its digest.
void check_seal(const Document& json, std::string_view text) {
  const auto format = json.is_object() ? json.find("format") : json.end();
  if (format == json.end() || *format != std::string(format_name))
    refuse("not a report of fixproof");
  // The digest first: in a damaged report the version may be wrong too.
  const std::uint64_t version = count_in(json.at("version"));
  if (json.contains("digest") || version == format_version) {
    const std::size_t sealed = text.size() - std::min(text.size(), seal_of("").size());
    if (text.substr(sealed) != seal_of(text.substr(0, sealed))) {
      refuse(
          "the digest at its end is missing or does not match: it was damaged or edited; run the "
          "verification again");
    }
  }
  if (version < format_version) {
    refuse(
        fmt::format("written in format {} by a fixproof 0.1.0 that did not record its build; this "
                    "fixproof reads format {}: run the verification again",
                    version, format_version));
  }
  if (version > format_version) {
    refuse(fmt::format(
        "fixproof {} wrote this report, in format {}; this fixproof reads format {}: "
        "read it with that version, or run the verification again",
        json.at("made_by").at(0).at("version").get<std::string>(), version, format_version));
  }
}

Report report_in(const Document& json) {
  cases::Plan plan(level_in(json.at("level")),
                   integer_in<std::uint64_t>(json.at("seed").get<std::string>(), 10, "seed"),
                   rows_in(json.at("rows")));
  const auto streams = streams_by_row<Document>(plan);
  for (std::size_t i = 0; i < plan.rows().size(); ++i) {
    if (json.at("rows")[i].at("streams") != streams[i]) {
      refuse("made by a fixproof that runs other cases; run verify again");
    }
  }
  const std::uint64_t max_shown = count_in(json.at("max_reports"));
  if (max_shown > max_reports) refuse(fmt::format("max_reports {} is too large", max_shown));
  Report report(std::move(plan), shard_in(json.at("shard")), max_shown);
  for (const Document& maker : json.at("made_by")) report.add(maker_in(maker, report.plan));
  read_done(json.at("done"), report);
  if (report.makers.empty() && report.chunks_done() > 0) refuse("made_by names no build");
  read_chunks(json.at("chunks"), report);
  for (std::size_t i = 0; i < report.findings.size(); ++i) {
    report.findings[i] = findings_in(json.at("rows")[i], report.plan.rows()[i]);
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

Report from_json(std::string_view text) {
  try {
    const Document json = support::parse_strictly(text);
    check_seal(json, text);
    Report report = report_in(json);
    if (to_json(report) != text) refuse("not as fixproof writes it: it has other keys or spaces");
    return report;
  } catch (const Document::parse_error&) {
    refuse(text.empty() ? "empty" : "not JSON, or cut short, or followed by other text");
  } catch (const Document::exception& error) {
    refuse(fmt::format("damaged report: {}", support::json_message(error)));
  } catch (const std::invalid_argument& error) {
    refuse(fmt::format("damaged report: {}", error.what()));
  }
}

}  // namespace fixproof::verify
