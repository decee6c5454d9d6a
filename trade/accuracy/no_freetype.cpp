// Where FreeType was not there when Fixproof was built.
#include "trade/host/host_contenders.hpp"

namespace fixproof::trade {

std::optional<Subject> freetype_subject(const std::string& /*operation*/) { return std::nullopt; }

std::vector<HostContender> freetype_contenders(const std::string& /*operation*/) { return {}; }

bool has_freetype() { return false; }

}  // namespace fixproof::trade
