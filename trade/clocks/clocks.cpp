// fixproof measure --clocks.
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>

#include "support/file.hpp"
#include "support/frame_progress.hpp"
#include "support/interrupt.hpp"
#include "support/json_text.hpp"
#include "support/plain_text.hpp"
#include "trade/clocks/call_clocks.hpp"
#include "trade/clocks/claim_clocks.hpp"
#include "trade/clocks/claim_text.hpp"
#include "trade/clocks/claims.hpp"
#include "trade/clocks/frame_clocks.hpp"
#include "trade/clocks/span_clocks.hpp"
#include "trade/figures.hpp"
#include "trade/host/provenance.hpp"
#include "trade/measure.hpp"

namespace fixproof::trade {

namespace {

using ClockJson = nlohmann::ordered_json;

constexpr std::uint64_t default_cases = 1000;
/// A transform takes up to 36 products.
constexpr std::uint64_t transforms_share = 10;

void print(const CallClocks& row) {
  for (const ProcessorClocks& on : row.processors) {
    const bool has_switch = row.variant.operation != cases::Operation::cossin;
    const auto mean = [](const Spread& s) {
      return s.calls() == 0 ? "-" : between(s.mean_min(), s.mean_max(), 1);
    };
    std::string bus;
    if (on.bus) bus = fmt::format("  {:>9}  {}", mean(*on.bus), on.bus_limits() ? "bus" : "table");
    std::cout << fmt::format("{:<8}  {:<10}  {:<8}  {:<4}  {:>6}{:>9}{:>7}  {:>7}{:>15}{:>8}{}\n",
                             cases::name_of(row.variant.operation),
                             fmt::format("{}{}", cases::name_of(row.variant.build.target),
                                         row.variant.build.chapter_52 ? " ch52" : ""),
                             !has_switch                  ? "-"
                             : cases::rounds(row.variant) ? "on"
                                                          : "off",
                             x86model::name_of(on.cpu), support::grouped(row.instructions.least()),
                             mean(row.instructions), support::grouped(row.instructions.most()),
                             support::grouped(on.clocks.least()), mean(on.clocks),
                             support::grouped(on.clocks.most()), bus);
  }
}

ClockJson json_of(const Spread& s) {
  ClockJson json{{"least", s.least()}, {"most", s.most()}, {"calls", s.calls()}};
  if (s.calls() > 0) json["mean"] = {{"min", s.mean_min()}, {"max", s.mean_max()}};
  return json;
}

ClockJson json_of(const CallClocks& row) {
  ClockJson processors = ClockJson::array();
  for (const ProcessorClocks& on : row.processors) {
    ClockJson one{{"cpu", x86model::name_of(on.cpu)}, {"clocks", json_of(on.clocks)}};
    if (on.bus) {
      one["bus"] = json_of(*on.bus);
      one["limit"] = on.bus_limits() ? "bus" : "table";
    }
    processors.push_back(std::move(one));
  }
  return {{"routine", cases::name_of(row.variant.operation)},
          {"target", cases::name_of(row.variant.build.target)},
          {"chapter", row.variant.build.chapter_52 ? 52 : 54},
          {"rounds", cases::rounds(row.variant)},
          {"instructions", json_of(row.instructions)},
          {"processors", std::move(processors)},
          {"faults", row.faults}};
}

/// The log of the build that a variant stands for.
const player::OperandLog& log_of(const RecordedScene& scene, const cases::Variant& variant) {
  const bool round = cases::rounds(variant);
  return operands_of(scene, {variant.build.target, round, round}).log;
}

/// What the listings take of a frame on an 8088, on average.
struct FrameOn8088 {
  std::string scene;
  bool rounds = true;
  double table = 0;
  double code = 0;  ///< bytes
  double data = 0;  ///< bytes
  double bus = 0;   ///< clocks
};

std::vector<FrameOn8088> frames_on_8088(const std::vector<RecordedScene>& scenes) {
  std::vector<FrameOn8088> all;
  for (const RecordedScene& scene : scenes) {
    for (const SceneOperands& operands : scene.builds) {
      if (operands.build.target != cases::Target::i8088) continue;
      const FrameClocks clocks = clocks_of(operands.log, operands.build, x86model::Cpu::i8088);
      const auto a_frame = [&operands](std::uint64_t sum) {
        return static_cast<double>(sum) / static_cast<double>(operands.frames);
      };
      all.push_back({scene.name, operands.build.mul_round, a_frame(clocks.table.max),
                     a_frame(clocks.bus.code), a_frame(clocks.bus.data),
                     a_frame(clocks.bus.clocks())});
    }
  }
  return all;
}

const char* limit_of(const FrameOn8088& frame) { return frame.bus > frame.table ? "bus" : "table"; }

void print(const std::vector<FrameOn8088>& frames) {
  const auto whole = [](double x) { return support::grouped(static_cast<std::uint64_t>(x)); };
  std::cout << fmt::format(
      "\nA frame on an 8088: the clocks of the listings by Intel's table, bytes and clocks of the "
      "bus, and\nwhich of the two limits.\n\n{:<22}{:<10}{:>12}{:>10}{:>10}{:>12}  {}\n",
      "scene", "rounding", "table", "code", "data", "bus", "limit");
  for (const FrameOn8088& f : frames) {
    std::cout << fmt::format("{:<22}{:<10}{:>12}{:>10}{:>10}{:>12}  {}\n",
                             support::printable(f.scene), f.rounds ? "on" : "off", whole(f.table),
                             whole(f.code), whole(f.data), whole(f.bus), limit_of(f));
  }
}

ClockJson json_of(const std::vector<FrameOn8088>& frames) {
  ClockJson json = ClockJson::array();
  for (const FrameOn8088& f : frames) {
    json.push_back({{"scene", f.scene},
                    {"rounds", f.rounds},
                    {"table", f.table},
                    {"code_bytes", f.code},
                    {"data_bytes", f.data},
                    {"bus", f.bus},
                    {"limit", limit_of(f)}});
  }
  return json;
}

class ClockRun {
 public:
  explicit ClockRun(const MeasureRequest& request)
      : request_(request),
        variants_(timed_variants()),
        all_(request.scenes.size() * recorded_builds().size() + variants_.size()),
        progress_(std::in_place, all_, "parts") {}

