// The host processor, which runs the listings as NASM assembles them.
#include <algorithm>
#include <vector>

#include "verify/machine_code/machine_code.hpp"
#include "verify/machine_code/processor.hpp"
#include "verify/parties/machine_calls.hpp"
#include "verify/parties/machines.hpp"
#include "verify/parties/parties.hpp"

namespace fixproof::parties {

namespace {

struct Loaded {
  machine_code::Processor processor;
  std::vector<std::uint8_t> code;
};

}  // namespace

void answer_on_silicon(std::span<const std::uint8_t> code, x86model::Routine routine,
                       const Cases& asked) {
  thread_local Loaded loaded;
  if (!std::equal(code.begin(), code.end(), loaded.code.begin(), loaded.code.end())) {
    loaded.code.clear();
    loaded.processor.load(code);
    loaded.code.assign(code.begin(), code.end());
  }
  MachineCalls cases(routine, asked);
  const machine_code::Processor::Calls calls(loaded.processor);
  machine_code::SegmentMachine m(loaded.processor.memory());
  for (std::size_t i = 0; i < asked.endings.size(); ++i) {
    cases.enter(i, m);
    const machine_code::CallEnding ending = calls.call(m);
    cases.leave(i, m, ending);
  }
}

namespace {

class Silicon final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "silicon"; }
  [[nodiscard]] std::string identity() const override { return processor_name(); }
  [[nodiscard]] std::string absence() const override {
    const std::string reason = machine_code::machine_code_absence();
    return reason.empty() ? machine_code::Processor::absence() : reason;
  }
  [[nodiscard]] bool answers(const cases::Variant& v) const override {
    return has_machine_code(v) && absence().empty();
  }
  void fill(const cases::Variant& v, const Cases& asked) const override {
    const machine_code::ProgramKey key = machine_code::key_of(v);
    answer_on_silicon(machine_code::machine_code(key), key.routine, asked);
  }
};

}  // namespace

std::unique_ptr<Party> make_silicon() { return std::make_unique<Silicon>(); }

}  // namespace fixproof::parties
