#include "verify/parties/machine_calls.hpp"

namespace fixproof::parties {

namespace {

Ending ending_after(machine_code::CallEnding ending) {
  switch (ending) {
    case machine_code::CallEnding::returned:
      return Ending::value;
    case machine_code::CallEnding::divide_error:
      return Ending::divide_error;
    case machine_code::CallEnding::fault:
      break;
  }
  return Ending::broken;
}

}  // namespace

MachineCalls::MachineCalls(x86model::Routine routine, const Cases& asked)
    : frame_(machine_code::frame_of(routine)),
      in_(static_cast<std::size_t>(x86model::arity(routine).in)),
      out_(static_cast<std::size_t>(x86model::arity(routine).out)),
      asked_(asked) {}

void MachineCalls::enter(std::size_t i, machine_code::SegmentMachine& m) {
  thread_local std::uint64_t number = 0;
  frame_.enter(m, asked_.in.subspan(i * in_, in_));
  machine_code::scramble(m, frame_, number++);
  entered_ = m.registers;
}

void MachineCalls::leave(std::size_t i, const machine_code::SegmentMachine& m,
                         machine_code::CallEnding ending) {
  Ending& said = asked_.endings[i];
  said = ending_after(ending);
  if (said != Ending::value) return;
  if (!machine_code::kept_for_caller(entered_, m.registers)) said = Ending::broken;
  frame_.leave(m, asked_.out.subspan(i * out_, out_));
}

}  // namespace fixproof::parties
