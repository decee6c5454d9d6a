// Replaces simavr.cpp if simavr is not installed.
#include <stdexcept>

#include "judge/code/machine.hpp"

namespace fixproof::judge {

std::string absence_on_simavr() {
  return "code for AVR runs on simavr, which this build lacks; install Debian's package "
         "libsimavr-dev and build again";
}

// Callers check absence_on_emulator() first.
std::unique_ptr<Machine> make_simavr(const Image& /*image*/, Trace* /*trace*/) {
  throw std::logic_error(absence_on_simavr());
}

}  // namespace fixproof::judge
