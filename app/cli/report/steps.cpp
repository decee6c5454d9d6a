#include "app/cli/report/steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "app/cli/drift.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/measure.hpp"
#include "app/cli/print_error.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/render.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/selection.hpp"
#include "measure/accuracy/accuracy.hpp"
#include "measure/clocks/clocks.hpp"
#include "measure/host/host.hpp"
#include "measure/stepping/stepping.hpp"
#include "support/file.hpp"
#include "support/interrupt.hpp"
#include "verify/engine.hpp"
#include "verify/report_json.hpp"

namespace fixproof::cli {

namespace {

using support::Json;
using Words = std::vector<std::string>;

/// Two seconds at 60 frames per second.
constexpr std::uint64_t animation_frames = 120;
constexpr std::uint64_t quick_frames = 3;
constexpr std::uint64_t quick_cases = 300;
constexpr std::uint64_t quick_spans = 4;

std::string shell_word(const std::string& word) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-./=,+:@").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), is_plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string command_line(const Words& arguments) {
  std::string line = "fixproof";
  for (const std::string& argument : arguments) line += ' ' + shell_word(argument);
  return line;
}

void append(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
}

ReportStep verify_step(const ReportRequest& request, const std::string& stem) {
  Selection selection;
  // These routines are the fastest to verify.
  if (request.quick) selection.operations = {"cossin", "sqrt"};
  const std::string json = stem + ".json";
  Words arguments{"verify"};
  append(arguments, selection.operations);
  append(arguments, {"--seed", fmt::to_string(request.seed), "--report", json});
  return {"verify", command_line(arguments), {json}, [=, seed = request.seed](ReportData& data) {
            constexpr std::size_t max_mismatches = 10;
            const auto parties = chosen_parties(selection);
            verify::Report report(
                cases::Plan(selection.level, seed, chosen_rows(selection, parties)), {},
                max_mismatches);
            Progress progress;
            const auto observe = [&](const verify::Report& state) { progress.show(state); };
            verify::run(report, parties, {.stop = &support::Interrupt::flag(), .observe = observe});
            if (!report.complete()) return support::interrupted_status;
            const std::string text = verify::to_json(report);
            support::replace_file(json, text);
            data.parts["verify"] = Json::parse(text);
            return report.mismatches() > 0 ? 1 : 0;
          }};
}

/// @param options of the command, without --seed and --json
template <class Result>
ReportStep measure_step(const std::string& name, Measurement<Result> measure, const Words& options,
                        measure::MeasureRequest request, const std::string& stem) {
  const std::string json = stem + ".json";
  Words arguments{"measure", "--" + name};
  append(arguments, options);
  append(arguments, {"--seed", fmt::to_string(request.seed), "--json", json});
  return {name, command_line(arguments), {json}, [=](ReportData& data) {
            measure::MeasureProgress progress(support::Interrupt::flag());
            const Measured<Result> measured = run_measurement(measure, request, progress);
            for (const std::string& line : measured.errors) print_error(line);
            if (measured.status != 0) return measured.status;
            data.parts[name] = result_json("measure", 0, json_of(measured));
            support::replace_file(json, support::json_text(data.parts[name]));
            return 0;
          }};
}

ReportStep drift_step(const ReportRequest& request, const xsharp::Scene& scene,
                      const std::string& stem) {
  const std::string json = stem + ".json";
  const std::string svg = stem + ".svg";
  DriftRequest drift;
  Words arguments{"drift", request.scenes.front()};
  if (request.quick) {
    drift.minutes = 1;
    append(arguments, {"--minutes", "1"});
  }
  append(arguments, {"--json", json, "--strip", svg});
  return {"drift", command_line(arguments), {json, svg}, [=, &scene](ReportData& data) {
            const trade::DriftFigures figures = measure_drift(scene, drift);
            if (!figures.complete()) return support::interrupted_status;
            data.parts["drift"] = result_json("drift", 0, figures);
            support::replace_file(json, support::json_text(data.parts["drift"]));
            data.strip = drift_strip(scene, drift);
            support::replace_file(svg, data.strip);
            return 0;
          }};
}

ReportStep render_step(const ReportRequest& request, std::size_t index,
                       const xsharp::Scene& read_scene, const std::string& data_folder) {
  const std::string name = fmt::format("scene_{}", index + 1);
  const std::uint64_t frames = request.quick ? quick_frames : animation_frames;
  player::OutputNames names;
  names.animation = data_folder + name + ".png";
  Words arguments{"render",    request.scenes[index], "--frames", fmt::to_string(frames),
                  "--animate", names.animation};
  Words files{names.animation};
  if (has_beside(read_scene)) {
    names.beside = data_folder + name + "_beside.png";
    append(arguments, {"--beside", names.beside});
    files.push_back(names.beside);
  }
  return {name, command_line(arguments), files, [=, &read_scene](ReportData& data) {
            const xsharp::Scene scene = SceneOptions().applied_to(read_scene);
            const DrawnFrames drawn = draw_frames(scene, frames, {.outputs = names});
            if (drawn.frames < frames) return support::interrupted_status;
            PagePicture picture{scene.name, support::read_file(names.animation), "", ""};
            if (!names.beside.empty()) {
              picture.beside = support::read_file(names.beside);
              picture.beside_text = drawn.differences;
            }
            data.pictures.push_back(std::move(picture));
            return 0;
          }};
}

}  // namespace

