// fixproof measure --stepping.
//
// The file that --json names:
//
//   made      {command, seed, compiler, date}
//   lengths   {least, most, spans}: pixels of the shortest and longest spans, spans of each length
//   stepping  a list of {value, rule; unit: level, depth or texel, what errors are in; ends: the
//             range of the values at the ends of spans; spans, pixels; max, bound: the largest
//             error of all, and the largest that one can be; part_of_bound: the largest part of its
//             own bound that an error takes, 0 ... 1, more only where `beyond` says where; last:
//             {max, bound} of last pixels; along: a list of {pixel, max, bound} of spans of the
//             most pixels; last_of: a list of {pixels, max, bound}, of the last pixel of spans so
//             long; wrong: the share of pixels that are not those of the exact picture; most_off:
//             by how much; bands: {exact, drawn, wrong, widest}; missed: the share of the exact
//             spans' different values that their spans never draw; ns: nanoseconds a pixel here,
//             with its share of what a span of 160 pixels begins with, null where it is not timed}
//
//   setups, pixels, times, claims: see stepping_cost.hpp
//
// Errors are magnitudes, of values before they are cut to what is drawn.
#include <fmt/format.h>

#include <iostream>

#include "support/file.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/json.hpp"
#include "support/plain_text.hpp"
#include "trade/host/host_run.hpp"
#include "trade/host/provenance.hpp"
#include "trade/measure.hpp"
#include "trade/stepping/stepping_cost.hpp"
#include "trade/stepping/stepping_run.hpp"

