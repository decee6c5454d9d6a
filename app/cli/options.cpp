#include "app/cli/options.hpp"

#include <fmt/format.h>

#include <map>

#include "app/cli/arguments.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

using Targets = std::map<std::string, std::vector<cases::Target>>;
const Targets targets_of_programs{{"i386", {cases::Target::i386}},
                                  {"i8088", {cases::Target::i8088}}};
const Targets targets_of_rows{{"i386", {cases::Target::i386}},
                              {"i8088", {cases::Target::i8088}},
                              {"both", {cases::Target::i386, cases::Target::i8088}},
                              {"standard", {cases::Target::standard}}};

}  // namespace

void add_rounding_options(CLI::App& command, std::optional<bool>& mul_round,
                          std::optional<bool>& div_round) {
  const auto on_off = [&command](const char* name, const char* what, auto set) {
    return command
        .add_option_function<std::string>(
            name, [set](const std::string& text) { set(text == "on"); }, what)
        ->check(one_of({"on", "off"}));
  };
  // Contradictory options exclude each other, because neither is the more likely intent.
  on_off("--round", "both roundings: on or off", [&](bool on) { mul_round = div_round = on; })
      ->excludes(on_off("--mul-round", "rounding of multiplies: on or off",
                        [&](bool on) { mul_round = on; }))
      ->excludes(on_off("--div-round", "rounding of divides: on or off",
                        [&](bool on) { div_round = on; }));
}

void VariantOptions::add_to(CLI::App& command, bool of_rows) {
  command
      .add_option_function<std::string>(
          "--target", [this](const std::string& t) { targets = targets_of_rows.at(t); },
          of_rows ? "rules of i386, of i8088, of both, or standard, those of fixproof::q16_16"
                  : "half of the listing: i386 or i8088")
      ->check(one_of(names_of(of_rows ? targets_of_rows : targets_of_programs)));
  add_rounding_options(command, mul_round, div_round);
  auto* printed =
      command.add_flag("--as-printed", as_printed,
                       "round as the printed switches say (docs/findings.md, 1); list and trace "
                       "also use the printed shift by two in CosSin (docs/findings.md, 8)");
  auto* chapter = command
                      .add_option_function<std::string>(
                          "--chapter", [this](const std::string& c) { chapter_52 = c == "52"; },
                          "chapter that prints the listing: 54, or 52 (386 only, always rounded)")
                      ->check(one_of({"52", "54"}));
  command
      .add_flag("--repaired", repaired,
                "use the repaired 8088 concat, which keeps a carry that the printed one loses; see "
                "docs/findings.md, 18")
      ->excludes(printed)
      ->excludes(chapter);
}

cases::Build VariantOptions::build_for(cases::Target target) const {
  const bool multiply = mul_round.value_or(true);
  // Chapter 52 has no switches. Its multiply and its divide always round.
  cases::Build build =
      as_printed
          ? cases::printed_build(target, multiply, div_round.value_or(chapter_52.value_or(false)))
          : cases::Build{target, multiply, div_round.value_or(true)};
  build.chapter_52 = chapter_52.value_or(false);
  build.repaired = repaired;
  return build;
}

bool VariantOptions::has_printed_shift(const cases::Variant& variant) const {
  return as_printed && variant.operation == cases::Operation::cossin &&
         variant.build.target == cases::Target::i8088;
}

cases::Variant VariantOptions::choose(cases::Operation operation) const {
  const cases::Build build = build_for(targets.empty() ? cases::Target::i386 : targets.front());
  const bool in_chapter_52 = operation == cases::Operation::mul ||
                             operation == cases::Operation::div ||
                             operation == cases::Operation::concat;
  if (build.chapter_52 && (!in_chapter_52 || build.target != cases::Target::i386 ||
                           !build.mul_round || !build.div_round)) {
    throw support::UsageError(
        "--chapter 52 has only mul, div and concat, for i386, rounded; use --chapter 54");
  }
  if (repaired && !cases::can_be_repaired(operation, build.target)) {
    throw support::UsageError(only_repaired);
  }
  return {.operation = operation, .build = build};
}

}  // namespace fixproof::cli
