#include "measure/clocks/replay.hpp"

#include <array>

#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/interpreter.hpp"
#include "x86model/with_routine.hpp"

namespace fixproof::measure {

namespace {

namespace x86 = x86model;

struct Observer {
  std::vector<x86::ClockCounter> counters;
  std::vector<bool> executed;

  template <class M>
  void before(std::size_t position, const M& m) {
    for (x86::ClockCounter& counter : counters) counter.before(position, m);
  }
  template <class M>
  void operator()(std::size_t position, const M& after) {
    for (x86::ClockCounter& counter : counters) counter(position, after);
    executed[position] = true;
  }
};

}  // namespace

std::vector<bool> replay_calls(const cases::Variant& variant, std::span<const std::uint32_t> words,
                               std::span<const x86::Cpu> cpus,
                               const std::function<bool(const ReplayedCall&)>& visit) {
  const x86::Program program = parties::program_of(variant);
  const auto code = program.instructions();
  std::vector<x86::ClockCounter> fresh;
  for (const x86::Cpu cpu : cpus) fresh.emplace_back(code, cpu);
  Observer observer{{}, std::vector<bool>(code.size())};
  std::array<std::uint32_t, cases::max_words_out> results{};
  const auto out = std::span(results).first(cases::words_out(variant.operation));
  const std::size_t step = cases::words_in(variant.operation);
  for (std::size_t i = 0; i + step <= words.size(); i += step) {
    const auto in = words.subspan(i, step);
    observer.counters = fresh;
    const auto ending = x86::with_routine(
        machine_code::key_of(variant).routine,
        [&]<x86::Routine routine> { return x86::call<routine, 16>(code, in, out, observer); });
    if (!visit({in, out, ending, observer.counters})) break;
  }
  return observer.executed;
}

}  // namespace fixproof::measure
