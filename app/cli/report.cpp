#include <filesystem>
#include <memory>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/report/make_report.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

std::vector<std::string> default_scenes() {
  std::vector<std::string> scenes;
  for (const char* name : {"xsharp/scenes/twelve_cubes.json", "xsharp/scenes/ball_and_cubes.json",
                           "xsharp/scenes/shaded_ball.json", "xsharp/scenes/intersecting.json",
                           "xsharp/scenes/textured.json", "xsharp/scenes/phong.json"}) {
    if (std::filesystem::is_regular_file(name)) scenes.emplace_back(name);
  }
  return scenes;
}

}  // namespace

void add_report(CLI::App& app, int& status) {
  auto options = std::make_shared<ReportRequest>();
  options->folder = "out";
  CLI::App* command =
      app.add_subcommand("report", "measure everything and write a page of charts for a browser");
  command
      ->add_option(
          "scene", options->scenes,
          "scene files to measure and draw; drift measures the first; by default six of the "
          "scenes in ./scenes")
      ->check(not_empty());
  command->add_option("--out", options->folder, "folder for report.html and its data")
      ->check(not_empty())
      ->capture_default_str();
  add_seed(*command, options->seed);
  command->add_flag("--quick", options->quick,
                    "make a trial page in seconds, with too few cases to draw conclusions");
  command->footer(
      R"(Does what `verify`, `measure`, `drift` and `render` do. Writes report.html, which needs no
other file and no network, report.json with all figures, and a JSON file or picture for
each step in the subfolder `data`.

Exit status: 0 the page is written, 1 the page is written and shows that parties differ,
2 bad usage, an invalid scene, a timed implementation that breaks its own rounding rule, or a
stepped value that exceeds its derived bound, 130 interrupted.

Examples:
  fixproof report
  fixproof report xsharp/scenes/shaded_ball.json --out ball --quick)");
  command->callback([options, &status] {
    if (options->scenes.empty()) options->scenes = default_scenes();
    if (options->scenes.empty()) {
      throw support::UsageError(
          "report: ./scenes has none of the default scenes; name a scene file");
    }
    status = make_report(*options);
  });
}

}  // namespace fixproof::cli