bool has_beside(const xsharp::Scene& scene) {
  return xsharp::interpolates(scene) && scene.arithmetic.by != "double";
}

std::vector<ReportStep> report_steps(const ReportRequest& request,
                                     const std::vector<xsharp::Scene>& scenes) {
  const std::string data = request.folder + "/data/";
  measure::MeasureRequest with_scenes;
  measure::MeasureRequest without_scenes;
  measure::MeasureRequest spans;
  with_scenes.seed = without_scenes.seed = spans.seed = request.seed;
  Words scene_options = request.scenes;
  Words host_options;
  Words span_options;
  with_scenes.scenes = scenes;
  if (request.quick) {
    // Counting clocks takes seconds per scene.
    with_scenes.scenes.resize(1);
    with_scenes.cases = without_scenes.cases = quick_cases;
    spans.cases = quick_spans;
    without_scenes.rounds = spans.rounds = 1;
    scene_options = {request.scenes.front(), "--cases", fmt::to_string(quick_cases)};
    host_options = {"--cases", fmt::to_string(quick_cases), "--rounds", "1"};
    span_options = {"--cases", fmt::to_string(quick_spans), "--rounds", "1"};
  }

  std::vector<ReportStep> steps{
      verify_step(request, data + "verify"),
      measure_step("accuracy", measure::measure_accuracy, scene_options, with_scenes,
                   data + "accuracy"),
      measure_step("clocks", measure::measure_clocks, scene_options, with_scenes, data + "clocks"),
      measure_step("host", measure::measure_host, host_options, without_scenes, data + "host"),
      measure_step("stepping", measure::measure_stepping, span_options, spans, data + "stepping"),
      drift_step(request, scenes.front(), data + "drift")};
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    steps.push_back(render_step(request, i, scenes[i], data));
  }
  return steps;
}

bool shows_on_page(const ReportStep& step, int status) {
  return status == 0 || (step.name == "verify" && status == 1);
}

int report_status(int status) { return status == support::interrupted_status ? status : 2; }

std::string stopped_text(const ReportStep& step, int status, std::size_t done, std::size_t all) {
  std::string text = fmt::format("STOPPED after {} of {} steps; no page is written.", done, all);
  if (status != support::interrupted_status) {
    text += fmt::format(" Step {} ended with status {}: {}", step.name, status,
                        step.name == "host" ? "an implementation breaks its own rounding rule."
                                            : "a stepped value exceeds its bound.");
  }
  return text + '\n';
}

}  // namespace fixproof::cli
