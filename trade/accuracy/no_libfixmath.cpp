// Where libfixmath was not there when Fixproof was built.
#include "trade/host/host_contenders.hpp"

namespace fixproof::trade {

std::optional<Subject> libfixmath_subject(const std::string& /*operation*/) { return std::nullopt; }

std::vector<HostContender> libfixmath_contenders(const std::string& /*operation*/) { return {}; }

bool has_libfixmath() { return false; }

}  // namespace fixproof::trade
