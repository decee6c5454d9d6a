#include "measure/accuracy/accuracy.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "measure/accuracy/scene_operands.hpp"
#include "measure/host/provenance.hpp"
#include "support/thread_pool.hpp"

namespace fixproof::measure {

namespace {

using support::Json;

constexpr std::uint64_t default_accuracy_cases = 500'000;
/// The other measurements use this many times as many operands as each octave has points.
constexpr std::uint64_t points_share = 10;
/// The operands of more would take gigabytes if several operations were measured at a time.
constexpr std::uint64_t most_cases_in_threads = 4'000'000;

}  // namespace

static void to_json(Json& json, const DistanceOctave& o) {
  json = {{"from", o.nearest},
          {"to", 2 * o.nearest},
          {"max", o.max},
          {"mean", o.mean},
          {"half_a_pixel", o.half}};
}

static void to_json(Json& json, const PixelErrors& e) {
  json = {{"variant", e.name}, {"safe_from", e.safe_from}, {"octaves", e.octaves}};
}

std::optional<AccuracyResult> measure_accuracy(const MeasureRequest& request,
                                               MeasureProgress& progress) {
  const std::vector<MeasuredOperation> operations = measured_operations();
  const std::uint64_t cases = request.cases.value_or(default_accuracy_cases);
  const std::atomic<bool>& stop = progress.stop();
  AccuracyResult result;
  result.seed = request.seed;
  result.points = cases / points_share + 1;
  progress.begin(request.scenes.size() + operations.size() + 1, "parts");
  std::vector<player::OperandLog> logs(request.scenes.size());
  for (const xsharp::Scene& scene : request.scenes) result.scenes.push_back(scene.name);
  support::for_each_in_threads(logs.size(), [&](std::size_t i) {
    if (stop) return;
    logs[i] = record_scene(request.scenes[i], cases::Build{}, stop).log;
    if (!stop) progress.add_part();
  });
  std::vector<std::vector<AccuracyRow>> rows(operations.size());
  const auto measure = [&](std::size_t k) {
    if (stop) return;
    const MeasuredOperation& operation = operations[k];
    std::vector<OperandSet> sets = random_operands(operation, request.seed, cases);
    for (std::size_t i = 0; i < logs.size(); ++i) {
      sets.push_back(scene_operands(operation, result.scenes[i], logs[i], cases));
    }
    for (const OperandSet& set : sets) {
      if (set.words.empty()) continue;
      for (AccuracyRow& row : measure_errors(operation, set, stop)) {
        rows[k].push_back(std::move(row));
      }
    }
    if (!stop) progress.add_part();
  };
  if (cases <= most_cases_in_threads) {
    support::for_each_in_threads(operations.size(), measure);
  } else {
    for (std::size_t k = 0; k < operations.size(); ++k) measure(k);
  }
  if (stop) return std::nullopt;
  for (std::vector<AccuracyRow>& of_operation : rows) {
    std::move(of_operation.begin(), of_operation.end(), std::back_inserter(result.rows));
  }
  result.pixels = measure_pixel_errors(result.page, request.seed, result.points, stop);
  if (stop) return std::nullopt;
  progress.add_part();
  return result;
}

void to_json(Json& json, const AccuracyResult& result) {
  json = {{"made", made_by_json("measure --accuracy", result.seed)},
          {"scenes", result.scenes},
          {"libfixmath", has_libfixmath()},
          {"FreeType", has_freetype()},
          {"accuracy", result.rows},
          {"pixels",
           {{"constant", result.page.constant},
            {"half_width", result.page.half_width},
            {"variants", result.pixels}}}};
}

}  // namespace fixproof::measure
