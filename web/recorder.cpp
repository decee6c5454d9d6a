#include "web/recorder.hpp"

#include <algorithm>

#include "x86model/count_clocks.hpp"
#include "x86model/forms.hpp"
#include "x86model/text.hpp"
#include "x86model/with_routine.hpp"

namespace fixproof::web {

namespace {

namespace x86 = x86model;

/// Takes a snapshot after every instruction.
class Recorder {
 public:
  explicit Recorder(Run& run)
      : run_(run),
        counter_(run.program.instructions(),
                 run.target == x86::Target::i386 ? x86::Cpu::i386 : x86::Cpu::i8088) {}

  template <class M>
  void take(std::size_t position, const M& m) {
    Snapshot taken{.position = position, .flags = m.flags, .clocks = counter_.total()};
    for (std::size_t r = 0; r < taken.registers.size(); ++r) {
      taken.registers[r] = m.registers.read(static_cast<x86::Register>(r), x86::Size::dword);
    }
    std::uint32_t word = 0;
    for (std::uint32_t address = 0; m.memory.read(address, word); address += 2) {
      taken.memory.push_back(static_cast<std::uint16_t>(word));
    }
    run_.snapshots.push_back(std::move(taken));
  }

  template <class M>
  void before(std::size_t position, const M& m) {
    if (run_.lacks_instruction) return;
    if (!x86::is_modelled(run_.program.instructions()[position], run_.target)) {
      run_.lacks_instruction = true;
      stopped_ = position;
      return;
    }
    counter_.before(position, m);
  }
  template <class M>
  void operator()(std::size_t position, const M& m) {
    if (run_.lacks_instruction) return;
    counter_(position, m);
    take(position, m);
  }

  /// Returns the position of the instruction that the processor lacks.
  [[nodiscard]] std::size_t stopped() const { return stopped_; }

 private:
  Run& run_;
  x86::ClockCounter counter_;
  std::size_t stopped_ = 0;
};

template <x86::Routine routine>
void run_recorded(Run& run, std::span<const std::uint32_t> in) {
  x86::CallMachine<routine, 16> machine;
  x86::enter<routine>(machine, in);
  Recorder recorder(run);
  recorder.take(0, machine);
  run.ending = x86::run(run.program.instructions(), machine, recorder);
  if (run.lacks_instruction) run.ending.position = recorder.stopped();
  if (run.lacks_instruction || run.ending.outcome != x86::Outcome::returned) return;
  run.result.resize(static_cast<std::size_t>(x86::arity(routine).out));
  x86::leave<routine>(machine, run.result);
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

}  // namespace

std::vector<std::string> builds_of(x86::Routine routine) {
  using enum x86::Routine;
  if (routine == cossin) return {"i386", "i8088", "i8088-printed"};
  std::vector<std::string> builds{"i386-on", "i386-off", "i8088-on", "i8088-off"};
  if (routine == mul || routine == div || routine == concat) builds.emplace_back("i386-52");
  if (routine == concat) builds.emplace_back("i8088-on-repaired");
  if (routine == div) builds.emplace_back("i8088-off-scanned");
  return builds;
}

Run record(x86::Routine routine, std::string_view build, std::span<const std::uint32_t> in) {
  Run run{.name = std::string(build),
          .target = build.starts_with("i386") ? x86::Target::i386 : x86::Target::i8088};
  const bool rounds = !contains(build, "-off");
  run.program = x86::assemble(x86::listing(routine, run.target),
                              {.mul_rounding = rounds,
                               .div_rounding = rounds,
                               .chapter_52 = contains(build, "-52"),
                               .endif_as_scanned = contains(build, "-scanned"),
                               .repaired = contains(build, "-repaired"),
                               .shl_as_printed = contains(build, "-printed")});
  x86::with_routine(routine, [&]<x86::Routine constant> { run_recorded<constant>(run, in); });
  return run;
}

std::size_t first_difference(const Run& a, const Run& b) {
  const auto text = [](const Run& run, std::size_t step) {
    return x86::text_of(run.program.instructions()[run.snapshots[step].position]);
  };
  const std::size_t both = std::min(a.snapshots.size(), b.snapshots.size());
  for (std::size_t step = 1; step < both; ++step) {
    const Snapshot& one = a.snapshots[step];
    const Snapshot& other = b.snapshots[step];
    if (text(a, step) != text(b, step) || one.registers != other.registers ||
        one.flags != other.flags || one.memory != other.memory) {
      return step;
    }
  }
  return a.snapshots.size() == b.snapshots.size() ? 0 : both;
}

}  // namespace fixproof::web
