#include "app/cli/drift.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/scene_options.hpp"
#include "measure/player/outputs.hpp"
#include "measure/trade/advice/choice.hpp"
#include "measure/trade/drift/strip.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/output_file.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "xsharp/files/scene_json.hpp"

namespace fixproof::cli {

namespace {

struct DriftOptions {
  std::string scene;
  DriftRequest request;
  std::string strip;
  ResultFile result;
};

/// Frame rates, in frames per second, at which the duration is printed.
constexpr std::uint64_t slow = 15;
constexpr std::uint64_t fast = 60;

std::vector<trade::DriftCase> drift_cases(std::int32_t restore_every) {
  std::vector<trade::DriftCase> rows;
  for (const cases::Build& build : cases::uniform_builds) {
    for (const trade::Without without : {trade::Without::nothing, trade::Without::offset,
                                         trade::Without::step, trade::Without::products}) {
      rows.push_back({build, without});
    }
    rows.push_back({build, trade::Without::nothing, restore_every});
    rows.push_back(
        {build, trade::Without::nothing, restore_every, false, xsharp::RestoredRows::one});
  }
  rows.push_back({{}, trade::Without::nothing, 0, true});
  rows.push_back({{}, trade::Without::all});
  return rows;
}

std::string percent(double share) {
  if (share < 5e-7) return "0";
  if (share > 9.99) return "> 999 %";
  return share < 0.01 ? fmt::format("{:.4f} %", 100 * share) : fmt::format("{:.2f} %", 100 * share);
}

std::string pixels(double count) {
  return count > 99'999 ? "> 99,999" : fmt::format("{:.2f}", count);
}

std::string first(const std::optional<std::uint64_t>& frame) {
  return frame ? support::grouped(*frame) : "never";
}

void print(const std::vector<trade::DriftResult>& results) {
  std::cout << fmt::format("{:<34}{:>10}{:>11}{:>11}{:>10}  {:>9}{:>9}{:>9}\n", "", "skew", "edges",
                           "volume", "pixels", "1 pixel", "2 %", "10 %");
  for (const trade::DriftResult& r : results) {
    std::cout << fmt::format("{:<34}{:>10}{:>11}{:>11}{:>10}  {:>9}{:>9}{:>9}\n",
                             trade::name_of(r.of), percent(r.worst.skew), percent(r.worst.length),
                             percent(r.worst.volume), pixels(r.worst.pixels), first(r.pixel),
                             first(r.some), first(r.much));
  }
}

xsharp::Scene unrestored(xsharp::Scene scene) {
  scene.restore_every = 0;
  scene.from_scratch = false;
  return scene;
}

}  // namespace

std::string drift_strip(const xsharp::Scene& scene, const DriftRequest& request) {
  std::vector<trade::StripRow> rows;
  const auto add = [&](std::string name, auto change) {
    rows.push_back({std::move(name), unrestored(scene)});
    change(rows.back().scene);
  };
  for (const bool on : {true, false}) {
    for (const auto target : {cases::Target::i386, cases::Target::i8088}) {
      const cases::Build build{target, on, on};
      add(fmt::format("{}, rounding {}", cases::name_of(target), on ? "on" : "off"),
          [&](xsharp::Scene& s) {
            s = trade::scene_with(s, {build, {}}, "type");
          });
    }
  }
  add(fmt::format("i386 on, restored every {}", request.restore_every), [&](xsharp::Scene& s) {
    s = trade::scene_with(s, {{}, {.restore_every = request.restore_every}}, "type");
  });
  add("i386 on, from scratch", [](xsharp::Scene& s) {
    s = trade::scene_with(s, {{}, {.from_scratch = true}}, "type");
  });
  add("double", [](xsharp::Scene& s) { s.arithmetic = {"double", "", true, true}; });

  std::vector<std::uint64_t> frames;
  std::vector<std::string> labels;
  for (const std::uint64_t minutes : {0U, 1U, 5U, 15U, 30U}) {
    frames.push_back(minutes * 60 * fast);
    labels.push_back(minutes == 0 ? "start" : fmt::format("{} min", minutes));
  }
  return trade::drift_strip(rows, request.object, frames, labels);
}

trade::DriftFigures measure_drift(const xsharp::Scene& scene, const DriftRequest& request) {
  const std::uint64_t frames = request.minutes * 60 * fast;
  trade::DriftFigures figures{scene.name, fast, frames, frames, {}};
  support::FrameProgress progress(frames);
  figures.results = trade::run_drift(unrestored(scene), drift_cases(request.restore_every),
                                     figures.frames, support::Interrupt::flag(),
                                     [&](std::uint64_t done) { progress.show(done); });
  return figures;
}

namespace {

int run(DriftOptions& options) {
  const xsharp::Scene scene = xsharp::read_scene(options.scene);
  require_objects(scene);
  if (options.request.object >= scene.objects.size()) {
    throw support::UsageError(fmt::format("--object {}: {} has objects 0 to {}; choose one of them",
                                          options.request.object, scene.name,
                                          scene.objects.size() - 1));
  }
  const auto strip = player::open_output("--strip", options.strip, scene.files);
  std::vector<std::string> others = scene.files;
  others.push_back(options.strip);
  options.result.open(others, "the scene or of --strip");

  trade::DriftFigures figures;
  {
    const support::Interrupt interrupt;
    figures = measure_drift(scene, options.request);
  }
  const std::uint64_t frames = figures.frames;
  std::cout << fmt::format(
      "{}: {} frames, {} at {} frames a second, {} at {}.\n"
      "Largest errors of any object: skew of its axes, length of its edges, volume, and pixels "
      "between a vertex\nand its exact place. Then the first frame at which a vertex is 1 pixel "
      "off, an edge 2 % and 10 % wrong.\n\n",
      support::printable(scene.name), support::grouped(frames),
      support::duration(static_cast<double>(frames) / static_cast<double>(slow)), slow,
      support::duration(static_cast<double>(frames) / static_cast<double>(fast)), fast);
  print(figures.results);
  if (!figures.complete()) {
    std::cout << fmt::format(
        "\nSTOPPED after {} of {} frames{}\n", support::grouped(frames),
        support::grouped(figures.wanted),
        options.strip.empty() && !options.result.is_wanted() ? "" : "; no file is written");
    return support::interrupted_status;
  }
  options.result.write(0, [&] { return support::Json(figures); });
  if (strip) {
    strip->replace(drift_strip(scene, options.request));
    std::cout << fmt::format("\n{}: {}\n", support::printable(options.strip),
                             support::printable(scene.objects[options.request.object].name));
  }
  return 0;
}

}  // namespace

void add_drift(CLI::App& app, int& status) {
  auto options = std::make_shared<DriftOptions>();
  CLI::App* command =
      app.add_subcommand("drift", "measure how long turning objects keep their shape");
  command
      ->add_option("scene", options->scene, "scene file, such as xsharp/scenes/twelve_cubes.json")
      ->required()
      ->check(not_empty());
  command
      ->add_option(
          "--minutes", options->request.minutes,
          "minutes of animation at 60 frames a second; at 15 frames a second the same frames last "
          "four times as long")
      ->transform(whole_number(1, 10'000))
      ->capture_default_str();
  command
      ->add_option(
          "--reortho", options->request.restore_every,
          "rotations between two restorations of orthogonality, in the rows named `restored`")
      ->transform(whole_number(1, 1'000'000))
      ->capture_default_str();
  auto* strip =
      command
          ->add_option(
              "--strip", options->strip,
              "write an SVG of one object after 0, 1, 5, 15 and 30 minutes in each arithmetic")
          ->check(picture_file(".svg"));
  options->result.add_to(*command);
  command->add_option("--object", options->request.object, "index of the object that --strip draws")
      ->transform(whole_number(0, 1'000'000))
      ->capture_default_str()
      ->needs(strip);
  command->footer(
      R"(Each `without` row removes one source of error: `offset` is the unit by which the published
conversion of constants is off, `step` the rounding of sines and cosines, `products` the rounding
of products. No divide affects the drift. `restored` makes all rows of a matrix orthogonal and of
unit length again; `one row` replaces the last row with the cross product of the others, as in
chapter 52.

Exit status: 0 done, 2 bad usage or an invalid scene, 130 interrupted.

Examples:
  fixproof drift xsharp/scenes/twelve_cubes.json
  fixproof drift xsharp/scenes/twelve_cubes.json --minutes 30 --strip strip.svg --object 11)");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace fixproof::cli
