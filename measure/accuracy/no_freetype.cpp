// Replaces freetype.cpp in builds without FreeType.
#include "measure/host/host_contenders.hpp"

namespace fixproof::measure {

std::optional<Subject> freetype_subject(const std::string& /*operation*/) { return std::nullopt; }

std::vector<HostContender> freetype_contenders(const std::string& /*operation*/) { return {}; }

WordFunction freetype_function(std::string_view /*function*/) { return nullptr; }

bool has_freetype() { return false; }

}  // namespace fixproof::measure
