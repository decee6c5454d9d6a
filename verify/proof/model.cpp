#include "verify/proof/model.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>
#include <vector>

#include "verify/proof/evaluate.hpp"
#include "verify/proof/s_expression.hpp"

namespace fixproof::proof {

namespace {

/// A script's functions, which may refer to earlier ones, and its assertions.
struct Question {
  std::map<std::string, Function> functions{};
  std::vector<std::string> constants{};  ///< defined ones, in order
  std::vector<const Expression*> assertions{};
};

Function declared_function(const std::vector<Expression>& parts) {
  Function function{.parameters = {}, .result = sort_of(parts.back())};
  if (parts[0].atom == "declare-fun") {
    for (const Expression& sort : parts.at(2).list) {
      function.parameters.emplace_back("", sort_of(sort));
    }
  }
  return function;
}

Question question_in(const std::vector<Expression>& script) {
  Question question;
  for (const Expression& command : script) {
    const std::vector<Expression>& parts = command.list;
    if (parts.empty()) throw std::invalid_argument("not a command: " + text_of(command));
    const std::string& name = parts[0].atom;
    if (name == "declare-const" || name == "declare-fun") {
      question.functions[parts.at(1).atom] = declared_function(parts);
    } else if (name == "define-fun") {
      question.functions[parts.at(1).atom] = defined_function(command);
      if (parts[2].list.empty()) question.constants.push_back(parts[1].atom);
    } else if (name == "assert") {
      question.assertions.push_back(&parts.at(1));
    } else if (name != "set-logic" && name != "set-option" && name != "check-sat") {
      throw std::invalid_argument("unknown command " + name);
    }
  }
  return question;
}

/// Adds the definitions of a model. @throws std::invalid_argument if it is none
void add_model(const std::vector<Expression>& model, Question& question) {
  if (model.size() != 1 || model[0].is_atom())
    throw std::invalid_argument("not a list of definitions");
  for (const Expression& definition : model[0].list) {
    // Before SMT-LIB 2.6 a model began with this word.
    if (definition.atom == "model" && &definition == model[0].list.data()) continue;
    const Function function = defined_function(definition);
    const std::string& name = definition.list[1].atom;
    const auto [place, added] = question.functions.emplace(name, function);
    // A function of the solver's own, for the definitions that follow.
    if (added) continue;
    // z3 repeats the definitions of the question, which hold whatever it says.
    if (place->second.body != nullptr) continue;
    if (!function.has_sorts_of(place->second)) {
      throw std::invalid_argument(fmt::format("{} is of another sort", name));
    }
    place->second = function;
  }
}

}  // namespace

std::string fault_of_model(std::string_view script, std::string_view model) {
  try {
    const auto commands = read_expressions(script);
    const auto definitions = read_expressions(model);
    const Question asked = question_in(commands);
    Question question = asked;
    add_model(definitions, question);
    Evaluator evaluator(question.functions);
    // In the order of the script, so that no long chain of definitions becomes a deep recursion.
    for (const std::string& name : question.constants) evaluator.value_of({.atom = name});
    for (std::size_t i = 0; i < question.assertions.size(); ++i) {
      const Value value = evaluator.value_of(*question.assertions[i]);
      if (value != Value{{Sort::Kind::boolean, 0}, 1}) {
        return fmt::format("it does not satisfy assertion {} of {}", i + 1,
                           question.assertions.size());
      }
    }
    // word_in_model() reads the model without the script. A constant that the script declares must
    // therefore have the same value without the script.
    Question alone;
    add_model(definitions, alone);
    Evaluator own(alone.functions);
    for (const auto& [name, function] : asked.functions) {
      if (function.body != nullptr || !function.parameters.empty()) continue;
      if (!alone.functions.contains(name)) continue;
      if (own.value_of({.atom = name}) != evaluator.value_of({.atom = name})) {
        return fmt::format("{} has another value in the question", name);
      }
    }
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  } catch (const std::out_of_range&) {
    return "a command is incomplete";
  }
}

std::uint64_t word_in_model(std::string_view model, std::string_view name) {
  const auto definitions = read_expressions(model);
  Question all;
  add_model(definitions, all);
  const auto found = all.functions.find(std::string(name));
  if (found == all.functions.end()) return 0;
  return static_cast<std::uint64_t>(
      Evaluator(all.functions).value_of({.atom = found->first}).number);
}

}  // namespace fixproof::proof
