#include "app/cli/profile_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "measure/trade/profile/places.hpp"
#include "support/plain_text.hpp"
#include "x86model/text.hpp"

namespace fixproof::cli {

namespace {

constexpr int word_bits = 32;

std::string in_units(std::int64_t value) {
  return fmt::format("{:.5f}", static_cast<double>(value) / 65536.0);
}

int bits_there(cases::Operation operation, bool is_operand) {
  return operation == cases::Operation::cossin && is_operand ? word_bits / 2 : word_bits;
}

std::string calls_text(const trade::SceneProfile& profile) {
  std::string text = fmt::format("{:<10}{:>12}{:>12}{:>12}{:>12}{:>8}{:>16}\n", "", "calls",
                                 "least", "mean", "most", "#DE", "instructions");
  for (const trade::RoutineProfile& r : profile.routines) {
    const double frames = static_cast<double>(std::max<std::uint64_t>(1, profile.frames));
    text += fmt::format("{:<10}{:>12}{:>12}{:>12.1f}{:>12}{:>8}{:>16}\n",
                        cases::name_of(r.variant.operation), support::grouped(r.calls),
                        support::grouped(r.least_in_frame), static_cast<double>(r.calls) / frames,
                        support::grouped(r.max_in_frame), support::grouped(r.faults),
                        support::grouped(r.instructions));
  }
  return text +
         "Least, mean and most: calls in a frame; the first frame includes the lookups made "
         "once.\n";
}

std::string range_row(cases::Operation operation, std::string_view name,
                      const trade::ValueRange& range, bool is_operand) {
  if (range.empty()) return "";
  const bool angle = operation == cases::Operation::cossin && is_operand;
  const auto shown = [angle](std::int64_t value) {
    return angle ? fmt::format("{:.1f}", static_cast<double>(value) / 10) : in_units(value);
  };
  return fmt::format("{:<10}{:<20}{:>14}{:>14}{:>6}{:>10}\n", cases::name_of(operation), name,
                     shown(range.least()), shown(range.greatest()), range.bits(),
                     bits_there(operation, is_operand) - range.bits());
}

std::string ranges_text(const trade::SceneProfile& profile) {
  std::string text =
      fmt::format("{:<30}{:>14}{:>14}{:>6}{:>10}\n", "", "least", "greatest", "bits", "to spare");
  for (const trade::RoutineProfile& r : profile.routines) {
    const cases::Operation operation = r.variant.operation;
    for (std::size_t i = 0; i < r.operands.size(); ++i) {
      text += range_row(operation, trade::operand_names(operation)[i], r.operands[i], true);
    }
    for (std::size_t i = 0; i < r.results.size(); ++i) {
      text += range_row(operation, fmt::format("= {}", trade::result_names(operation)[i]),
                        r.results[i], false);
    }
  }
  return text;
}

std::string wrapped_text(const trade::SceneProfile& profile) {
  std::uint64_t wrapped = 0;
  for (const trade::RoutineProfile& r : profile.routines) wrapped += r.wrapped;
  if (wrapped == 0) return "Overflow: every result fits 16.16";
  return fmt::format("Overflow: {} calls had a result outside 16.16", support::grouped(wrapped));
}

int max_bits(const trade::SceneProfile& profile) {
  int bits = 0;
  for (const trade::RoutineProfile& r : profile.routines) {
    for (const trade::ValueRange& range : r.results) bits = std::max(bits, range.bits());
    if (r.variant.operation == cases::Operation::cossin) continue;
    for (const trade::ValueRange& range : r.operands) bits = std::max(bits, range.bits());
  }
  return bits;
}

/// Describes where quotients overflow. The rounded 386 divide wraps before it faults. The 8088
/// divide only wraps; its faults depend on the divisor alone.
std::string quotient_limit(const trade::SceneProfile& profile) {
  if (profile.arithmetic.target == "i8088") return " (from 32768 they wrap)";
  return profile.arithmetic.div_round ? " (from 32768 they wrap, from 65536 they fault)"
                                      : " (from 32768 they fault)";
}

std::string closeness_text(const trade::SceneProfile& profile) {
  const int bits = max_bits(profile);
  std::string text = fmt::format("{}; the widest word has {} bits, {} to spare.\n",
                                 wrapped_text(profile), bits, word_bits - bits);
  const trade::DivideProfile& divides = profile.divides;
  if (divides.least_divisor) {
    text += fmt::format("Divide: divisors from {} in magnitude (below 1 the 8088 listing faults)",
                        in_units(*divides.least_divisor));
    if (divides.greatest_quotient) {
      text += fmt::format(", quotients to {}{}", in_units(*divides.greatest_quotient),
                          quotient_limit(profile));
    }
    text += ".\n";
  }
  const trade::ViewProfile& view = profile.view;
  if (view.nearest) {
    text +=
        fmt::format("Near plane, z = -1: the nearest vertex that is not clipped is at z = {}.\n",
                    in_units(*view.nearest));
  }
  text += fmt::format("Faces with a corner clipped: {} of {}.\n",
                      support::grouped(view.clipped_faces), support::grouped(view.faces));
  if (view.out_of_reach > 0) {
    text += fmt::format("Objects too far away for 16.16: left out {} times.\n",
                        support::grouped(view.out_of_reach));
  }
  return text;
}

/// Lists the unused instructions, as in `FixedDiv: 2 of 40 instructions: 7 neg edx; 9 js .FD1`.
std::string unexecuted_text(const trade::RoutineProfile& r) {
  const auto name = x86model::name_of(static_cast<x86model::Routine>(r.variant.operation));
  if (r.calls == 0) return fmt::format("  {}: never called\n", name);
  std::vector<std::string> never;
  for (std::size_t at = 0; at < r.program.size; ++at) {
    if (!r.executed[at]) {
      never.push_back(fmt::format("{} {}", at, x86model::text_of(r.program.code.at(at))));
    }
  }
  if (never.empty()) return "";
  return fmt::format("  {}: {} of {} instructions: {}\n", name, never.size(), r.program.size,
                     fmt::join(never, "; "));
}

std::string unused_text(const trade::SceneProfile& profile) {
  const trade::FormUse forms = forms_of(profile);
  const int bits = max_bits(profile);
  std::string text = "Never needed by this scene:\n";
  for (const trade::RoutineProfile& r : profile.routines) text += unexecuted_text(r);
  if (!forms.never.empty()) {
    text += fmt::format("  {} of {} forms of instructions: {}\n", forms.never.size(),
                        forms.never.size() + forms.executed.size(), fmt::join(forms.never, "; "));
  }
  if (bits < word_bits) {
    text += fmt::format("  {} of {} bits: {} before the point suffice, including the sign\n",
                        word_bits - bits, word_bits, std::max(1, bits - 16));
  }
  return text;
}

}  // namespace

std::string text_of(const trade::SceneProfile& profile) {
  return calls_text(profile) + '\n' + ranges_text(profile) + '\n' + closeness_text(profile) + '\n' +
         unused_text(profile);
}

}  // namespace fixproof::cli
