#include "app/cli/render.hpp"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstdint>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/surface_options.hpp"
#include "measure/clocks/frame_clocks.hpp"
#include "measure/player/beside_exact.hpp"
#include "measure/player/canvas.hpp"
#include "measure/player/players.hpp"
#include "measure/player/show.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "xsharp/validate.hpp"

namespace fixproof::cli {

namespace {

struct RenderOptions {
  SceneOptions scene;
  SurfaceOptions surfaces;
  std::uint64_t threads = 1;
  std::string size;
  std::vector<std::uint64_t> switched_spots;
  bool true_color = false;
  player::OutputNames outputs;
  bool show = false;
  ResultFile result;
};

constexpr std::uint64_t max_threads = 256;

void set_size(xsharp::Scene& scene, const std::string& size) {
  const auto refuse = [&size] {
    throw support::UsageError(fmt::format("--size {}: give WIDTHxHEIGHT, from {}x1 to {}x{}", size,
                                          xsharp::narrowest, xsharp::longest_side,
                                          xsharp::longest_side));
  };
  const auto cross = size.find('x');
  if (cross == std::string::npos) refuse();
  const auto side = [&](std::string_view text, std::int32_t least) {
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < least ||
        value > xsharp::longest_side) {
      refuse();
    }
    return value;
  };
  scene.width = side(std::string_view(size).substr(0, cross), xsharp::narrowest);
  scene.height = side(std::string_view(size).substr(cross + 1), 1);
  try {
    xsharp::validate(scene);
  } catch (const xsharp::SceneError& error) {
    throw support::UsageError(fmt::format("--size {}: {}", size, error.what()));
  }
}

/// Toggles spotlights. Their numbers start at 0, as in the text of chapter 54.
void switch_spots(xsharp::Scene& scene, const std::vector<std::uint64_t>& spots) {
  for (const std::uint64_t spot : spots) {
    if (spot >= scene.lights.spots.size()) {
      throw support::UsageError(
          fmt::format("--switch-spot {}: {} has {} spotlights, counted from 0", spot,
                      support::printable(scene.name), scene.lights.spots.size()));
    }
    scene.lights.spots[spot].on = !scene.lights.spots[spot].on;
  }
}

/// Averages the clocks that the listings take per frame, on the 386 and, for 8088 rules, the 8088.
class ClockMeter {
 public:
  ClockMeter(const xsharp::ArithmeticChoice& choice, bool has_loops) : has_loops_(has_loops) {
    if (choice.by != "model") return;
    build_ = player::build_of(choice).value();
    if (build_.target == cases::Target::i8088) totals_.push_back({x86model::Cpu::i8088, {}});
    totals_.push_back({x86model::Cpu::i386, {}});
  }

  /// Selects every tenth frame, because counting takes longer than drawing.
  [[nodiscard]] bool wants(std::uint64_t frame) const {
    return !totals_.empty() && frame % every == 0;
  }

  void count(const player::OperandLog& log) {
    for (auto& [cpu, sum] : totals_) sum += measure::clocks_of(log, build_, cpu);
    ++counted_;
  }

  /// Returns `Listings alone: 123,456 clocks a frame on the 386`, or nothing without a model.
  [[nodiscard]] std::string text() const {
    std::string text;
    if (counted_ == 0) return text;
    for (const auto& [cpu, sum] : totals_) {
      const std::uint64_t least = sum.table.min / counted_;
      const std::uint64_t most = sum.table.max / counted_;
      text += text.empty() ? "Listings alone: " : ", ";
      text += least == most
                  ? support::grouped(least)
                  : fmt::format("{} to {}", support::grouped(least), support::grouped(most));
      text += fmt::format(" clocks a frame on the {}", x86model::name_of(cpu));
      if (cpu == x86model::Cpu::i8088) {
        text += fmt::format(" by its table and {} by its bus",
                            support::grouped(sum.bus.clocks() / counted_));
      }
    }
    return text.empty() ? text
                        : fmt::format("{} (mean of {} frame{}{})\n", text,
                                      support::grouped(counted_), counted_ == 1 ? "" : "s",
                                      has_loops_ ? "; routines, without the inner loops" : "");
  }

