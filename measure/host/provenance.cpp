#include "measure/host/provenance.hpp"

#include <fmt/chrono.h>

#include <ctime>

#include "support/build_info/build_info.hpp"
#include "support/json.hpp"

namespace fixproof::measure {

std::string compiler_flags() { return FIXPROOF_COMPILER_FLAGS; }

std::string date_now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

support::Json made_by_json(std::uint64_t seed, const std::string& command) {
  return {{"command", command},
          {"seed", seed},
          {"compiler", support::compiler_name()},
          {"date", date_now()}};
}

support::Json made_by_json(const std::string& command) {
  support::Json made = made_by_json(0, command);
  made.erase("seed");
  return made;
}

}  // namespace fixproof::measure
