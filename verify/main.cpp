// The command `fixproof`: only joins the commands, which have a file each.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>

#include "verify/commands/commands.hpp"
#include "verify/hex.hpp"
#include "verify/interrupt.hpp"
#include "verify/proof/process.hpp"
#include "verify/usage_error.hpp"

int main(int argc, char** argv) {
  CLI::App app{
      "Bit-exact verification of 16.16 fixed-point arithmetic: a register-level model of the 8088\n"
      "and 386 sequences of FIXED.ASM, a big-integer oracle and a production C++ type, compared."};
  app.name("fixproof");
  app.require_subcommand(0, 1);
  app.set_version_flag("--version", FIXPROOF_VERSION);
  // A reader that goes away or a limit on files is an error that is reported, not a silent end.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  // Commands that read a line at a time need a buffer of their own; none mixes the two libraries.
  std::ios::sync_with_stdio(false);
  int status = 0;
  fixproof::add_verify(app, status);
  fixproof::add_merge(app, status);
  fixproof::add_gen(app, status);
  fixproof::add_check(app, status);
  fixproof::add_eval(app, status);
  fixproof::add_step(app, status);
  fixproof::add_trace(app, status);
  fixproof::add_list(app, status);
  fixproof::add_prove(app, status);
  fixproof::add_mutate(app, status);
  fixproof::add_dos(app, status);
  fixproof::add_render(app, status);
  fixproof::add_drift(app, status);
  fixproof::add_measure(app, status);
  fixproof::add_profile(app, status);
  fixproof::add_advise(app, status);
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty())
      throw fixproof::UsageError("which command? (see fixproof --help)");
  } catch (const CLI::Success& help) {
    app.exit(help);
  } catch (const CLI::ExtrasError&) {
    const auto extra = app.remaining(true);
    const char* what = app.get_subcommands().empty() ? "no such command" : "not expected";
    fmt::print(stderr, "fixproof: {}: {} (see fixproof --help)\n", what,
               fixproof::printable(extra.front()));
    return 2;
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "fixproof: {} (see fixproof --help)\n", fixproof::printable(error.what()));
    return 2;
  } catch (const fixproof::Stopped&) {
    fmt::print(stderr, "fixproof: stopped\n");
    return fixproof::interrupted_status;
  } catch (const std::exception& error) {
    std::cout.flush();
    fmt::print(stderr, "fixproof: {}\n", fixproof::printable(error.what()));
    return 2;
  }
  // A full disk or a closed pipe shows at the latest here.
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    fmt::print(stderr, "fixproof: cannot write standard output\n");
    return 2;
  }
  return status;
}
