// In the place of the table where NASM is not installed.
#include "verify/machine_code/table.hpp"

namespace fixproof {

std::span<const Assembled> assembled_programs() { return {}; }

}  // namespace fixproof
