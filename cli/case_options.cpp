#include "cli/case_options.hpp"

#include <cstdint>

#include "cli/arguments.hpp"

namespace fixproof::cli {

void add_case_options(CLI::App& command, check::CaseOptions& options) {
  command
      .add_option("--level", options.level,
                  "level of verify: 1 has about a million cases, 2 sixty times as many")
      ->transform(whole_number(1, 2))
      ->capture_default_str();
  add_seed(command, options.seed);
  command.add_option("--shard", options.shard, "i/n: select only the i-th of n parts")
      ->check(not_empty())
      ->capture_default_str();
  command
      .add_option("--cases", options.cases, "select only this many cases, evenly spread over all")
      ->transform(whole_number(1, std::uint64_t{1} << 32U));
}

}  // namespace fixproof::cli
