#include "verify/commands/program.hpp"

#include <fmt/format.h>

#include "verify/usage_error.hpp"

namespace fixproof {

void ProgramOptions::add_to(CLI::App& command) {
  command.add_option("routine", operation, "mul, div, cossin, xformvec or concat")->required();
  variant.add_to(command);
  command.add_flag("--as-scanned", as_scanned,
                   "the 8088 divide as a scan has it: see docs/findings.md, 10");
}

ProgramChoice ProgramOptions::choose() const {
  const Operation chosen = operation_named(operation);
  if (chosen > Operation::concat) {
    throw UsageError(fmt::format("{} is no routine of FIXED.ASM", operation));
  }
  const Variant v = variant.choose(chosen);
  if (as_scanned && (chosen != Operation::div || v.target != Target::i8088)) {
    throw UsageError("--as-scanned is a reading of div --target i8088");
  }
  // The model's routines and the first operations are the same five, in the same order.
  static_assert(static_cast<int>(Operation::concat) == static_cast<int>(x86model::Routine::concat));
  return {.routine = static_cast<x86model::Routine>(chosen),
          .target = v.target == Target::i386 ? x86model::Target::i386 : x86model::Target::i8088,
          .build = {.mul_rounding = v.mul_round,
                    .div_rounding = v.div_round,
                    .chapter_52 = v.chapter_52,
                    .endif_as_scanned = as_scanned}};
}

}  // namespace fixproof
