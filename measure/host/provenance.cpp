#include "measure/host/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>

#include "support/json.hpp"
#include "support/plain_text.hpp"

namespace fixproof::measure {

std::string compiler_name() {
#if defined(__clang__)
  return fmt::format("clang++ {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
  return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
  return "an unknown compiler";
#endif
}

std::string compiler_flags() { return FIXPROOF_COMPILER_FLAGS; }

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

std::string date_now() {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

support::Json made_by_json(const std::string& command, std::optional<std::uint64_t> seed) {
  support::Json made{{"command", command}};
  if (seed) made["seed"] = *seed;
  made["compiler"] = compiler_name();
  made["date"] = date_now();
  return made;
}

}  // namespace fixproof::measure
