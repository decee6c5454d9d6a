#include "verify/commands/program.hpp"

#include "verify/machine_code/machine_code.hpp"
#include "verify/usage_error.hpp"

namespace fixproof {

void ProgramOptions::add_to(CLI::App& command) {
  command.add_option("routine", operation, "mul, div, cossin, xformvec or concat")->required();
  variant.add_to(command);
  command.add_flag("--as-scanned", as_scanned,
                   "the 8088 divide as a scan has it: see docs/findings.md, 10");
}

ProgramKey ProgramOptions::choose() const {
  const Operation chosen = routine_named(operation);
  const Variant v = variant.choose(chosen);
  if (as_scanned && (chosen != Operation::div || v.target != Target::i8088)) {
    throw UsageError("--as-scanned is a reading of div --target i8088");
  }
  ProgramKey key = key_of(v);
  key.build.endif_as_scanned = as_scanned;
  return key;
}

}  // namespace fixproof
