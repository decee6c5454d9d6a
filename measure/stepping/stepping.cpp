#include "measure/stepping/stepping.hpp"

#include <array>
#include <utility>

#include "measure/host/provenance.hpp"

namespace fixproof::measure {

namespace {

using support::Json;

constexpr std::uint64_t default_spans = 200;

Json to_json(const ErrorAndBound& e) { return {{"max", e.error}, {"bound", e.bound}}; }

/// {name: value, max, bound}
Json to_json(const char* name, std::size_t value, const ErrorAndBound& e) {
  return {{name, value}, {"max", e.error}, {"bound", e.bound}};
}

Json to_json(const SteppingRow& row, const std::vector<SteppingTimes>& times) {
  const auto ns = nanoseconds_a_pixel(row.variant.value, row.variant.rule, times);
  const SteppingStatistics& s = row.statistics;
  Json along = Json::array();
  for (std::size_t i = 0; i < SteppingStatistics::places; ++i) {
    along.push_back(to_json("pixel", SteppingStatistics::pixel_at(i), s.along().at(i)));
  }
  Json last_of = Json::array();
  for (std::size_t i = 0; i < SteppingStatistics::lengths; ++i) {
    last_of.push_back(to_json("pixels", SteppingStatistics::length(i), s.last_of().at(i)));
  }
  return {{"value", row.variant.value},
          {"rule", row.variant.rule},
          {"unit", name_of(row.variant.drawn)},
          {"ends", row.variant.range},
          {"spans", s.spans()},
          {"pixels", s.pixels()},
          {"max", s.all().error},
          {"bound", s.all().bound},
          {"part_of_bound", s.part_of_bound()},
          {"beyond", s.beyond()},
          {"last", to_json(s.last())},
          {"along", std::move(along)},
          {"last_of", std::move(last_of)},
          {"wrong", share_of(s.wrong(), s.drawn())},
          {"most_off", s.max_error()},
          {"bands",
           {{"exact", s.bands().exact},
            {"drawn", s.bands().drawn},
            {"wrong", s.bands().wrong},
            {"widest", s.bands().widest}}},
          {"missed", share_of(s.missed(), s.wanted())},
          {"ns", ns ? Json(*ns) : Json(nullptr)}};
}

Json to_json(const PixelCost& p) {
  Json of_span = Json::array();
  for (std::size_t i = 0; i < costed_lengths.size(); ++i) {
    const Bounds& clocks = p.of_span.at(i);
    of_span.push_back({{"pixels", costed_lengths.at(i)}, {"min", clocks.min}, {"max", clocks.max}});
  }
  return {{"loop", p.loop},
          {"cpu", x86model::name_of(p.cpu)},
          {"values", p.values},
          {"pixel", to_json(p.pixel)},
          {"of_span", std::move(of_span)}};
}

}  // namespace

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

Json to_json(const SteppingResult& result) {
  Json json{{"made", made_by_json(result.seed, "measure --stepping")},
            {"lengths", {{"least", 1}, {"most", xsharp::longest_span}, {"spans", result.spans}}},
            {"stepping", Json::array()},
            {"setups", Json::array()},
            {"pixels", Json::array()},
            {"times",
             {{"rounds", result.rounds},
              {"processor", processor_name()},
              {"flags", compiler_flags()},
              {"loops", Json::array()}}},
            {"claims", Json::array()}};
  for (const SteppingRow& row : result.rows) {
    json["stepping"].push_back(to_json(row, result.times));
  }
  for (const SetupClocks& s : result.setups) {
    json["setups"].push_back({{"cpu", x86model::name_of(s.cpu)},
                              {"divide", to_json(s.divide)},
                              {"multiply", to_json(s.multiply)}});
  }
  for (const PixelCost& p : result.pixels) json["pixels"].push_back(to_json(p));
  for (const SteppingTimes& t : result.times) {
    json["times"]["loops"].push_back({{"what", t.what}, {"of", t.of}, {"ns", to_json(t.times)}});
  }
  for (const Claim& claim : result.claims) json["claims"].push_back(to_json(claim));
  return json;
}

}  // namespace fixproof::measure
