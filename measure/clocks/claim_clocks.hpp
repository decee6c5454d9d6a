/// @file
/// The clocks and figures by which the claims are judged.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "cases/variant.hpp"
#include "measure/clocks/claims.hpp"

namespace fixproof::measure {

inline constexpr cases::Build i386_rounded = cases::uniform_builds[0];
inline constexpr cases::Build i386_unrounded = cases::uniform_builds[1];
/// The builds that the printed switches select: the 386 rounds multiplies alone, the 8088 both.
inline constexpr cases::Build i386_printed = cases::printed_build(cases::Target::i386);
inline constexpr cases::Build i8088_printed = cases::printed_build(cases::Target::i8088);

/// Up to a fifth less or a quarter more.
constexpr Bounds about(double figure) { return {figure / 1.25, figure * 1.25}; }
inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Scenes whose frames a second are published.
inline constexpr std::string_view cubes_scene = "twelve cubes";
inline constexpr std::string_view ball_scene = "shaded ball";

/// Whether an 8088 fetches code while it executes.
enum class Fetching {
  meanwhile,  ///< the least time: the larger of table and bus time
  waiting,    ///< it waits for every byte of code: table time plus the code's bus time
};

/// The operands that a scene has for a build.
/// @throws std::out_of_range if the build is not one of recorded_builds()
const SceneOperands& operands_of(const RecordedScene& scene, const cases::Build& build);

/// Clocks of the listings in a frame of a scene. Only an 8088 fetches.
Bounds clocks_a_frame(const RecordedScene& scene, const cases::Build& build, x86model::Cpu cpu,
                      Fetching fetching = Fetching::meanwhile);

Bounds ratio(const Bounds& a, const Bounds& b);

/// Adds a figure with its verdict, unless there is nothing to compare.
void add_figure(Claim& claim, std::string where, const Bounds& measured,
                Evidence evidence = Evidence::decides);

/// The claims of chapters 52 and 53, which are about the 386 alone.
std::vector<Claim> judge_claims_of_the_386(const std::vector<RecordedScene>& scenes);

}  // namespace fixproof::measure
