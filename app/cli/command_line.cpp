#include "app/cli/command_line.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <boost/noncopyable.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <memory>
#include <new>

#include "app/cli/option_names.hpp"
#include "app/cli/print_error.hpp"
#include "app/cli/suggestion.hpp"
#include "support/build_info/build_info.hpp"
#include "support/interrupt.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

/// `(see fixproof COMMAND --help)`
std::string help_hint(const CLI::App& app) {
  const auto given = app.get_subcommands();
  return fmt::format("(see fixproof {}--help)",
                     given.empty() ? "" : given.front()->get_name() + " ");
}

/// Says that a word is no command, no option or no argument, and which one it may have meant.
std::string unknown_text(const CLI::App& app, const std::string& word) {
  const auto given = app.get_subcommands();
  const CLI::App& asked = given.empty() ? app : *given.front();
  std::vector<std::string> names;
  for (const CLI::Option* option : asked.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  if (given.empty()) {
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  }
  const bool is_option = word.starts_with('-');
  const char* what = is_option       ? "unknown option"
                     : given.empty() ? "unknown command"
                                     : "unexpected argument";
  return fmt::format("{}: {}{} {}", what, word, suggestion(word, names), help_hint(app));
}

/// `help` and `help COMMAND` are other words for `--help` and `COMMAND --help`.
void accept_help(std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments.front() != "help") return;
  arguments.erase(arguments.begin());
  arguments.emplace_back("--help");
}

/// Returns the exit status of a command whose output is lost. A reader that has read enough, such
/// as head, is no error: the status is the shell's for a program that SIGPIPE ends.
int status_of_lost_output() {
  constexpr int ended_by_pipe = 128 + SIGPIPE;
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  if (::poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0) return ended_by_pipe;
  print_error(OutputLost().what());
  return 2;
}

/// @throws std::bad_alloc
int run(std::vector<std::string> arguments, AddCommands& add_commands) {
  CLI::App app{
      "Bit-exact verification of 16.16 fixed-point arithmetic. Compares a register-level model of\n"
      "FIXED.ASM for the 8088 and the 386, a big-integer oracle and a C++ number type."};
  int status = 0;
  app.name("fixproof");
  app.formatter(std::make_shared<HelpFormatter>());
  app.require_subcommand(0, 1);
  app.set_version_flag("--version", std::string(support::program_version()));
  add_commands(app, status);
  accept_help(arguments);
  try {
    // CLI11 expects the arguments in reverse order.
    std::reverse(arguments.begin(), arguments.end());
    app.parse(std::move(arguments));
    if (app.get_subcommands().empty())
      throw support::UsageError("no command given (see fixproof --help)");
  } catch (const CLI::Success& help) {
    app.exit(help);
  } catch (const CLI::ExtrasError&) {
    print_error(unknown_text(app, app.remaining(true).front()));
    return 2;
  } catch (const CLI::ExcludesError&) {
    print_error(fmt::format("{} {}", exclusion_in(app), help_hint(app)));
    return 2;
  } catch (const CLI::ParseError& error) {
    print_error(fmt::format("{} {}", error.what(), help_hint(app)));
    return 2;
  } catch (const support::Stopped&) {
    print_error("stopped");
    return support::interrupted_status;
  } catch (const OutputLost&) {
    return status_of_lost_output();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    std::cout.flush();
    print_error(error.what());
    return support::Interrupt::flag() ? support::interrupted_status : 2;
  }
  // Flushing reveals a full disk or a closed pipe.
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return status_of_lost_output();
  }
  return status;
}

}  // namespace

int run_command_line(std::vector<std::string> arguments, AddCommands& add_commands) {
  try {
    return run(std::move(arguments), add_commands);
  } catch (const std::bad_alloc&) {
    std::cout.flush();
    print_error("out of memory");
    return 2;
  }
}

}  // namespace fixproof::cli
