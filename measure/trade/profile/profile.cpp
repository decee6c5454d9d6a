#include "measure/trade/profile/profile.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "measure/clocks/replay.hpp"
#include "measure/player/players.hpp"
#include "measure/trade/profile/places.hpp"
#include "measure/trade/profile/wraps.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/interpreter.hpp"
#include "x86model/forms.hpp"

namespace fixproof::trade {

namespace {

std::int64_t value_in(cases::Operation operation, std::uint32_t word) {
  if (operation == cases::Operation::cossin) return static_cast<std::int16_t>(word);
  return static_cast<std::int32_t>(word);
}

/// Runs the calls of a frame again.
void add_calls(RoutineProfile& profile, std::span<const std::uint32_t> words) {
  const cases::Operation operation = profile.variant.operation;
  const auto add = [&](const measure::ReplayedCall& call) {
    profile.instructions += call.ending.steps;
    for (std::size_t i = 0; i < call.in.size(); ++i) {
      profile.operands[operand_place(operation, i)].add(value_in(operation, call.in[i]));
    }
    if (call.ending.outcome == x86model::Outcome::divide_error) {
      ++profile.faults;
      return true;
    }
    for (std::size_t i = 0; i < call.out.size(); ++i) {
      profile.results[result_place(operation, i)].add(static_cast<std::int32_t>(call.out[i]));
    }
    if (wraps(profile.variant, call.in)) ++profile.wrapped;
    return true;
  };
  const std::vector<bool> executed = measure::replay_calls(profile.variant, words, {}, add);
  std::transform(executed.begin(), executed.end(), profile.executed.begin(),
                 profile.executed.begin(), std::logical_or());
}

std::int64_t magnitude(std::int64_t value) { return value < 0 ? -value : value; }

void note_divide(DivideProfile& divides, const RoutineProfile& div,
                 std::span<const std::uint32_t> words) {
  for (std::size_t i = 1; i < words.size(); i += 2) {
    const std::int64_t divisor = magnitude(static_cast<std::int32_t>(words[i]));
    divides.least_divisor = std::min(divides.least_divisor.value_or(divisor), divisor);
  }
  const ValueRange& quotients = div.results.front();
  if (quotients.empty()) return;
  divides.greatest_quotient =
      std::max(magnitude(quotients.least()), magnitude(quotients.greatest()));
}

}  // namespace

Profiler::Profiler(const xsharp::Scene& scene, const xsharp::ArithmeticChoice& choice)
    : scene_(scene) {
  if (!xsharp::is_listing(choice)) throw player::no_arithmetic(choice);
  profile_.scene = scene.name;
  profile_.arithmetic = choice;
  const cases::Build build = player::build_of(choice).value();
  for (int i = 0; i < x86model::routine_count; ++i) {
    RoutineProfile routine;
    // Operations begin with the routines.
    routine.variant = cases::variant_of(static_cast<cases::Operation>(i), build);
    routine.program = parties::program_of(routine.variant);
    routine.executed.resize(routine.program.size);
    routine.operands.resize(operand_names(routine.variant.operation).size());
    routine.results.resize(result_names(routine.variant.operation).size());
    profile_.routines.push_back(routine);
  }
}

void Profiler::add(const player::OperandLog& log, const xsharp::Player& player) {
  for (std::size_t i = 0; i < log.size(); ++i) {
    RoutineProfile& routine = profile_.routines.at(i);
    const std::span<const std::uint32_t> all = log.at(i);
    const std::uint64_t calls = all.size() / cases::words_in(routine.variant.operation);
    add_calls(routine, all);
    routine.calls += calls;
    routine.least_in_frame = profile_.frames == 0 ? calls : std::min(routine.least_in_frame, calls);
    routine.max_in_frame = std::max(routine.max_in_frame, calls);
    if (routine.variant.operation == cases::Operation::div) {
      note_divide(profile_.divides, routine, all);
    }
  }
  add_view(player);
  ++profile_.frames;
}

void Profiler::add_view(const xsharp::Player& player) {
  ViewProfile& view = profile_.view;
  for (std::size_t object = 0; object < scene_.objects.size(); ++object) {
    const xsharp::ObjectState state = player.state(object);
    if (state.view.empty()) {
      ++view.out_of_reach;
      continue;
    }
    for (const xsharp::Face& face : scene_.objects[object].mesh.faces) {
      bool clipped = false;
      for (const std::size_t v : face.vertices) {
        if (!state.screen[v]) {
          clipped = true;
        } else {
          view.nearest = std::max(view.nearest.value_or(state.view[v][2]), state.view[v][2]);
        }
      }
      ++view.faces;
      if (clipped) ++view.clipped_faces;
    }
  }
}

FormUse forms_of(const SceneProfile& profile) {
  std::set<std::string> executed;
  for (const RoutineProfile& routine : profile.routines) {
    for (std::size_t at = 0; at < routine.program.size; ++at) {
      if (routine.executed[at]) executed.insert(x86model::form_text(routine.program.code.at(at)));
    }
  }
  FormUse use;
  use.executed = {executed.begin(), executed.end()};
  const auto target = machine_code::model_target(profile.routines.front().variant.build.target);
  for (const std::string& form : x86model::form_texts(target)) {
    if (!executed.contains(form)) use.never.push_back(form);
  }
  return use;
}

}  // namespace fixproof::trade
