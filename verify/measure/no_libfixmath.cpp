// Where libfixmath was not there when Fixproof was built.
#include "verify/measure/subjects.hpp"

namespace fixproof {

std::optional<Subject> libfixmath_subject(const std::string& /*operation*/) { return std::nullopt; }

bool has_libfixmath() { return false; }

}  // namespace fixproof
