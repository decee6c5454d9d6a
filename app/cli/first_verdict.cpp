// The program that ./run builds first: `verify` alone.
#include "app/cli/commands.hpp"
#include "app/cli/program_start.hpp"

int main(int argc, char** argv) {
  return fixproof::cli::start_program(argc, argv, fixproof::cli::add_verify);
}
