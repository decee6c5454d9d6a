#include <fmt/format.h>

#include <cstdint>
#include <iostream>
#include <memory>
#include <utility>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/profile_text.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/surface_options.hpp"
#include "measure/player/canvas.hpp"
#include "measure/player/players.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"

namespace fixproof::cli {

namespace {

struct ProfileOptions {
  SceneOptions scene;
  SurfaceOptions surfaces;
  ResultFile result;
};

int run_profile(ProfileOptions& options) {
  xsharp::Scene scene = options.scene.read();
  options.surfaces.apply(scene);
  options.result.open(scene.files, "the scene");
  const std::uint64_t frames = options.scene.frame_count(scene);
  std::unique_ptr<xsharp::Player> player;
  trade::Profiler profiler(scene, scene.arithmetic);
  const auto canvas = player::canvas_of_surfaces(scene);
  xsharp::Picture picture;
  const support::Interrupt interrupt;
  support::FrameProgress progress(frames);
  std::uint64_t done = 0;
  for (; done < frames && !support::Interrupt::flag(); ++done) {
    player::OperandLog log;
    {
      const player::Recording recording(log);
      if (player) {
        player->move();
      } else {
        // make_player() looks up the sines of the steps. They count towards the first frame.
        player = player::make_player(scene, scene.arithmetic);
      }
      player->draw(picture);
      if (canvas) canvas->show(picture);
    }
    profiler.add(log, *player);
    progress.show(done + 1);
  }
  const trade::SceneProfile& profile = profiler.profile();
  std::cout << fmt::format("{}, {}: {} frames\n\n", support::printable(scene.name),
                           player::name_of(scene.arithmetic), support::grouped(done))
            << text_of(profile);
  if (done < frames) {
    std::cout << fmt::format("\nSTOPPED after {} of {} frames{}\n", support::grouped(done),
                             support::grouped(frames), options.result.loss_text());
    return support::interrupted_status;
  }
  return options.result.write(0, [&] { return support::Json(profile); });
}

}  // namespace

void add_profile(CLI::App& app, int& status) {
  auto options = std::make_shared<ProfileOptions>();
  CLI::App* command = app.add_subcommand(
      "profile", "record the calls, ranges and margins of the arithmetic in a scene");
  options->scene.add_to(*command);
  // The profile records instructions, which only the listings have.
  command->remove_option(command->get_option("--arith"));
  options->scene.by = "model";
  command->remove_option(command->get_option("--target"));
  command->add_option("--target", options->scene.target, "rules of i386 or i8088")
      ->check(one_of({"i386", "i8088"}));
  options->surfaces.add_to(*command);
  options->result.add_to(*command);
  command->footer(
      R"(Runs the scene on the register-level model. For each routine it reports the number of calls, the
ranges of operands and results, their distance from overflow, a divide error and the near plane,
and the instructions that the scene never executes.

Exit status: 0 done, 2 bad usage or an invalid scene, 130 interrupted.

Examples:
  fixproof profile xsharp/scenes/twelve_cubes.json
  fixproof profile xsharp/scenes/shaded_ball.json --target i8088 --frames 100 --json ball.json)");
  command->callback([options, &status] { status = run_profile(*options); });
}

}  // namespace fixproof::cli
