// The program that ./run builds first: `verify` alone.
#include "cli/commands.hpp"
#include "cli/program_start.hpp"

int main(int argc, char** argv) {
  return fixproof::cli::start_program(argc, argv, fixproof::cli::add_verify);
}
