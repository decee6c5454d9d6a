/// @file
/// What the chapters say about speed, set against the clocks of the listings.
#pragma once

#include <string>
#include <vector>

#include "verify/measure/scene_operands.hpp"
#include "x86model/clocks.hpp"

namespace fixproof {

/// A figure that is known within bounds, both included.
struct Bounds {
  double min = 0;
  double max = 0;
};

enum class Verdict { holds, does_not_hold, open, in_part };

/// `holds` where all of `measured` is allowed, `does_not_hold` where none is, `open` where the
/// tables' ranges leave both possible.
Verdict judge(const Bounds& measured, const Bounds& allowed);

/// One figure.
struct ClaimFigure {
  std::string where;  ///< which scene, code and processor
  Bounds measured;
  Verdict verdict{};
};

/// One published claim.
struct Claim {
  std::string text;   ///< in our words
  std::string means;  ///< what is measured, and what is allowed
  std::string unit;
  Bounds allowed;
  std::vector<ClaimFigure> figures;
};

/// A scene as each of four builds of the listings plays it.
struct RecordedScene {
  std::string name;
  std::vector<SceneOperands> builds;  ///< for the 386 rounded, unrounded, for the 8088 the same
};

/// The builds of RecordedScene, in its order.
std::vector<xsharp::ArithmeticChoice> recorded_builds();

/// Every claim with its figures for these scenes.
std::vector<Claim> judge_claims(const std::vector<RecordedScene>& scenes);

/// Of a claim as a whole: that of its figures, those left aside that are open; `in_part` where they
/// disagree.
Verdict verdict_on(const Claim& claim);

std::string name_of(Verdict verdict);

}  // namespace fixproof
