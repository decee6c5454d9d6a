#include "measure/clocks/clocks.hpp"

#include <utility>

#include "measure/clocks/claim_clocks.hpp"
#include "measure/clocks/frame_clocks.hpp"
#include "measure/host/provenance.hpp"
#include "support/thread_pool.hpp"
#include "verify/machine_code/programs.hpp"
#include "x86model/text.hpp"

namespace fixproof::measure {

namespace {

using support::Json;

constexpr std::uint64_t default_cases = 1000;
/// Transforms get a tenth of the cases, because they have up to 36 products each.
constexpr std::uint64_t transforms_share = 10;

/// The log of the build that the variant belongs to.
const player::OperandLog& log_of(const RecordedScene& scene, const cases::Variant& variant) {
  const bool round = cases::rounds(variant);
  return operands_of(scene, {variant.build.target, round, round}).log;
}

std::vector<FrameOn8088> frames_on_8088(const std::vector<RecordedScene>& scenes) {
  std::vector<FrameOn8088> all;
  for (const RecordedScene& scene : scenes) {
    for (const SceneOperands& operands : scene.builds) {
      if (operands.build.target != cases::Target::i8088) continue;
      const FrameClocks clocks = clocks_of(operands.log, operands.build, x86model::Cpu::i8088);
      const auto frames = static_cast<double>(operands.frames);
      all.push_back({scene.name, operands.build.mul_round,
                     static_cast<double>(clocks.bus.code) / frames,
                     static_cast<double>(clocks.bus.data) / frames, clocks.per_frame(frames)});
    }
  }
  return all;
}

}  // namespace

static void to_json(Json& json, const Spread& s) {
  json = {{"least", s.least()}, {"most", s.most()}, {"calls", s.calls()}};
  if (s.calls() > 0) json["mean"] = {{"min", s.mean_min()}, {"max", s.mean_max()}};
}

static void to_json(Json& json, const ProcessorClocks& on) {
  json = {{"cpu", x86model::name_of(on.cpu)}, {"clocks", on.clocks}};
  if (!on.bus) return;
  json["bus"] = on.bus;
  json["limit"] = on.mean().limit();
}

static void to_json(Json& json, const CallClocks& row) {
  json = {{"routine", cases::name_of(row.variant.operation)},
          {"target", cases::name_of(row.variant.build.target)},
          {"chapter", row.variant.build.chapter_52 ? 52 : 54},
          {"rounds", cases::rounds(row.variant)},
          {"instructions", row.instructions},
          {"processors", row.processors},
          {"faults", row.faults}};
}

static void to_json(Json& json, const NotJudged& statement) {
  json = {{"claim", statement.text}, {"place", statement.place}, {"reason", statement.reason}};
}

static void to_json(Json& json, const FrameOn8088& f) {
  json = {{"scene", f.scene},           {"rounds", f.rounds},         {"table", f.clocks.table.max},
          {"code_bytes", f.code_bytes}, {"data_bytes", f.data_bytes}, {"bus", f.clocks.bus},
          {"limit", f.clocks.limit()}};
}

static void to_json(Json& json, const LoopClocks& row) {
  Json processors = Json::array();
  for (std::size_t i = 0; i < row.on.size(); ++i) {
    const auto& clocks = row.on.at(i);
    if (!clocks) continue;
    const x86model::Cpu cpu = loop_processors.at(i);
    Json on{
        {"cpu", x86model::name_of(cpu)}, {"min", clocks->table.min}, {"max", clocks->table.max}};
    if (cpu == x86model::Cpu::i8088) on["bus"] = clocks->bus;
    processors.push_back(std::move(on));
  }
  json = {{"loop", machine_code::name_of_loop(row.form.loop)},
          {"counting", x86model::name_of(row.form.counting)},
          {"target", target_name(row.form)},
          {"as_printed", row.form.as_printed},
          {"pixels", row.pixels == Pixels::drawn ? "drawn" : "hidden"},
          {"clocks", std::move(processors)}};
}

static void to_json(Json& json, const LoopGain& gain) {
  json = {{"where", gain.where}, {"min", gain.min}, {"max", gain.max}};
}

static void to_json(Json& json, const LoopClaim& claim) {
  json = {{"claim", claim.text}, {"place", claim.place}, {"gains", claim.gains}};
}

std::optional<ClockResult> measure_clocks(const MeasureRequest& request,
                                          MeasureProgress& progress) {
  const std::atomic<bool>& stop = progress.stop();
  const std::vector<cases::Variant> variants = timed_variants();
  const auto builds = recorded_builds();
  ClockResult result;
  result.seed = request.seed;
  progress.begin(request.scenes.size() * builds.size() + variants.size(), "parts");
  std::vector<RecordedScene> scenes;
  for (const xsharp::Scene& scene : request.scenes) {
    scenes.push_back({scene.name, std::vector<SceneOperands>(builds.size())});
    result.scenes.push_back(scene.name);
  }
  support::for_each_in_threads(scenes.size() * builds.size(), [&](std::size_t i) {
    const std::size_t scene = i / builds.size();
    const std::size_t build = i % builds.size();
    if (stop) return;
    scenes[scene].builds[build] = record_scene(request.scenes[scene], builds.at(build), stop);
    if (!stop) progress.add_part();
  });
  const std::uint64_t cases = request.cases.value_or(default_cases);
  result.rows.resize(variants.size());
  support::for_each_in_threads(variants.size(), [&](std::size_t i) {
    if (stop) return;
    const cases::Variant& variant = variants[i];
    CallClocks& row = result.rows[i];
    row = no_calls(variant);
    const bool transforms = cases::words_in(variant.operation) > 2;
    add_cases(row, request.seed, transforms ? cases / transforms_share + 1 : cases, scenes.empty(),
              stop);
    for (const RecordedScene& scene : scenes) {
      add_calls(row, log_of(scene, variant).at(static_cast<std::size_t>(variant.operation)), true,
                stop);
    }
    if (!stop) progress.add_part();
  });
  if (stop) return std::nullopt;
  if (!scenes.empty()) result.claims = judge_claims(scenes);
  result.frames = frames_on_8088(scenes);
  result.loops = loop_clocks();
  result.loop_claims = loop_claims();
  return result;
}

void to_json(Json& json, const ClockResult& result) {
  json = {{"made", made_by_json("measure --clocks", result.seed)},
          {"scenes", result.scenes},
          {"clocks", result.rows},
          {"claims", result.claims},
          {"not_judged", not_judged()},
          {"frames_8088", result.frames},
          {"loops", {{"pixels", result.loops}, {"claims", result.loop_claims}}}};
}

}  // namespace fixproof::measure
