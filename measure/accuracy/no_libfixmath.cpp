// Replaces libfixmath.cpp in builds without libfixmath.
#include "measure/host/host_contenders.hpp"

namespace fixproof::measure {

std::optional<Subject> libfixmath_subject(const std::string& /*operation*/) { return std::nullopt; }

std::vector<HostContender> libfixmath_contenders(const std::string& /*operation*/) { return {}; }

WordFunction libfixmath_function(std::string_view /*function*/) { return nullptr; }

bool has_libfixmath() { return false; }

}  // namespace fixproof::measure
