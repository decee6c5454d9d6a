#include "app/cli/json/judge_json.hpp"

#include <string_view>

#include "app/cli/json/check_json.hpp"
#include "app/cli/json/proof_json.hpp"
#include "app/cli/judge_text.hpp"
#include "judge/check/verdict_text.hpp"
#include "support/plain_text.hpp"
#include "x86model/text.hpp"

namespace fixproof::cli {

namespace {

using support::Json;

Json defect_json(std::string_view kind, const std::string& operands, const std::string& text) {
  return {{"kind", kind}, {"operands", operands}, {"text", support::printable(text)}};
}

/// The defects that calls of many cases show.
Json call_defects(const judge::Verdict& verdict, const judge::Image& image) {
  Json json = Json::array();
  if (const auto& stuck = verdict.stuck) {
    json += defect_json("broken", stuck->operands, text_of(stuck->ending, image));
  }
  if (const auto& broken = verdict.not_preserved) {
    json += defect_json("breaks convention", broken->operands, broken_text(broken->broken, image));
  }
  if (const auto& unsteady = verdict.unsteady) {
    json += verdict.state ? defect_json("stateful", unsteady->operands,
                                        verdict.state->reads.text + " reads what " +
                                            verdict.state->writes.text + " writes")
                          : defect_json("unsteady", unsteady->operands, "");
  }
  return json;
}

/// The defects that single steps show.
void add_step_defects(Json& json, const judge::Inspection& inspection) {
  const auto add = [&json](std::string_view kind, const auto& finding) {
    if (finding) json += defect_json(kind, finding->operands, finding->line.text);
  };
  add("reads an undefined flag", inspection.undefined_flag);
  add("uses foreign memory", inspection.foreign_memory);
  add("changes its own code", inspection.changes_own_code);
  add("uses a privileged instruction", inspection.privileged);
}

/// Adds the judgement of the results, and the wrong case with the smallest operands.
/// @param judge null if a defect leaves nothing to judge
void add_judgement(Json& json, const check::Judge* judge,
                   const std::optional<check::JudgedCase>& smallest, bool complete) {
  json["judgement"] = nullptr;
  json["smallest"] = nullptr;
  if (judge == nullptr || judge->cases() == 0) return;
  json["judgement"] = check_json(*judge, check::verdict_text(*judge), complete);
  if (smallest) json["smallest"] = answer_json(*smallest, judge->rules());
}

Json spread_json(const judge::Spread& spread) {
  return {{"least", spread.least()},
          {"most", spread.most()},
          {"mean", {{"min", spread.mean_min()}, {"max", spread.mean_max()}}}};
}

Json clocks_json(const judge::RoutineClocks& clocks) {
  Json json{{"calls", clocks.calls}, {"processors", Json::array()}};
  if (clocks.calls == 0) return json;
  json["instructions"] = spread_json(clocks.instructions);
  json["code_bytes"] = spread_json(clocks.code_bytes);
  json["data_bytes"] = spread_json(clocks.data_bytes);
  for (const auto& on : clocks.on) {
    Json one{
        {"cpu", x86model::name_of(on.cpu)}, {"clocks", nullptr}, {"no_figure_for", Json::array()}};
    if (on.without.empty()) one["clocks"] = spread_json(on.clocks);
    for (const judge::Line& line : on.without) one["no_figure_for"] += line.text;
    json["processors"] += one;
  }
  return json;
}

Json routine_proof_json(const judge::RoutineProof& proof, const std::string& solver,
                        const check::Rules& rules) {
  Json json{{"standing", word_of(proof.standing)},
            {"solver", solver},
            {"paths", proof.paths},
            {"seconds", proof.seconds},
            {"why", support::printable(proof.why)},
            {"counterexample", nullptr}};
  if (proof.counterexample) json["counterexample"] = answer_json(*proof.counterexample, rules);
  return json;
}

Json candidates_json(const judge::WholeVerdict& whole) {
  Json json = Json::array();
  for (const judge::Candidate& one : whole.candidates) {
    json += Json{{"name", one.name},
                 {"exceptions", one.exceptions},
                 {"first", one.first_exception ? Json(one.first_exception->operands) : Json()}};
  }
  return json;
}

}  // namespace

Json routine_json(const judge::Subject& subject, const std::string& file,
                  const RoutineFindings& found) {
  const judge::Verdict& verdict = found.verdict();
  const judge::Image& image = subject.image;
  Json json;
  json["subject"] = "routine";
  json["file"] = support::printable(file);
  json["container"] = image.container;
  json["entry"] = image.entry;
  json["code"] = code_text(image);
  json["frame"] = subject.frame.text;
  json["operation"] = cases::name_of(subject.variant.operation);
  json["rules"] = found.rules;
  json["machine"] = machine_name(verdict, image);
  json["complete"] = !verdict.is_stopped && !verdict.stuck;
  json["cases"] = verdict.cases;
  json["seconds"] = verdict.seconds;
  json["divide_errors"] = verdict.divide_errors;
  json["defects"] = call_defects(verdict, image);
  if (found.inspection) add_step_defects(json["defects"], *found.inspection);
  const bool is_judged = verdict.judge && !verdict.stuck && !verdict.state;
  add_judgement(json, is_judged ? &*verdict.judge : nullptr, verdict.smallest, !verdict.is_stopped);
  json["candidates"] = found.of_whole ? candidates_json(*found.of_whole) : Json();
  json["clocks"] = found.clocks ? clocks_json(*found.clocks) : Json();
  json["proof"] =
      found.proof ? routine_proof_json(*found.proof, found.solver, verdict.rules) : Json();
  return json;
}

Json program_json(const std::string& command, const program::Verdict& verdict,
                  const std::string& rules, const std::string& failure) {
  Json json;
  json["subject"] = "program";
  json["program"] = support::printable(command);
  json["operation"] = cases::name_of(verdict.rules.variant.operation);
  json["rules"] = rules;
  json["complete"] = !verdict.is_stopped && !verdict.failure;
  json["cases"] = verdict.judge && !verdict.failure ? verdict.judge->cases() : 0;
  json["seconds"] = verdict.seconds;
  json["processes"] = verdict.processes;
  json["defects"] = Json::array();
  if (verdict.failure) {
    const auto& at = verdict.failure->at;
    json["defects"] +=
        defect_json("broken", at ? check::text_of_operands(*at, verdict.rules) : "", failure);
  }
  if (verdict.unsteady) {
    json["defects"] +=
        defect_json("unsteady", check::text_of_operands(*verdict.unsteady, verdict.rules), "");
  }
  const bool is_judged = verdict.judge && !verdict.failure;
  add_judgement(json, is_judged ? &*verdict.judge : nullptr, verdict.smallest, !verdict.is_stopped);
  return json;
}

Json listings_json(const std::string& file, const std::vector<ListingResult>& listings) {
  Json json;
  json["subject"] = "listings";
  json["file"] = support::printable(file);
  json["listings"] = Json::array();
  for (const ListingResult& listing : listings) {
    json["listings"] += Json{{"name", listing.name},
                             {"confirmed", listing.is_confirmed},
                             {"at", listing.places},
                             {"text", listing.text}};
  }
  return json;
}

}  // namespace fixproof::cli
