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
#include <optional>

#include "app/cli/colour.hpp"
#include "app/cli/option_names.hpp"
#include "app/cli/print_error.hpp"
#include "support/build_info/build_info.hpp"
#include "support/edits.hpp"
#include "support/interrupt.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

/// Returns the command that was given, or a command of it, or the application.
const CLI::App& asked_of(const CLI::App& app) {
  const auto given = app.get_subcommands();
  return given.empty() ? app : asked_of(*given.front());
}

/// `(see fixproof COMMAND --help)`
std::string help_hint(const CLI::App& app) {
  std::string words = "--help";
  for (const CLI::App* asked = &asked_of(app); asked != nullptr; asked = asked->get_parent()) {
    words = asked->get_name() + " " + words;
  }
  return fmt::format("(see {})", words);
}

void add_option_names(const CLI::App& app, std::vector<std::string>& names) {
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
}

/// Says that a word is no command, no option or no argument, and which one it may have meant.
std::string unknown_text(const CLI::App& app, const std::string& word) {
  const CLI::App& asked = asked_of(app);
  const bool is_first = &asked == &app;
  std::vector<std::string> names;
  add_option_names(asked, names);
  for (const CLI::App* command : asked.get_subcommands({})) {
    names.push_back(command->get_name());
    // A group of options of this command is a command without a name.
    if (command->get_name().empty()) add_option_names(*command, names);
  }
  const bool is_option = word.starts_with('-');
  const char* what = is_option  ? "unknown option"
                     : is_first ? "unknown command"
                                : "unexpected argument";
  return fmt::format("{}: {}{} {}", what, word, support::suggestion(word, names), help_hint(app));
}

/// Returns the first word that belongs to no command, or nothing.
std::string first_unknown(const CLI::App& app) {
  const std::vector<std::string> remaining = app.remaining(true);
  return remaining.empty() ? "" : remaining.front();
}

/// `help`, `help COMMAND` and `COMMAND help` are other words for `--help` and `COMMAND --help`, and
/// `COMMAND --version` for `--version`.
void accept_other_words(std::vector<std::string>& arguments) {
  if (arguments.empty()) return;
  if (arguments.front() == "help") {
    arguments.erase(arguments.begin());
    arguments.emplace_back("--help");
  } else if (arguments.size() == 2 && arguments.back() == "help") {
    arguments.back() = "--help";
  } else if (arguments.size() == 2 && arguments.back() == "--version") {
    arguments.erase(arguments.begin());
  }
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
  accept_other_words(arguments);
  std::optional<ColouredOutput> colours;
  if (wants_colour()) colours.emplace();
  try {
    // CLI11 expects the arguments in reverse order.
    std::reverse(arguments.begin(), arguments.end());
    app.parse(std::move(arguments));
    if (app.get_subcommands().empty())
      throw support::UsageError("no command given (see fixproof --help)");
  } catch (const CLI::Success& help) {
    // Help about what there is not.
    if (app.get_subcommands().empty() && !first_unknown(app).empty()) {
      print_error(unknown_text(app, first_unknown(app)));
      return 2;
    }
    colours.reset();
    app.exit(help);
  } catch (const CLI::ExtrasError&) {
    print_error(unknown_text(app, first_unknown(app)));
    return 2;
  } catch (const CLI::ExcludesError&) {
    print_error(fmt::format("{} {}", exclusion_in(app), help_hint(app)));
    return 2;
  } catch (const CLI::ParseError& error) {
    // What is missing may be there, with a slip.
    const std::string unknown = first_unknown(app);
    const bool is_slip = unknown.starts_with("--") && unknown != "--";
    print_error(is_slip ? unknown_text(app, unknown)
                        : fmt::format("{} {}", error.what(), help_hint(app)));
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
  colours.reset();
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