  /// @return false where it was stopped before its time
  bool run() {
    for (const xsharp::Scene& scene : read_scenes(request_)) record(scene);
    for (const cases::Variant& variant : variants_) {
      CallClocks row = no_calls(variant);
      const std::uint64_t cases = request_.cases.value_or(default_cases);
      const bool transforms = cases::words_in(variant.operation) > 2;
      add_cases(row, request_.seed, transforms ? cases / transforms_share + 1 : cases,
                scenes_.empty(), stop_);
      for (const RecordedScene& scene : scenes_) {
        add_calls(row, log_of(scene, variant).at(static_cast<std::size_t>(variant.operation)), true,
                  stop_);
      }
      if (stop_) return false;
      rows_.push_back(std::move(row));
      done();
    }
    if (!scenes_.empty()) claims_ = judge_claims(scenes_);
    frames_ = frames_on_8088(scenes_);
    progress_.reset();
    return !stop_;
  }

  void print_all() const {
    std::cout << made_by(request_.seed) << "\n\n";
    if (scenes_.empty()) {
      std::cout
          << "Means are over the cases of level 1: without a SCENE there are no operands of a "
             "scene,\nand no claim is judged.\n";
    } else {
      std::cout << "Means are over the operands of";
      for (const RecordedScene& scene : scenes_) {
        std::cout << fmt::format("{} {}", &scene == scenes_.data() ? "" : ",",
                                 support::printable(scene.name));
      }
      std::cout << fmt::format(", {} frames of each.\n", recorded_frames);
    }
    std::cout
        << "Least and most are those seen in these and in cases of level 1. Two numbers: "
           "Intel's tables give\na range. The caller's PUSHes and CALL are not counted; calls "
           "that end in #DE are left out.\n"
           "Bus: the mean clocks that an 8088 needs for the bytes of code and data, 4 for each. "
           "Its "
           "bus fetches while\nit executes, so a call takes at least the larger of the two means. "
           "The column limit names it. Code that\nis fetched and discarded at a jump is not "
           "counted. Only an 8088 has bus time here: others have wider buses.\n\n";
    std::cout << fmt::format("{:<8}  {:<10}  {:<8}  {:<4}  {:>22}  {:>30}\n", "", "", "", "",
                             "instructions", "clocks");
    std::cout << fmt::format(
        "{:<8}  {:<10}  {:<8}  {:<4}  {:>6}{:>9}{:>7}  {:>7}{:>15}{:>8}  {:>9}  {}\n", "routine",
        "target", "rounding", "cpu", "least", "mean", "most", "least", "mean", "most", "bus",
        "limit");
    for (const CallClocks& row : rows_) print(row);
    if (!scenes_.empty()) print(frames_);
    if (!claims_.empty()) {
      std::cout << "\nWhat is published, and what the listings alone show. \"About\" allows a "
                   "fifth less and a quarter more;\nopen: the ranges of Intel's tables leave both "
                   "possible, or the listings cannot decide.\n";
    }
    for (const Claim& claim : claims_) print_claim(claim);
    if (!claims_.empty()) print_not_judged();
    std::cout << '\n' << span_clocks_text();
  }

  void write_json() const {
    ClockJson json{{"made", made_by_json(request_.seed, "measure --clocks")}};
    json["scenes"] = ClockJson::array();
    for (const RecordedScene& scene : scenes_) json["scenes"].push_back(scene.name);
    json["clocks"] = ClockJson::array();
    for (const CallClocks& row : rows_) json["clocks"].push_back(json_of(row));
    json["claims"] = ClockJson::array();
    for (const Claim& claim : claims_) json["claims"].push_back(json_of_claim(claim));
    json["not_judged"] = not_judged_json();
    json["frames_8088"] = json_of(frames_);
    json["loops"] = span_clocks_json();
    support::replace_file(request_.json, support::json_text(json));
  }

  [[nodiscard]] std::string how_far() const {
    return fmt::format("STOPPED after {} of {} parts{}\n", done_, all_,
                       request_.json.empty() ? "" : "; " + request_.json + " is not written");
  }

 private:
  void record(const xsharp::Scene& scene) {
    RecordedScene recorded{scene.name, {}};
    for (const cases::Build& build : recorded_builds()) {
      if (stop_) return;
      recorded.builds.push_back(record_scene(scene, build, stop_));
      done();
    }
    scenes_.push_back(std::move(recorded));
  }

  void done() { progress_->show(++done_); }

  const MeasureRequest& request_;
  const support::Interrupt interrupt_;
  const std::atomic<bool>& stop_ = support::Interrupt::flag();
  std::vector<cases::Variant> variants_;
  std::uint64_t all_;
  std::optional<support::FrameProgress> progress_;  ///< until all is done
  std::uint64_t done_ = 0;
  std::vector<RecordedScene> scenes_;
  std::vector<CallClocks> rows_;
  std::vector<Claim> claims_;
  std::vector<FrameOn8088> frames_;
};

}  // namespace

int measure_clocks(const MeasureRequest& request) {
  ClockRun run(request);
  if (!run.run()) {
    std::cout << run.how_far();
    return support::interrupted_status;
  }
  run.print_all();
  if (!request.json.empty()) run.write_json();
  return 0;
}

}  // namespace fixproof::trade
