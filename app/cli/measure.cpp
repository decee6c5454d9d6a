#include "app/cli/measure.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/measure_text.hpp"
#include "app/cli/print_error.hpp"
#include "support/interrupt.hpp"
#include "support/json.hpp"
#include "xsharp/files/scene_json.hpp"

namespace fixproof::cli {

namespace {

struct MeasureOptions {
  bool accuracy = false;
  bool clocks = false;
  bool host = false;
  bool stepping = false;
  std::vector<std::string> scenes;
  std::string format;
  measure::MeasureRequest request;
  ResultFile result;
};

/// Reads the scenes and locks the JSON file, if one is named.
/// @throws xsharp::SceneError, UsageError if the format is not one or the JSON file is an input,
///         std::runtime_error if that cannot be written
measure::MeasureRequest read_request(MeasureOptions& options) {
  measure::MeasureRequest request = options.request;
  if (!options.format.empty()) request.format = cases::format_named(options.format);
  std::vector<std::string> inputs;
  for (const std::string& file : options.scenes) {
    request.scenes.push_back(xsharp::read_scene(file));
    const auto& files = request.scenes.back().files;
    inputs.insert(inputs.end(), files.begin(), files.end());
  }
  options.result.open(inputs, "the scene");
  return request;
}

template <class Result>
int run(MeasureOptions& options, Measurement<Result> measure) {
  const measure::MeasureRequest request = read_request(options);
  measure::MeasureProgress progress(support::Interrupt::flag());
  Measured<Result> measured;
  {
    const support::Interrupt interrupt;
    measured = run_measurement(measure, request, progress);
  }
  if (measured.status == support::interrupted_status) {
    std::cout << fmt::format("STOPPED after {} of {} {}{}\n", progress.done(), progress.all(),
                             progress.unit(), options.result.loss_text());
    return measured.status;
  }
  if (measured.result) std::cout << text_of(*measured.result);
  for (const std::string& line : measured.errors) print_error(line);
  return options.result.write(measured.status, [&] { return json_of(measured); });
}

}  // namespace

std::vector<std::string> broken_bounds(const measure::SteppingResult& result) {
  std::vector<std::string> lines;
  for (const measure::SteppingRow& row : result.rows) {
    if (row.statistics.beyond.empty()) continue;
    lines.push_back(
        fmt::format("{}, {}: {}", row.variant.value, row.variant.rule, row.statistics.beyond));
  }
  return lines;
}

void add_measure(CLI::App& app, int& status) {
  auto options = std::make_shared<MeasureOptions>();
  CLI::App* command =
      app.add_subcommand("measure", "measure errors, clocks and times of the arithmetic");
  CLI::Option_group* what = command->add_option_group("what", "what to measure");
  CLI::Option* accuracy = what->add_flag(
      "--accuracy", options->accuracy,
      "measure the errors of every operation in every variant, in units of the last place");
  CLI::Option* clocks = what->add_flag("--clocks", options->clocks,
                                       "count the clocks of every routine, and per pixel of every "
                                       "inner loop, on 8088, 286, 386, 486");
  CLI::Option* host = what->add_flag(
      "--host", options->host,
      "time this processor, beside float, double and third-party libraries, with their errors");
  CLI::Option* stepping = what->add_flag(
      "--stepping", options->stepping,
      "measure the errors of values stepped across spans, with derived bounds, the wrong pixels, "
      "and clocks and nanoseconds of the loops");
  what->require_option(1);
  const auto add_text = [command](const char* name, auto& value, const char* help) {
    return command->add_option(name, value, help)->check(not_empty());
  };
  CLI::Option* format = add_text("--format", options->format,
                                 "measure mul, div and sqrt in this format, such as q2_30: "
                                 "the type under every rounding rule, float and double")
                            ->needs(accuracy);
  CLI::Option* function = add_text("--function", options->request.function,
                                   "measure this function of docs/functions.md; all for every one")
                              ->needs(accuracy);
  add_text("scene", options->scenes,
           "scene files whose operands are recorded, such as xsharp/scenes/twelve_cubes.json")
      ->excludes(host)
      ->excludes(stepping)
      ->excludes(format)
      ->excludes(function);
  command
      ->add_option("--cases", options->request.cases,
                   "number of random operands of each kind, or of spans of each length")
      ->transform(whole_number(1, 100'000'000));
  add_seed(*command, options->request.seed);
  command
      ->add_option("--rounds", options->request.rounds,
                   "number of timed rounds of --host (about 0.07 s each) and --stepping")
      ->transform(whole_number(1, 100'000))
      ->capture_default_str()
      ->excludes(accuracy)
      ->excludes(clocks);
  options->result.add_to(*command);
  command->footer(
      R"(--accuracy compares results with exact integers, by default for 500,000 operands of each kind. With
--format, it takes the formats that fixed/formats.hpp names, but no scene: its operands are 16.16.
With --function, it takes the cases of `fixproof gen` (--cases of them) in 16.16 or a --format, and adds
the worst operands, and the order and symmetry of the results, as `fixproof check` shows them.
--clocks counts clocks by Intel's tables and tests the chapters' claims about speed.
--host times this processor, by default with 100,000 results of each kind, and takes no scene.
--stepping steps spans of 1 to 320 pixels, by default 200 of each length, and takes no scene.

Exit status: 0 done, 1 an implementation timed by --host breaks its own rounding rule or a stepped
value exceeds its derived bound, 2 bad usage or an invalid scene, 130 interrupted.

Examples:
  fixproof measure --accuracy xsharp/scenes/twelve_cubes.json --json accuracy.json
  fixproof measure --accuracy --format q2_30
  fixproof measure --accuracy --function exp
  fixproof measure --clocks xsharp/scenes/twelve_cubes.json xsharp/scenes/shaded_ball.json --json clocks.json
  fixproof measure --host --json host.json
  fixproof measure --stepping --json stepping.json)");
  command->callback([options, &status] {
    status = !options->request.function.empty() ? run(*options, measure::measure_function_accuracy)
             : !options->format.empty()         ? run(*options, measure::measure_format_accuracy)
             : options->accuracy                ? run(*options, measure::measure_accuracy)
             : options->host                    ? run(*options, measure::measure_host)
             : options->stepping                ? run(*options, measure::measure_stepping)
                                                : run(*options, measure::measure_clocks);
  });
}

}  // namespace fixproof::cli
