#include "parties/machines.hpp"

#include "machine_code/machine_code.hpp"
#include "parties/parties.hpp"

namespace fixproof::parties {

bool has_machine_code(const cases::Variant& v) {
  return is_routine(v) && v.fraction_bits == 16 &&
         !machine_code::machine_code(machine_code::key_of(v)).empty();
}

}  // namespace fixproof::parties
