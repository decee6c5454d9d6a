#include "trade/clocks/claim_text.hpp"

#include <fmt/format.h>

#include <iostream>

#include "support/json.hpp"
#include "support/plain_text.hpp"
#include "trade/figures.hpp"

namespace fixproof::trade {

namespace {

using support::Json;

Json json_of(const Bounds& b) { return {{"min", b.min}, {"max", b.max}}; }

}  // namespace

Json json_of_claim(const Claim& claim) {
  Json figures = Json::array();
  for (const ClaimFigure& f : claim.figures) {
    figures.push_back(
        {{"where", f.where}, {"measured", json_of(f.measured)}, {"verdict", name_of(f.verdict)}});
  }
  return {{"claim", claim.text},
          {"place", claim.place},
          {"means", claim.means},
          {"unit", claim.unit},
          {"verdict", name_of(verdict_on(claim))},
          {"allowed", json_of(claim.allowed)},
          {"figures", std::move(figures)}};
}

void print_claim(const Claim& claim) {
  std::cout << fmt::format("\n{} ({})\n=> {}\n({})\n", claim.text, claim.place,
                           name_of(verdict_on(claim)), claim.means);
  for (const ClaimFigure& f : claim.figures) {
    std::cout << fmt::format("  {:<45}{:>15} {:<16} {}\n", support::printable(f.where),
                             between(f.measured.min, f.measured.max, 2), claim.unit,
                             name_of(f.verdict));
  }
}

Json not_judged_json() {
  Json json = Json::array();
  for (const NotJudged& statement : not_judged()) {
    json.push_back(
        {{"claim", statement.text}, {"place", statement.place}, {"reason", statement.reason}});
  }
  return json;
}

void print_not_judged() {
  std::cout << "\nNot judged:\n";
  for (const NotJudged& statement : not_judged()) {
    std::cout << fmt::format("\n{} ({})\n  {}\n", statement.text, statement.place,
                             statement.reason);
  }
}

}  // namespace fixproof::trade
