/// @file
/// Manual pages, from the same declarations as the help.
#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/commands.hpp"
#include "app/cli/shell/command_tree.hpp"
#include "support/build_info/build_info.hpp"
#include "support/edits.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace shell {

namespace {

/// `text` for troff: no letter is a command, and a hyphen is a minus that can be copied.
std::string escaped(std::string_view text) {
  std::string all;
  bool is_first = true;
  for (const char c : text) {
    if (is_first && (c == '.' || c == '\'')) all += "\\&";
    is_first = c == '\n';
    if (c == '\\') {
      all += "\\e";
    } else if (c == '-') {
      all += "\\-";
    } else {
      all += c;
    }
  }
  return all;
}

/// The heading of troff in capitals.
std::string heading(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return ".SH " + escaped(text) + "\n";
}

std::string title(const std::string& page, const std::string& name,
                  const std::string& description) {
  return fmt::format(".TH {} 1 \"\" \"{}\" \"User Commands\"\n{}{} \\- {}\n", page,
                     escaped(support::program_version()), heading("name"), escaped(name),
                     escaped(description.substr(0, description.find('.'))));
}

std::string options_text(const CommandEntry& command, bool is_positional) {
  std::string text;
  std::string under;
  for (const OptionEntry& option : command.options) {
    if (option.is_positional != is_positional) continue;
    if (!is_positional && option.heading != under) {
      under = option.heading;
      text += under == "Options" ? heading("options") : ".SS " + escaped(under) + "\n";
    }
    text += ".TP\n\\fB";
    for (const std::string& name : option.names) {
      text += (&name == &option.names.front() ? "" : "\\fR, \\fB") + escaped(name);
    }
    text += "\\fR";
    if (!option.value.empty() && !is_positional) {
      // `=2` is a default, which needs no space before it.
      text += (option.value.front() == '=' ? "" : " ") + escaped(option.value);
    }
    text += "\n" + escaped(option.description) + "\n";
  }
  return text.empty() || !is_positional ? text : heading("arguments") + text;
}

/// Notes and examples stand as they are written.
std::string notes(const std::string& footer) {
  return footer.empty() ? "" : heading("notes") + ".nf\n" + escaped(footer) + "\n.fi\n";
}

std::string page_of(const CommandEntry& command) {
  std::string usage = "\\fBfixproof " + escaped(command.name) + "\\fR [\\fIoptions\\fR]";
  for (const OptionEntry& option : command.options) {
    if (option.is_positional) usage += " \\fI" + escaped(option.names.front()) + "\\fR";
  }
  return title("FIXPROOF\\-" + command.name, "fixproof-" + command.name, command.description) +
         heading("synopsis") + usage + "\n" + options_text(command, true) +
         options_text(command, false) + notes(command.footer) + heading("see also") +
         ".BR fixproof (1)\n";
}

std::string first_page(const CommandEntry& app, const std::vector<CommandEntry>& commands) {
  std::string text = title("FIXPROOF", "fixproof", "judge and verify fixed-point arithmetic") +
                     heading("synopsis") + "\\fBfixproof\\fR \\fIcommand\\fR [\\fIoptions\\fR]\n" +
                     heading("description") + escaped(app.description) + "\n";
  std::string under;
  std::string also;
  for (const CommandEntry& command : commands) {
    if (command.heading != under) {
      under = command.heading;
      text += heading(under);
    }
    text +=
        fmt::format(".TP\n\\fB{}\\fR\n{}\n", escaped(command.name), escaped(command.description));
    also += fmt::format("{}.BR fixproof\\-{} (1)", also.empty() ? "" : ",\n", command.name);
  }
  return text + options_text(app, false) + notes(app.footer) + heading("see also") + also + "\n";
}

std::string manual_page(const std::string& name, const CLI::App& app) {
  const std::vector<CommandEntry> commands = commands_of(app);
  if (name.empty()) return first_page(entry_of(app), commands);
  std::vector<std::string> names;
  for (const CommandEntry& command : commands) {
    if (command.name == name) return page_of(command);
    names.push_back(command.name);
  }
  throw support::UsageError(
      fmt::format("no command '{}'{}", name, support::suggestion(name, names)));
}

}  // namespace

}  // namespace shell

void add_manual(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("manual", "print a manual page of fixproof or of a command");
  const auto name = std::make_shared<std::string>();
  command->add_option("command", *name, "a command; by default fixproof itself");
  command->footer(
      R"(The page is troff:
  fixproof manual check | man -l -
  fixproof manual >~/.local/share/man/man1/fixproof.1)");
  command->callback([&app, name, &status] {
    std::cout << shell::manual_page(*name, app);
    status = 0;
  });
}

}  // namespace fixproof::cli
