#include "measure/host/provenance.hpp"
#include "measure/trade/profile/places.hpp"
#include "measure/trade/profile/profile.hpp"
#include "x86model/text.hpp"

namespace fixproof::trade {

using support::Json;

static void to_json(Json& json, const RoutineProfile& routine) {
  const cases::Operation operation = routine.variant.operation;
  const auto ranges = [](std::span<const std::string_view> names,
                         const std::vector<ValueRange>& values) {
    Json list = Json::array();
    for (std::size_t i = 0; i < names.size(); ++i) {
      Json& range = list.emplace_back(Json{{"name", names[i]}});
      if (values[i].empty()) continue;
      range["least"] = values[i].least();
      range["greatest"] = values[i].greatest();
      range["bits"] = values[i].bits();
    }
    return list;
  };
  Json never = Json::array();
  for (std::size_t at = 0; at < routine.program.size; ++at) {
    if (routine.executed[at]) continue;
    never.push_back(
        {{"position", at}, {"instruction", x86model::text_of(routine.program.code.at(at))}});
  }
  json = {{"operation", cases::name_of(operation)},
          {"calls", routine.calls},
          {"least_in_frame", routine.least_in_frame},
          {"most_in_frame", routine.max_in_frame},
          {"faults", routine.faults},
          {"wrapped", routine.wrapped},
          {"instructions_executed", routine.instructions},
          {"operands", ranges(operand_names(operation), routine.operands)},
          {"results", ranges(result_names(operation), routine.results)},
          {"never_executed", std::move(never)}};
}

void to_json(Json& json, const SceneProfile& profile) {
  const FormUse forms = forms_of(profile);
  json = {{"made", measure::made_by_json("profile")},
          {"scene", profile.scene},
          {"target", profile.arithmetic.target},
          {"mul_round", profile.arithmetic.mul_round},
          {"div_round", profile.arithmetic.div_round},
          {"repaired", profile.arithmetic.repaired},
          {"frames", profile.frames},
          {"unit", "2^-16; angles: tenths of a degree"},
          {"routines", profile.routines},
          {"least_divisor", profile.divides.least_divisor},
          {"greatest_quotient", profile.divides.greatest_quotient},
          {"nearest_view_z", profile.view.nearest},
          {"faces", profile.view.faces},
          {"clipped_faces", profile.view.clipped_faces},
          {"out_of_reach", profile.view.out_of_reach},
          {"forms_executed", forms.executed},
          {"forms_never_executed", forms.never}};
}

}  // namespace fixproof::trade
