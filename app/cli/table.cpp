#include "app/cli/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

#include "support/plain_text.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/words.hpp"
#include "verify/replay.hpp"

namespace fixproof::cli {

namespace {

constexpr std::size_t columns = 7;
using Line = std::array<std::string, columns>;

std::vector<bool> unfinished_rows(const verify::Report& report) {
  std::vector<bool> unfinished(report.findings.size());
  for (std::uint64_t number = 0; number < report.done.size(); ++number) {
    if (report.done[number] || !report.shard.has(number)) continue;
    unfinished[report.plan.chunk(number).job->row] = true;
  }
  return unfinished;
}

std::string result_of(const cases::Row& row, const verify::Findings& found, bool unfinished) {
  if (!row.compared()) return "not compared";
  if (found.mismatches > 0) return fmt::format("{} DIFFER", support::grouped(found.mismatches));
  if (found.cases == 0) return "not run";
  return unfinished ? "equal so far" : "equal";
}

Line line_of(const cases::Row& row, const verify::Findings& found, bool unfinished) {
  const cases::Variant& v = row.variant;
  std::string target(cases::name_of(v.build.target));
  if (v.build.chapter_52) target += " ch52";
  if (v.build.repaired) target += " repaired";
  if (v.format == cases::q8_8) target += " 8.8";
  if (!cases::has_routine_format(v)) target = cases::name_of(cases::operand_format(v));
  if (v.from) target += " to " + cases::name_of(v.format);
  return {std::string(cases::name_of(v.operation)),
          target,
          v.build.target == cases::Target::standard ? "-"
          : cases::rounds(v)                        ? "on"
                                                    : "off",
          row.parties.empty() ? "none" : fmt::format("{}", fmt::join(row.parties, " ")),
          support::grouped(found.cases),
          support::grouped(found.faults),
          result_of(row, found, unfinished)};
}

std::string aligned(const std::vector<Line>& lines) {
  std::array<std::size_t, columns> widths{};
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < columns; ++i)
      widths.at(i) = std::max(widths.at(i), line.at(i).size());
  }
  std::string text;
  for (const Line& line : lines) {
    for (std::size_t i = 0; i < columns; ++i) {
      const bool number = i == 4 || i == 5;
      if (i > 0) text += "  ";
      if (i + 1 == columns) {
        text += line.at(i);
      } else {
        text += number ? fmt::format("{:>{}}", line.at(i), widths.at(i))
                       : fmt::format("{:<{}}", line.at(i), widths.at(i));
      }
    }
    text += '\n';
  }
  return text;
}

/// Formats the recorded mismatches of a row. Cases that shrink to the same case appear once.
std::string mismatch_lines(const cases::Row& row, const verify::Findings& found,
                           const verify::RowCases& among) {
  std::vector<const verify::Mismatch*> distinct;
  std::map<std::vector<std::uint32_t>, std::size_t> alike;
  for (const verify::Mismatch& m : found.shown) {
    if (alike[m.smallest.empty() ? m.words : m.smallest]++ == 0) distinct.push_back(&m);
  }
  std::string text;
  for (const verify::Mismatch* m : distinct) {
    const auto& words = m->smallest.empty() ? m->words : m->smallest;
    text += fmt::format("{}: {} ({})", cases::name_of(row.variant),
                        cases::hex_words(words, cases::operand_bits(row.variant)),
                        cases::decimal_words(row.variant, words));
    if (!m->said.empty()) text += fmt::format(": {}", grouped_answers(m->said));
    if (alike[words] > 1) text += fmt::format("; {} cases shrink to it", alike[words]);
    const verify::Replay again = verify::replay(row, *m, among);
    if (!m->said.empty() && !again.differs) text += "; alone, this case does not differ";
    text += fmt::format("\n  replay: {}\n", again.verify);
    if (!again.trace.empty()) text += fmt::format("  trace: {}\n", again.trace);
  }
  if (found.mismatches > found.shown.size()) {
    text += fmt::format("{}: {} more mismatches are not shown; see --max-reports\n",
                        cases::name_of(row.variant),
                        support::grouped(found.mismatches - found.shown.size()));
  }
  return text;
}

