// fixproof profile: what a scene asks of the arithmetic.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

#include "verify/arguments.hpp"
#include "verify/commands/commands.hpp"
#include "verify/file.hpp"
#include "verify/frame_progress.hpp"
#include "verify/hex.hpp"
#include "verify/interrupt.hpp"
#include "verify/profile/profile_text.hpp"
#include "verify/scenes/canvas.hpp"
#include "verify/scenes/outputs.hpp"
#include "verify/scenes/players.hpp"
#include "verify/scenes/scene_options.hpp"
#include "verify/scenes/surface_options.hpp"
#include "verify/text.hpp"

namespace fixproof {

namespace {

struct ProfileOptions {
  SceneOptions scene;
  SurfaceOptions surfaces;
  std::optional<std::uint64_t> frames;
  std::string json;
};

int run_profile(const ProfileOptions& options) {
  xsharp::Scene scene = options.scene.read();
  options.surfaces.apply(scene);
  if (!options.json.empty()) {
    refuse_inputs("--json", options.json, scene.files);
    check_replaceable(options.json);
  }
  const std::uint64_t frames = options.frames.value_or(
      std::max<std::uint64_t>(1, static_cast<std::uint64_t>(10 * scene.frames_per_second)));
  std::unique_ptr<xsharp::Player> player;
  Profiler profiler(scene, scene.arithmetic);
  const auto canvas = canvas_of_surfaces(scene);
  xsharp::Picture picture;
  const Interrupt interrupt;
  FrameProgress progress(frames);
  std::uint64_t done = 0;
  for (; done < frames && !Interrupt::flag(); ++done) {
    OperandLog log;
    {
      const Recording recording(log);
      if (player) {
        player->move();
      } else {
        // Sines of steps are looked up here: they count for the first frame.
        player = make_player(scene, scene.arithmetic);
      }
      player->draw(picture);
      if (canvas) canvas->show(picture);
    }
    profiler.add(log, *player);
    progress.show(done + 1);
  }
  const SceneProfile& profile = profiler.profile();
  std::cout << fmt::format("{}, {}: {} frames\n\n", printable(scene.name),
                           name_of(scene.arithmetic), grouped(done))
            << text_of(profile);
  if (done < frames) {
    std::cout << fmt::format("\nSTOPPED after {} of {} frames{}\n", grouped(done), grouped(frames),
                             options.json.empty() ? "" : "; no JSON is written");
    return interrupted_status;
  }
  if (!options.json.empty()) replace_file(options.json, json_of(profile, scene.name));
  return 0;
}

}  // namespace

void add_profile(CLI::App& app, int& status) {
  auto options = std::make_shared<ProfileOptions>();
  CLI::App* command =
      app.add_subcommand("profile", "record what a scene asks of the arithmetic while it runs");
  options->scene.add_to(*command);
  // Listings alone have instructions to be recorded.
  command->remove_option(command->get_option("--arith"));
  options->scene.by = "model";
  command->get_option("--target")->description("rules of i386 or i8088");
  options->surfaces.add_to(*command);
  command->add_option("--frames", options->frames, "how many; by default ten seconds")
      ->transform(whole_number(1, 100'000'000));
  command->add_option("--json", options->json, "the same as JSON")->check(not_empty());
  command->footer(
      "Runs the scene on the register-level model and reports, routine by routine, how often it "
      "is\n"
      "called, the range of its operands and results, how near they came to overflow, to a divide\n"
      "error and to the near plane, and which instructions the scene never needed.\n\n"
      "Exit status: 0 done, 2 bad usage or a scene that is refused, 130 stopped before the end.\n\n"
      "Examples:\n"
      "  fixproof profile scenes/twelve_cubes.json\n"
      "  fixproof profile scenes/shaded_ball.json --target i8088 --frames 100 --json ball.json");
  command->callback([options, &status] { status = run_profile(*options); });
}

}  // namespace fixproof