 private:
  static constexpr std::uint64_t every = 10;

  cases::Build build_{};
  bool has_loops_;
  std::vector<std::pair<x86model::Cpu, measure::FrameClocks>> totals_;
  std::uint64_t counted_ = 0;
};

support::Json json_of(const xsharp::Scene& scene, const DrawnFrames& drawn, bool complete) {
  return {{"scene", support::printable(scene.name)},
          {"arithmetic", player::name_of(scene.arithmetic)},
          {"complete", complete},
          {"frames", drawn.frames},
          {"polygons", drawn.count.polygons},
          {"pixels", drawn.count.pixels},
          {"faults", drawn.tally.faults},
          {"out_of_reach", drawn.tally.out_of_reach},
          {"seconds", drawn.seconds}};
}

int render(RenderOptions& options) {
  xsharp::Scene scene = options.scene.read();
  options.surfaces.apply(scene);
  if (!options.size.empty()) set_size(scene, options.size);
  switch_spots(scene, options.switched_spots);
  const std::size_t threads = options.threads;
  if (options.show) return player::show_scene(scene, options.true_color, threads);

  const std::uint64_t frames = options.scene.frame_count(scene);
  const player::OutputNames& files = options.outputs;
  std::vector<std::string> others = scene.files;
  others.insert(others.end(), {files.animation, files.dump, files.digests, files.beside});
  options.result.open(others, "the scene or of another option");
  if (files.folder.empty() && files.animation.empty() && files.dump.empty() &&
      files.digests.empty() && files.beside.empty()) {
    std::cout << "No picture is written or shown; add --animate FILE.png, --out FOLDER or --show\n"
              << std::flush;
  }
  DrawnFrames drawn;
  {
    const support::Interrupt interrupt;
    drawn = draw_frames(scene, frames, {options.outputs, options.true_color, threads});
  }
  std::cout << fmt::format(
      "{}, {}: {} frames, {} polygons, {} pixels, {} faults, {} frames a second\n",
      support::printable(scene.name), player::name_of(scene.arithmetic),
      support::grouped(drawn.frames),
      support::grouped(static_cast<std::uint64_t>(drawn.count.polygons)),
      support::grouped(static_cast<std::uint64_t>(drawn.count.pixels)),
      support::grouped(drawn.tally.faults),
      support::grouped(drawn.frames == 0 ? 0
                                         : static_cast<std::uint64_t>(
                                               static_cast<double>(drawn.frames) / drawn.seconds)));
  std::cout << drawn.clocks;
  if (!drawn.differences.empty()) std::cout << "Beside exact: " << drawn.differences << '\n';
  if (drawn.tally.out_of_reach > 0) {
    std::cout << fmt::format("Objects too far away for 16.16: left out {} times\n",
                             support::grouped(drawn.tally.out_of_reach));
  }
  if (!drawn.older_frame.empty()) {
    std::cout << fmt::format("{} and the frames after it are from an earlier run\n",
                             support::printable(drawn.older_frame));
  }
  const bool complete = drawn.frames == frames;
  if (!complete) {
    std::cout << fmt::format("STOPPED after {} of {} frames; the written files are complete\n",
                             support::grouped(drawn.frames), support::grouped(frames));
  }
  return options.result.write(complete ? 0 : support::interrupted_status,
                              [&] { return json_of(scene, drawn, complete); });
}

}  // namespace

