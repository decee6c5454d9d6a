#include "app/cli/shell/command_tree.hpp"

#include "app/cli/option_names.hpp"
#include "verify/cases/operation.hpp"

namespace fixproof::cli::shell {

namespace {

OptionEntry option_entry(const CLI::Option& option) {
  OptionEntry entry;
  entry.is_positional = !option.nonpositional();
  if (entry.is_positional) {
    entry.names.push_back(option.get_name(true));
  } else {
    for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  }
  if (option.get_items_expected_max() > 0) {
    entry.value = HelpFormatter().make_option_opts(&option);
    if (const std::size_t first = entry.value.find_first_not_of(' '); first != std::string::npos) {
      entry.value.erase(0, first);
    }
  }
  entry.description = option.get_description();
  entry.heading = option.get_group();
  return entry;
}

}  // namespace

CommandEntry entry_of(const CLI::App& app) {
  CommandEntry entry{app.get_name(), app.get_description(), app.get_group(), {}, app.get_footer()};
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_group().empty()) entry.options.push_back(option_entry(*option));
  }
  return entry;
}

std::vector<CommandEntry> commands_of(const CLI::App& app) {
  std::vector<CommandEntry> commands;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!command->get_group().empty()) commands.push_back(entry_of(*command));
  }
  return commands;
}

std::vector<std::string> words_for(const OptionEntry& option) {
  std::vector<std::string> words;
  const std::string& name = option.names.back();
  if (name == "--as" || name == "operation" || name == "operations") {
    for (const auto& operation : cases::operations) words.emplace_back(operation.name);
  }
  return words;
}

}  // namespace fixproof::cli::shell
