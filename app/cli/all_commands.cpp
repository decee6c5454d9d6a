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
  app.footer(R"(Start here:
  fixproof judge fixed.c:fix_mul --as mul    is this function right, and by which rule?
  fixproof judge --run './mine' --as mul     the same for a program in any language
  fixproof verify                            FIXED.ASM and the number type, in seconds
  echo '1.5 -0.25' | fixproof eval mul       one exact product
  fixproof help check                        the options of a command, with examples

--json FILE writes the result of a command that judges or measures for other programs
(docs/json.md). NO_COLOR=1 turns colours off.

Exit status: 0 right, 1 wrong, 2 not decided, bad usage or bad input, 130 interrupted.)");
  for (const Group& group : groups) {
    for (const auto add : group.commands) {
      add(app, status);
      app.get_subcommands([](const CLI::App*) { return true; }).back()->group(group.question);
    }
  }
}

}  // namespace fixproof::cli
