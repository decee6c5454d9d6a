#include "measure/trade/advice/formats.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "measure/host/provenance.hpp"
#include "measure/trade/advice/fraction_number.hpp"
#include "measure/trade/advice/screen_run.hpp"
#include "verify/parties/machines.hpp"

namespace fixproof::trade {

namespace {

/// The scene with FractionRun::fraction_bits.
class FractionScreen final : public ScreenRun {
 public:
  FractionScreen(const xsharp::Scene& scene, const Turning& turning, FractionRun& run) : run_(run) {
    const FractionNumber::Scope scope(run_);
    const xsharp::RotationStyle style{scene.trigonometry, scene.conversion, turning.from_scratch,
                                      turning.restore_every, scene.restore_rows};
    view_ = xsharp::view_of<FractionNumber>(scene);
    for (const auto& object : scene.objects) objects_.emplace_back(object, style);
  }

  void advance(std::size_t object) override {
    const FractionNumber::Scope scope(run_);
    objects_[object].advance();
  }

  /// Also compares a corner that this run would clip: the number has no range to leave.
  void compare(std::size_t object, const ExactPlaces& exact) override {
    const FractionNumber::Scope scope(run_);
    worst_ = 0;
    const auto& corners = objects_[object].view(view_);
    for (std::size_t i = 0; i < std::min(corners.size(), exact.size()); ++i) {
      if (exact[i]) add_error(worst_, screen_place(corners[i], view_.projection), *exact[i]);
    }
  }

  /// The largest squared distance of the object that was compared last.
  [[nodiscard]] double worst() const { return worst_; }

 private:
  FractionRun& run_;
  xsharp::View<FractionNumber> view_;
  std::vector<ScreenCorners<FractionNumber>> objects_;
  double worst_ = 0;
};

}  // namespace

std::vector<TriedFormat> try_formats(const xsharp::Scene& scene, double budget,
                                     std::uint64_t& frames, const std::atomic<bool>& stop,
                                     const std::function<void(std::uint64_t)>& frame_done) {
  std::vector<Turning> ways{{scene.from_scratch, scene.restore_every}};
  if (!scene.from_scratch) ways.push_back({.from_scratch = true});
  std::vector<TriedFormat> tried;
  for (const Turning& turning : ways) {
    for (int bits = 0; bits <= max_tried_fraction_bits; ++bits) {
      tried.push_back({bits, turning, {}, 0});
    }
  }
  std::vector<FractionRun> runs(tried.size());
  std::vector<std::unique_ptr<ScreenRun>> screens;
  std::vector<const FractionScreen*> of_screens;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    runs[i].fraction_bits = tried[i].fraction_bits;
    auto screen = std::make_unique<FractionScreen>(scene, tried[i].turning, runs[i]);
    of_screens.push_back(screen.get());
    screens.push_back(std::move(screen));
  }
  const auto compared = [&](std::uint64_t frame, std::size_t object) {
    for (std::size_t i = 0; i < tried.size(); ++i) {
      if (!screens[i]) continue;
      note_error(tried[i].error, of_screens[i]->worst(), frame, object, budget);
      if (tried[i].error.over) screens[i].reset();
    }
  };
  compare_with_exact(scene, screens, frames, stop, compared, frame_done);
  for (std::size_t i = 0; i < tried.size(); ++i) tried[i].word_bits = runs[i].range.bits();
  return tried;
}

std::optional<std::size_t> narrowest(const std::vector<TriedFormat>& tried) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < tried.size(); ++i) {
    if (tried[i].error.over) continue;
    if (!best || tried[i].fraction_bits < tried[*best].fraction_bits) best = i;
  }
  return best;
}

int integer_width(int word_bits) {
  for (const int width : {8, 16, 32}) {
    if (word_bits <= width) return width;
  }
  return 64;
}

void to_json(support::Json& json, const FormatReport& report) {
  using support::Json;
  Json formats = Json::array();
  for (const TriedFormat& tried : report.tried) {
    formats.push_back({{"fraction_bits", tried.fraction_bits},
                       {"word_bits", tried.word_bits},
                       {"turning", name_of(tried.turning)},
                       {"worst_pixels", tried.error.pixels},
                       {"worst_frame", tried.error.frame},
                       {"worst_object", tried.error.object},
                       {"first_frame_over", tried.error.over}});
  }
  Json costs = Json::array();
  for (const FormatCost& cost : report.costs) {
    costs.push_back(
        {{"width", cost.width}, {"bytes", cost.bytes}, {"nanoseconds", cost.nanoseconds}});
  }
  Json made = measure::made_by_json("advise --formats");
  made["processor"] = parties::processor_name();
  const auto take = narrowest(report.tried);
  json = {{"made", std::move(made)},       {"scene", report.scene},
          {"frames", report.frames},       {"budget_pixels", report.budget},
          {"formats", std::move(formats)}, {"take", take ? Json(*take) : Json()},
          {"costs", std::move(costs)}};
}

}  // namespace fixproof::trade
