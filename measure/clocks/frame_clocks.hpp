/// @file
/// The clocks of the listings' calls on old processors.
#pragma once

#include "measure/clocks/bounds.hpp"
#include "measure/player/model_call.hpp"
#include "verify/cases/variant.hpp"
#include "x86model/bus.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::measure {

/// The clocks of calls: of the listings alone, without the C around them.
struct FrameClocks {
  x86model::Range table;   ///< by Intel's tables, which give ranges in places
  x86model::BusBytes bus;  ///< on an 8088; see x86model/bus.hpp

  [[nodiscard]] Clocks per_frame(double frames) const {
    return {{static_cast<double>(table.min) / frames, static_cast<double>(table.max) / frames},
            static_cast<double>(bus.clocks()) / frames};
  }
  FrameClocks& operator+=(const FrameClocks& other) {
    table += other.table;
    bus += other.bus;
    return *this;
  }
};

/// Counts the clocks of the calls in a log.
/// @param build the listings that made the calls
/// @throws std::invalid_argument if `cpu` cannot run the listings
FrameClocks clocks_of(const player::OperandLog& log, const cases::Build& build, x86model::Cpu cpu);

}  // namespace fixproof::measure
