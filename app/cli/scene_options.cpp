#include "app/cli/scene_options.hpp"

#include <algorithm>
#include <limits>

#include "app/cli/arguments.hpp"
#include "app/cli/options.hpp"
#include "measure/player/players.hpp"
#include "support/usage_error.hpp"
#include "xsharp/files/scene_json.hpp"

namespace fixproof::cli {

void require_objects(const xsharp::Scene& scene) {
  if (!scene.objects.empty()) return;
  throw support::UsageError(scene.name + " has no objects: add one to \"objects\"");
}

void SceneOptions::add_to(CLI::App& command) {
  command.add_option("scene", file, "scene file, such as xsharp/scenes/twelve_cubes.json")
      ->required()
      ->check(not_empty());
  command.add_option("--frames", frames, "number of frames; by default ten seconds")
      ->transform(whole_number(1, 100'000'000));
  command.add_option("--arith", by, "arithmetic: type, model or double")
      ->check(one_of({"type", "model", "double"}));
  command
      .add_option("--target", target,
                  "rules of i386 or i8088; the type also has standard, saturating and trapping")
      ->check(one_of({"i386", "i8088", "standard", "saturating", "trapping"}));
  add_rounding_options(command, mul_round, div_round);
  command.add_flag(
      "--repaired", repaired,
      "use the repaired 8088 ConcatXforms, which keeps a carry that the printed one loses; see "
      "docs/findings.md, 18");
  command
      .add_option(
          "--reortho", restore_every,
          "rotations of an object between two restorations of orthogonality; 0: never restore")
      ->transform(whole_number(0, std::numeric_limits<std::int32_t>::max()));
  command
      .add_option("--reortho-rows", restore_rows,
                  "rows that --reortho restores: all, or one, as the cross product of the others")
      ->check(one_of({"all", "one"}));
  command.add_flag("--from-scratch", from_scratch,
                   "compute every orientation from scratch instead of appending rotations");
}

std::uint64_t SceneOptions::frame_count(const xsharp::Scene& scene) const {
  return frames.value_or(
      std::max<std::uint64_t>(1, static_cast<std::uint64_t>(10 * scene.frames_per_second)));
}

xsharp::Scene SceneOptions::read() const { return applied_to(xsharp::read_scene(file)); }

// One line for each option.  NOLINTNEXTLINE(readability-function-cognitive-complexity)
xsharp::Scene SceneOptions::applied_to(xsharp::Scene scene) const {
  xsharp::ArithmeticChoice& choice = scene.arithmetic;
  if (by) choice.by = *by;
  // The model has only the rules of the listings.
  if (by == "model" && !target && !xsharp::is_listing(choice))
    choice = {"model", "i386", true, true};
  if (choice.by == "double" && (target || mul_round || div_round)) {
    throw support::UsageError(
        "--arith double has no --target and no roundings; leave these options out");
  }
  if (target) choice.target = *target;
  if (choice.by != "double" && !xsharp::is_listing(choice)) {
    if (mul_round || div_round) {
      throw support::UsageError("--target " + choice.target +
                                " always rounds; leave out the rounding options");
    }
    choice.mul_round = choice.div_round = true;
  }
  if (!xsharp::can_be_repaired(choice)) choice.repaired = false;
  if (repaired) {
    if (!xsharp::can_be_repaired(choice)) {
      throw support::UsageError(
          "--repaired is for --target i8088: only its ConcatXforms loses a carry");
    }
    choice.repaired = true;
  }
  if (mul_round) choice.mul_round = *mul_round;
  if (div_round) choice.div_round = *div_round;
  if (restore_every) scene.restore_every = *restore_every;
  if (restore_rows) {
    scene.restore_rows =
        *restore_rows == "one" ? xsharp::RestoredRows::one : xsharp::RestoredRows::all;
  }
  if (from_scratch) scene.from_scratch = true;
  if (from_scratch && !restore_every) scene.restore_every = 0;
  if (restore_every && !from_scratch) scene.from_scratch = false;
  if (scene.from_scratch && scene.restore_every > 0) {
    throw support::UsageError(
        "--from-scratch leaves --reortho nothing to restore; give --reortho 0 or leave one out");
  }
  if (restore_rows && scene.restore_every == 0) {
    throw support::UsageError("--reortho-rows has no effect without restoring; add --reortho N");
  }
  return scene;
}

}  // namespace fixproof::cli
