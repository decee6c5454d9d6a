#include "measure/clocks/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "measure/clocks/claim_clocks.hpp"

namespace fixproof::measure {

namespace {

using x86model::Cpu;

constexpr const char* opening = "chapter 54, opening, before listing 54.1";

/// Clock rates of the compared machines in MHz.
constexpr double pc = 4.77;
constexpr double at = 8;
constexpr double fast_486 = 33;

Bounds seconds(const Bounds& clocks, double megahertz) {
  return {clocks.min / megahertz / 1e6, clocks.max / megahertz / 1e6};
}

Claim switch_to_8088(const std::vector<RecordedScene>& scenes) {
  Claim claim{
      "The switch to 8088 instructions makes the fixed-point work about 2.5 times slower.",
      opening,
      "8088 listings over 386 listings, as printed (the 386's cut quotients, the 8088's round), "
      "on one\nprocessor, a frame; 2 to 3.125. The text names no processor. It multiplies the "
      "figure by the 40 times\nbetween a PC and a 486/33 to get a hundred. That takes the figure "
      "of the 486, so the 486 decides",
      "times",
      about(2.5),
      {}};
  for (const RecordedScene& scene : scenes) {
    for (const Cpu cpu : {Cpu::i386, Cpu::i486}) {
      add_figure(claim, fmt::format("{} on a {}", scene.name, name_of(cpu)),
                 ratio(clocks_per_frame(scene, i8088_printed, cpu),
                       clocks_per_frame(scene, i386_printed, cpu)),
                 cpu == Cpu::i486 ? Evidence::decides : Evidence::neither);
    }
  }
  return claim;
}

struct Machine {
  Cpu cpu{};
  double megahertz = 0;
  cases::Build build;
};

/// An 8088 has two figures: with bus and table time overlapping, and without any overlap. Its real
/// time lies between them, so a verdict that both share does not depend on the overlap.
Claim machines(const std::vector<RecordedScene>& scenes, std::string text, std::string means,
               double times, const Machine& slow, const Machine& fast,
               Evidence evidence = Evidence::decides, const char* place = opening) {
  Claim claim{std::move(text), place, std::move(means), "times", about(times), {}};
  for (const RecordedScene& scene : scenes) {
    const auto time = [&](const Machine& m, Fetching fetching) {
      return seconds(clocks_per_frame(scene, m.build, m.cpu, fetching), m.megahertz);
    };
    const Bounds fast_time = time(fast, Fetching::meanwhile);
    const bool fetches = slow.cpu == Cpu::i8088;
    add_figure(claim, scene.name + (fetches ? ", code fetched meanwhile" : ""),
               ratio(time(slow, Fetching::meanwhile), fast_time), evidence);
    if (!fetches) continue;
    add_figure(claim, scene.name + ", code waited for",
               ratio(time(slow, Fetching::waiting), fast_time), evidence);
  }
  return claim;
}

/// A necessary condition: the clocks of the listings alone must fit into the frame.
Claim claim_of_frame_rate(const std::vector<RecordedScene>& scenes, std::string text, double wanted,
                          const Machine& m) {
  Claim claim{
      std::move(text),
      opening,
      fmt::format(
          "what the listings would allow if nothing had to be drawn: that can refute it and is not "
          "enough\nto show it; at least {}",
          wanted),
      "frames a second",
      {wanted, unlimited},
      {}};
  for (const RecordedScene& scene : scenes) {
    if (scene.name != ball_scene) continue;
    add_figure(claim, scene.name,
               ratio({1, 1}, seconds(clocks_per_frame(scene, m.build, m.cpu), m.megahertz)),
               Evidence::can_refute);
  }
  return claim;
}

}  // namespace

ClaimVerdict judge(const Bounds& measured, const Bounds& allowed, Evidence evidence) {
  const bool shows = evidence == Evidence::decides || evidence == Evidence::can_show;
  const bool refutes = evidence == Evidence::decides || evidence == Evidence::can_refute;
  const bool inside = allowed.min <= measured.min && measured.max <= allowed.max;
  const bool outside = measured.max < allowed.min || allowed.max < measured.min;
  if (inside && shows) return ClaimVerdict::holds;
  if (inside && refutes) return ClaimVerdict::not_refuted;
  if (outside && refutes) return ClaimVerdict::does_not_hold;
  return ClaimVerdict::open;
}

ClaimVerdict verdict_on(const Claim& claim) {
  ClaimVerdict all = ClaimVerdict::open;
  for (const ClaimFigure& f : claim.figures) {
    if (f.verdict == ClaimVerdict::open || f.verdict == all) continue;
    if (all != ClaimVerdict::open) return ClaimVerdict::in_part;
    all = f.verdict;
  }
  return all;
}

std::string name_of(ClaimVerdict verdict) {
  static constexpr std::array names{"holds", "does not hold", "not refuted", "open",
                                    "holds in part"};
  return names.at(static_cast<std::size_t>(verdict));
}

void to_json(support::Json& json, const Bounds& bounds) {
  json = {{"min", bounds.min}, {"max", bounds.max}};
}

static void to_json(support::Json& json, const ClaimFigure& f) {
  json = {{"where", f.where}, {"measured", f.measured}, {"verdict", name_of(f.verdict)}};
}

void to_json(support::Json& json, const Claim& claim) {
  json = {{"claim", claim.text},
          {"place", claim.place},
          {"means", claim.means},
          {"unit", claim.unit},
          {"verdict", name_of(verdict_on(claim))},
          {"allowed", claim.allowed},
          {"figures", claim.figures}};
}

std::vector<cases::Build> recorded_builds() {
  std::vector<cases::Build> builds(cases::uniform_builds.begin(), cases::uniform_builds.end());
  builds.push_back(i386_printed);
  return builds;
}

std::vector<Claim> judge_claims(const std::vector<RecordedScene>& scenes) {
  const Machine pc_8088{Cpu::i8088, pc, i8088_printed};
  const Machine at_8088{Cpu::i286, at, i8088_printed};
  const Machine same_486{Cpu::i486, fast_486, i8088_printed};
  const Machine native_486{Cpu::i486, fast_486, i386_printed};
  std::vector<Claim> claims = judge_claims_of_the_386(scenes);
  const auto add = [&claims](Claim claim) { claims.push_back(std::move(claim)); };
  add(switch_to_8088(scenes));
  add(machines(
      scenes, "A PC is perhaps 40 times slower than a 486 at 33 MHz.",
      "8088 listings, as printed, at 4.77 MHz over the same on the 486, seconds a frame; 32 "
      "to 50. A real\n8088 lies between its two figures: it fetches some code while it "
      "executes, and waits for some",
      40, pc_8088, same_486));
  add(machines(scenes, "With its 8088 instructions that makes a hundred.",
               "8088 listings on the PC over 386 listings on the 486, seconds a frame; 80 to 125",
               100, pc_8088, native_486));
  add(claim_of_frame_rate(
      scenes,
      "A 486 at 33 MHz animates the shaded ball 60 times a second, with cycles to "
      "spare.",
      60, native_486));
  add(claim_of_frame_rate(scenes, "An AT at 8 MHz animates it about 6 times a second.", 6,
                          at_8088));
  add(machines(scenes, "An 8 MHz AT is about 10 times slower than a 486 at 33 MHz.",
               "8088 listings on a 286 at 8 MHz over 386 listings on a 486, as printed, seconds a "
               "frame; 8 to 12.5.\nPublished as 6 and 60 frames a second of whole animations, of "
               "which the 486 has cycles to spare:\nthe listings alone can neither show nor refute "
               "it",
               10, at_8088, native_486, Evidence::neither,
               "not printed: our quotient of 60 and 6 frames a second"));
  std::erase_if(claims, [](const Claim& claim) { return claim.figures.empty(); });
  return claims;
}

}  // namespace fixproof::measure
