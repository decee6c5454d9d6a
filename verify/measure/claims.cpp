#include "verify/measure/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "verify/measure/call_clocks.hpp"
#include "verify/scenes/frame_clocks.hpp"

namespace fixproof {

namespace {

using x86model::Cpu;

/// The places of RecordedScene::builds.
enum class Build : std::size_t { i386_on, i386_off, i8088_on, i8088_off, i386_printed };
/// What was measured when the claims were made.
constexpr Build i8088_printed = Build::i8088_on;

/// Up to a fifth less or a quarter more.
constexpr Bounds about(double figure) { return {figure / 1.25, figure * 1.25}; }
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Scenes whose frames a second are published.
constexpr std::string_view cubes = "twelve cubes";
constexpr std::string_view ball = "shaded ball";
/// Of the twelve cubes on a 386 of 20 MHz.
constexpr double published_frames = 15;

/// Megahertz of the machines that are compared.
constexpr double pc = 4.77;
constexpr double at = 8;
constexpr double early_386 = 20;
constexpr double fast_486 = 33;

/// Clocks of the listings in a frame of a scene.
Bounds clocks_a_frame(const RecordedScene& scene, Build build, Cpu cpu) {
  const SceneOperands& operands = scene.builds.at(static_cast<std::size_t>(build));
  const x86model::Range clocks = clocks_of(operands.log, operands.choice, cpu);
  const auto frames = static_cast<double>(operands.frames);
  return {static_cast<double>(clocks.min) / frames, static_cast<double>(clocks.max) / frames};
}

Bounds seconds(const Bounds& clocks, double megahertz) {
  return {clocks.min / megahertz / 1e6, clocks.max / megahertz / 1e6};
}

Bounds ratio(const Bounds& a, const Bounds& b) { return {a.min / b.max, a.max / b.min}; }

/// What a build that rounds takes more, in percent of one that does not. Both meet the same ranges
/// in the same instructions: least is set against least, most against most.
Bounds surplus(const Bounds& a, const Bounds& b) {
  const double least = 100 * (a.min / b.min - 1);
  const double most = 100 * (a.max / b.max - 1);
  return {std::min(least, most), std::max(least, most)};
}

void add(Claim& claim, std::string where, const Bounds& measured,
         Evidence evidence = Evidence::decides) {
  // A scene that never calls a routine has no figure for it.
  if (!std::isfinite(measured.min) || !std::isfinite(measured.max)) return;
  claim.figures.push_back({std::move(where), measured, judge(measured, claim.allowed, evidence)});
}

Claim switch_to_8088(const std::vector<RecordedScene>& scenes) {
  Claim claim{
      "The switch to 8088 instructions makes the fixed-point work about 2.5 times slower.",
      "8088 listings over 386 listings, as printed (the 386's cut quotients, the 8088's round), "
      "on one\nprocessor, a frame; 2 to 3.125",
      "times",
      about(2.5),
      {}};
  for (const RecordedScene& scene : scenes) {
    for (const Cpu cpu : {Cpu::i386, Cpu::i486}) {
      add(claim, fmt::format("{} on a {}", scene.name, name_of(cpu)),
          ratio(clocks_a_frame(scene, i8088_printed, cpu),
                clocks_a_frame(scene, Build::i386_printed, cpu)));
    }
  }
  return claim;
}

Claim cost_of_rounding(const std::vector<RecordedScene>& scenes) {
  Claim claim{
      "Rounding costs little.",
      "listings that round over those that do not, a frame; at most 10 % more. And the same "
      "clocks\nas a share of the published frame of the cubes, a 15th of a second of 20 MHz",
      "%",
      {-unlimited, 10},
      {}};
  for (const RecordedScene& scene : scenes) {
    const auto compare = [&](Build on, Build off, Cpu cpu, const char* code) {
      add(claim,
          fmt::format("{}, {} listings on {} {}", scene.name, code, cpu == Cpu::i8088 ? "an" : "a",
                      name_of(cpu)),
          surplus(clocks_a_frame(scene, on, cpu), clocks_a_frame(scene, off, cpu)));
    };
    compare(Build::i386_on, Build::i386_off, Cpu::i386, "386");
    compare(Build::i386_on, Build::i386_off, Cpu::i486, "386");
    compare(Build::i8088_on, Build::i8088_off, Cpu::i8088, "8088");
    compare(Build::i8088_on, Build::i8088_off, Cpu::i286, "8088");
    if (scene.name != cubes) continue;
    const Bounds on = clocks_a_frame(scene, Build::i386_on, Cpu::i386);
    const Bounds off = clocks_a_frame(scene, Build::i386_off, Cpu::i386);
    const double share = 100 * (on.max - off.max) / (early_386 * 1e6 / published_frames);
    add(claim, fmt::format("{}, of the whole frame on a 386", scene.name), {share, share});
  }
  return claim;
}

/// The mean clocks of a call of one routine, over the operands that a scene has for it.
Bounds clocks_a_call(const RecordedScene& scene, Operation operation, Target target) {
  static const std::atomic<bool> never{false};
  const SceneOperands& operands = scene.builds.at(static_cast<std::size_t>(Build::i386_on));
  CallClocks clocks = no_calls({.operation = operation, .target = target});
  const std::vector<std::uint32_t> words =
      operation == Operation::mul ? products_of(operands.log)
                                  : operands.log.at(static_cast<std::size_t>(operation));
  add_calls(clocks, words, true, never);
  for (const ProcessorClocks& on : clocks.processors) {
    if (on.cpu == Cpu::i386) return {on.clocks.mean_min(), on.clocks.mean_max()};
  }
  return {};
}

Claim native_instructions(const std::vector<RecordedScene>& scenes) {
  Claim claim{
      "The native 32-bit multiply and divide were the second key to speed.",
      "a call with 16-bit MUL and DIV over one with 32-bit IMUL and DIV, rounded, on a 386; twice "
      "at\nleast. What they replaced in C were library calls, which nobody prints. The 8088 divide "
      "drops the\ndivisor's fraction and does less than those: it can show the claim, not refute "
      "it.",
      "times",
      {2, unlimited},
      {}};
  for (const RecordedScene& scene : scenes) {
    for (const Operation operation : {Operation::mul, Operation::div}) {
      add(claim,
          fmt::format("{}, {}", scene.name, operation == Operation::mul ? "FixedMul" : "FixedDiv"),
          ratio(clocks_a_call(scene, operation, Target::i8088),
                clocks_a_call(scene, operation, Target::i386)),
          operation == Operation::div ? Evidence::can_show : Evidence::decides);
    }
  }
  return claim;
}

struct Machine {
  Cpu cpu;
  double megahertz;
  Build build;
};

Claim machines(const std::vector<RecordedScene>& scenes, std::string text, std::string means,
               double times, const Machine& slow, const Machine& fast,
               Evidence evidence = Evidence::decides) {
  Claim claim{std::move(text), std::move(means), "times", about(times), {}};
  for (const RecordedScene& scene : scenes) {
    const auto time = [&](const Machine& m) {
      return seconds(clocks_a_frame(scene, m.build, m.cpu), m.megahertz);
    };
    add(claim, scene.name, ratio(time(slow), time(fast)), evidence);
  }
  return claim;
}

/// A necessary condition: the listings alone have to fit into the frame.
Claim frames_a_second(const std::vector<RecordedScene>& scenes, std::string_view wanted_scene,
                      std::string text, double wanted, const Machine& m) {
  Claim claim{
      std::move(text),
      fmt::format(
          "what the listings would allow if nothing had to be drawn: that can refute it and is not "
          "enough\nto show it; at least {}",
          wanted),
      "frames a second",
      {wanted, unlimited},
      {}};
  for (const RecordedScene& scene : scenes) {
    if (scene.name != wanted_scene) continue;
    add(claim, scene.name,
        ratio({1, 1}, seconds(clocks_a_frame(scene, m.build, m.cpu), m.megahertz)),
        Evidence::can_refute);
  }
  return claim;
}

}  // namespace

Verdict judge(const Bounds& measured, const Bounds& allowed, Evidence evidence) {
  const bool shows = evidence == Evidence::decides || evidence == Evidence::can_show;
  const bool refutes = evidence == Evidence::decides || evidence == Evidence::can_refute;
  const bool inside = allowed.min <= measured.min && measured.max <= allowed.max;
  const bool outside = measured.max < allowed.min || allowed.max < measured.min;
  if (inside && shows) return Verdict::holds;
  if (inside && refutes) return Verdict::not_refuted;
  if (outside && refutes) return Verdict::does_not_hold;
  return Verdict::open;
}

Verdict verdict_on(const Claim& claim) {
  Verdict all = Verdict::open;
  for (const ClaimFigure& f : claim.figures) {
    if (f.verdict == Verdict::open || f.verdict == all) continue;
    if (all != Verdict::open) return Verdict::in_part;
    all = f.verdict;
  }
  return all;
}

std::string name_of(Verdict verdict) {
  static constexpr std::array names{"holds", "does not hold", "not refuted", "open",
                                    "holds in part"};
  return names.at(static_cast<std::size_t>(verdict));
}

std::vector<xsharp::ArithmeticChoice> recorded_builds() {
  return {listing_choice("i386", true),
          listing_choice("i386", false),
          listing_choice("i8088", true),
          listing_choice("i8088", false),
          {"model", "i386", true, false}};
}

std::vector<Claim> judge_claims(const std::vector<RecordedScene>& scenes) {
  const Machine pc_8088{Cpu::i8088, pc, i8088_printed};
  const Machine at_8088{Cpu::i286, at, i8088_printed};
  const Machine same_486{Cpu::i486, fast_486, i8088_printed};
  const Machine native_486{Cpu::i486, fast_486, Build::i386_printed};
  std::vector<Claim> claims{
      switch_to_8088(scenes),
      cost_of_rounding(scenes),
      native_instructions(scenes),
      machines(scenes, "An 8 MHz AT is about 10 times slower than a 486 at 33 MHz.",
               "8088 listings on a 286 at 8 MHz over 386 listings on a 486, as printed, seconds a "
               "frame; 8 to 12.5.\nPublished as 6 and 60 frames a second of whole animations, of "
               "which the 486 has cycles to spare:\nthe listings alone can neither show nor refute "
               "it",
               10, at_8088, native_486, Evidence::neither),
      frames_a_second(scenes, ball,
                      "An AT at 8 MHz animates the shaded ball about 6 times a second.", 6,
                      at_8088),
      frames_a_second(scenes, ball,
                      "A 486 at 33 MHz animates it 60 times a second, with cycles to spare.", 60,
                      native_486),
      frames_a_second(scenes, cubes,
                      "A 386 at 20 MHz animates the twelve cubes about 15 times a second.",
                      published_frames, {Cpu::i386, early_386, Build::i386_on}),
      machines(
          scenes, "A PC is perhaps 40 times slower than a 486 at 33 MHz.",
          "8088 listings, as printed, at 4.77 MHz over the same on the 486, seconds a frame; 32 "
          "to 50",
          40, pc_8088, same_486),
      machines(scenes, "With its 8088 instructions that makes a hundred.",
               "8088 listings on the PC over 386 listings on the 486, seconds a frame; 80 to 125",
               100, pc_8088, native_486),
  };
  std::erase_if(claims, [](const Claim& claim) { return claim.figures.empty(); });
  return claims;
}

}  // namespace fixproof