namespace fixproof::trade {

namespace {

using support::Json;

constexpr std::uint64_t default_spans = 200;

const char* drawn_text(Drawn drawn) {
  switch (drawn) {
    case Drawn::level:
      return "level";
    case Drawn::depth:
      return "depth";
    case Drawn::texel:
      return "texel";
  }
  return "";
}

double part_of(std::uint64_t part, std::uint64_t of) {
  return of == 0 ? 0 : static_cast<double>(part) / static_cast<double>(of);
}

/// Five digits that count at most.
std::string figure_text(double x) { return x < 1e-9 ? "0" : fmt::format("{:.4g}", x); }
std::string percent_text(double x) { return x == 0 ? "0" : fmt::format("{:.3g} %", 100 * x); }

void print_errors(const std::vector<SteppingRow>& rows) {
  std::cout << fmt::format("\n{:<24}{:>7}{:>10}{:>10}{:>8}{:>10}{:>10}{:>10}{:>10}{:>10}\n", "",
                           "unit", "max", "bound", "of it", "at 1/4", "at 1/2", "at 3/4", "last",
                           "bound");
  std::string heading;
  for (const SteppingRow& row : rows) {
    const SteppingStatistics& s = row.statistics;
    if (row.variant.value != heading) std::cout << '\n' << row.variant.value << '\n';
    heading = row.variant.value;
    std::cout << fmt::format("  {:<22}{:>7}{:>10}{:>10}{:>8.3f}", row.variant.rule,
                             drawn_text(row.variant.drawn), figure_text(s.all().error),
                             figure_text(s.all().bound), s.part_of_bound());
    for (const std::size_t i : {4U, 8U, 12U, 16U}) {
      std::cout << fmt::format("{:>10}", figure_text(s.along().at(i).error));
    }
    std::cout << fmt::format("{:>10}\n", figure_text(s.along().back().bound));
  }
}

void print_pictures(const std::vector<SteppingRow>& rows) {
  std::cout << fmt::format("\n{:<24}{:>10}{:>9}{:>12}{:>10}{:>8}{:>10}\n", "", "wrong", "by most",
                           "bands", "wrong", "widest", "missed");
  std::string heading;
  for (const SteppingRow& row : rows) {
    const SteppingStatistics& s = row.statistics;
    if (row.variant.value != heading) std::cout << '\n' << row.variant.value << '\n';
    heading = row.variant.value;
    std::cout << fmt::format("  {:<22}{:>10}{:>9}{:>12}{:>10}{:>8}{:>10}\n", row.variant.rule,
                             percent_text(part_of(s.wrong(), s.drawn())), s.most_off(),
                             support::grouped(s.bands().drawn),
                             percent_text(part_of(s.bands().wrong, s.bands().drawn)),
                             s.bands().widest, percent_text(part_of(s.missed(), s.wanted())));
  }
}

Json json_of(const SteppingRow& row, const SteppingCost& cost) {
  const auto ns = nanoseconds_a_pixel(row.variant.value, row.variant.rule, cost.times);
  const SteppingStatistics& s = row.statistics;
  Json along = Json::array();
  for (std::size_t i = 0; i < SteppingStatistics::places; ++i) {
    along.push_back({{"pixel", SteppingStatistics::pixel_at(i)},
                     {"max", s.along().at(i).error},
                     {"bound", s.along().at(i).bound}});
  }
  Json last_of = Json::array();
  for (std::size_t i = 0; i < SteppingStatistics::lengths; ++i) {
    last_of.push_back({{"pixels", SteppingStatistics::length(i)},
                       {"max", s.last_of().at(i).error},
                       {"bound", s.last_of().at(i).bound}});
  }
  return {{"value", row.variant.value},
          {"rule", row.variant.rule},
          {"unit", drawn_text(row.variant.drawn)},
          {"ends", row.variant.range},
          {"spans", s.spans()},
          {"pixels", s.pixels()},
          {"max", s.all().error},
          {"bound", s.all().bound},
          {"part_of_bound", s.part_of_bound()},
          {"beyond", s.beyond()},
          {"last", {{"max", s.last().error}, {"bound", s.last().bound}}},
          {"along", std::move(along)},
          {"last_of", std::move(last_of)},
          {"wrong", part_of(s.wrong(), s.drawn())},
          {"most_off", s.most_off()},
          {"bands",
           {{"exact", s.bands().exact},
            {"drawn", s.bands().drawn},
            {"wrong", s.bands().wrong},
            {"widest", s.bands().widest}}},
          {"missed", part_of(s.missed(), s.wanted())},
          {"ns", ns ? Json(*ns) : Json(nullptr)}};
}

void print_stepping(const MeasureRequest& request, std::uint64_t spans,
                    const std::vector<SteppingRow>& rows) {
  std::cout << fmt::format(
      "{}\n\n"
      "Values stepped across {} span{} of each length from 1 to {} pixels, set against the exact "
      "ones.\nErrors are of values before they are cut to what is drawn, in that unit: the largest "
      "of all beside\nthe largest that one can be, as derived, the largest part of its own bound "
      "that any takes; then\nalong spans of {} pixels, with the bound at the last.\n",
      made_by(request.seed), support::grouped(spans), spans == 1 ? "" : "s", xsharp::longest_span,
      xsharp::longest_span);
  print_errors(rows);
  std::cout
      << "\nOf the spans whose ends are random, half of all: wrong pixels are not those of the "
         "exact picture,\nwhich is cut as well; by most how many units. Bands are runs of "
         "equal pixels; wrong those that the\nexact picture does not have from end to end; "
         "the widest stretch of wrong pixels. Missed are values\n(texels) of the exact span "
         "that its span never draws.\n";
  print_pictures(rows);
}

SteppingCost measure_cost(const MeasureRequest& request, const std::atomic<bool>& stop) {
  SteppingCost cost;
  cost.rounds = request.rounds;
  cost.setups = measure_setup_clocks(request.seed);
  cost.pixels = measure_pixel_costs(cost.setups);
  cost.claims = judge_stepping_claims(cost.setups);
  cost.times = time_stepping(request.seed, request.rounds, stop, [](std::uint64_t) {});
  return cost;
}

}  // namespace

int measure_stepping(const MeasureRequest& request) {
  if (!request.json.empty()) support::check_replaceable(request.json);
  const std::uint64_t spans = request.cases.value_or(default_spans);
  const std::vector<SteppingVariant> variants = stepping_variants();
  std::vector<SteppingRow> rows;
  SteppingCost cost;
  std::uint64_t done = 0;
  try {
    const support::Interrupt interrupt;
    const std::atomic<bool>& stop = support::Interrupt::flag();
    support::FrameProgress progress(variants.size() + 1, "parts");
    rows = measure_stepping_rows(variants, request.seed, spans, stop,
                                 [&](std::uint64_t all) { progress.show(done = all); });
    if (!rows.empty()) cost = measure_cost(request, stop);
  } catch (const WrongContender& wrong) {
    fmt::print(stderr, "fixproof: {}\n", wrong.what());
    return 1;
  }
  if (cost.times.empty()) {
    std::cout << fmt::format("STOPPED after {} of {} parts{}\n", done, variants.size() + 1,
                             request.json.empty() ? "" : "; " + request.json + " is not written");
    return support::interrupted_status;
  }
  print_stepping(request, spans, rows);
  print_cost(cost);
  if (!request.json.empty()) {
    Json json{{"made", made_by_json(request.seed, "measure --stepping")},
              {"lengths", {{"least", 1}, {"most", xsharp::longest_span}, {"spans", spans}}},
              {"stepping", Json::array()}};
    for (const SteppingRow& row : rows) json["stepping"].push_back(json_of(row, cost));
    add_cost(json, cost);
    support::replace_file(request.json, support::json_text(json));
  }
  int status = 0;
  for (const SteppingRow& row : rows) {
    if (row.statistics.beyond().empty()) continue;
    status = 1;
    fmt::print(stderr, "fixproof: {}, {}: {}\n", row.variant.value, row.variant.rule,
               row.statistics.beyond());
  }
  return status;
}

}  // namespace fixproof::trade
