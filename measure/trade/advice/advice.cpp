#include "measure/trade/advice/advice.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "measure/host/provenance.hpp"
#include "verify/parties/machines.hpp"

namespace fixproof::trade {

namespace {

/// The first of `places` and all others that cost the same.
std::vector<std::size_t> choices_of_equal_cost(std::span<const Tried> tried,
                                               const std::vector<std::size_t>& places) {
  std::vector<std::size_t> same;
  for (const std::size_t i : places) {
    if (has_equal_cost(tried[places.front()].cost, tried[i].cost)) same.push_back(i);
  }
  return same;
}

/// The place with the smallest error; ties go to the cheaper one.
std::size_t nearest_of(std::span<const Tried> tried, const std::vector<std::size_t>& places) {
  return *std::ranges::min_element(places, {},
                                   [&](std::size_t i) { return tried[i].error.pixels; });
}

}  // namespace

bool has_equal_cost(const Cost& a, const Cost& b) {
  return std::abs(a.ranked - b.ranked) <= std::min(a.spread, b.spread);
}

void sort_by_cost(std::vector<Tried>& tried) {
  std::ranges::stable_sort(tried, [](const Tried& a, const Tried& b) {
    const double difference = a.cost.ranked - b.cost.ranked;
    return difference < 0 || (difference == 0 && a.error.pixels < b.error.pixels);
  });
}

Advice advise(std::span<const Tried> tried, double budget) {
  Advice advice;
  std::vector<std::size_t> fit;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (tried[i].error.pixels < tried[advice.nearest].error.pixels) advice.nearest = i;
    if (tried[i].error.pixels <= budget) fit.push_back(i);
  }
  if (fit.empty()) return advice;
  const auto equal_cost = choices_of_equal_cost(tried, fit);
  advice.equal_cost_count = equal_cost.size() - 1;
  advice.take = nearest_of(tried, equal_cost);
  std::erase(fit, *advice.take);
  if (!fit.empty()) advice.runner_up = nearest_of(tried, choices_of_equal_cost(tried, fit));
  const Cost& taken = tried[*advice.take].cost;
  for (std::size_t i = 0; i < *advice.take; ++i) {
    const bool fits = tried[i].error.pixels <= budget;
    if (!fits && !has_equal_cost(tried[i].cost, taken)) advice.next_cheaper = i;
  }
  return advice;
}

void to_json(support::Json& json, const AdviceReport& report) {
  using support::Json;
  Json variants = Json::array();
  for (const auto& [choice, cost, error] : report.tried) {
    variants.push_back({{"name", name_of(choice)},
                        {"target", cases::name_of(choice.build.target)},
                        {"mul_round", choice.build.mul_round},
                        {"div_round", choice.build.div_round},
                        {"from_scratch", choice.turning.from_scratch},
                        {"restore_every", choice.turning.restore_every},
                        {"cost_least", cost.least},
                        {"cost_most", cost.most},
                        {"cost_ranked", cost.ranked},
                        {"cost_spread", cost.spread},
                        {"cost_bus", cost.bus},
                        {"worst_pixels", error.pixels},
                        {"worst_frame", error.frame},
                        {"worst_object", error.object},
                        {"first_frame_over", error.over},
                        {"within_budget", error.pixels <= report.budget}});
  }
  Json made = measure::made_by_json("advise");
  made["processor"] = report.cpu ? Json() : Json(parties::processor_name());
  const Advice advice = advise(report.tried, report.budget);
  json = {{"made", std::move(made)},
          {"scene", report.scene},
          {"frames", report.frames},
          {"frames_per_second", advised_rate},
          {"budget_pixels", report.budget},
          {"cpu", report.cpu ? Json(x86model::name_of(*report.cpu)) : Json()},
          {"repaired", report.repaired},
          {"cost_unit", cost_unit(report)},
          {"variants", std::move(variants)},
          {"take", advice.take},
          {"runner_up", advice.runner_up},
          {"next_cheaper", advice.next_cheaper},
          {"drift_pixels", report.drift_pixels}};
}

}  // namespace fixproof::trade
