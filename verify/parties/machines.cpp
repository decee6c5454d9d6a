#include "verify/parties/machines.hpp"

#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/parties.hpp"

namespace fixproof {

bool has_machine_code(const Variant& v) {
  return is_routine(v) && v.fraction_bits == 16 && !machine_code(key_of(v)).empty();
}

}  // namespace fixproof
