// Replaces emulator.cpp if Unicorn is not installed.
#include <stdexcept>

#include "judge/code/machine.hpp"
#include "verify/machine_code/emulator.hpp"

namespace fixproof::judge {

std::string absence_on_unicorn() { return machine_code::Emulator::absence(); }
std::string absence_on_emulator(const Architecture* /*architecture*/) { return {}; }

// Callers check absence_on_unicorn() first.
std::unique_ptr<Machine> make_emulator(const Image& /*image*/, Trace* /*trace*/) {
  throw std::logic_error(absence_on_unicorn());
}

// No image has a processor other than x86.
RegisterFile::RegisterFile(const Architecture& /*architecture*/) {}
std::optional<std::size_t> RegisterFile::find(std::string_view /*name*/) const { return {}; }
std::vector<std::size_t> RegisterFile::all(std::string_view /*names*/) const { return {}; }
const Architecture* architecture_of_elf(std::string_view /*bytes*/) { return nullptr; }
unsigned kind_of_elf(const Architecture& /*architecture*/, std::string_view /*bytes*/) { return 0; }
std::string_view emulator_of(const Architecture* /*architecture*/) { return "Unicorn"; }
std::string names_of_architectures() { return {}; }

}  // namespace fixproof::judge
