#include "measure/clocks/call_clocks.hpp"

#include <array>

#include "measure/clocks/replay.hpp"
#include "verify/cases/plan.hpp"

namespace fixproof::measure {

namespace x86 = x86model;

std::span<const x86::Cpu> processors_of(const cases::Variant& variant) {
  static constexpr std::array all{x86::Cpu::i8088, x86::Cpu::i286, x86::Cpu::i386, x86::Cpu::i486};
  const std::span<const x86::Cpu> cpus = all;
  return variant.build.target == cases::Target::i8088 ? cpus : cpus.last(2);
}

std::vector<cases::Variant> timed_variants() {
  std::vector<cases::Variant> timed;
  for (const cases::Variant& v : cases::all_variants()) {
    const bool second_of_two = v.operation == cases::Operation::cossin && !v.build.mul_round;
    // Chapter 52 has ConcatXforms in C. Its assembly is ours and has no published time.
    const bool ours = v.build.chapter_52 && v.operation == cases::Operation::concat;
    // The repaired ConcatXforms replaces ADD with ADC, which takes as long.
    if (v.build.target != cases::Target::standard && !second_of_two && !ours && !v.build.repaired)
      timed.push_back(v);
  }
  return timed;
}

CallClocks no_calls(const cases::Variant& variant) {
  CallClocks clocks{.variant = variant};
  for (const x86::Cpu cpu : processors_of(variant)) {
    ProcessorClocks on{.cpu = cpu};
    if (cpu == x86::Cpu::i8088) on.bus.emplace();
    clocks.processors.push_back(on);
  }
  return clocks;
}

void add_calls(CallClocks& clocks, std::span<const std::uint32_t> words, bool typical,
               const std::atomic<bool>& stop) {
  const auto note = [typical](Spread& spread, x86::Range r) {
    typical ? spread.add(r) : spread.bound(r);
  };
  replay_calls(clocks.variant, words, processors_of(clocks.variant), [&](const ReplayedCall& call) {
    if (call.ending.outcome != x86::Outcome::returned) {
      ++clocks.faults;
      return !stop;
    }
    note(clocks.instructions, {call.ending.steps, call.ending.steps});
    for (std::size_t i = 0; i < call.counters.size(); ++i) {
      const std::uint64_t of_bus = call.counters[i].bus().clocks();
      note(clocks.processors[i].clocks, call.counters[i].total());
      if (auto& bus = clocks.processors[i].bus) note(*bus, {of_bus, of_bus});
    }
    return !stop;
  });
}

void add_cases(CallClocks& clocks, std::uint64_t seed, std::uint64_t cases, bool typical,
               const std::atomic<bool>& stop) {
  // A plan only makes jobs for rows with two parties. The names are placeholders.
  const cases::Plan plan(1, seed, {{clocks.variant, {"one", "another"}}});
  std::vector<std::uint32_t> words;
  for (const cases::Job& job : plan.jobs()) {
    const bool whole = cases::size_of(job.stream, clocks.variant).has_value();
    const std::uint64_t count = whole ? job.cases : std::min(cases, job.cases);
    words.resize(count * cases::words_in(clocks.variant.operation));
    cases::make_cases(job.stream, clocks.variant, seed, 0, words);
    add_calls(clocks, words, typical, stop);
  }
}

}  // namespace fixproof::measure
