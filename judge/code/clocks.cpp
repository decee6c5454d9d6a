#include "judge/code/clocks.hpp"

#include <algorithm>
#include <map>

#include "judge/check/cases.hpp"
#include "judge/code/clock_table.hpp"
#include "judge/code/inspection.hpp"

namespace fixproof::judge {

namespace {

class Counter {
 public:
  explicit Counter(const Subject& subject)
      : subject_(subject), tracer_(subject), listing_(subject.image) {
    for (std::size_t i = 0; i < clocks_.on.size(); ++i) {
      clocks_.on.at(i).cpu = static_cast<x86model::Cpu>(i);
    }
  }

  void count(std::span<const std::uint32_t> words) {
    const auto call = tracer_.call(words);
    if (!call || call->answer.ending.end != End::returned) return;
    ++clocks_.calls;
    const Trace& trace = call->trace;
    std::uint64_t code = 0;
    for (const Step& step : trace.steps) code += step.bytes;
    std::uint64_t data = 0;
    for (const Access& access : trace.accesses) data += access.bytes;
    clocks_.instructions.add({trace.steps.size(), trace.steps.size()});
    clocks_.code_bytes.add({code, code});
    clocks_.data_bytes.add({data, data});
    for (auto& on : clocks_.on) count_on(on, trace);
  }

  RoutineClocks result() {
    for (auto& on : clocks_.on) {
      if (!on.without.empty()) on.clocks = {};
      std::ranges::sort(on.without, {}, &Line::at);
    }
    return clocks_;
  }

 private:
  void count_on(RoutineClocks::OnCpu& on, const Trace& trace) {
    x86model::Range sum;
    std::size_t access = 0;
    TimedStep step;
    for (std::size_t i = 0; i < trace.steps.size(); ++i) {
      const Step& here = trace.steps[i];
      const bool is_last = i + 1 == trace.steps.size();
      step.previous = step.line;
      step.line = &line_at(here);
      step.next = is_last ? nullptr : &line_at(trace.steps[i + 1]);
      step.registers = here.registers;
      step.taken = is_taken(*step.line, here.registers);
      step.memory = 0;
      while (access < trace.accesses.size() && trace.accesses[access].step < i) ++access;
      if (access < trace.accesses.size() && trace.accesses[access].step == i) {
        step.memory = trace.accesses[access].value;
      }
      if (const auto clocks = clocks_of(on.cpu, step, subject_.image.bits)) {
        sum += *clocks;
        continue;
      }
      on.is_too_wide |= is_too_wide(on.cpu, *step.line, subject_.image.bits);
      const bool is_new =
          std::ranges::none_of(on.without, [&](const Line& known) { return known.at == here.at; });
      if (is_new) on.without.push_back(step.line->line);
    }
    on.clocks.add(sum);
  }

  const TimedLine& line_at(const Step& step) {
    const auto known = lines_.find(step.at);
    if (known != lines_.end()) return known->second;
    const std::uint32_t at = subject_.image.index_of(subject_.image.code_at(step.at));
    // An instruction may reach beyond the end of a segment.
    const auto& memory = subject_.image.memory;
    const std::size_t first = std::min<std::size_t>(at, memory.size());
    const auto bytes =
        std::span(memory).subspan(first, std::min<std::size_t>(step.bytes, memory.size() - first));
    Line line = listing_.at(step.at);
    line.bytes = step.bytes;
    return lines_.emplace(step.at, timed_line(line, decoded(bytes, step.at, subject_.image.bits)))
        .first->second;
  }

  const Subject& subject_;
  Tracer tracer_;
  Listing listing_;
  std::map<std::uint32_t, TimedLine> lines_;
  RoutineClocks clocks_;
};

}  // namespace

void Spread::add(x86model::Range one) {
  least_ = calls_ == 0 ? one.min : std::min(least_, one.min);
  most_ = std::max(most_, one.max);
  sum_ += one;
  ++calls_;
}

RoutineClocks count_clocks(const Subject& subject) {
  Counter counter(subject);
  check::GeneratedCases cases(subject.variant, {.cases = calls_to_inspect});
  std::vector<std::uint32_t> words(words_in(subject.variant));
  while (cases.next(words)) counter.count(words);
  return counter.result();
}

}  // namespace fixproof::judge
