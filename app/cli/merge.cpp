#include "verify/merge.hpp"

#include <iostream>
#include <memory>
#include <optional>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/json/result_file.hpp"
#include "app/cli/json/verify_json.hpp"
#include "app/cli/print_error.hpp"
#include "app/cli/table.hpp"
#include "support/output_file.hpp"
#include "verify/report_file.hpp"

namespace fixproof::cli {

namespace {

struct MergeOptions {
  std::vector<std::string> files;
  std::string report;
  bool accept_other_builds = false;
  ResultFile result;
};

int run(MergeOptions& options) {
  std::vector<std::string> others = options.files;
  others.push_back(options.report);
  options.result.open(others, "the reports");
  std::optional<support::OutputFile> report;
  if (!options.report.empty()) report.emplace(options.report);
  std::vector<verify::NamedReport> parts;
  for (const std::string& file : options.files) parts.push_back({file, verify::read_report(file)});
  const verify::Report sum = verify::merged(parts, options.accept_other_builds);
  if (report) report->replace(verify::to_json(sum));
  std::cout << table(sum) << std::flush;
  const std::string missing = verify::missing(sum, parts);
  if (!missing.empty()) print_error(missing);
  // A mismatch counts even if parts are missing.
  const int status = sum.mismatches() > 0 ? 1 : missing.empty() ? 0 : 2;
  return options.result.write(status, [&] { return verify_json(sum); });
}

}  // namespace

void add_merge(CLI::App& app, int& status) {
  auto options = std::make_shared<MergeOptions>();
  CLI::App* command =
      app.add_subcommand("merge", "add up the reports of the shards of one verification");
  command->add_option("reports", options->files, "files that verify --report or --resume wrote")
      ->required();
  command
      ->add_option("--report", options->report,
                   "write the sum to this file as JSON; - is standard output")
      ->transform(output_file());
  command->add_flag("--accept-other-builds", options->accept_other_builds,
                    "add parts of other builds or other parties; the sum lists them");
  options->result.add_to(*command);
  command->footer(
      R"(The parts must belong to the same verification (level, seed, rows, parties) and must not share
a chunk. All parts must come from this build, and their parties must have used the same libraries
and processors. If chunks are missing, merge prints a table of those that it has and names the
missing shards. It then exits with status 1 if there are mismatches, otherwise with 2.
`verify --resume SUM` runs the rest.

Example:
  fixproof verify --shard 1/2 --report a.json     # on one machine
  fixproof verify --shard 2/2 --report b.json     # on another
  fixproof merge a.json b.json --report all.json)");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace fixproof::cli