std::string totals(const verify::Report& report) {
  std::uint64_t comparisons = 0;
  std::uint64_t faults = 0;
  for (std::size_t i = 0; i < report.findings.size(); ++i) {
    const verify::Findings& found = report.findings[i];
    faults += found.faults;
    if (found.cases > 0) comparisons += found.cases * (report.plan.rows()[i].parties.size() - 1);
  }
  return fmt::format("{} cases compared ({} comparisons), {} of them #DE; {}, seed {}\n",
                     support::grouped(report.cases()), support::grouped(comparisons),
                     support::grouped(faults), support::duration(report.seconds),
                     report.plan.seed());
}

/// Describes the builds of a report that several made.
std::string maker_lines(const verify::Report& report) {
  if (report.makers.size() < 2) return "";
  std::string text = fmt::format("{} builds answered:\n", report.makers.size());
  for (const verify::Maker& maker : report.makers) {
    std::string line =
        fmt::format("  fixproof {}, commit {}, {}, {}, executable {}", maker.version, maker.commit,
                    maker.build_type, maker.compiler, maker.executable);
    for (const auto& [name, identity] : maker.parties) {
      line += fmt::format("; {}: {}", name, identity);
    }
    text += support::printable(line) + '\n';
  }
  return text;
}

std::string verdict(const verify::Report& report) {
  std::string text;
  if (report.shard.count > 1) {
    text += fmt::format("Shard {}/{}: ", report.shard.index, report.shard.count);
  }
  if (!report.complete()) {
    text += fmt::format("INCOMPLETE, {} of {} chunks: ", support::grouped(report.chunks_done()),
                        support::grouped(report.chunks_in_shard()));
  }
  if (report.mismatches() > 0) {
    const auto rows =
        std::count_if(report.findings.begin(), report.findings.end(),
                      [](const verify::Findings& found) { return found.mismatches > 0; });
    text += fmt::format("{} cases DIFFER, in {} {}.", support::grouped(report.mismatches()), rows,
                        rows == 1 ? "row" : "rows");
  } else if (report.cases() == 0) {
    text += "nothing was compared.";
  } else {
    text += report.complete() ? "all parties agree on every case." : "so far all parties agree.";
  }
  const auto uncompared = std::count_if(report.plan.rows().begin(), report.plan.rows().end(),
                                        [](const cases::Row& row) { return !row.compared(); });
  if (uncompared > 0) {
    text += fmt::format(" {} {} NOT COMPARED: fewer than two of the parties answer.", uncompared,
                        uncompared == 1 ? "row is" : "rows are");
  }
  if (text.front() >= 'a') text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text + '\n';
}

}  // namespace

std::string grouped_answers(const std::vector<std::pair<std::string, std::string>>& said) {
  std::vector<std::pair<std::string, std::string>> groups;
  for (const auto& one : said) {
    const auto same = std::find_if(groups.begin(), groups.end(),
                                   [&](const auto& group) { return group.second == one.second; });
    if (same == groups.end()) {
      groups.push_back(one);
    } else {
      same->first += " " + one.first;
    }
  }
  std::string text;
  for (const auto& [names, answer] : groups) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", names, answer);
  }
  return text;
}

std::string table(const verify::Report& report) {
  std::vector<Line> lines{
      {"operation", "target", "rounding", "parties, first judged", "cases", "#DE", "result"}};
  std::string mismatches;
  const std::vector<bool> unfinished = unfinished_rows(report);
  for (std::size_t i = 0; i < report.findings.size(); ++i) {
    lines.push_back(line_of(report.plan.rows()[i], report.findings[i], unfinished[i]));
    mismatches += mismatch_lines(report.plan.rows()[i], report.findings[i],
                                 {report.plan.level(), report.plan.seed()});
  }
  return aligned(lines) + '\n' + mismatches + (mismatches.empty() ? "" : "\n") + totals(report) +
         maker_lines(report) + verdict(report);
}

}  // namespace fixproof::cli