DrawnFrames draw_frames(const xsharp::Scene& scene, std::uint64_t frames,
                        const DrawOptions& options) {
  const auto player = player::make_player(scene, scene.arithmetic, options.threads);
  const auto canvas = player::make_canvas(scene, options.true_color);
  player::Outputs outputs(options.outputs, scene.files, scene.frames_per_second);
  std::optional<player::BesideExact> beside;
  if (!options.outputs.beside.empty()) beside.emplace(scene, options.outputs.beside);

  DrawnFrames drawn;
  xsharp::Picture picture;
  std::chrono::duration<double> drawing{};
  support::FrameProgress progress(frames);
  ClockMeter meter(scene.arithmetic, xsharp::interpolates(scene));
  player::OperandLog log;
  for (; drawn.frames < frames && !support::Interrupt::flag(); ++drawn.frames) {
    const auto begin = std::chrono::steady_clock::now();
    try {
      std::optional<player::Recording> recording;
      if (meter.wants(drawn.frames)) recording.emplace(log);
      if (drawn.frames > 0) player->move();
      drawn.tally = drawn.tally + player->draw(picture);
      canvas->show(picture);
    } catch (const std::exception& error) {
      throw std::runtime_error(
          fmt::format("{}, frame {}: {}", scene.name, drawn.frames, error.what()));
    }
    drawing += std::chrono::steady_clock::now() - begin;
    if (meter.wants(drawn.frames)) meter.count(std::exchange(log, {}));
    outputs.add(*canvas, *player, drawn.frames);
    if (beside) beside->show(picture);
    progress.show(drawn.frames + 1);
  }
  outputs.finish(drawn.frames);
  if (beside) {
    beside->finish();
    drawn.differences = beside->differences();
  }
  drawn.count = canvas->count();
  drawn.seconds = drawing.count();
  drawn.clocks = meter.text();
  drawn.older_frame = outputs.older_frame(drawn.frames);
  return drawn;
}

void add_render(CLI::App& app, int& status) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "draw a scene to images or a window");
  options->scene.add_to(*command);
  options->surfaces.add_to(*command);
  command
      ->add_option(
          "--threads", options->threads,
          "most threads to use; small scenes use fewer, one for each 40,000 vertices; the number "
          "changes no picture; the model takes 1")
      ->transform(whole_number(1, max_threads))
      ->capture_default_str();
  command->add_option("--size", options->size, "size of the picture, as in 640x480")
      ->check(not_empty());
  command
      ->add_option("--switch-spot", options->switched_spots,
                   "turn this spotlight on if the scene has it off, else off; counted from 0")
      ->allow_extra_args(false)
      ->transform(whole_number(0, xsharp::max_spots - 1));
  CLI::Option* true_color = command->add_flag("--true-color", options->true_color,
                                              "draw 24 bits per pixel instead of the palette");
  command->add_option("--out", options->outputs.folder, "write a PNG of every frame to this folder")
      ->check(not_empty());
  command
      ->add_option("--animate", options->outputs.animation,
                   "write an animated PNG, which browsers play")
      ->check(picture_file(".png"));
  command
      ->add_option("--dump", options->outputs.dump,
                   "write transforms, vertices and faces as lines of JSON")
      ->transform(output_file());
  command
      ->add_option("--digests", options->outputs.digests,
                   "write a line for every picture that differs from the one before: the first 16 "
                   "hex digits of the SHA-256 of its palette indices, row by row")
      ->transform(output_file())
      ->excludes(true_color);
  command
      ->add_option("--beside", options->outputs.beside,
                   "write a PNG of the last frame: as stepped, exact, and where they differ")
      ->check(picture_file(".png"));
  options->result.add_to(*command);
  CLI::Option* show =
      command->add_flag("--show", options->show, "draw in a window until it is closed");
  for (const char* written :
       {"--frames", "--out", "--animate", "--dump", "--digests", "--beside", "--json"}) {
    show->excludes(command->get_option(written));
  }
  command->footer(
      R"(Keys in the window: space pauses, s or the right arrow steps one frame, 1 or a switches the
ambient light, 2, 3 and 4 switch the spotlights, r switches the rounding, q or Escape quits.

--dump -, --digests - and --json - write to standard output.

Exit status: 0 all frames are drawn, 2 bad usage or an invalid scene, 130 interrupted.

Examples:
  fixproof render xsharp/scenes/twelve_cubes.json --animate cubes.png
  fixproof render xsharp/scenes/shaded_ball.json --frames 60 --out frames --true-color
  fixproof render xsharp/scenes/twelve_cubes.json --arith model --target i8088 --dump cubes.jsonl
  fixproof render xsharp/scenes/chapter53.json --frames 62 --digests pictures.txt
  fixproof render xsharp/scenes/textured.json --texture-every never --frames 40 --beside t.png)");
  command->callback([options, &status] { status = render(*options); });
}

}  // namespace fixproof::cli
