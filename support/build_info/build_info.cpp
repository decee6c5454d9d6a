#include "support/build_info/build_info.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "support/sha256.hpp"

namespace fixproof::support {

std::string_view program_version() { return FIXPROOF_VERSION; }

std::string_view build_type() {
  constexpr std::string_view type = FIXPROOF_BUILD_TYPE;
  return type.empty() ? "none" : type;
}

std::string compiler_name() {
#if defined(__clang__)
  return fmt::format("clang++ {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#elif defined(__GNUC__)
  return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#else
  return "an unknown compiler";
#endif
}

const std::string& executable_digest() {
  static const std::string digest = [] {
    try {
      return sha256_hex_of_file("/proc/self/exe");
    } catch (const std::runtime_error&) {
      return std::string("unknown");
    }
  }();
  return digest;
}

}  // namespace fixproof::support
