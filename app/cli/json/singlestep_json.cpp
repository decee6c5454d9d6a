#include "app/cli/json/singlestep_json.hpp"

#include <numeric>

#include "support/plain_text.hpp"

namespace fixproof::cli {

namespace {

using support::Json;

Json counts_json(const StepCounts& counts) {
  Json json;
  json["cases"] = counts.run() + counts.all_skipped();
  json["run"] = counts.run();
  json["equal"] = counts.equal;
  json["differing"] = counts.differing;
  json["skipped"] = Json::object();
  for (std::size_t i = 0; i < counts.skipped.size(); ++i) {
    json["skipped"][std::string(name_of(static_cast<singlestep::Skip>(i)))] = counts.skipped[i];
  }
  return json;
}

}  // namespace

std::uint64_t StepCounts::all_skipped() const {
  return std::accumulate(skipped.begin(), skipped.end(), std::uint64_t{0});
}

StepCounts& StepCounts::operator+=(const StepCounts& other) {
  equal += other.equal;
  differing += other.differing;
  for (std::size_t i = 0; i < skipped.size(); ++i) skipped[i] += other.skipped[i];
  return *this;
}

Json singlestep_json(const std::vector<StepFile>& files, const StepCounts& total) {
  Json json = counts_json(total);
  json["files"] = Json::array();
  for (const StepFile& file : files) {
    Json one{{"file", support::printable(file.path)},
             {"error", file.error.empty() ? Json() : Json(support::printable(file.error))}};
    one.update(counts_json(file.counts));
    one["examples"] = Json::array();
    for (const DifferingStep& step : file.shown) {
      one["examples"] += Json{{"case", step.index},
                              {"name", support::printable(step.name)},
                              {"differences", step.differences}};
    }
    json["files"] += one;
  }
  return json;
}

}  // namespace fixproof::cli
