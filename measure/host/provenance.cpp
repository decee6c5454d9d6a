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

support::Json made_by_json(const std::string& command, std::optional<std::uint64_t> seed) {
  support::Json made{{"command", command}};
  if (seed) made["seed"] = *seed;
  made["compiler"] = support::compiler_name();
  made["date"] = date_now();
  return made;
}

}  // namespace fixproof::measure
