#include "measure/clocks/frame_clocks.hpp"

#include <span>

#include "parties/interpreter.hpp"
#include "x86model/count_clocks.hpp"

namespace fixproof::measure {

namespace {

static_assert(static_cast<int>(cases::Operation::mul) == static_cast<int>(x86model::Routine::mul) &&
              static_cast<int>(cases::Operation::concat) ==
                  static_cast<int>(x86model::Routine::concat));

template <x86model::Routine routine>
void add(FrameClocks& sum, const player::OperandLog& log, const cases::Build& build,
         x86model::Cpu cpu) {
  // OperandLog is indexed by operation, and operations begin with the routines.
  constexpr auto operation = static_cast<cases::Operation>(routine);
  const x86model::Program program = parties::program_of(cases::variant_of(operation, build));
  const std::span<const std::uint32_t> words = log.at(static_cast<std::size_t>(operation));
  const std::size_t in = cases::words_in(operation);
  for (std::size_t i = 0; i + in <= words.size(); i += in) {
    const auto counted =
        x86model::count_clocks<routine>(program.instructions(), words.subspan(i, in), cpu);
    sum += {counted.clocks, counted.bus};
  }
}

}  // namespace

FrameClocks clocks_of(const player::OperandLog& log, const cases::Build& build, x86model::Cpu cpu) {
  using x86model::Routine;
  FrameClocks sum;
  add<Routine::mul>(sum, log, build, cpu);
  add<Routine::div>(sum, log, build, cpu);
  add<Routine::cossin>(sum, log, build, cpu);
  add<Routine::xformvec>(sum, log, build, cpu);
  add<Routine::concat>(sum, log, build, cpu);
  return sum;
}

}  // namespace fixproof::measure
