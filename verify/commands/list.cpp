#include <iostream>
#include <memory>

#include "verify/commands/commands.hpp"
#include "verify/commands/program.hpp"
#include "verify/options.hpp"
#include "x86model/text.hpp"

namespace fixproof {

void add_list(CLI::App& app, int& status) {
  auto options = std::make_shared<ProgramOptions>();
  CLI::App* command = app.add_subcommand("list", "print a routine as NASM source");
  options->add_to(*command);
  command->footer(
      "Example:\n"
      "  fixproof list div --target i8088 --round on > fixeddiv.asm && nasm -f bin fixeddiv.asm");
  command->callback([options, &status] {
    const ProgramKey chosen = options->choose();
    std::cout << x86model::nasm_source(chosen.routine, chosen.target, chosen.build);
    status = 0;
  });
}

}  // namespace fixproof
