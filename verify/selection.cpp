#include "verify/selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "verify/machine_code/programs.hpp"
#include "verify/parties/parties.hpp"
#include "verify/text.hpp"
#include "verify/usage_error.hpp"

namespace fixproof {

namespace {

/// Whether a rounding that was given fits the variant's. The standard rules have none to choose:
/// they fit only where none is asked for, or rounding, and nothing of them was printed.
bool rounding_fits(const VariantOptions& options, const Variant& v) {
  if (options.as_printed && v.target == Target::standard) return false;
  if (v.operation == Operation::div) {
    auto wanted = options.div_round;
    // As in VariantOptions::choose(): the listings print rounded multiplies and unrounded divides.
    if (options.as_printed) {
      wanted = VariantOptions::div_round_as_printed(v.target, wanted.value_or(false));
    }
    return !wanted || *wanted == v.div_round;
  }
  const auto wanted = options.as_printed ? options.mul_round.value_or(true) : options.mul_round;
  return !wanted || *wanted == v.mul_round;
}

/// @throws UsageError for --repaired with an operation or a target that has no repaired routine
void check_repaired(const Selection& selection) {
  const VariantOptions& options = selection.variant;
  if (!options.repaired) return;
  const bool only_concat = std::all_of(selection.operations.begin(), selection.operations.end(),
                                       [](const std::string& name) { return name == "concat"; });
  const bool has_8088 = options.targets.empty() ||
                        std::find(options.targets.begin(), options.targets.end(), Target::i8088) !=
                            options.targets.end();
  if (!only_concat || !has_8088) throw UsageError(only_repaired);
}

bool fits(const Selection& selection, const std::vector<Operation>& operations, const Variant& v) {
  const VariantOptions& options = selection.variant;
  return (operations.empty() ||
          std::find(operations.begin(), operations.end(), v.operation) != operations.end()) &&
         (options.targets.empty() || std::find(options.targets.begin(), options.targets.end(),
                                               v.target) != options.targets.end()) &&
         (!selection.chapter_given || (options.chapter_52 == v.chapter_52 && !v.repaired)) &&
         (!options.repaired || v.repaired) && !(options.as_printed && v.repaired) &&
         rounding_fits(options, v);
}

}  // namespace

std::vector<const Party*> chosen_parties(const Selection& selection) {
  std::vector<std::string> names{selection.by.empty() ? "model" : selection.by};
  if (!selection.against.empty()) {
    names.insert(names.end(), selection.against.begin(), selection.against.end());
  } else if (selection.level == 3) {
    names.insert(names.end(), {"model", "fast", "type"});
  } else {
    names.insert(names.end(), {"model", "oracle", "fast", "type"});
  }
  std::vector<const Party*> chosen;
  for (const std::string& name : names) {
    const Party* party = &party_named(name);
    if (std::find(chosen.begin(), chosen.end(), party) == chosen.end()) chosen.push_back(party);
  }
  if (chosen.size() < 2) {
    throw UsageError(
        fmt::format("'{}' alone cannot be compared: give --against another", names.front()));
  }
  return chosen;
}

std::vector<Variant> chosen_variants(const Selection& selection) {
  std::vector<Operation> operations;
  for (const std::string& name : selection.operations) operations.push_back(operation_named(name));
  check_repaired(selection);
  std::vector<Variant> variants = all_variants();
  std::erase_if(variants, [&](const Variant& v) { return !fits(selection, operations, v); });
  return variants;
}

std::vector<Variant> chosen_routines(const Selection& selection) {
  for (const std::string& name : selection.operations) static_cast<void>(routine_named(name));
  std::vector<Variant> variants = chosen_variants(selection);
  std::erase_if(variants, [](const Variant& v) {
    return !has_program(v) || (v.operation == Operation::cossin && !v.mul_round);
  });
  if (variants.empty()) throw UsageError("no routine has these operations and options");
  return variants;
}

Programs chosen_programs(const Selection& selection) {
  Selection routines = selection;
  std::vector<x86model::Loop> loops;
  std::erase_if(routines.operations, [&](const std::string& name) {
    const auto loop = loop_named(name);
    if (loop) loops.push_back(*loop);
    return loop.has_value();
  });
  const VariantOptions& options = selection.variant;
  check_repaired(selection);
  const bool rounds = options.mul_round || options.div_round || options.as_printed ||
                      options.repaired || selection.chapter_given;
  if (rounds && !loops.empty()) {
    throw UsageError(
        fmt::format("{} rounds nothing, and is of no chapter", name_of_loop(loops[0])));
  }
  Programs chosen;
  if (selection.operations.empty() || !routines.operations.empty()) {
    chosen.routines = chosen_routines(routines);
  }
  const auto asked = [&](const x86model::LoopForm& form) {
    const auto target = form.target == x86model::Target::i386 ? Target::i386 : Target::i8088;
    const auto is_among = [](const auto& all, const auto& one) {
      return std::find(all.begin(), all.end(), one) != all.end();
    };
    if (!options.targets.empty() && !is_among(options.targets, target)) return false;
    return selection.operations.empty() ? !rounds : is_among(loops, form.loop);
  };
  for (const x86model::LoopForm& form : x86model::all_loop_forms()) {
    if (asked(form)) chosen.loops.push_back(form);
  }
  if (chosen.routines.empty() && chosen.loops.empty()) {
    throw UsageError("the loop depth is for the 386 alone");  // all others are for both
  }
  return chosen;
}

namespace {

/// A row that is not compared as it was asked for would be taken for one that is equal, were it
/// passed over.
[[noreturn]] void refuse(const Row& row, std::string_view reason) {
  throw UsageError(fmt::format("{}: {}; choose rows (--target, the operations) or other parties",
                               name_of(row.variant), reason));
}

void refuse_without(const std::string& party, std::span<const Row> rows) {
  for (const Row& row : rows) {
    if (std::find(row.parties.begin(), row.parties.end(), party) != row.parties.end()) continue;
    refuse(row, fmt::format("{} does not answer", party));
  }
}

}  // namespace

std::vector<Row> chosen_rows(const Selection& selection, std::span<const Party* const> parties) {
  std::vector<Row> rows;
  for (const Variant& listed : chosen_variants(selection)) {
    auto variant = at_level(selection.level, listed);
    if (!variant) continue;
    if (selection.half_width) {
      // The table has no cosines of 8.8, and so nobody has.
      if (variant->operation == Operation::cossin) continue;
      variant->fraction_bits = 8;
    }
    rows.push_back(row_of(*variant, parties));
  }
  if (rows.empty()) {
    throw UsageError(
        fmt::format("level {} has no row for these operations and options", selection.level));
  }
  if (!selection.by.empty()) refuse_without(selection.by, rows);
  for (const std::string& party : selection.against) refuse_without(party, rows);
  for (const Row& row : rows) {
    if (!row.compared()) refuse(row, "nothing to compare, fewer than two of the parties answer");
  }
  return rows;
}

Shard parse_shard(const std::string& text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ec == std::errc{} && index.ptr != end && *index.ptr == '/') {
    const auto count = std::from_chars(index.ptr + 1, end, shard.count);
    if (count.ec == std::errc{} && count.ptr == end && shard.index >= 1 &&
        shard.index <= shard.count) {
      return shard;
    }
  }
  throw UsageError(fmt::format("--shard {}: i/n is wanted, 1 <= i <= n", text));
}

}  // namespace fixproof
