#include "measure/clocks/frame_clocks.hpp"

#include "measure/clocks/replay.hpp"

namespace fixproof::measure {

FrameClocks clocks_of(const player::OperandLog& log, const cases::Build& build, x86model::Cpu cpu) {
  FrameClocks sum;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const cases::Variant variant = cases::variant_of(static_cast<cases::Operation>(i), build);
    replay_calls(variant, log.at(i), std::span(&cpu, 1), [&sum](const ReplayedCall& call) {
      sum += {call.counters[0].total(), call.counters[0].bus()};
      return true;
    });
  }
  return sum;
}

}  // namespace fixproof::measure
