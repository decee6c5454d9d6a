/// @file
/// The clocks and figures that decide the claims.
#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "measure/clocks/claims.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::measure {

inline constexpr cases::Build i386_rounded = cases::uniform_builds[0];
inline constexpr cases::Build i386_unrounded = cases::uniform_builds[1];
/// The builds with the printed switches: the 386 rounds multiplies alone, the 8088 rounds both.
inline constexpr cases::Build i386_printed = cases::printed_build(cases::Target::i386);
inline constexpr cases::Build i8088_printed = cases::printed_build(cases::Target::i8088);

/// A range from a fifth below the figure to a quarter above it.
constexpr Bounds about(double figure) { return {figure / 1.25, figure * 1.25}; }
inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The scenes with published frame rates.
inline constexpr std::string_view cubes_scene = "twelve cubes";
inline constexpr std::string_view ball_scene = "shaded ball";

/// Whether an 8088 fetches code while it executes.
enum class Fetching {
  meanwhile,  ///< the least time: the larger of table and bus time
  waiting,    ///< every code byte stalls the processor: table time plus the bus time of the code
};

/// The operands of a scene under a build.
/// @throws std::out_of_range if the build is not one of recorded_builds()
const SceneOperands& operands_of(const RecordedScene& scene, const cases::Build& build);

/// Clocks of the listings per frame of a scene. `fetching` matters on the 8088 alone.
Bounds clocks_per_frame(const RecordedScene& scene, const cases::Build& build, x86model::Cpu cpu,
                        Fetching fetching = Fetching::meanwhile);

Bounds ratio(const Bounds& a, const Bounds& b);

/// Adds a figure with its verdict, unless `measured` is not finite.
void add_figure(Claim& claim, std::string where, const Bounds& measured,
                Evidence evidence = Evidence::decides);

/// The claims of chapters 52 and 53, which are about the 386 alone.
std::vector<Claim> judge_claims_of_the_386(const std::vector<RecordedScene>& scenes);

}  // namespace fixproof::measure
