#include "cli/options.hpp"

#include <fmt/format.h>

#include <map>

#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

const std::map<std::string, bool> on_off{{"on", true}, {"off", false}};
using Targets = std::map<std::string, std::vector<cases::Target>>;
const Targets targets_of_programs{{"i386", {cases::Target::i386}},
                                  {"i8088", {cases::Target::i8088}}};
const Targets targets_of_rows{{"i386", {cases::Target::i386}},
                              {"i8088", {cases::Target::i8088}},
                              {"both", {cases::Target::i386, cases::Target::i8088}},
                              {"standard", {cases::Target::standard}}};

}  // namespace

void VariantOptions::add_to(CLI::App& command, bool of_rows) {
  const auto named = [](const auto& names) { return CLI::IsMember(&names); };
  command
      .add_option_function<std::string>(
          "--target", [this](const std::string& t) { targets = targets_of_rows.at(t); },
          of_rows ? "whose rules: i386, i8088, both of these, or standard (those of the type)"
                  : "which half of the listing: i386 or i8088")
      ->check(named(of_rows ? targets_of_rows : targets_of_programs));
  // Which of two that contradict each other is meant, nobody can know.
  auto* both =
      command
          .add_option_function<std::string>(
              "--round", [this](const std::string& r) { mul_round = div_round = on_off.at(r); },
              "both roundings: on or off")
          ->check(named(on_off));
  command
      .add_option_function<std::string>(
          "--mul-round", [this](const std::string& r) { mul_round = on_off.at(r); },
          "rounding of multiplies: on or off")
      ->check(named(on_off))
      ->excludes(both);
  command
      .add_option_function<std::string>(
          "--div-round", [this](const std::string& r) { div_round = on_off.at(r); },
          "rounding of divides: on or off")
      ->check(named(on_off))
      ->excludes(both);
  auto* printed =
      command.add_flag("--as-printed", as_printed,
                       "take roundings from the printed switches (docs/findings.md, 1); "
                       "list and trace take CosSin's shift by two as well (8)");
  auto* chapter = command
                      .add_option_function<std::string>(
                          "--chapter", [this](const std::string& c) { chapter_52 = c == "52"; },
                          "which printing: 54, or 52 (386 only, always rounded)")
                      ->check(CLI::IsMember({"52", "54"}));
  command
      .add_flag("--repaired", repaired,
                "the 8088 concat with the carry that its listing loses: see docs/findings.md, 18")
      ->excludes(printed)
      ->excludes(chapter);
}

cases::Variant VariantOptions::choose(cases::Operation operation) const {
  cases::Variant v{.operation = operation,
                   .target = targets.empty() ? cases::Target::i386 : targets.front()};
  v.mul_round = mul_round.value_or(true);
  // The listings of chapter 54 print rounded multiplies and unrounded divides; chapter 52 has no
  // switch.
  v.div_round = div_round.value_or(!as_printed || chapter_52);
  if (as_printed) v.div_round = div_round_as_printed(v.target, v.div_round);
  v.chapter_52 = chapter_52;
  const bool printed_there = operation == cases::Operation::mul ||
                             operation == cases::Operation::div ||
                             operation == cases::Operation::concat;
  if (chapter_52 &&
      (!printed_there || v.target != cases::Target::i386 || !v.mul_round || !v.div_round)) {
    throw support::UsageError("--chapter 52 has only mul, div and concat, for the 386, rounded");
  }
  v.repaired = repaired;
  if (repaired && (operation != cases::Operation::concat || v.target != cases::Target::i8088)) {
    throw support::UsageError(only_repaired);
  }
  return v;
}

}  // namespace fixproof::cli
