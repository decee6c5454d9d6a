// Replaces the table if NASM is not installed.
#include "verify/machine_code/table.hpp"

namespace fixproof::machine_code {

std::span<const Assembled> assembled_programs() { return {}; }

}  // namespace fixproof::machine_code
