#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/cli/measure_text.hpp"
#include "support/plain_text.hpp"
#include "x86model/text.hpp"

namespace fixproof::cli {

namespace {

std::string row_text(const measure::CallClocks& row) {
  const bool has_switch = row.variant.operation != cases::Operation::cossin;
  const auto mean = [](const measure::Spread& s) {
    return s.calls() == 0 ? "-" : between(s.mean_min(), s.mean_max(), 1);
  };
  std::string text;
  for (const measure::ProcessorClocks& on : row.processors) {
    std::string bus;
    if (on.bus) bus = fmt::format("  {:>9}  {}", mean(*on.bus), on.mean().limit());
    text += fmt::format("{:<8}  {:<10}  {:<8}  {:<4}  {:>6}{:>9}{:>7}  {:>7}{:>15}{:>8}{}\n",
                        cases::name_of(row.variant.operation),
                        fmt::format("{}{}", cases::name_of(row.variant.build.target),
                                    row.variant.build.chapter_52 ? " ch52" : ""),
                        !has_switch                  ? "-"
                        : cases::rounds(row.variant) ? "on"
                                                     : "off",
                        x86model::name_of(on.cpu), support::grouped(row.instructions.least()),
                        mean(row.instructions), support::grouped(row.instructions.most()),
                        support::grouped(on.clocks.least()), mean(on.clocks),
                        support::grouped(on.clocks.most()), bus);
  }
  return text;
}

std::string frames_text(const std::vector<measure::FrameOn8088>& frames) {
  const auto whole = [](double x) { return support::grouped(static_cast<std::uint64_t>(x)); };
  std::string text = fmt::format(
      "\nA frame on an 8088: clocks of the listings by Intel's table, bytes and clocks of the bus, "
      "and which\nof the two is the limit.\n\n{:<22}{:<10}{:>12}{:>10}{:>10}{:>12}  {}\n",
      "scene", "rounding", "table", "code", "data", "bus", "limit");
  for (const measure::FrameOn8088& f : frames) {
    text += fmt::format("{:<22}{:<10}{:>12}{:>10}{:>10}{:>12}  {}\n", support::printable(f.scene),
                        f.rounds ? "on" : "off", whole(f.clocks.table.max), whole(f.code_bytes),
                        whole(f.data_bytes), whole(f.clocks.bus), f.clocks.limit());
  }
  return text;
}

std::string not_judged_text() {
  std::string text = "\nNot judged:\n";
  for (const measure::NotJudged& statement : measure::not_judged()) {
    text += fmt::format("\n{} ({})\n  {}\n", statement.text, statement.place, statement.reason);
  }
  return text;
}

std::string row_text(const measure::LoopClocks& row) {
  std::string text =
      fmt::format("{:<24}{:<10}{:<7}", measure::name_of(row.form, row.pixels),
                  x86model::name_of(row.form.counting), measure::target_name(row.form));
  for (std::size_t i = 0; i < row.on.size(); ++i) {
    const auto& clocks = row.on.at(i);
    const x86model::Cpu cpu = measure::loop_processors.at(i);
    const std::string table = clocks ? between(clocks->table.min, clocks->table.max, 1) : "-";
    if (cpu == x86model::Cpu::i8088) {
      text += fmt::format("{:>9}{:>6}", table, clocks ? fmt::format("{:.1f}", clocks->bus) : "-");
    } else {
      text += fmt::format("{:>{}}", table, cpu == x86model::Cpu::i486 ? 12 : 10);
    }
  }
  return text + '\n';
}

std::string claim_text(const measure::LoopClaim& claim) {
  std::string text = fmt::format("\n{} ({})\n", claim.text, claim.place);
  for (const measure::LoopGain& gain : claim.gains) {
    text += fmt::format("  {:<65}{:>10} times  {}\n", gain.where, between(gain.min, gain.max, 2),
                        gain.min > 1    ? "holds"
                        : gain.max <= 1 ? "does not hold"
                                        : "open");
  }
  return text;
}

std::string means_text(const std::vector<std::string>& scenes) {
  if (scenes.empty()) {
    return "Means are over the cases of level 1. Name a SCENE to measure its operands and to judge "
           "the claims.\n";
  }
  std::vector<std::string> names;
  for (const std::string& scene : scenes) names.push_back(support::printable(scene));
  return fmt::format("Means are over the operands of {}, {} frames of each.\n",
                     fmt::join(names, ", "), measure::recorded_frames);
}

}  // namespace

std::string text_of(const measure::ClockResult& result) {
  std::string text =
      made_by(result.seed) + "\n\n" + means_text(result.scenes) +
      "Least and most also include the cases of level 1. Two numbers mean that Intel's tables give "
      "a "
      "range.\nThe caller's PUSHes and CALL are not counted, and calls that end in #DE are left "
      "out.\n"
      "Bus: the mean clocks that an 8088 needs for the bytes of code and data, 4 for each. "
      "Its bus fetches while\nit executes, so a call takes at least the larger of the two means, "
      "which the column limit names. Code\nthat is fetched and discarded at a jump is not "
      "counted. Other processors have wider buses, whose time is\nnot counted.\n\n";
  text += fmt::format("{:<8}  {:<10}  {:<8}  {:<4}  {:>22}  {:>30}\n", "", "", "", "",
                      "instructions", "clocks");
  text += fmt::format("{:<8}  {:<10}  {:<8}  {:<4}  {:>6}{:>9}{:>7}  {:>7}{:>15}{:>8}  {:>9}  {}\n",
                      "routine", "target", "rounding", "cpu", "least", "mean", "most", "least",
                      "mean", "most", "bus", "limit");
  for (const measure::CallClocks& row : result.rows) text += row_text(row);
  if (!result.scenes.empty()) text += frames_text(result.frames);
  if (!result.claims.empty()) {
    text +=
        "\nPublished claims, and the clocks of the listings alone. \"About\" allows a fifth less "
        "and a "
        "quarter more.\nA claim is open if the ranges of Intel's tables allow both answers, or if "
        "the "
        "listings cannot decide.\n";
    for (const measure::Claim& claim : result.claims) text += text_of(claim);
    text += not_judged_text();
  }
  text +=
      "\nInner loops: clocks per pixel of a long span, by Intel's tables and on the bus of an "
      "8088.\n"
      "An 8088 takes at least the larger of the two.\n\n" +
      fmt::format("{:<24}{:<10}{:<7}{:>9}{:>6}{:>10}{:>10}{:>12}\n", "loop", "counting", "code",
                  "8088", "bus", "286", "386", "486");
  for (const measure::LoopClocks& row : result.loops) text += row_text(row);
  for (const measure::LoopClaim& claim : result.loop_claims) text += claim_text(claim);
  return text;
}

}  // namespace fixproof::cli
