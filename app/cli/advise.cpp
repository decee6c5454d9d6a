#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <iostream>
#include <memory>

#include "app/cli/advice_text.hpp"
#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/options.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/surface_options.hpp"
#include "measure/trade/advice/advice.hpp"
#include "measure/trade/drift/run.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "xsharp/files/scene_json.hpp"

namespace fixproof::cli {

namespace {

struct AdviseOptions {
  std::string scene;
  SurfaceOptions surfaces;
  std::string budget;
  std::uint64_t minutes = 30;
  x86model::Cpu cpu = x86model::Cpu::i386;
  bool host = false;
  bool repaired = false;
  bool formats = false;
  ResultFile result;
};

constexpr double max_pixels = 10'000;

double pixels_of(std::string_view text) {
  std::string_view number = text;
  if (number.ends_with("px")) number.remove_suffix(2);
  double pixels = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), pixels);
  // The negated condition also rejects NaN.
  if (error != std::errc{} || end != number.data() + number.size() ||
      !(pixels > 0 && pixels <= max_pixels)) {
    throw support::UsageError(
        fmt::format("--budget {}: give pixels above 0 and up to {:.0f}, as in 0.5 or 0.5px",
                    support::quoted(text), max_pixels));
  }
  return pixels;
}

/// Returns the largest error of the choice's motion in pixels, as `fixproof drift` measures it.
double drift_of(const xsharp::Scene& scene, const trade::Choice& choice, std::uint64_t& frames) {
  const trade::DriftCase motion{.build = choice.build,
                                .restore_every = choice.turning.restore_every,
                                .from_scratch = choice.turning.from_scratch};
  support::FrameProgress progress(frames);
  return trade::run_drift(scene, {motion}, frames, support::Interrupt::flag(),
                          [&](std::uint64_t done) { progress.show(done); })
      .at(0)
      .worst.pixels;
}

std::string heading(const trade::AdviceReport& report) {
  std::string text = scene_line(report.scene, report.frames, report.budget) + '\n';
  if (report.cpu) {
    text += fmt::format(
        "Least and most: clocks of the listings alone on the {}, mean of {} frames of the first "
        "minute.\nDouble computes orientations from scratch; each counts as a CosSin and a "
        "rotation "
        "per turning axis.\n",
        x86model::name_of(*report.cpu),
        trade::ClockSample::consecutive * trade::ClockSample::places);
    if (report.cpu == x86model::Cpu::i8088) {
      text +=
          "Clocks are the larger of two times: Intel's table, and the bus at 4 clocks for each "
          "byte "
          "of code and data.\n";
    }
  } else {
    text += fmt::format(
        "Least and most: nanoseconds per frame of the type on this processor, minimum and "
        "median of {} rounds over\nthe first minute. Medians that differ by less than their spread "
        "count as equal; the more accurate choice\ncomes first.\n",
        trade::TimeSample::rounds);
  }
  if (report.repaired) text += "The 8088 code has the repaired ConcatXforms.\n";
  return text + '\n';
}

int stopped(std::uint64_t frames, std::uint64_t wanted, const AdviseOptions& options) {
  std::cout << fmt::format("STOPPED after {} of {} frames: no advice is given{}\n",
                           support::grouped(frames), support::grouped(wanted),
                           options.result.loss_text());
  return support::interrupted_status;
}

int advise_formats(const xsharp::Scene& scene, double budget, std::uint64_t frames,
                   AdviseOptions& options) {
  trade::FormatReport report{
      .scene = scene.name, .frames = frames, .budget = budget, .tried = {}, .costs = {}};
  const support::Interrupt interrupt;
  const std::atomic<bool>& stop = support::Interrupt::flag();
  {
    support::FrameProgress progress(frames);
    report.tried = trade::try_formats(scene, budget, report.frames, stop,
                                      [&](std::uint64_t done) { progress.show(done); });
  }
  const auto take = trade::narrowest(report.tried);
  if (take && !stop) {
    const int width = trade::integer_width(report.tried[*take].word_bits);
    report.costs = trade::format_costs(scene, width, stop);
  }
  std::cout << fmt::format(
      "{}\nEach row has that many fraction bits in every number; products and quotients are "
      "rounded half up. Word: the\nbits of the largest result, with the sign. A run ends when it "
      "exceeds the budget, and its word is that until then.\n\n{}\n",
      scene_line(report.scene, report.frames, report.budget), table_of(report));
  if (stop) return stopped(report.frames, frames, options);
  std::cout << sentences_of(report);
  return options.result.write(take ? 0 : 1, [&] { return support::Json(report); });
}

