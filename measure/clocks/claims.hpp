/// @file
/// What the chapters say about speed, set against the clocks of the listings.
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

enum class Verdict { holds, does_not_hold, not_refuted, open, in_part };

/// What a measurement of the listings can say of a claim.
enum class Evidence {
  decides,
  can_show,    ///< what is claimed is at least as much as what is measured
  can_refute,  ///< what is measured is necessary, and not enough
  neither,     ///< the claim is of more than is measured
};

/// `holds` where all of `measured` is allowed, `does_not_hold` where none is; `not_refuted` where
/// it is allowed but not enough; `open` where the tables' ranges leave both possible, and for what
/// the evidence cannot say.
Verdict judge(const Bounds& measured, const Bounds& allowed, Evidence evidence);

/// One figure.
struct ClaimFigure {
  std::string where;  ///< which scene, code and processor
  Bounds measured;
  Verdict verdict{};
};

/// One published claim.
struct Claim {
  std::string text;   ///< in our words
  std::string place;  ///< where it is printed: chapter and section
  std::string means;  ///< what is measured, and what is allowed
  std::string unit;
  Bounds allowed;
  std::vector<ClaimFigure> figures;
};

/// A scene as each of five builds of the listings plays it.
struct RecordedScene {
  std::string name;
  /// For the 386 rounded, unrounded, for the 8088 the same; then for the 386 as printed, which
  /// rounds multiplies alone. The 8088's as printed rounds both.
  std::vector<SceneOperands> builds;
};

/// The builds of RecordedScene, in its order.
std::vector<cases::Build> recorded_builds();

/// A statement about speed that no measurement of the listings can judge.
struct NotJudged {
  std::string_view text;
  std::string_view place;
  std::string_view reason;
};
std::span<const NotJudged> not_judged();

/// Every claim with its figures for these scenes.
std::vector<Claim> judge_claims(const std::vector<RecordedScene>& scenes);

/// Of a claim as a whole: that of its figures, those left aside that are open; `in_part` where they
/// disagree.
Verdict verdict_on(const Claim& claim);

std::string name_of(Verdict verdict);

support::Json to_json(const Bounds& bounds);

/// {claim, place, means, unit, verdict, allowed: {min, max}, figures: a list of {where, measured:
/// {min, max}, verdict}}. Infinite bounds become null, because JSON has no number for them.
support::Json to_json(const Claim& claim);

}  // namespace fixproof::measure
