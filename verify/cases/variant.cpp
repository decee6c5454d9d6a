#include "verify/cases/variant.hpp"

#include <fmt/format.h>

#include <span>
#include <stdexcept>

#include "support/edits.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cases {

namespace {

/// Returns the operation called `name` among `known`; `kind` is for the error message, and so is
/// `list`, which says where the names are. If it is empty, the message has them.
Operation named(std::string_view name, std::string_view kind, std::span<const OperationRow> known,
                std::string_view list) {
  std::string all;
  std::string nearest;
  std::string_view beginning;  // the longest name that `name` begins with, as mul in multiply
  std::size_t fewest_edits = name.size() < 5 ? 1 : 2;
  for (const OperationRow& other : known) {
    if (other.name == name) return other.operation;
    all += fmt::format("{}{}", all.empty() ? "" : ", ", other.name);
    if (name.starts_with(other.name) && other.name.size() > beginning.size()) {
      beginning = other.name;
    }
    const std::size_t edits = support::edits_between(name, other.name);
    if (edits > fewest_edits) continue;
    if (edits < fewest_edits) nearest.clear();
    fewest_edits = edits;
    nearest += fmt::format("{}{}", nearest.empty() ? "" : " or ", other.name);
  }
  if (nearest.empty()) nearest = beginning;
  const std::string meant = nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest);
  const std::string choice = list.empty()      ? fmt::format("choose one of {}", all)
                             : nearest.empty() ? fmt::format("choose mul, div or another: {}", list)
                                               : std::string(list);
  throw std::invalid_argument(fmt::format("unknown {} '{}'{}; {}", kind, name, meant, choice));
}

}  // namespace

std::string_view name_of(Target t) {
  switch (t) {
    case Target::i386:
      return "i386";
    case Target::i8088:
      return "i8088";
    case Target::standard:
      break;
  }
  return "standard";
}

Operation operation_named(std::string_view name) {
  return named(name, "operation", operations, "fixproof gen --help lists all");
}

void check_format(Operation operation, const Format& format) {
  if (is_in_format(operation, format)) return;
  throw support::UsageError(fmt::format("{} has {}, which {} is not", name_of(operation),
                                        operation == Operation::remainder
                                            ? "signed formats"
                                            : "formats such as q16_16, with a "
                                              "unit from 2^-64 to 1",
                                        name_of(format)));
}

std::string function_names() {
  std::string all;
  for (const OperationRow& row : operations) {
    if (row.kind != Kind::function && row.kind != Kind::quotient) continue;
    all += fmt::format("{}{}", all.empty() ? "" : ", ", row.name);
  }
  return all;
}

Operation routine_named(std::string_view name) {
  return named(name, "routine", std::span(operations).first<5>(), "");
}

std::vector<Variant> all_variants() {
  std::vector<Variant> all;
  for (const Operation o : {Operation::mul, Operation::div, Operation::cossin, Operation::xformvec,
                            Operation::concat}) {
    for (const Target t : {Target::i386, Target::i8088}) {
      for (const bool round : {true, false}) {
        all.push_back(
            {.operation = o, .build = {.target = t, .mul_round = round, .div_round = round}});
      }
    }
  }
  for (const Operation o : {Operation::mul, Operation::div, Operation::concat}) {
    all.push_back({.operation = o, .build = {.target = Target::i386, .chapter_52 = true}});
  }
  for (const bool round : {true, false}) {
    all.push_back(
        {.operation = Operation::concat,
         .build = {
             .target = Target::i8088, .mul_round = round, .div_round = round, .repaired = true}});
  }
  for (const Operation o :
       {Operation::mul, Operation::div, Operation::xformvec, Operation::concat, Operation::sqrt,
        Operation::sin, Operation::cos, Operation::decimal, Operation::binary64}) {
    all.push_back({.operation = o, .build = {.target = Target::standard}});
  }
  return all;
}

std::string name_of(const Variant& v) {
  std::string name = fmt::format("{} {}", name_of(v.operation), name_of(v.build.target));
  if (v.build.target != Target::standard) name += fmt::format(" {}", rounds(v) ? "on" : "off");
  if (v.build.chapter_52) name += ", chapter 52";
  if (v.build.repaired) name += ", repaired";
  if (v.from) {
    name += fmt::format(", {} to {}", name_of(*v.from), name_of(v.format));
  } else if (v.format == q8_8) {
    name += ", 8.8";
  } else if (v.format != q16_16) {
    name += fmt::format(", {}", name_of(v.format));
  }
  return name;
}

}  // namespace fixproof::cases
