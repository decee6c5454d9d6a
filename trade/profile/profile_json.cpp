
#include "measure/host/provenance.hpp"
#include "trade/profile/places.hpp"
#include "trade/profile/profile.hpp"
#include "x86model/text.hpp"

namespace fixproof::trade {

namespace {

using support::Json;

Json to_json(std::string_view name, const ValueRange& range) {
  Json json;
  json["name"] = name;
  if (range.empty()) return json;
  json["least"] = range.least();
  json["greatest"] = range.greatest();
  json["bits"] = range.bits();
  return json;
}

Json to_json(std::span<const std::string_view> names, const std::vector<ValueRange>& ranges) {
  Json json = Json::array();
  for (std::size_t i = 0; i < names.size(); ++i) json.push_back(to_json(names[i], ranges[i]));
  return json;
}

Json to_json(const RoutineProfile& routine) {
  const cases::Operation operation = routine.variant.operation;
  Json json;
  json["operation"] = cases::name_of(operation);
  json["calls"] = routine.calls;
  json["least_in_frame"] = routine.least_in_frame;
  json["most_in_frame"] = routine.max_in_frame;
  json["faults"] = routine.faults;
  json["wrapped"] = routine.wrapped;
  json["instructions_executed"] = routine.instructions;
  json["operands"] = to_json(operand_names(operation), routine.operands);
  json["results"] = to_json(result_names(operation), routine.results);
  json["never_executed"] = Json::array();
  for (std::size_t at = 0; at < routine.program.size; ++at) {
    if (routine.executed[at]) continue;
    json["never_executed"].push_back(
        {{"position", at}, {"instruction", x86model::text_of(routine.program.code.at(at))}});
  }
  return json;
}

template <class Number>
Json number(const std::optional<Number>& value) {
  return value ? Json(*value) : Json();
}

}  // namespace

Json to_json(const SceneProfile& profile, const std::string& scene) {
  Json json;
  json["made"] = measure::made_by_json("profile");
  json["scene"] = scene;
  json["target"] = profile.arithmetic.target;
  json["mul_round"] = profile.arithmetic.mul_round;
  json["div_round"] = profile.arithmetic.div_round;
  json["repaired"] = profile.arithmetic.repaired;
  json["frames"] = profile.frames;
  json["unit"] = "2^-16; angles: tenths of a degree";
  json["routines"] = Json::array();
  for (const RoutineProfile& r : profile.routines) json["routines"].push_back(to_json(r));
  json["least_divisor"] = number(profile.divides.least_divisor);
  json["greatest_quotient"] = number(profile.divides.greatest_quotient);
  json["nearest_view_z"] = number(profile.view.nearest);
  json["faces"] = profile.view.faces;
  json["clipped_faces"] = profile.view.clipped_faces;
  json["out_of_reach"] = profile.view.out_of_reach;
  const FormUse forms = forms_of(profile);
  json["forms_executed"] = forms.executed;
  json["forms_never_executed"] = forms.never;
  return json;
}

}  // namespace fixproof::trade
