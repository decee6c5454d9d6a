// What `prove type` states of the type, with numbers in place of operands: what a statement asserts
// is true, it calls right what the type returns, and wrong everything else.
#include "judge/type/statements.hpp"

#include <fmt/format.h>

#include "judge/code/abstract_functions.hpp"
#include "judge/code/load.hpp"
#include "judge/type/compiled.hpp"
#include "judge/type/goal.hpp"
#include "judge/type/prove_goal.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/test.hpp"
#include "verify/proof/model.hpp"
#include "x86model/symbolic/evaluate.hpp"

namespace fixproof::judge {
namespace {

namespace sym = x86model::symbolic;
using proof::Arithmetic;

constexpr std::uint64_t cases_of_each = 4;
/// Every so many of the goals, which are of the same kinds in each format.
constexpr std::size_t one_in = 3;

const MayHold any_may_hold = [](sym::Term) { return true; };

/// A goal, and the paths of its function.
struct Followed {
  const Goal& goal;
  Image image;
  sym::Terms terms{};
  std::vector<Path> paths{};

  Followed(const Goal& followed, const std::string& object)
      : goal(followed), image(load_bytes("type.o", object, {.symbol = followed.symbol})) {
    Listing listing(image);
    const Signature& s = goal.signature;
    const Frame frame = convention_of_64_bits(false, s);
    SymbolicRun run = run_symbolically(image, frame, s, listing, terms, any_may_hold);
    if (run.obstacle.empty()) paths = std::move(run.paths);
  }

  /// Whether exact arithmetic says that a path breaks a claim.
  bool breaks(const Path& path, const Claim& claim, const std::vector<std::uint64_t>& words) {
    std::string model;
    for (std::size_t i = 0; i < words.size(); ++i) {
      model +=
          fmt::format("(define-fun {} () (_ BitVec {}) (_ bv{} {}))", operand_name(i),
                      goal.signature.operands[i].bits, words[i], goal.signature.operands[i].bits);
    }
    const std::string script =
        question({terms, paths, goal.signature.operands}, path, claim, "true", Arithmetic::exact);
    return proof::fault_of_model(script, "(" + model + ")").empty();
  }
};

Claim never(Claim claim) {
  claim.is_right = claim.may_fault = claim.may_trap = "false";
  return claim;
}

/// Tells what is wrong with the statements of a goal for operands; empty if nothing.
std::string fault_for(Followed& of, const std::vector<std::uint64_t>& words) {
  sym::Evaluation evaluation(of.terms, concrete_function);
  for (std::size_t i = 0; i < words.size(); ++i) evaluation.set(operand_name(i), words[i]);
  for (const Path& path : of.paths) {
    if (evaluation(path.condition) == 0) continue;
    for (const Statement& way : of.goal.says.ways) {
      if (!of.breaks(path, never(way(of.terms, path)), words)) return "asserts what is not so";
    }
    const Claim claim = of.goal.says.definition(of.terms, path);
    if (of.breaks(path, claim, words)) return "calls wrong what is right";
    Path other = path;
    if (path.returns()) {
      const std::uint64_t bit = std::uint64_t{1} << words[0] % 8;
      const std::uint64_t said = evaluation(path.result) ^ bit;
      other.result = of.terms.constant(said, of.goal.signature.result_bits);
      if (!of.breaks(other, claim, words)) return "calls right what is wrong";
      other.traps = true;
      if (!of.breaks(other, claim, words)) return "allows an error that is none";
    } else {
      other.traps = false;
      other.result = of.terms.constant(1, of.goal.signature.result_bits);
      other.kept = of.terms.truth(true);
      if (!of.breaks(other, claim, words)) return "asks for no error";
    }
    return "";
  }
  return "no path is taken";
}

TEST(TypeStatements, SayWhatIsSoAndNothingElse) {
  std::vector<Goal> some;
  const std::vector<Goal> all = goals();
  for (std::size_t i = 0; i < all.size(); i += one_in) some.push_back(all[i]);
  const std::string object = compiled({TYPE_COMPILER, "-O1", paths::source("")}, some);
  std::size_t followed = 0;
  for (const Goal& goal : some) {
    Followed of(goal, object);
    if (of.paths.empty() || !goal.says.definition) continue;
    ++followed;
    for (std::uint64_t n = 0; n < cases_of_each; ++n) {
      EXPECT_EQ(fault_for(of, operands_of(goal.signature, n)), "")
          << goal.operation << ' ' << goal.type << ' ' << n;
    }
  }
  // Only quotients of 128 bits have no paths.
  EXPECT_GT(followed, some.size() * 9 / 10);
}

}  // namespace
}  // namespace fixproof::judge
