#include "measure/stepping/stepping.hpp"

#include <array>
#include <utility>

#include "measure/host/provenance.hpp"
#include "verify/parties/machines.hpp"

namespace fixproof::measure {

namespace {

using support::Json;

constexpr std::uint64_t default_spans = 200;

/// A list of {name: value, max, bound}. @param value_of gives the value of index i
template <class Errors>
Json list_of(const char* name, std::size_t (*value_of)(std::size_t), const Errors& errors) {
  Json list = Json::array();
  for (std::size_t i = 0; i < errors.size(); ++i) {
    list.push_back({{name, value_of(i)}, {"max", errors[i].error}, {"bound", errors[i].bound}});
  }
  return list;
}

Json json_of(const SteppingRow& row, const std::vector<SteppingTimes>& times) {
  const SteppingStatistics& s = row.statistics;
  return {{"value", row.variant.value},
          {"rule", row.variant.rule},
          {"unit", name_of(row.variant.drawn)},
          {"ends", row.variant.range},
          {"spans", s.spans},
          {"pixels", s.pixels},
          {"max", s.all.error},
          {"bound", s.all.bound},
          {"part_of_bound", s.part_of_bound},
          {"beyond", s.beyond},
          {"last", {{"max", s.last.error}, {"bound", s.last.bound}}},
          {"along", list_of("pixel", SteppingStatistics::pixel_at, s.along)},
          {"last_of", list_of("pixels", SteppingStatistics::length, s.last_of)},
          {"wrong", share_of(s.wrong, s.drawn)},
          {"most_off", s.max_error},
          {"bands",
           {{"exact", s.bands.exact},
            {"drawn", s.bands.drawn},
            {"wrong", s.bands.wrong},
            {"widest", s.bands.widest}}},
          {"missed", share_of(s.missed, s.wanted)},
          {"ns", nanoseconds_per_pixel(row.variant.value, row.variant.rule, times)}};
}

}  // namespace

static void to_json(Json& json, const SetupClocks& s) {
  json = {{"cpu", x86model::name_of(s.cpu)}, {"divide", s.divide}, {"multiply", s.multiply}};
}

static void to_json(Json& json, const SteppingTimes& t) {
  json = {{"what", t.what}, {"of", t.of}, {"ns", t.times}};
}

static void to_json(Json& json, const PixelCost& p) {
  Json of_span = Json::array();
  for (std::size_t i = 0; i < costed_lengths.size(); ++i) {
    const Bounds& clocks = p.of_span.at(i);
    of_span.push_back({{"pixels", costed_lengths.at(i)}, {"min", clocks.min}, {"max", clocks.max}});
  }
  json = {{"loop", p.loop},
          {"cpu", x86model::name_of(p.cpu)},
          {"values", p.values},
          {"pixel", p.pixel},
          {"of_span", std::move(of_span)}};
}

const char* name_of(Drawn drawn) {
  static constexpr std::array names{"level", "depth", "texel"};
  return names.at(static_cast<std::size_t>(drawn));
}

std::optional<SteppingResult> measure_stepping(const MeasureRequest& request,
                                               MeasureProgress& progress) {
  const std::vector<SteppingVariant> variants = stepping_variants();
  SteppingResult result;
  result.seed = request.seed;
  result.spans = request.cases.value_or(default_spans);
  result.rounds = request.rounds;
  progress.begin(variants.size() + 1, "parts");
  result.rows = measure_stepping_rows(variants, request.seed, result.spans, progress.stop(),
                                      [&](std::uint64_t done) { progress.show(done); });
  if (result.rows.empty()) return std::nullopt;
  result.setups = measure_setup_clocks(request.seed);
  result.pixels = measure_pixel_costs(result.setups);
  result.claims = judge_stepping_claims(result.setups);
  result.times = time_stepping(request.seed, request.rounds, progress.stop(), [](std::uint64_t) {});
  if (result.times.empty()) return std::nullopt;
  return result;
}

void to_json(Json& json, const SteppingResult& result) {
  json = {{"made", made_by_json("measure --stepping", result.seed)},
          {"lengths", {{"least", 1}, {"most", xsharp::longest_span}, {"spans", result.spans}}},
          {"stepping", Json::array()},
          {"setups", result.setups},
          {"pixels", result.pixels},
          {"times",
           {{"rounds", result.rounds},
            {"processor", parties::processor_name()},
            {"flags", compiler_flags()},
            {"loops", result.times}}},
          {"claims", result.claims}};
  for (const SteppingRow& row : result.rows) json["stepping"].push_back(json_of(row, result.times));
}

}  // namespace fixproof::measure
