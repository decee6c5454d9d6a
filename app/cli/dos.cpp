#include <fmt/format.h>
#include <unistd.h>

#include <iostream>
#include <memory>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/program.hpp"
#include "support/file.hpp"
#include "support/usage_error.hpp"
#include "verify/machine_code/machine_code.hpp"

namespace fixproof::cli {

namespace {

struct DosOptions {
  ProgramOptions program;
  std::string file;
};

void write(const DosOptions& options) {
  const machine_code::ProgramKey key = options.program.choose();
  if (const std::string absence = machine_code::machine_code_absence(); !absence.empty()) {
    throw support::UsageError(
        fmt::format("dos has no programs: {}; install NASM and build again", absence));
  }
  if (key.build.shl_as_printed) throw support::UsageError(no_printed_shift);
  const auto bytes = machine_code::dos_command(key);
  if (bytes.empty()) {
    throw support::UsageError(
        fmt::format("there is no DOS program for {}", machine_code::name_of(key)));
  }
  const std::string contents(bytes.begin(), bytes.end());
  if (!options.file.empty()) return support::replace_file(options.file, contents);
  if (isatty(STDOUT_FILENO) != 0) {
    throw support::UsageError(
        "dos does not write a program to a terminal: give -o FILE.COM, or redirect the output");
  }
  std::cout.write(contents.data(), static_cast<std::streamsize>(contents.size()));
}

}  // namespace

void add_dos(CLI::App& app, int& status) {
  auto options = std::make_shared<DosOptions>();
  CLI::App* command = app.add_subcommand("dos", "write a DOS program that calls a routine");
  options->program.add_to(*command);
  command->add_option("-o,--output", options->file, "output file; by default standard output")
      ->check(not_empty());
  command->footer(
      R"(Writes a .COM file that runs on any DOS. It reads lines of operands and writes one line of
results for each, as `fixproof eval` does; DE is a divide error. A routine for the 8088 needs
only an 8088. The program exits with status 2 if it cannot read a line.

Examples:
  fixproof dos mul --target i8088 -o MUL.COM
  dosbox -c 'mount c .' -c 'c:' -c 'MUL.COM < IN.TXT > OUT.TXT' -c exit)");
  command->callback([options, &status] {
    write(*options);
    status = 0;
  });
}

}  // namespace fixproof::cli
