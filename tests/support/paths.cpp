#include "tests/support/paths.hpp"

namespace paths {

std::string source(const std::string& file) { return FIXPROOF_SOURCE "/" + file; }

std::string built(const std::string& file) { return FIXPROOF_BUILD "/" + file; }

}  // namespace paths
