#include "trade/drift/drift_json.hpp"

#include <optional>

#include "measure/host/provenance.hpp"
#include "support/json.hpp"

namespace fixproof::trade {

namespace {

using support::Json;

Json frame_or_null(const std::optional<std::uint64_t>& frame) {
  return frame ? Json(*frame) : Json();
}

Json json_of(const DriftCase& c, const DriftResult& r) {
  Json length = Json::array();
  Json pixels = Json::array();
  for (const Distortion& d : r.series) {
    length.push_back(d.length);
    pixels.push_back(d.pixels);
  }
  return {
      {"name", name_of(c)},
      {"multiply", multiply_name(c.build)},
      {"without", name_of(c.without)},
      {"restore_every", c.restore_every},
      {"restore_rows", xsharp::restored_rows_words.at(static_cast<std::size_t>(c.restore_rows))},
      {"from_scratch", c.from_scratch},
      {"worst",
       {{"skew", r.worst.skew},
        {"length", r.worst.length},
        {"volume", r.worst.volume},
        {"pixels", r.worst.pixels}}},
      {"first",
       {{"pixel", frame_or_null(r.pixel)},
        {"some", frame_or_null(r.some)},
        {"much", frame_or_null(r.much)}}},
      {"series", {{"length", std::move(length)}, {"pixels", std::move(pixels)}}}};
}

}  // namespace

Json drift_json(const std::string& scene, std::uint64_t frames, std::uint64_t rate,
                const std::vector<DriftCase>& cases, const std::vector<DriftResult>& results) {
  Json json{
      {"made", measure::made_by_json("drift")},
      {"scene", scene},
      {"frames", frames},
      {"frames_a_second", rate},
      {"frames_a_point", frames_a_point(frames)},
      {"thresholds",
       {{"pixels", Thresholds::pixels}, {"some", Thresholds::some}, {"much", Thresholds::much}}},
      {"cases", Json::array()}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    json["cases"].push_back(json_of(cases[i], results[i]));
  }
  return json;
}

}  // namespace fixproof::trade
