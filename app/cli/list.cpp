#include <iostream>
#include <memory>

#include "app/cli/commands.hpp"
#include "app/cli/forms_text.hpp"
#include "app/cli/options.hpp"
#include "app/cli/program.hpp"
#include "support/usage_error.hpp"
#include "x86model/text.hpp"

namespace fixproof::cli {

void add_list(CLI::App& app, int& status) {
  auto options = std::make_shared<ProgramOptions>();
  CLI::App* command = app.add_subcommand(
      "list", "print a routine or an inner loop as NASM source, or the forms of instructions");
  options->add_to(*command, true);
  command->footer(
      "Examples:\n"
      "  fixproof list div --target i8088 --round on > fixeddiv.asm && nasm -f bin fixeddiv.asm\n"
      "  fixproof list gouraud-byte --loop dec-jnz\n"
      "  fixproof list forms     (encodings, flags and clocks of every instruction of the model)");
  command->callback([options, command, &status] {
    if (options->operation == "forms") {
      if (command->count_all() > 2) {
        throw support::UsageError("list forms has no options; leave them out");
      }
      std::cout << forms_text();
      status = 0;
      return;
    }
    if (const auto loop = options->choose_loop()) {
      std::cout << x86model::nasm_source(*loop);
      status = 0;
      return;
    }
    const machine_code::ProgramKey chosen = options->choose();
    std::cout << x86model::nasm_source(chosen.routine, chosen.target, chosen.build);
    status = 0;
  });
}

}  // namespace fixproof::cli
