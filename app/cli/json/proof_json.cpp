#include "app/cli/json/proof_json.hpp"

#include <fmt/format.h>

#include <array>

#include "support/plain_text.hpp"
#include "verify/cases/words.hpp"

namespace fixproof::cli {

namespace {

using proof::Standing;
using support::Json;

constexpr std::array standings{Standing::proven, Standing::disproven, Standing::open,
                               Standing::one_sided, Standing::disputed};

/// The solver, and how many goals have each standing.
template <class Result>
Json summary_json(const SolverUse& solver, const std::vector<Result>& results, std::size_t all) {
  Json json;
  json["solver"] = solver.version;
  json["timeout"] = solver.seconds;
  json["complete"] = results.size() == all;
  json["counts"] = Json::object();
  for (const Standing standing : standings) {
    std::size_t count = 0;
    for (const Result& result : results) count += result.proof.standing == standing ? 1 : 0;
    json["counts"][std::string(word_of(standing))] = count;
  }
  json["counts"]["unanswered"] = all - results.size();
  return json;
}

Json goal_json(const GoalResult& goal) {
  const proof::Proof& proof = goal.proof;
  Json json;
  json["name"] = goal.name;
  json["standing"] = word_of(proof.standing);
  json["questions"] = proof.questions;
  json["seconds"] = proof.seconds;
  json["remarks"] = Json::array();
  for (const std::string& remark : proof.remarks) json["remarks"] += support::printable(remark);
  json["counterexample"] = nullptr;
  if (goal.variant && proof.standing == Standing::disproven) {
    const int bits = goal.variant->format.word_bits;
    json["counterexample"] = {
        {"operands", cases::hex_words(proof.counterexample, cases::operand_bits(*goal.variant))},
        {"program", proof.given.text(bits)},
        {"oracle", proof.wanted.text(bits)},
        {"replay", goal.replay}};
  }
  return json;
}

Json function_json(const FunctionResult& function) {
  const judge::GoalProof& proof = function.proof;
  Json json;
  json["compiler"] = function.compiler;
  json["level"] = function.level;
  json["operation"] = function.operation;
  json["type"] = function.type;
  json["standing"] = word_of(proof.standing);
  json["seconds"] = proof.seconds;
  json["why"] = support::printable(proof.why);
  json["counterexample"] = nullptr;
  if (proof.standing == Standing::disproven) {
    std::vector<std::string> words;
    for (const std::uint64_t word : proof.counterexample)
      words.push_back(fmt::format("{:x}", word));
    json["counterexample"] = {{"operands", words}, {"function", proof.given}};
  }
  return json;
}

}  // namespace

std::string_view word_of(Standing standing) {
  switch (standing) {
    case Standing::proven:
      return "proven";
    case Standing::disproven:
      return "disproven";
    case Standing::one_sided:
      return "one-sided";
    case Standing::disputed:
      return "disputed";
    case Standing::open:
      break;
  }
  return "not decided";
}

Json goals_json(const SolverUse& solver, const std::vector<GoalResult>& goals, std::size_t all) {
  Json json = summary_json(solver, goals, all);
  json["goals"] = Json::array();
  for (const GoalResult& goal : goals) json["goals"] += goal_json(goal);
  return json;
}

Json functions_json(const SolverUse& solver, const std::vector<FunctionResult>& functions,
                    std::size_t all) {
  Json json = summary_json(solver, functions, all);
  json["functions"] = Json::array();
  for (const FunctionResult& function : functions) json["functions"] += function_json(function);
  return json;
}

}  // namespace fixproof::cli
