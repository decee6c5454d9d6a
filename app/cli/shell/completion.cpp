/// @file
/// Completions: a script for a shell, from the same declarations as the help.
#include <fmt/format.h>

#include <cstddef>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/commands.hpp"
#include "app/cli/shell/command_tree.hpp"
#include "support/edits.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace shell {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// The first sentence or clause of a description, for a list of one line per option.
std::string brief(const std::string& description) {
  return description.substr(0, description.find_first_of(";\n"));
}

/// `text` for single quotes of a shell.
std::string in_quotes(std::string_view text) {
  std::string all;
  for (const char c : text) all += c == '\'' ? std::string(R"('\'')") : std::string(1, c);
  return "'" + all + "'";
}

std::vector<std::string> positional_words(const CommandEntry& command) {
  for (const OptionEntry& option : command.options) {
    if (option.is_positional) return words_for(option);
  }
  return {};
}

/// bash completes names of files where nothing else fits.
std::string bash_script(const CommandEntry& app, const std::vector<CommandEntry>& commands) {
  std::string names;
  std::string cases;
  for (const CommandEntry& command : commands) {
    names += " " + command.name;
    std::string options;
    std::string values;
    for (const OptionEntry& option : command.options) {
      if (option.is_positional) continue;
      options += " " + joined(option.names);
      const std::string words = joined(words_for(option));
      if (!words.empty()) {
        values += fmt::format("        {}) words={} ;;\n", option.names.back(), in_quotes(words));
      }
    }
    cases += fmt::format("    {})\n      options={}\n", command.name, in_quotes(options.substr(1)));
    if (const std::string words = joined(positional_words(command)); !words.empty()) {
      cases += fmt::format("      ((COMP_CWORD > 2)) || words={}\n", in_quotes(words));
    }
    if (!values.empty()) {
      cases += "      case ${COMP_WORDS[COMP_CWORD - 1]} in\n" + values + "      esac\n";
    }
    cases += "      ;;\n";
  }
  std::string general;
  for (const OptionEntry& option : app.options) general += " " + joined(option.names);
  return fmt::format(
      R"(# bash completion for fixproof
_fixproof() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} options='' words=''
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W {} -- "$word")
    return
  fi
  case ${{COMP_WORDS[1]}} in
{}  esac
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
  elif [[ $words ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  else
    mapfile -t COMPREPLY < <(compgen -f -- "$word")
  fi
}}
complete -o filenames -F _fixproof fixproof
)",
      in_quotes(names.substr(1) + general), cases);
}

/// `text` for a description or a message of _arguments and _describe.
std::string zsh_text(const std::string& text) {
  std::string all;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') all += '\\';
    all += c;
  }
  return all;
}

/// One argument of _arguments: `(-o --output){-o,--output}'[description]:value:_files'`.
std::string zsh_argument(const OptionEntry& option) {
  const std::string words = joined(words_for(option));
  const std::string action = words.empty() ? "_files" : "(" + words + ")";
  if (option.is_positional) {
    return in_quotes(fmt::format("*:{}:{}", zsh_text(option.names.back()), action));
  }
  std::string all;
  for (const std::string& name : option.names) {
    const std::string value = option.value.empty() ? "" : ":value:" + action;
    all += (all.empty() ? "" : " ") +
           in_quotes(fmt::format("{}[{}]{}", name, zsh_text(brief(option.description)), value));
  }
  return all;
}

std::string zsh_script(const CommandEntry& app, const std::vector<CommandEntry>& commands) {
  std::string described;
  std::string cases;
  for (const CommandEntry& command : commands) {
    described +=
        "    " + in_quotes(command.name + ":" + zsh_text(brief(command.description))) + "\n";
    cases += "    " + command.name + ") _arguments";
    bool has_positional = false;
    for (const OptionEntry& option : command.options) {
      // Only the first positional: `*:` takes all of them.
      if (option.is_positional && has_positional) continue;
      has_positional = has_positional || option.is_positional;
      cases += " \\\n      " + zsh_argument(option);
    }
    cases += " ;;\n";
  }
  for (const OptionEntry& option : app.options) {
    for (const std::string& name : option.names) {
      described += "    " + in_quotes(name + ":" + zsh_text(brief(option.description))) + "\n";
    }
  }
  return fmt::format(
      R"(#compdef fixproof
_fixproof() {{
  local -a commands=(
{}  )
  if ((CURRENT == 2)); then
    _describe command commands
    return
  fi
  local command=$words[2]
  shift words
  ((CURRENT--))
  case $command in
{}  esac
}}
if [[ $funcstack[1] == _fixproof ]]; then _fixproof "$@"; else compdef _fixproof fixproof; fi
)",
      described, cases);
}

std::string fish_script(const CommandEntry& app, const std::vector<CommandEntry>& commands) {
  std::string text = "# fish completion for fixproof\n";
  const auto add = [&](const std::string& condition, const OptionEntry& option) {
    text += "complete -c fixproof -n " + in_quotes(condition);
    for (const std::string& name : option.names) {
      text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    }
    const std::string words = joined(words_for(option));
    if (!option.value.empty()) text += words.empty() ? " -r" : " -x -a " + in_quotes(words);
    text += " -d " + in_quotes(brief(option.description)) + "\n";
  };
  for (const OptionEntry& option : app.options) add("__fish_use_subcommand", option);
  for (const CommandEntry& command : commands) {
    text += fmt::format("complete -c fixproof -f -n __fish_use_subcommand -a {} -d {}\n",
                        command.name, in_quotes(brief(command.description)));
    const std::string condition = "__fish_seen_subcommand_from " + command.name;
    for (const OptionEntry& option : command.options) {
      if (!option.is_positional) add(condition, option);
    }
    if (const std::string words = joined(positional_words(command)); !words.empty()) {
      text +=
          fmt::format("complete -c fixproof -n {} -a {}\n", in_quotes(condition), in_quotes(words));
    }
  }
  return text;
}

std::string script_for(const std::string& name, const CLI::App& app) {
  const CommandEntry general = entry_of(app);
  const std::vector<CommandEntry> commands = commands_of(app);
  if (name == "bash") return bash_script(general, commands);
  if (name == "zsh") return zsh_script(general, commands);
  if (name == "fish") return fish_script(general, commands);
  throw support::UsageError(fmt::format("no completion for '{}'{} (there are bash, zsh and fish)",
                                        name, support::suggestion(name, {"bash", "zsh", "fish"})));
}

}  // namespace

}  // namespace shell

void add_completion(CLI::App& app, int& status) {
  auto* command = app.add_subcommand("completion",
                                     "print a script that completes this command line in a shell");
  const auto name = std::make_shared<std::string>();
  command->add_option("shell", *name, "bash, zsh or fish")->required();
  command->footer(
      R"(The script knows commands, options and names of operations. Where to put it:
  fixproof completion bash >~/.local/share/bash-completion/completions/fixproof
  fixproof completion zsh >DIRECTORY/_fixproof      # a DIRECTORY of $fpath
  fixproof completion fish >~/.config/fish/completions/fixproof.fish)");
  command->callback([&app, name, &status] {
    std::cout << shell::script_for(*name, app);
    status = 0;
  });
}

}  // namespace fixproof::cli
