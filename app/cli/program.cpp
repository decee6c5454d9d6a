#include "app/cli/program.hpp"

#include <fmt/format.h>

#include "app/cli/arguments.hpp"
#include "support/usage_error.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "x86model/text.hpp"

namespace fixproof::cli {

void ProgramOptions::add_to(CLI::App& command, bool with_loops) {
  command
      .add_option("routine", operation,
                  with_loops ? "mul, div, cossin, xformvec or concat; or an inner loop: "
                               "gouraud-byte, gouraud-word, depth, texture"
                             : "mul, div, cossin, xformvec or concat")
      ->required();
  variant.add_to(command);
  if (with_loops) {
    command
        .add_option(
            "--loop", counting,
            "how an inner loop counts: loop, dec-jnz or unrolled; depth --as-printed has SHRD")
        ->check(one_of({"loop", "dec-jnz", "unrolled"}));
  }
  command.add_flag("--as-scanned", as_scanned,
                   "use the 8088 divide as one scan shows it; see docs/findings.md, 10");
}

std::optional<x86model::LoopForm> ProgramOptions::choose_loop() const {
  const auto loop = machine_code::loop_named(operation);
  if (!loop) {
    if (!counting.empty()) {
      throw support::UsageError(
          "--loop is for gouraud-byte, gouraud-word, depth and texture; leave it out for a "
          "routine");
    }
    return std::nullopt;
  }
  if (variant.repaired) throw support::UsageError(only_repaired);
  if (variant.mul_round || variant.div_round || variant.chapter_52 || as_scanned) {
    throw support::UsageError(fmt::format(
        "{} is an inner loop: it has no rounding, chapter or --as-scanned; leave these options out",
        operation));
  }
  x86model::LoopForm form{.loop = *loop, .as_printed = variant.as_printed};
  if (!variant.targets.empty()) {
    form.target = machine_code::model_target(variant.targets.front());
  }
  for (const auto way : {x86model::Counting::dec_jnz, x86model::Counting::unrolled}) {
    if (x86model::name_of(way) == counting) form.counting = way;
  }
  if (!exists(form)) {
    throw support::UsageError(
        *loop == x86model::Loop::depth_test
            ? "depth needs --target i386 and --loop loop or dec-jnz"
            : fmt::format("{}: leave out --as-printed, only depth differs from its printed form",
                          operation));
  }
  return form;
}

machine_code::ProgramKey ProgramOptions::choose() const {
  const cases::Operation chosen = cases::routine_named(operation);
  const cases::Variant v = variant.choose(chosen);
  if (as_scanned && (chosen != cases::Operation::div || v.build.target != cases::Target::i8088)) {
    throw support::UsageError("--as-scanned is for div --target i8088");
  }
  machine_code::ProgramKey key = machine_code::key_of(v);
  key.build.endif_as_scanned = as_scanned;
  key.build.shl_as_printed = variant.has_printed_shift(v);
  return key;
}

}  // namespace fixproof::cli
