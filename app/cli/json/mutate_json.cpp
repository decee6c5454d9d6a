#include "app/cli/json/mutate_json.hpp"

namespace fixproof::cli {

namespace {

using support::Json;

Json score_json(const MutantScore& score) {
  return {{"mutants", score.mutants},
          {"killed", score.killed},
          {"equivalent", score.equivalent},
          {"gaps", score.gaps},
          {"slowest_kill", score.slowest}};
}

}  // namespace

Json mutate_json(const MutationReport& report) {
  Json json;
  json["solver"] = report.solver.version;
  json["timeout"] = report.solver.seconds;
  json["seed"] = report.seed;
  json["complete"] = report.left == 0;
  json["unanswered"] = report.left;
  json["seconds"] = report.seconds;
  json.update(score_json(report.all));
  json["programs"] = Json::array();
  for (const MutantScore& score : report.programs) {
    Json program{{"name", score.name}};
    program.update(score_json(score));
    json["programs"] += program;
  }
  json["examples"] = Json::array();
  for (const NotableMutant& mutant : report.notable) {
    json["examples"] += Json{{"program", mutant.program},
                             {"mutant", mutant.number},
                             {"change", mutant.change},
                             {"fate", mutant.fate}};
  }
  return json;
}

}  // namespace fixproof::cli
