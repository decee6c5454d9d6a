#include "app/cli/case_options.hpp"

#include <cstdint>

#include "app/cli/arguments.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

void add_result_format(CLI::App& command, std::string& to) {
  command.add_option("--to", to, "format of the results of convert, such as q8_8")
      ->check(not_empty());
}

cases::Variant variant_in(cases::Operation operation, const cases::Format& format,
                          const std::string& to) {
  const bool converts = operation == cases::Operation::convert;
  if (converts && to.empty()) {
    throw support::UsageError(
        "convert: --to is required; name the format of the results, such as q8_8");
  }
  if (!converts && !to.empty()) {
    throw support::UsageError("--to applies only to convert; leave it out");
  }
  return converts ? check::variant_of(operation, cases::format_named(to), format)
                  : check::variant_of(operation, format);
}

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
