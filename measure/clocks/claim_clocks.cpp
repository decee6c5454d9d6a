#include "measure/clocks/claim_clocks.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>

#include "measure/clocks/frame_clocks.hpp"

namespace fixproof::measure {

const SceneOperands& operands_of(const RecordedScene& scene, const cases::Build& build) {
  for (const SceneOperands& operands : scene.builds) {
    if (operands.build == build) return operands;
  }
  throw std::out_of_range("the build is not recorded");
}

Bounds clocks_per_frame(const RecordedScene& scene, const cases::Build& build, x86model::Cpu cpu,
                        Fetching fetching) {
  const SceneOperands& operands = operands_of(scene, build);
  const FrameClocks clocks = clocks_of(operands.log, operands.build, cpu);
  const auto frames = static_cast<double>(operands.frames);
  if (fetching == Fetching::meanwhile) return clocks.per_frame(frames).at_least();
  const std::uint64_t code = x86model::bus_clocks_per_byte * clocks.bus.code;
  return {static_cast<double>(clocks.table.min + code) / frames,
          static_cast<double>(clocks.table.max + code) / frames};
}

Bounds ratio(const Bounds& a, const Bounds& b) { return {a.min / b.max, a.max / b.min}; }

void add_figure(Claim& claim, std::string where, const Bounds& measured, Evidence evidence) {
  // A ratio is not finite if the scene never calls the routine.
  if (!std::isfinite(measured.min) || !std::isfinite(measured.max)) return;
  claim.figures.push_back({std::move(where), measured, judge(measured, claim.allowed, evidence)});
}

}  // namespace fixproof::measure
