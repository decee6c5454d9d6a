#include "app/cli/json/check_json.hpp"

#include "judge/check/guess_text.hpp"
#include "judge/check/verdict_text.hpp"
#include "support/plain_text.hpp"
#include "verify/cases/variant.hpp"

namespace fixproof::cli {

namespace {

using support::Json;

Json example_json(const check::JudgedCase& one, const check::Rules& rules) {
  Json json;
  json["case"] = one.number;
  json["stream"] = support::printable(one.origin);
  json.update(answer_json(one, rules));
  json["text"] = check::text_of(one, rules);
  return json;
}

}  // namespace

Json answer_json(const check::JudgedCase& one, const check::Rules& rules) {
  const cases::Format& format = rules.variant.format;
  const bool is_text = rules.variant.operation == cases::Operation::to_decimal;
  const check::Expected expected = check::expected_of(one, rules);
  Json json;
  json["operands"] = check::line_of_operands(one, rules);
  json["expected"] = nullptr;
  // The result as its line, or as the word that a line of to_decimal stands for.
  if (expected.judged) {
    json["expected"] = is_text ? check::decimal_text(*expected.said, format)
                               : check::line_of_result(expected.said, format);
  }
  json["said"] = is_text ? one.said_text : check::line_of_result(one.said, format);
  json["kind"] = check::name_of(check::kind_of(one, rules), rules.variant.operation);
  return json;
}

Json check_json(const check::Judge& judge, const std::string& text, bool complete) {
  const check::Rules& rules = judge.rules();
  const cases::Variant& variant = rules.variant;
  Json json;
  json["operation"] = cases::name_of(variant.operation);
  json["format"] = cases::name_of(cases::operand_format(variant));
  json["to"] = cases::name_of(variant.format);
  json["right"] = judge.is_right();
  json["complete"] = complete;
  json["cases"] = judge.cases();
  json["wrong"] = judge.wrong();
  json["not_judged"] = judge.not_judged();
  json["rounding"] = nullptr;
  const check::RuleScore score = judge.trial().rounding().first;
  if (check::is_rounded(variant) && score.cases > 0) {
    json["rounding"] = {{"best", check::name_of(check::roundings()[check::best_rounding(judge)])},
                        {"cases", score.cases},
                        {"exceptions", score.exceptions.count()}};
  }
  json["follows"] = Json::array();
  for (const check::PortRule* rule : judge.ports().followed()) json["follows"] += rule->name;
  json["examples"] = Json::array();
  for (const check::JudgedCase& one : judge.shown()) {
    json["examples"] += example_json(one, rules);
  }
  json["text"] = text;
  return json;
}

}  // namespace fixproof::cli
