// fixproof measure --accuracy.
//
// The file that --json names:
//
//   made        {command, seed, compiler, date}
//   scenes      whose operands were taken; libfixmath, FreeType: whether each was built in
//   accuracy    a list of {operation, operands, variant; alike: endings of presets that return the
//               same; cases, left_out, faults; max, mean, mean_error: the standard error of the
//               mean of random cases, rms / sqrt(cases); rms, correct; histogram: {span, counts}}
//   pixels      {constant, half_width; variants: a list of {variant; safe_from: the distance from
//               which no point is half a pixel off; octaves: a list of {from, to, max, mean,
//               half_a_pixel: the share of points half a pixel off or more}}}
//
// Errors are in units of the last place of 16.16, those of points in pixels; correct is the share,
// 0 ... 1, within half a unit.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "support/file.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/json_text.hpp"
#include "support/plain_text.hpp"
#include "trade/accuracy/accuracy_run.hpp"
#include "trade/accuracy/pixel_error.hpp"
#include "trade/accuracy/scene_operands.hpp"
#include "trade/figures.hpp"
#include "trade/host/provenance.hpp"
#include "trade/measure.hpp"

namespace fixproof::trade {

namespace {

using AccuracyJson = nlohmann::ordered_json;

constexpr std::uint64_t default_accuracy_cases = 500'000;
/// Points of an octave of distance for every operand of the other measurements.
constexpr std::uint64_t points_share = 10;

/// One character for a bucket, the fullest the tallest; a space for an empty one.
std::string sparkline(const ErrorHistogram& histogram) {
  static constexpr std::array heights{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  const auto& counts = histogram.counts();
  const std::uint64_t fullest = *std::max_element(counts.begin(), counts.end());
  std::string line;
  for (const std::uint64_t count : counts) {
    line += count == 0 ? " " : heights.at((count * heights.size() - 1) / fullest);
  }
  return line;
}

void print(const AccuracyRow& row) {
  const ErrorStatistics& e = row.errors;
  if (e.cases() == 0) {
    std::cout << fmt::format("  {:<24}no case has a result that fits\n", row.subject.name);
    return;
  }
  std::cout << fmt::format(
      "  {:<24}{:>9}{:>10}{:>10}{:>11}{:>12}{:>10}{:>10}{:>11}  {:>6} |{}|\n", row.subject.name,
      support::grouped(e.cases()), support::grouped(row.beyond), support::grouped(row.faults),
      largest_text(e.max()), error_text(e.mean(), true), error_text(e.mean_error()),
      error_text(e.root_mean_square()), share_text(e.correct()),
      fmt::format("{:g}", e.histogram().span()), sparkline(e.histogram()));
}

AccuracyJson json_of(const AccuracyRow& row) {
  const ErrorStatistics& e = row.errors;
  return {{"operation", row.operation},
          {"operands", row.operands},
          {"variant", row.subject.name},
          {"alike", row.subject.alike},
          {"cases", e.cases()},
          {"left_out", row.beyond},
          {"faults", row.faults},
          {"max", e.max()},
          {"mean", e.mean()},
          {"mean_error", e.mean_error()},
          {"rms", e.root_mean_square()},
          {"correct", e.correct()},
          {"histogram", {{"span", e.histogram().span()}, {"counts", e.histogram().counts()}}}};
}

AccuracyJson json_of(const PixelErrors& errors) {
  AccuracyJson octaves = AccuracyJson::array();
  for (const DistanceOctave& o : errors.octaves) {
    octaves.push_back({{"from", o.nearest},
                       {"to", 2 * o.nearest},
                       {"max", o.max},
                       {"mean", o.mean},
                       {"half_a_pixel", o.half}});
  }
  return {
      {"variant", errors.name}, {"safe_from", errors.safe_from}, {"octaves", std::move(octaves)}};
}

class AccuracyRun {
 public:
  explicit AccuracyRun(const MeasureRequest& request)
      : request_(request),
        cases_(request.cases.value_or(default_accuracy_cases)),
        operations_(measured_operations()),
        all_(request.scenes.size() + operations_.size() + 1),
        progress_(std::in_place, all_, "parts") {}

  /// @return false where it was stopped before its time
  bool run() {
    for (const xsharp::Scene& scene : read_scenes(request_)) {
      scenes_.push_back(scene.name);
      logs_.push_back(record_scene(scene, cases::Build{}, stop_).log);
      done();
    }
    for (const MeasuredOperation& operation : operations_) {
      measure(operation);
      if (stop_) return false;
      done();
    }
    pixels_ = measure_pixel_errors(page_, request_.seed, cases_ / points_share + 1, stop_);
    if (stop_) return false;
    done();
    progress_.reset();
    return true;
  }

  void print_all() const {
    std::cout
        << made_by(request_.seed) << "\n\n"
        << "Errors in units of the last place, each a result less the exact one. Correct is a "
           "result within\nhalf a unit of it: a word than which none is nearer. Left out are cases "
           "whose exact result does\nnot fit, or that have none; #DE cases whose result would fit. "
           "The mean is the bias, and +- its\nstandard error where cases are random: a mean of two "
           "or three times that may be chance. The\nhistogram goes from -span to span, its tallest "
           "column the fullest.\n";
    std::cout << libraries_left_out();
    if (scenes_.empty()) {
      std::cout << "Without a SCENE there are no operands of a scene.\n";
    }
    std::cout << fmt::format("\n{:<26}{:>9}{:>10}{:>10}{:>11}{:>12}{:>10}{:>10}{:>11}  {:>6}\n", "",
                             "cases", "left out", "#DE", "max", "mean", "+-", "rms", "correct",
                             "span");
    std::string heading;
    for (const AccuracyRow& row : rows_) {
      const std::string here =
          fmt::format("{}, {}", row.operation, support::printable(row.operands));
      if (here != heading) {
        std::cout << '\n' << here << '\n';
      }
      heading = here;
      print(row);
    }
    print_pixels();
  }

  void write_json() const {
    AccuracyJson json{{"made", made_by_json(request_.seed, "measure --accuracy")}};
    json["scenes"] = scenes_;
    json["libfixmath"] = has_libfixmath();
    json["FreeType"] = has_freetype();
    json["accuracy"] = AccuracyJson::array();
    for (const AccuracyRow& row : rows_) json["accuracy"].push_back(json_of(row));
    json["pixels"] = {{"constant", page_.constant}, {"half_width", page_.half_width}};
    json["pixels"]["variants"] = AccuracyJson::array();
    for (const PixelErrors& e : pixels_) json["pixels"]["variants"].push_back(json_of(e));
    support::replace_file(request_.json, support::json_text(json));
  }

  [[nodiscard]] std::string how_far() const {
    return fmt::format("STOPPED after {} of {} parts{}\n", done_, all_,
                       request_.json.empty() ? "" : "; " + request_.json + " is not written");
  }

 private:
  void measure(const MeasuredOperation& operation) {
    std::vector<OperandSet> sets = random_operands(operation, request_.seed, cases_);
    for (std::size_t i = 0; i < logs_.size(); ++i) {
      sets.push_back(scene_operands(operation, scenes_[i], logs_[i], cases_));
    }
    for (const OperandSet& set : sets) {
      if (set.words.empty()) continue;
      for (AccuracyRow& row : measure_errors(operation, set, stop_)) {
        rows_.push_back(std::move(row));
      }
    }
  }

  void print_pixels() const {
    std::cout << fmt::format(
        "\nPixels that a point of the page is off, by its distance: x over z, times {}, on a page "
        "that\nreaches {} to each side. The largest error of {} points of each octave.\n\n"
        "{:>15}",
        page_.constant, page_.half_width, support::grouped(cases_ / points_share + 1), "distance");
    for (const PixelErrors& e : pixels_) std::cout << fmt::format("{:>24}", e.name);
    std::cout << '\n';
    for (std::size_t i = 0; i < pixels_.front().octaves.size(); ++i) {
      const std::int32_t from = pixels_.front().octaves[i].nearest;
      std::cout << fmt::format("{:>15}", fmt::format("{} to {}", from, 2 * from));
      for (const PixelErrors& e : pixels_) std::cout << fmt::format("{:>24.4f}", e.octaves[i].max);
      std::cout << '\n';
    }
    std::cout << fmt::format("{:>15}", "safe from");
    for (const PixelErrors& e : pixels_) std::cout << fmt::format("{:>24}", e.safe_from);
    std::cout << "\n\nSafe from: at this distance and beyond, no point is half a pixel off.\n";
  }

  void done() { progress_->show(++done_); }

  const MeasureRequest& request_;
  const support::Interrupt interrupt_;
  const std::atomic<bool>& stop_ = support::Interrupt::flag();
  std::uint64_t cases_;
  std::vector<MeasuredOperation> operations_;
  PageProjection page_;
  std::uint64_t all_;
  std::optional<support::FrameProgress> progress_;  ///< until all is done
  std::uint64_t done_ = 0;
  std::vector<std::string> scenes_;
  std::vector<player::OperandLog> logs_;
  std::vector<AccuracyRow> rows_;
  std::vector<PixelErrors> pixels_;
};

}  // namespace

int measure_accuracy(const MeasureRequest& request) {
  AccuracyRun run(request);
  if (!run.run()) {
    std::cout << run.how_far();
    return support::interrupted_status;
  }
  run.print_all();
  if (!request.json.empty()) run.write_json();
  return 0;
}

}  // namespace fixproof::trade
