#include "measure/clocks/call_clocks.hpp"

#include <array>

#include "cases/plan.hpp"
#include "machine_code/machine_code.hpp"
#include "parties/interpreter.hpp"
#include "x86model/count_clocks.hpp"
#include "x86model/with_routine.hpp"

namespace fixproof::measure {

namespace {

namespace x86 = x86model;

class Counters {
 public:
  Counters(std::span<const x86::Instruction> code, std::span<const x86::Cpu> cpus) {
    for (const x86::Cpu cpu : cpus) each_.emplace_back(code, cpu);
  }
  template <class M>
  void before(std::size_t position, const M& m) {
    for (auto& counter : each_) counter.before(position, m);
  }
  template <class M>
  void operator()(std::size_t position, const M& after) {
    for (auto& counter : each_) counter(position, after);
  }
  [[nodiscard]] x86::Range total(std::size_t i) const { return each_.at(i).total(); }
  [[nodiscard]] std::uint64_t bus(std::size_t i) const { return each_.at(i).bus().clocks(); }

 private:
  std::vector<x86::ClockCounter> each_;
};

template <x86::Routine routine>
void add(CallClocks& clocks, std::span<const std::uint32_t> words, bool typical,
         const std::atomic<bool>& stop) {
  const x86::Program program = parties::program_of(clocks.variant);
  constexpr auto in = static_cast<std::size_t>(x86::arity(routine).in);
  std::array<std::uint32_t, cases::max_words_out> results{};
  const auto out = std::span(results).first(static_cast<std::size_t>(x86::arity(routine).out));
  const Counters none(program.instructions(), processors_of(clocks.variant));
  const auto note = [typical](Spread& spread, x86::Range r) {
    typical ? spread.add(r) : spread.bound(r);
  };
  for (std::size_t i = 0; i + in <= words.size() && !stop; i += in) {
    Counters counters = none;
    const x86::Ending ending =
        x86::call<routine, 16>(program.instructions(), words.subspan(i, in), out, counters);
    if (ending.outcome != x86::Outcome::returned) {
      ++clocks.faults;
      continue;
    }
    note(clocks.instructions, {ending.steps, ending.steps});
    for (std::size_t c = 0; c < clocks.processors.size(); ++c) {
      note(clocks.processors[c].clocks, counters.total(c));
      if (auto& bus = clocks.processors[c].bus) note(*bus, {counters.bus(c), counters.bus(c)});
    }
  }
}

}  // namespace

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
  x86::with_routine(machine_code::key_of(clocks.variant).routine,
                    [&]<x86::Routine routine> { add<routine>(clocks, words, typical, stop); });
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
