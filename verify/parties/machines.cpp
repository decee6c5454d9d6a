#include "verify/parties/machines.hpp"

#include <fstream>

#include "support/plain_text.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/parties.hpp"

namespace fixproof::parties {

bool has_machine_code(const cases::Variant& v) {
  return is_routine(v) && v.format == cases::q16_16 &&
         !machine_code::machine_code(machine_code::key_of(v)).empty();
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) {
      return support::printable(line.substr(colon + 2));
    }
  }
  return "unknown";
}

}  // namespace fixproof::parties
