#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <iostream>
#include <map>
#include <memory>
#include <optional>

#include "cli/advice_text.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/surface_options.hpp"
#include "player/outputs.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/output_file.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "trade/advice/advice.hpp"
#include "trade/drift/run.hpp"
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
  std::string json;
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
        fmt::format("--budget {}: want pixels above 0, to {:.0f}, as 0.5 or 0.5px",
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
  std::string text = fmt::format(
      "{}: {} frames, {} at {} frames a second; budget {} pixels.\n"
      "Pixels: the worst of any corner, from where it is in double worked out from scratch, before "
      "it is\nrounded to a whole pixel.\n",
      support::printable(report.scene), support::grouped(report.frames),
      support::duration(static_cast<double>(report.frames) /
                        static_cast<double>(trade::advised_rate)),
      trade::advised_rate, report.budget);
  if (report.cpu) {
    text += fmt::format(
        "Least and most: clocks of the listings alone on the {}, mean of {} frames of the first "
        "minute.\nFrom scratch, made in double, is counted as a CosSin and a rotation for each "
        "axis that "
        "turns.\n",
        x86model::name_of(*report.cpu), trade::ClockSample::in_a_row * trade::ClockSample::places);
    if (report.cpu == x86model::Cpu::i8088) {
      text +=
          "They are the larger of two times: Intel's table, and the bus at 4 clocks for each byte "
          "of code and data.\n";
    }
  } else {
    text += fmt::format(
        "Least and most: nanoseconds a frame by the type on this processor, least and "
        "median of {} rounds over the\nfirst minute; medians nearer than the spread from round to "
        "round count as the same, and the more exact\nis taken first.\n",
        trade::TimeSample::rounds);
  }
  if (report.repaired) text += "The 8088 code has ConcatXforms repaired.\n";
  return text + '\n';
}

int stopped(std::uint64_t frames, std::uint64_t wanted, const AdviseOptions& options) {
  std::cout << fmt::format("STOPPED after {} of {} frames: no advice{}\n", support::grouped(frames),
                           support::grouped(wanted),
                           options.json.empty() ? "" : "; no JSON is written");
  return support::interrupted_status;
}

int advise_on(const AdviseOptions& options) {
  const double budget = pixels_of(options.budget);
  xsharp::Scene scene = xsharp::read_scene(options.scene);
  options.surfaces.apply(scene);
  if (options.repaired) scene.arithmetic.repaired = true;
  if (scene.objects.empty()) throw support::UsageError(scene.name + " has no objects");
  std::optional<support::OutputFile> json;
  if (!options.json.empty()) {
    player::refuse_inputs("--json", options.json, scene.files);
    json.emplace(options.json);
  }

  trade::AdviceReport report{
      .scene = scene.name, .budget = budget, .repaired = scene.arithmetic.repaired};
  if (!options.host) report.cpu = options.cpu;
  const auto choices = trade::choices_on(report.cpu);
  const std::uint64_t wanted = options.minutes * 60 * trade::advised_rate;
  report.frames = wanted;

  const support::Interrupt interrupt;
  const std::atomic<bool>& stop = support::Interrupt::flag();
  std::vector<trade::Cost> costs;
  if (report.cpu) {
    support::FrameProgress progress(choices.size(), "choices");
    costs = trade::clocks_a_frame(scene, choices, *report.cpu, stop,
                                  [&](std::uint64_t done) { progress.show(done); });
  } else {
    costs = trade::nanoseconds_a_frame(scene, choices, stop);
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
  if (json) json->replace(support::json_text(trade::to_json(report)));
  return advice.take ? 0 : 1;
}

}  // namespace

void add_advise(CLI::App& app, int& status) {
  auto options = std::make_shared<AdviseOptions>();
  CLI::App* command =
      app.add_subcommand("advise", "find the cheapest way to draw a scene accurately enough");
  command->add_option("scene", options->scene, "a scene, such as scenes/twelve_cubes.json")
      ->required()
      ->check(not_empty());
  options->surfaces.add_to(*command);
  command
      ->add_option("--budget", options->budget,
                   "how far a corner may be from where it should be, in pixels, as 0.5px")
      ->required()
      ->check(not_empty());
  command->add_option("--minutes", options->minutes, "how long, at 60 frames a second")
      ->transform(whole_number(1, 10'000))
      ->capture_default_str();
  static const std::map<std::string, x86model::Cpu> cpus{{"8088", x86model::Cpu::i8088},
                                                         {"286", x86model::Cpu::i286},
                                                         {"386", x86model::Cpu::i386},
                                                         {"486", x86model::Cpu::i486}};
  command
      ->add_option_function<std::string>(
          "--cpu", [options](const std::string& name) { options->cpu = cpus.at(name); },
          "whose clocks count: 8088, 286, 386 or 486 (386)")
      ->check(CLI::IsMember({"8088", "286", "386", "486"}));
  command->add_flag("--host", options->host, "count nanoseconds of this processor instead")
      ->excludes(command->get_option("--cpu"));
  command->add_flag(
      "--repaired", options->repaired,
      "8088 code has the ConcatXforms that keeps its carry: see docs/findings.md, 18");
  command->add_option("--json", options->json, "the same as JSON")->check(not_empty());
  command->footer(
      R"(Tries the routines of both processors with multiplies and divides rounded or not. Orientations
are computed from scratch, or by appending rotations and restoring orthogonality never or after
every 600, 60, 10 or 1 rotations. Among choices of equal cost advise takes the most accurate
one. With --host, costs are equal if the times differ by less than their interquartile range
from round to round. The cost includes stepping along surfaces; the budget applies to corners
only. For the error that stepping adds at the pixels see render --beside.

Exit status: 0 a choice stays within the budget, 1 none does, 2 bad usage or an invalid scene,
130 interrupted.

Examples:
  fixproof advise scenes/twelve_cubes.json --budget 0.5px
  fixproof advise scenes/shaded_ball.json --budget 2px --minutes 5 --cpu 8088)");
  command->callback([options, &status] { status = advise_on(*options); });
}

}  // namespace fixproof::cli
