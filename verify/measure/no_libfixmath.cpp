// Where libfixmath was not there when Fixproof was built.
#include "verify/measure/host_contenders.hpp"

namespace fixproof {

std::optional<Subject> libfixmath_subject(const std::string& /*operation*/) { return std::nullopt; }

std::vector<HostContender> libfixmath_contenders(const std::string& /*operation*/) { return {}; }

bool has_libfixmath() { return false; }

}  // namespace fixproof
