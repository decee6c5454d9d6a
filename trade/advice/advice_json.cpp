
#include "measure/host/provenance.hpp"
#include "parties/machines.hpp"
#include "trade/advice/advice.hpp"

namespace fixproof::trade {

namespace {

using support::Json;

Json to_json(const Tried& tried, const AdviceReport& report) {
  const Choice& choice = tried.choice;
  Json json;
  json["name"] = name_of(choice);
  json["target"] = cases::name_of(choice.build.target);
  json["mul_round"] = choice.build.mul_round;
  json["div_round"] = choice.build.div_round;
  json["from_scratch"] = choice.turning.from_scratch;
  json["restore_every"] = choice.turning.restore_every;
  json["cost_least"] = tried.cost.least;
  json["cost_most"] = tried.cost.most;
  json["cost_ranked"] = tried.cost.ranked;
  json["cost_spread"] = tried.cost.spread;
  json["cost_bus"] = tried.cost.bus ? Json(*tried.cost.bus) : Json();
  json["worst_pixels"] = tried.error.pixels;
  json["worst_frame"] = tried.error.frame;
  json["worst_object"] = tried.error.object;
  json["first_frame_over"] = nullptr;
  if (tried.error.over) json["first_frame_over"] = *tried.error.over;
  json["within_budget"] = tried.error.pixels <= report.budget;
  return json;
}

Json place(const std::optional<std::size_t>& index) { return index ? Json(*index) : Json(); }

}  // namespace

Json to_json(const AdviceReport& report) {
  const Advice advice = advise(report.tried, report.budget);
  Json json;
  json["made"] = measure::made_by_json("advise");
  json["made"]["processor"] = report.cpu ? Json() : Json(parties::processor_name());
  json["scene"] = report.scene;
  json["frames"] = report.frames;
  json["frames_per_second"] = advised_rate;
  json["budget_pixels"] = report.budget;
  json["cpu"] = report.cpu ? Json(x86model::name_of(*report.cpu)) : Json();
  json["repaired"] = report.repaired;
  json["cost_unit"] = cost_unit(report);
  json["variants"] = Json::array();
  for (const Tried& tried : report.tried) json["variants"].push_back(to_json(tried, report));
  json["take"] = place(advice.take);
  json["runner_up"] = place(advice.runner_up);
  json["next_cheaper"] = place(advice.next_cheaper);
  json["drift_pixels"] = report.drift_pixels ? Json(*report.drift_pixels) : Json();
  return json;
}

}  // namespace fixproof::trade
