// The processor itself: the listings as NASM assembles them, run on the machine that verifies.
#include <algorithm>
#include <vector>

#include "verify/machine_code/machine_code.hpp"
#include "verify/machine_code/processor.hpp"
#include "verify/parties/machine_calls.hpp"
#include "verify/parties/machines.hpp"
#include "verify/parties/parties.hpp"

namespace fixproof {

namespace {

/// The processor of one thread and the code that stands in its segment.
struct Loaded {
  Processor processor;
  std::vector<std::uint8_t> code;
};

}  // namespace

void answer_on_silicon(std::span<const std::uint8_t> code, x86model::Routine routine,
                       const Batch& batch) {
  thread_local Loaded loaded;
  if (!std::equal(code.begin(), code.end(), loaded.code.begin(), loaded.code.end())) {
    loaded.code.clear();
    loaded.processor.load(code);
    loaded.code.assign(code.begin(), code.end());
  }
  MachineCalls cases(routine, batch);
  const Processor::Calls calls(loaded.processor);
  SegmentMachine m(loaded.processor.memory());
  for (std::size_t i = 0; i < batch.endings.size(); ++i) {
    cases.enter(i, m);
    const CallEnding ending = calls.call(m);
    cases.leave(i, m, ending);
  }
}

namespace {

class Silicon final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "silicon"; }
  [[nodiscard]] std::string absence() const override {
    const std::string reason = machine_code_absence();
    return reason.empty() ? Processor::absence() : reason;
  }
  [[nodiscard]] bool answers(const Variant& v) const override {
    return has_machine_code(v) && absence().empty();
  }
  void answer(const Variant& v, const Batch& batch) const override {
    const ProgramKey key = key_of(v);
    answer_on_silicon(machine_code(key), key.routine, batch);
  }
};

}  // namespace

std::unique_ptr<Party> make_silicon() { return std::make_unique<Silicon>(); }

}  // namespace fixproof
