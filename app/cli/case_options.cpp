#include "app/cli/case_options.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "app/cli/arguments.hpp"
#include "judge/check/rules.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

void add_format_options(CLI::App& command, FormatOptions& options, const std::string& what) {
  command
      .add_option("--format", options.format,
                  "format of the words: qW_F signed or uW_F unsigned, with W bits before the point "
                  "and F after it, 2 to 64 in all; dB_F or udB_F for B bits in units of 10^-F; by "
                  "default q16_16" +
                      what)
      ->check(not_empty());
  command
      .add_option("--to", options.to,
                  "format of the results, such as q8_8; by default that of the words, and required "
                  "for convert")
      ->check(not_empty());
  command.add_option("--terms", options.terms, "number of products of dot")
      ->transform(whole_number(1, cases::max_terms))
      ->capture_default_str();
}

cases::Variant variant_in(cases::Operation operation, const FormatOptions& options) {
  const bool converts = operation == cases::Operation::convert;
  if (converts && options.to.empty()) {
    throw support::UsageError(
        "convert: --to is required; name the format of the results, such as q8_8");
  }
  if (!options.to.empty() && !converts &&
      (!check::is_judged(operation) || cases::is_conversion(operation))) {
    throw support::UsageError(fmt::format(
        "--to: {} has one format, that of --format; leave --to out", cases::name_of(operation)));
  }
  const cases::Format operands =
      options.format.empty() ? cases::q16_16 : cases::judged_format_named(options.format);
  const cases::Format results =
      options.to.empty() ? operands : cases::judged_format_named(options.to);
  cases::check_format(operation, operands);
  cases::check_format(operation, results);
  cases::Variant variant = cases::variant_of(operation, operands, results);
  if (operation == cases::Operation::dot) {
    variant.terms = options.terms;
  } else if (options.terms != variant.terms) {
    throw support::UsageError(fmt::format("--terms applies only to dot, not to {}; leave it out",
                                          cases::name_of(operation)));
  }
  return variant;
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
