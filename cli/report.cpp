// fixproof report: everything measured, on one page.
#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/report/make_report.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

/// The scenes of the tree, where the command runs in its root.
std::vector<std::string> scenes_here() {
  std::vector<std::string> scenes;
  for (const char* name :
       {"scenes/twelve_cubes.json", "scenes/ball_and_cubes.json", "scenes/shaded_ball.json",
        "scenes/intersecting.json", "scenes/textured.json", "scenes/phong.json"}) {
    if (std::filesystem::is_regular_file(name)) scenes.emplace_back(name);
  }
  return scenes;
}

}  // namespace

void add_report(CLI::App& app, int& status) {
  auto options = std::make_shared<ReportRequest>();
  options->folder = "out";
  CLI::App* command =
      app.add_subcommand("report", "measure everything and show it on a page for a browser");
  command
      ->add_option("scene", options->scenes,
                   "scenes to measure with, the first of them for the drift; by default those of "
                   "the folder scenes, where the command runs beside it")
      ->check(not_empty());
  command->add_option("--out", options->folder, "the folder for report.html and its data")
      ->check(not_empty())
      ->capture_default_str();
  command->add_option("--seed", options->seed, "of the random operands")
      ->transform(whole_number(0, ~std::uint64_t{0}))
      ->capture_default_str();
  command->add_flag("--quick", options->quick, "a little of everything, in seconds, to try it");
  command->add_flag(
      "--resume", options->resume,
      "keep what an earlier run of the same program has measured of the same scenes on "
      "the same processor");
  command->footer(
      R"(Runs verify, measure, drift and render, and stores their output in the folder `data` in DIR, with
the figures as JSON and CSV. The page is self-contained.

Exit status: 0 done, 1 parties differ (the page shows where), 2 bad usage, an invalid scene or a
failed step, 130 interrupted.

Examples:
  fixproof report
  fixproof report scenes/shaded_ball.json --out ball --quick)");
  command->callback([options, &status] {
    if (options->scenes.empty()) options->scenes = scenes_here();
    if (options->scenes.empty()) {
      throw support::UsageError(
          "report: name a scene; there is no folder scenes here to take them from");
    }
    status = make_report(*options);
  });
}

}  // namespace fixproof::cli
