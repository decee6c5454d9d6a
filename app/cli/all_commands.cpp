#include "app/cli/commands.hpp"

namespace fixproof::cli {

void add_all_commands(CLI::App& app, int& status) {
  add_verify(app, status);
  add_merge(app, status);
  add_gen(app, status);
  add_check(app, status);
  add_judge(app, status);
  add_eval(app, status);
  add_step(app, status);
  add_trace(app, status);
  add_list(app, status);
  add_prove(app, status);
  add_mutate(app, status);
  add_dos(app, status);
  add_desync(app, status);
  add_render(app, status);
  add_drift(app, status);
  add_measure(app, status);
  add_profile(app, status);
  add_advise(app, status);
  add_report(app, status);
}

}  // namespace fixproof::cli
