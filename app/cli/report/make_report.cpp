#include "app/cli/report/make_report.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <system_error>

#include "app/cli/scene_options.hpp"
#include "measure/host/provenance.hpp"
#include "measure/player/outputs.hpp"
#include "support/build_info/build_info.hpp"
#include "support/file.hpp"
#include "support/file_lock.hpp"
#include "support/folder_lock.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "verify/parties/machines.hpp"
#include "xsharp/files/scene_json.hpp"

namespace fixproof::cli {

namespace {

using support::Json;

/// Reads every scene once, so that all steps measure the same scenes even if a file changes.
/// @throws UsageError if two scenes share a name, because the page identifies them by name, or if
///         the first scene has no objects, because the drift step needs one
std::vector<xsharp::Scene> read_scenes(const std::vector<std::string>& files) {
  std::vector<xsharp::Scene> scenes;
  for (const std::string& file : files) {
    scenes.push_back(xsharp::read_scene(file));
    for (std::size_t i = 0; i + 1 < scenes.size(); ++i) {
      if (scenes[i].name != scenes.back().name) continue;
      throw support::UsageError(
          fmt::format("{} and {} are both named {}; change the \"name\" of one of them", files[i],
                      file, scenes[i].name));
    }
  }
  require_objects(scenes.front());
  return scenes;
}

/// Checks before the long measurements that every output file can be written.
/// @throws UsageError if an output file is an input of a scene, std::runtime_error if it cannot be
///         written
void check_outputs(const ReportRequest& request, const std::vector<xsharp::Scene>& scenes,
                   const std::vector<ReportStep>& steps) {
  std::vector<std::string> files{request.folder + "/report.html", request.folder + "/report.json"};
  for (const ReportStep& step : steps) {
    files.insert(files.end(), step.files.begin(), step.files.end());
  }
  std::vector<std::string> inputs;
  for (const xsharp::Scene& scene : scenes) {
    inputs.insert(inputs.end(), scene.files.begin(), scene.files.end());
  }
  for (const std::string& file : files) player::check_output("--out", file, inputs);
}

void make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw support::UsageError(
        fmt::format("--out {}: cannot create this folder: {}", folder, error.message()));
  }
}

Json origin_of(const ReportRequest& request, const std::vector<xsharp::Scene>& scenes) {
  Json names = Json::array();
  for (const xsharp::Scene& scene : scenes) names.push_back(scene.name);
  return {{"version", support::program_version()},
          {"seed", request.seed},
          {"compiler", support::compiler_name()},
          {"processor", parties::processor_name()},
          {"date", measure::date_now()},
          {"quick", request.quick},
          {"scenes", std::move(names)}};
}

void write_page(const ReportRequest& request, const std::vector<xsharp::Scene>& scenes,
                const Json& commands, const ReportData& data) {
  Json report{{"made", origin_of(request, scenes)}, {"commands", commands}};
  for (const char* part : {"verify", "accuracy", "clocks", "host", "drift", "stepping"}) {
    report[part] = data.parts.at(part);
  }
  const std::string page = assemble_page(page_parts(), report, data.pictures, data.strip);
  support::replace_file(request.folder + "/report.json", support::json_text(report));
  support::replace_file(request.folder + "/report.html", page);
}

}  // namespace

int make_report(const ReportRequest& request) {
  const support::Interrupt interrupt;
  const std::vector<xsharp::Scene> scenes = read_scenes(request.scenes);
  make_folder(request.folder);
  const support::FolderLock lock("--out", request.folder);
  make_folder(request.folder + "/data");
  for (const char* part : {"", "/data"}) support::remove_leftovers(request.folder + part);
  const std::vector<ReportStep> steps = report_steps(request, scenes);
  check_outputs(request, scenes, steps);

  ReportData data;
  Json commands = Json::array();
  int verify_status = 0;
  for (const ReportStep& step : steps) {
    std::cout << fmt::format("{} of {}: {}\n", commands.size() + 1, steps.size(),
                             support::printable(step.command))
              << std::flush;
    const auto begin = std::chrono::steady_clock::now();
    const int status = support::Interrupt::flag() ? support::interrupted_status : step.run(data);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
    if (!shows_on_page(step, status)) {
      std::cout << "  not done\n" << stopped_text(step, status, commands.size(), steps.size());
      return report_status(status);
    }
    std::cout << fmt::format("  {}\n", support::duration(passed.count()));
    if (step.name == "verify") verify_status = status;
    commands.push_back(
        {{"command", step.command}, {"date", measure::date_now()}, {"seconds", passed.count()}});
  }
  write_page(request, scenes, commands, data);
  std::cout << fmt::format(
      "Wrote the page {0}/report.html, and its figures to {0}/report.json and {0}/data\n",
      support::printable(request.folder));
  return verify_status;
}

}  // namespace fixproof::cli
