/// @file
/// The commands of fixproof. Each function adds one to the command line. The command sets `status`
/// when it runs: 0 for success, 1 for a mismatch, 2 for bad usage or input, 130 if interrupted.
#pragma once

#include <CLI/CLI.hpp>

namespace fixproof::cli {

void add_all_commands(CLI::App& app, int& status);

void add_verify(CLI::App& app, int& status);
void add_gen(CLI::App& app, int& status);
void add_check(CLI::App& app, int& status);
void add_judge(CLI::App& app, int& status);
void add_merge(CLI::App& app, int& status);
void add_eval(CLI::App& app, int& status);
void add_step(CLI::App& app, int& status);
void add_trace(CLI::App& app, int& status);
void add_list(CLI::App& app, int& status);
void add_prove(CLI::App& app, int& status);
void add_mutate(CLI::App& app, int& status);
void add_desync(CLI::App& app, int& status);
void add_dos(CLI::App& app, int& status);
void add_render(CLI::App& app, int& status);
void add_drift(CLI::App& app, int& status);
void add_measure(CLI::App& app, int& status);
void add_profile(CLI::App& app, int& status);
void add_advise(CLI::App& app, int& status);
void add_report(CLI::App& app, int& status);
void add_completion(CLI::App& app, int& status);
void add_manual(CLI::App& app, int& status);

}  // namespace fixproof::cli
