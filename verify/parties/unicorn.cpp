// The Unicorn emulator, which runs the listings as NASM assembles them.
#include <algorithm>
#include <memory>
#include <vector>

#include "verify/machine_code/emulator.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/machine_calls.hpp"
#include "verify/parties/machines.hpp"
#include "verify/parties/parties.hpp"

namespace fixproof::parties {

void answer_on_unicorn(std::span<const std::uint8_t> code, x86model::Routine routine,
                       const Cases& asked) {
  // Other code needs a new emulator, because an emulator caches translated code.
  thread_local std::unique_ptr<machine_code::Emulator> emulator;
  thread_local std::vector<std::uint8_t> loaded;
  if (!emulator || !std::equal(code.begin(), code.end(), loaded.begin(), loaded.end())) {
    emulator.reset();
    loaded.clear();  // if memory runs out below, `loaded` names no code that the emulator lacks
    emulator = std::make_unique<machine_code::Emulator>(code);
    loaded.assign(code.begin(), code.end());
  }
  MachineCalls cases(routine, asked);
  try {
    emulator->run(
        {.count = asked.endings.size(),
         .enter = [&](std::size_t i, machine_code::SegmentMachine& m) { cases.enter(i, m); },
         .leave = [&](std::size_t i, const machine_code::SegmentMachine& m,
                      machine_code::CallEnding ending) { cases.leave(i, m, ending); }});
  } catch (...) {
    // The emulator may have stopped anywhere. The next call gets a new one.
    emulator.reset();
    throw;
  }
}

namespace {

class Unicorn final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "unicorn"; }
  [[nodiscard]] std::string identity() const override {
    return "Unicorn " + machine_code::Emulator::version();
  }
  [[nodiscard]] std::string absence() const override {
    const std::string reason = machine_code::Emulator::absence();
    return reason.empty() ? machine_code::machine_code_absence() : reason;
  }
  [[nodiscard]] bool answers(const cases::Variant& v) const override {
    return has_machine_code(v) && absence().empty();
  }
  void fill(const cases::Variant& v, const Cases& asked) const override {
    const machine_code::ProgramKey key = machine_code::key_of(v);
    answer_on_unicorn(machine_code::machine_code(key), key.routine, asked);
  }
};

}  // namespace

std::unique_ptr<Party> make_unicorn() { return std::make_unique<Unicorn>(); }

}  // namespace fixproof::parties
