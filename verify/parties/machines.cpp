#include "verify/parties/machines.hpp"

#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/parties.hpp"

namespace fixproof {

bool has_machine_code(const Variant& v) {
  return is_routine(v) && v.fraction_bits == 16 && !machine_code(key_of(v)).empty();
}

Ending ending_of(CallEnding ending) {
  switch (ending) {
    case CallEnding::returned:
      return Ending::value;
    case CallEnding::divide_error:
      return Ending::divide_error;
    case CallEnding::fault:
      break;
  }
  return Ending::broken;
}

}  // namespace fixproof