int advise_on(AdviseOptions& options) {
  const double budget = pixels_of(options.budget);
  xsharp::Scene scene = xsharp::read_scene(options.scene);
  options.surfaces.apply(scene);
  if (options.repaired) scene.arithmetic.repaired = true;
  require_objects(scene);
  options.result.open(scene.files, "the scene");
  const std::uint64_t wanted = options.minutes * 60 * trade::advised_rate;
  if (options.formats) return advise_formats(scene, budget, wanted, options);

  trade::AdviceReport report{
      .scene = scene.name, .budget = budget, .repaired = scene.arithmetic.repaired};
  if (!options.host) report.cpu = options.cpu;
  const auto choices = trade::choices_on(report.cpu);
  report.frames = wanted;

  const support::Interrupt interrupt;
  const std::atomic<bool>& stop = support::Interrupt::flag();
  std::vector<trade::Cost> costs;
  if (report.cpu) {
    support::FrameProgress progress(choices.size(), "choices");
    costs = trade::clocks_per_frame(scene, choices, *report.cpu, stop,
                                    [&](std::uint64_t done) { progress.show(done); });
  } else {
    costs = trade::nanoseconds_per_frame(scene, choices, stop);
  }
  if (costs.size() < choices.size()) return stopped(0, wanted, options);
  std::vector<trade::ScreenError> errors;
  {
    support::FrameProgress progress(wanted);
    errors = trade::screen_errors(scene, choices, budget, report.frames, stop,
                                  [&](std::uint64_t done) { progress.show(done); });
  }
  for (std::size_t i = 0; i < choices.size(); ++i) {
    report.tried.push_back({choices[i], costs[i], errors[i]});
  }
  trade::sort_by_cost(report.tried);
  std::cout << heading(report) << table_of(report) << '\n';
  if (report.frames < wanted) return stopped(report.frames, wanted, options);

  const trade::Advice advice = trade::advise(report.tried, budget);
  if (advice.take) {
    std::uint64_t frames = wanted;
    report.drift_pixels = drift_of(scene, report.tried[*advice.take].choice, frames);
    if (frames < wanted) return stopped(frames, wanted, options);
  }
  std::cout << sentences_of(report);
  return options.result.write(advice.take ? 0 : 1, [&] { return support::Json(report); });
}

}  // namespace

void add_advise(CLI::App& app, int& status) {
  auto options = std::make_shared<AdviseOptions>();
  CLI::App* command =
      app.add_subcommand("advise", "find the cheapest way to draw a scene accurately enough");
  command
      ->add_option("scene", options->scene, "scene file, such as xsharp/scenes/twelve_cubes.json")
      ->required()
      ->check(not_empty());
  options->surfaces.add_to(*command);
  command
      ->add_option("--budget", options->budget,
                   "largest allowed error of a corner in pixels, as in 0.5px")
      ->required()
      ->check(not_empty());
  command
      ->add_option("--minutes", options->minutes, "length of the animation at 60 frames a second")
      ->transform(whole_number(1, 10'000))
      ->capture_default_str();
  command
      ->add_option_function<std::string>(
          "--cpu", [options](const std::string& name) { options->cpu = cpu_names.at(name); },
          "processor whose clocks are the cost: 8088, 286, 386 or 486; by default 386")
      ->check(one_of(names_of(cpu_names)));
  command
      ->add_flag("--host", options->host,
                 "measure the cost in nanoseconds on this processor instead")
      ->excludes(command->get_option("--cpu"));
  command->add_flag(
      "--repaired", options->repaired,
      "use the repaired 8088 ConcatXforms, which keeps a carry that the printed one loses; see "
      "docs/findings.md, 18");
  command
      ->add_flag("--formats", options->formats,
                 "find the narrowest word and the fewest fraction bits instead")
      ->excludes(command->get_option("--cpu"))
      ->excludes(command->get_option("--host"))
      ->excludes(command->get_option("--repaired"));
  options->result.add_to(*command);
  command->footer(
      R"(Tries every routine that the processor can run, with and without rounding of multiplies and of
divides. Orientations are computed from scratch, or by appending rotations and restoring
orthogonality never or after every 600, 60, 10 or 1 rotations. Among choices of equal cost, advise
takes the most accurate.
With --host, costs are equal if the medians differ by less than the interquartile range of the
rounds. The cost includes stepping along surfaces; the budget applies to corners only.
render --beside shows the error that stepping adds at the pixels.
With --formats, advise computes the corners with 0 to 24 fraction bits in every number and half-up
rounding, for the scene's way of turning and for orientations from scratch. It takes the fewest
fraction bits within the budget and the narrowest word that holds every result, and times batches
of that width and of q16_16 on this processor.

Exit status: 0 a choice stays within the budget, 1 none does, 2 bad usage or an invalid scene,
130 interrupted.

Examples:
  fixproof advise xsharp/scenes/twelve_cubes.json --budget 0.5px
  fixproof advise xsharp/scenes/shaded_ball.json --budget 2px --minutes 5 --cpu 8088
  fixproof advise xsharp/scenes/twelve_cubes.json --budget 0.5px --formats)");
  command->callback([options, &status] { status = advise_on(*options); });
}

}  // namespace fixproof::cli
