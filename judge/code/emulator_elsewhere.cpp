// Replaces emulator.cpp if Unicorn is not installed.
#include <stdexcept>

#include "judge/code/machine.hpp"
#include "verify/machine_code/emulator.hpp"

namespace fixproof::judge {

std::string absence_on_unicorn() { return machine_code::Emulator::absence(); }

// Callers check absence_on_unicorn() first.
std::unique_ptr<Machine> make_emulator(const Image& /*image*/, Trace* /*trace*/) {
  throw std::logic_error(absence_on_unicorn());
}

}  // namespace fixproof::judge
