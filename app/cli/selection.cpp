#include "app/cli/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "support/usage_error.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "verify/parties/answer.hpp"
#include "verify/parties/library.hpp"
#include "verify/parties/parties.hpp"

namespace fixproof::cli {

namespace {

/// Whether the variant rounds as the options require. The standard rules always round, and no
/// listing prints them.
bool rounding_fits(const VariantOptions& options, const cases::Variant& v) {
  if (options.as_printed && v.build.target == cases::Target::standard) return false;
  const auto& given = v.operation == cases::Operation::div ? options.div_round : options.mul_round;
  if (!given && !options.as_printed) return true;
  const cases::Variant wanted{.operation = v.operation, .build = options.build_for(v.build.target)};
  return cases::rounds(wanted) == cases::rounds(v);
}

void check_repaired(const Selection& selection) {
  const VariantOptions& options = selection.variant;
  if (!options.repaired) return;
  constexpr auto repairable = cases::Operation::concat;
  const bool only_concat =
      std::all_of(selection.operations.begin(), selection.operations.end(),
                  [](const std::string& name) { return name == cases::name_of(repairable); });
  const bool has_target =
      options.targets.empty() ||
      std::any_of(options.targets.begin(), options.targets.end(),
                  [](cases::Target target) { return cases::can_be_repaired(repairable, target); });
  if (!only_concat || !has_target) throw support::UsageError(only_repaired);
}

bool fits(const Selection& selection, const std::vector<cases::Operation>& operations,
          const cases::Variant& v) {
  const VariantOptions& options = selection.variant;
  return (operations.empty() ||
          std::find(operations.begin(), operations.end(), v.operation) != operations.end()) &&
         (options.targets.empty() || std::find(options.targets.begin(), options.targets.end(),
                                               v.build.target) != options.targets.end()) &&
         (!options.chapter_52 || (options.chapter_52 == v.build.chapter_52 && !v.build.repaired)) &&
         (!options.repaired || v.build.repaired) && !(options.as_printed && v.build.repaired) &&
         rounding_fits(options, v);
}

/// The operations that exist in every format, in the order of the table. Functions run only if they
/// are named.
constexpr std::array format_operations{cases::Operation::add,     cases::Operation::sub,
                                       cases::Operation::mul,     cases::Operation::div,
                                       cases::Operation::sqrt,    cases::Operation::decimal,
                                       cases::Operation::binary64};

/// Returns the formats of --format; 16.16 without one.
std::vector<cases::Format> operand_formats(const Selection& selection) {
  if (selection.formats.empty()) return {cases::q16_16};
  std::vector<cases::Format> formats;
  const auto add = [&](const cases::Format& format) {
    if (std::ranges::find(formats, format) == formats.end()) formats.push_back(format);
  };
  for (const std::string& name : selection.formats) {
    if (name == "all") {
      std::ranges::for_each(cases::named_formats(), add);
    } else {
      add(cases::format_named(name));
    }
  }
  return formats;
}

bool is_round_trip(cases::Operation operation) {
  return operation == cases::Operation::decimal || operation == cases::Operation::binary64;
}

/// Returns the variants of --format and --to: each operation in each format.
std::vector<cases::Variant> variants_in_formats(const Selection& selection) {
  const VariantOptions& options = selection.variant;
  if (selection.half_width || !options.targets.empty() || options.mul_round || options.div_round ||
      options.as_printed || options.chapter_52 || options.repaired) {
    throw support::UsageError(
        "--format: other formats have no width, target, rounding or chapter; leave these options "
        "out");
  }
  const bool names_all = std::ranges::find(selection.formats, "all") != selection.formats.end();
  const bool is_converted = !selection.to.empty();
  std::vector<cases::Operation> operations;
  for (const std::string& name : selection.operations) {
    operations.push_back(format_operation_named(name));
    if (is_converted && is_round_trip(operations.back())) {
      throw support::UsageError(
          fmt::format("--to: {} goes there and back in one format; leave --to out", name));
    }
  }
  if (operations.empty()) {
    operations.assign(format_operations.begin(), format_operations.end());
    if (is_converted) std::erase_if(operations, is_round_trip);
  }
  std::vector<cases::Variant> variants;
  for (const cases::Format& operands : operand_formats(selection)) {
    const cases::Format results = is_converted ? cases::format_named(selection.to) : operands;
    for (const cases::Operation operation : operations) {
      const bool exists =
          cases::is_in_format(operation, operands) && cases::is_in_format(operation, results);
      if (!exists && names_all) continue;
      cases::check_format(operation, operands);
      cases::check_format(operation, results);
      variants.push_back(cases::variant_of(operation, operands, results));
    }
  }
  return variants;
}

}  // namespace

cases::Operation evaluated_operation_named(std::string_view name) {
  const cases::Operation operation = cases::operation_named(name);
  if (cases::is_conversion(operation)) {
    throw support::UsageError(
        fmt::format("{} is a conversion, which only gen and check take", name));
  }
  return operation;
}

cases::Operation answered_operation_named(std::string_view name) {
  const cases::Operation operation = evaluated_operation_named(name);
  if (cases::is_sum(operation)) {
    throw support::UsageError(
        fmt::format("{} is a sum, which only gen, eval and check take", name));
  }
  return operation;
}

cases::Operation format_operation_named(std::string_view name) {
  const cases::Operation operation = answered_operation_named(name);
  if (std::ranges::find(format_operations, operation) == format_operations.end() &&
      !cases::is_function(operation) && !cases::is_quotient_function(operation)) {
    std::string operations;
    for (const cases::Operation o : format_operations) {
      operations += fmt::format("{}, ", cases::name_of(o));
    }
    throw support::UsageError(
        fmt::format("{} exists only in 16.16; with --format choose {}or a function: {}", name,
                    operations, cases::function_names()));
  }
  return operation;
}

std::vector<const parties::Party*> chosen_parties(const Selection& selection) {
  // Results of another format have one oracle.
  const bool is_fast = selection.level == 3 && selection.to.empty();
  std::vector<std::string> names;
  if (!selection.by.empty()) {
    names.push_back(selection.by);
  } else if (std::ranges::any_of(selection.against, parties::names_function)) {
    // It answers every variant that a function can, and the model does not.
    names.emplace_back(is_fast ? "fast" : "oracle");
  } else {
    names.emplace_back("model");
  }
  if (!selection.against.empty()) {
    names.insert(names.end(), selection.against.begin(), selection.against.end());
  } else if (is_fast) {
    names.insert(names.end(), {"model", "fast", "type"});
  } else {
    names.insert(names.end(), {"model", "oracle", "fast", "type"});
  }
  std::vector<const parties::Party*> chosen;
  for (const std::string& name : names) {
    const parties::Party* party = &parties::party_named(name);
    if (std::find(chosen.begin(), chosen.end(), party) == chosen.end()) chosen.push_back(party);
  }
  if (chosen.size() < 2) {
    throw support::UsageError(fmt::format(
        "'{}' alone cannot be compared; give another party to --against", names.front()));
  }
  return chosen;
}

std::vector<cases::Variant> chosen_variants(const Selection& selection) {
  std::vector<cases::Variant> variants = cases::all_variants();
  std::vector<cases::Operation> operations;
  for (const std::string& name : selection.operations) {
    operations.push_back(answered_operation_named(name));
    if (std::ranges::find(variants, operations.back(), &cases::Variant::operation) ==
        variants.end()) {
      throw support::UsageError(
          fmt::format("verify compares {} only in a format, such as --format q16_16", name));
    }
  }
  check_repaired(selection);
  std::erase_if(variants, [&](const cases::Variant& v) { return !fits(selection, operations, v); });
  return variants;
}

std::vector<cases::Variant> chosen_routines(const Selection& selection) {
  for (const std::string& name : selection.operations) {
    static_cast<void>(cases::routine_named(name));
  }
  std::vector<cases::Variant> variants = chosen_variants(selection);
  std::erase_if(variants, [](const cases::Variant& v) {
    return !parties::has_program(v) ||
           (v.operation == cases::Operation::cossin && !v.build.mul_round);
  });
  if (variants.empty())
    throw support::UsageError(
        "no routine matches these operations and options; leave some options out");
  return variants;
}

void add_programs_to(CLI::App& command, Selection& selection) {
  command.add_option("operations", selection.operations,
                     "mul, div, cossin, xformvec, concat, or the inner loops gouraud-byte, "
                     "gouraud-word, depth, texture; by default all");
  selection.variant.add_to(command);
}

Programs chosen_programs(const Selection& selection) {
  Selection routines = selection;
  std::vector<x86model::Loop> loops;
  std::erase_if(routines.operations, [&](const std::string& name) {
    const auto loop = machine_code::loop_named(name);
    if (loop) loops.push_back(*loop);
    return loop.has_value();
  });
  const VariantOptions& options = selection.variant;
  check_repaired(selection);
  const bool rounds = options.mul_round || options.div_round || options.as_printed ||
                      options.repaired || options.chapter_52;
  if (rounds && !loops.empty()) {
    throw support::UsageError(fmt::format(
        "{} is an inner loop: it has no rounding, chapter or repair; leave these options out",
        machine_code::name_of_loop(loops[0])));
  }
  Programs chosen;
  if (selection.operations.empty() || !routines.operations.empty()) {
    chosen.routines = chosen_routines(routines);
  }
  const auto asked = [&](const x86model::LoopForm& form) {
    const auto is_target = [&](cases::Target target) {
      return machine_code::model_target(target) == form.target;
    };
    if (!options.targets.empty() && std::ranges::none_of(options.targets, is_target)) return false;
    return selection.operations.empty() ? !rounds
                                        : std::ranges::find(loops, form.loop) != loops.end();
  };
  for (const x86model::LoopForm& form : x86model::all_loop_forms()) {
    if (asked(form)) chosen.loops.push_back(form);
  }
  if (chosen.routines.empty() && chosen.loops.empty()) {
    throw support::UsageError(
        "depth exists only for i386; leave out --target i8088");  // the others run on both
  }
  return chosen;
}

namespace {

/// Rejects a row that cannot be compared as requested. Skipping it would suggest that it is equal.
[[noreturn]] void refuse(const cases::Row& row, std::string_view reason) {
  throw support::UsageError(
      fmt::format("{}: {}; select other operations, another --target or other parties",
                  cases::name_of(row.variant), reason));
}

void refuse_without(const std::string& party, std::span<const cases::Row> rows) {
  for (const cases::Row& row : rows) {
    if (std::find(row.parties.begin(), row.parties.end(), party) != row.parties.end()) continue;
    refuse(row, fmt::format("{} does not answer", party));
  }
}

[[noreturn]] void throw_no_rows(const Selection& selection,
                                std::span<const cases::Variant> left_out) {
  if (left_out.empty() || selection.level < 3) {
    throw support::UsageError("no row has these operations and options; leave some options out");
  }
  throw support::UsageError(
      fmt::format("level 3 tries all cases, and {} has more than 2^32; choose --level 2{}",
                  cases::name_of(left_out.front()),
                  has_formats(selection) ? ", or a format of fewer bits" : ""));
}

}  // namespace

std::vector<cases::Row> chosen_rows(const Selection& selection,
                                    std::span<const parties::Party* const> parties) {
  std::vector<cases::Row> rows;
  const auto variants =
      has_formats(selection) ? variants_in_formats(selection) : chosen_variants(selection);
  for (const cases::Variant& listed : variants) {
    const auto variant_in_format = [&]() -> std::optional<cases::Variant> {
      if (selection.level == 3 && !cases::can_be_exhausted(listed)) return std::nullopt;
      return listed;
    };
    auto variant =
        has_formats(selection) ? variant_in_format() : cases::at_level(selection.level, listed);
    if (!variant) continue;
    if (selection.half_width) {
      // The cosine table has no 8.8 values, so that no party computes cossin in 8.8.
      if (variant->operation == cases::Operation::cossin) continue;
      variant->format = cases::q8_8;
    }
    rows.push_back(parties::row_of(*variant, parties));
  }
  if (rows.empty()) throw_no_rows(selection, variants);
  if (!selection.by.empty()) refuse_without(selection.by, rows);
  for (const std::string& party : selection.against) refuse_without(party, rows);
  for (const cases::Row& row : rows) {
    if (!row.compared())
      refuse(row, "fewer than two of the parties answer, so there is nothing to compare");
  }
  return rows;
}

}  // namespace fixproof::cli
