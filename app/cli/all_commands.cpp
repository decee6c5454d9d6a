#include <array>
#include <vector>

#include "app/cli/commands.hpp"

namespace fixproof::cli {

namespace {

/// Commands that answer one question of a user, in the order of the help.
struct Group {
  const char* question;
  std::vector<void (*)(CLI::App&, int&)> commands;
};

const std::array<Group, 5> groups{{
    {"Judge your own code", {add_gen, add_check, add_judge, add_desync}},
    {"Verify FIXED.ASM and the number type",
     {add_verify, add_merge, add_prove, add_mutate, add_step}},
    {"Look inside", {add_eval, add_trace, add_list, add_dos}},
    {"Scenes and what they cost",
     {add_render, add_measure, add_drift, add_profile, add_advise, add_report}},
    {"Your shell", {add_completion, add_manual}},
}};

}  // namespace

void add_all_commands(CLI::App& app, int& status) {
  for (const Group& group : groups) {
    for (const auto add : group.commands) {
      add(app, status);
      app.get_subcommands([](const CLI::App*) { return true; }).back()->group(group.question);
    }
  }
}

}  // namespace fixproof::cli
