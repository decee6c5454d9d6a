// Replaces emulator.cpp if Unicorn is not installed.
#include <stdexcept>

#include "verify/machine_code/emulator.hpp"

namespace fixproof::machine_code {

struct Emulator::Parts {};

std::string Emulator::absence() { return "this fixproof was built without Unicorn 2"; }
std::string Emulator::version() { return "none"; }

// Callers check absence() first.
Emulator::Emulator(std::span<const std::uint8_t> /*code*/) { throw std::logic_error(absence()); }
Emulator::~Emulator() = default;
// NOLINTBEGIN(readability-convert-member-functions-to-static): the other emulator has a state
std::uint8_t* Emulator::memory() const { return nullptr; }
void Emulator::run(const Calls& /*calls*/) {}
CallEnding Emulator::trace(SegmentMachine& /*m*/, const Step& /*step*/, std::size_t /*limit*/) {
  return CallEnding::fault;
}
// NOLINTEND(readability-convert-member-functions-to-static)

}  // namespace fixproof::machine_code
