/// @file
/// Judges the chapters' claims about speed by the clocks of the listings.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measure/accuracy/scene_operands.hpp"
#include "measure/clocks/bounds.hpp"
#include "support/json.hpp"
#include "x86model/clocks.hpp"

namespace fixproof::measure {

enum class ClaimVerdict { holds, does_not_hold, not_refuted, open, in_part };

/// How a measurement of the listings relates to a claim.
enum class Evidence {
  decides,
  can_show,    ///< the claimed quantity is at least the measured one
  can_refute,  ///< the measured condition is necessary but not sufficient
  neither,     ///< the claim covers more than is measured
};

/// `holds` if all of `measured` is allowed, `does_not_hold` if none of it is. `not_refuted` if it
/// is allowed but not sufficient. `open` if the tables' ranges or the evidence leave the claim
/// undecided.
ClaimVerdict judge(const Bounds& measured, const Bounds& allowed, Evidence evidence);

struct ClaimFigure {
  std::string where;  ///< scene, code and processor
  Bounds measured;
  ClaimVerdict verdict{};
};

struct Claim {
  std::string text;   ///< in our words
  std::string place;  ///< where it is printed: chapter and section
  std::string means;  ///< the measured quantity and the allowed range
  std::string unit;
  Bounds allowed;
  std::vector<ClaimFigure> figures;
};

/// The operands of a scene under five builds of the listings.
struct RecordedScene {
  std::string name;
  /// The 386 rounded and unrounded, the 8088 rounded and unrounded, then the 386 as printed, which
  /// rounds multiplies alone. The 8088 as printed rounds both.
  std::vector<SceneOperands> builds;
};

/// The builds in the order of RecordedScene::builds.
std::vector<cases::Build> recorded_builds();

/// A claim about speed that the listings cannot decide.
struct NotJudged {
  std::string_view text;
  std::string_view place;
  std::string_view reason;
};
std::span<const NotJudged> not_judged();

/// Judges every claim for these scenes.
std::vector<Claim> judge_claims(const std::vector<RecordedScene>& scenes);

/// The common verdict of the figures that are not open; `in_part` if they disagree.
ClaimVerdict verdict_on(const Claim& claim);

std::string name_of(ClaimVerdict verdict);

void to_json(support::Json& json, const Bounds& bounds);

/// {claim, place, means, unit, verdict, allowed: {min, max}, figures: a list of {where, measured:
/// {min, max}, verdict}}. Infinite bounds become null, because JSON has no number for them.
void to_json(support::Json& json, const Claim& claim);

}  // namespace fixproof::measure
