// The claims of chapters 52 and 53, whose listings are for the 386 alone.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "measure/clocks/call_clocks.hpp"
#include "measure/clocks/claim_clocks.hpp"
#include "measure/clocks/frame_clocks.hpp"
#include "measure/clocks/replay.hpp"
#include "measure/player/model_call.hpp"

namespace fixproof::measure {

namespace {

using x86model::Cpu;

constexpr const char* three_keys = "chapter 52, three keys to real-time performance";
constexpr const char* raw_speed = "chapter 53, raw speed by assembly language";
constexpr const char* rounding_section = "chapter 53, rounding";

/// Frames per second of the twelve cubes on a 20 MHz 386.
constexpr double published_frames = 15;
constexpr double clocks_of_published_frame = 20e6 / published_frames;
/// Chapter 53's limit for the share of the time spent on fixed-point work.
constexpr double published_share = 0.1;

/// The operands of a routine in a scene. FixedMul has the factors of the transforms, too.
std::vector<std::uint32_t> operands_in(const RecordedScene& scene, cases::Operation operation) {
  const player::OperandLog& log = operands_of(scene, i386_rounded).log;
  return operation == cases::Operation::mul ? products_of(log)
                                            : log.at(static_cast<std::size_t>(operation));
}

/// The clocks per call of a routine on a 386, over its operands in a scene.
Spread clocks_on_386(const RecordedScene& scene, const cases::Variant& variant) {
  static constexpr std::array cpus{Cpu::i386};
  Spread clocks;
  replay_calls(variant, operands_in(scene, variant.operation), cpus, [&](const ReplayedCall& call) {
    if (call.ending.outcome == x86model::Outcome::returned) clocks.add(call.counters[0].total());
    return true;
  });
  return clocks;
}

Claim native_instructions(const std::vector<RecordedScene>& scenes) {
  Claim claim{
      "The native 32-bit multiply and divide were the second key to speed.",
      three_keys,
      "a call with 16-bit MUL and DIV over one with 32-bit IMUL and DIV, rounded, on a 386; at "
      "least\ntwice. In C they replaced library calls, which are not printed. The 8088 divide "
      "drops the divisor's\nfraction, so it does less: it can show the claim, but not refute it",
      "times",
      {2, unlimited},
      {}};
  for (const RecordedScene& scene : scenes) {
    for (const cases::Operation operation : {cases::Operation::mul, cases::Operation::div}) {
      const auto mean = [&](cases::Target target) {
        const Spread clocks =
            clocks_on_386(scene, {.operation = operation, .build = {.target = target}});
        return Bounds{clocks.mean_min(), clocks.mean_max()};
      };
      add_figure(claim,
                 fmt::format("{}, {}", scene.name,
                             operation == cases::Operation::mul ? "FixedMul" : "FixedDiv"),
                 ratio(mean(cases::Target::i8088), mean(cases::Target::i386)),
                 operation == cases::Operation::div ? Evidence::can_show : Evidence::decides);
    }
  }
  return claim;
}

/// The extra clocks of a rounding build, in percent. Both builds have the same ranges in the same
/// instructions, so minimum is compared with minimum and maximum with maximum.
Bounds surplus(const Bounds& a, const Bounds& b) {
  const double least = 100 * (a.min / b.min - 1);
  const double most = 100 * (a.max / b.max - 1);
  return {std::min(least, most), std::max(least, most)};
}

Claim cost_of_rounding(const std::vector<RecordedScene>& scenes) {
  Claim claim{
      "The performance cost of rounding is small.",
      rounding_section,
      "386 listings, the only ones of that chapter: those that round over those that do not, a "
      "frame; at\nmost 10 % more. The figures of the whole program take fixed-point work as a "
      "tenth of the time, as\nthe same chapter says",
      "%",
      {-unlimited, 10},
      {}};
  for (const RecordedScene& scene : scenes) {
    for (const Cpu cpu : {Cpu::i386, Cpu::i486}) {
      const Bounds more = surplus(clocks_per_frame(scene, i386_rounded, cpu),
                                  clocks_per_frame(scene, i386_unrounded, cpu));
      const std::string where = fmt::format("{} on a {}", scene.name, name_of(cpu));
      add_figure(claim, where, more);
      if (cpu != Cpu::i386) continue;
      const double saved = published_share * (1 - 1 / (1 + more.max / 100));
      const double of_whole = 100 * saved / (1 - saved);
      add_figure(claim, where + ", of the whole program", {of_whole, of_whole});
    }
  }
  return claim;
}

/// The largest difference between a rounded and an unrounded result, in ulps.
double max_changed(cases::Operation operation, const RecordedScene& scene) {
  const std::vector<std::uint32_t> words = operands_in(scene, operation);
  std::int32_t most = 0;
  for (std::size_t i = 0; i + 2 <= words.size(); i += 2) {
    const auto result = [&](bool rounds, std::array<std::uint32_t, 1>& out) {
      return player::call_model(
          {.operation = operation,
           .build = {.target = cases::Target::i386, .mul_round = rounds, .div_round = rounds}},
          std::span(words).subspan(i, 2), out);
    };
    std::array<std::uint32_t, 1> rounded{};
    std::array<std::uint32_t, 1> truncated{};
    if (!result(true, rounded) || !result(false, truncated)) continue;
    most = std::max(most, std::abs(static_cast<std::int32_t>(rounded[0] - truncated[0])));
  }
  return most;
}

Claim effect_of_rounding(const std::vector<RecordedScene>& scenes) {
  Claim claim{
      "Rounded and truncated results differ by 2^-16 at most.",
      rounding_section,
      "the largest difference of any product and quotient in the scenes, by the 386 listings, in "
      "units of\n2^-16; at most 1. It follows from the listings: they add half a unit before "
      "they cut a product, and\n0 or 1 to a quotient afterwards",
      "units",
      {0, 1},
      {}};
  for (const RecordedScene& scene : scenes) {
    const double most = std::max(max_changed(cases::Operation::mul, scene),
                                 max_changed(cases::Operation::div, scene));
    add_figure(claim, scene.name, {most, most});
  }
  return claim;
}

/// The least share of the time for the matrix routines, assuming that no frame of chapter 53 takes
/// longer than those of chapter 52. The text suggests that but does not say it.
Claim share_of_matrix_math(const std::vector<RecordedScene>& scenes) {
  Claim claim{"In assembly language, matrix math takes less than ten percent of the time.",
              raw_speed,
              "ConcatXforms and XformVec, rounded, on a 386 at 20 MHz, as a share of the 15th of a "
              "second that a\nframe takes in chapter 52; at most 10. In shorter frames the share "
              "is larger, so this can refute the\nclaim, but not show it",
              "%",
              {0, 100 * published_share},
              {}};
  for (const RecordedScene& scene : scenes) {
    if (scene.name != cubes_scene) continue;
    const SceneOperands& operands = operands_of(scene, i386_rounded);
    player::OperandLog log;
    for (const cases::Operation operation :
         {cases::Operation::xformvec, cases::Operation::concat}) {
      log.at(static_cast<std::size_t>(operation)) = operands_in(scene, operation);
    }
    const auto clocks = static_cast<double>(clocks_of(log, operands.build, Cpu::i386).table.max);
    const double share =
        100 * clocks / static_cast<double>(operands.frames) / clocks_of_published_frame;
    add_figure(claim, scene.name, {share, share}, Evidence::can_refute);
  }
  return claim;
}

/// In chapter 52, only multiply and divide are in assembly.
Claim cubes_in_c(const std::vector<RecordedScene>& scenes) {
  Claim claim{
      "A 386 at 20 MHz animates the twelve cubes about 15 times a second.",
      three_keys,
      "what the calls of FixedMul and FixedDiv, the assembly of that chapter, would allow; at "
      "least 15.\nConcatXforms and XformVec are C there. They call FixedMul 36 and 9 times, "
      "which gives the first number\nof calls. Their loops, pushes and sums, the emulator's sines "
      "and cosines and all of the drawing come\non top. So this can refute the claim, but not "
      "show it",
      "frames a second",
      {published_frames, unlimited},
      {}};
  for (const RecordedScene& scene : scenes) {
    if (scene.name != cubes_scene) continue;
    const SceneOperands& operands = operands_of(scene, i386_rounded);
    const auto frames = static_cast<double>(operands.frames);
    const auto calls = [&](cases::Operation operation) {
      return clocks_on_386(scene, {.operation = operation, .build = {.chapter_52 = true}});
    };
    const Spread multiplies = calls(cases::Operation::mul);
    const Spread divides = calls(cases::Operation::div);
    const auto number = [](const Spread& s) { return static_cast<double>(s.calls()); };
    const auto clocks = [&](const Spread& s) { return number(s) * s.mean_max(); };
    const std::size_t words =
        operands.log.at(static_cast<std::size_t>(cases::Operation::mul)).size();
    const double single = static_cast<double>(words) / cases::words_in(cases::Operation::mul);
    const double rate = 20e6 * frames / (clocks(multiplies) + clocks(divides));
    add_figure(claim,
               fmt::format("{}, {:.0f} + {:.0f} FixedMul, {:.0f} FixedDiv", scene.name,
                           (number(multiplies) - single) / frames, single / frames,
                           number(divides) / frames),
               {rate, rate}, Evidence::can_refute);
  }
  return claim;
}

}  // namespace

std::vector<Claim> judge_claims_of_the_386(const std::vector<RecordedScene>& scenes) {
  return {cubes_in_c(scenes), native_instructions(scenes), share_of_matrix_math(scenes),
          cost_of_rounding(scenes), effect_of_rounding(scenes)};
}

}  // namespace fixproof::measure
