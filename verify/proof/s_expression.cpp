#include "verify/proof/s_expression.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace fixproof::proof {

std::vector<Expression> read_expressions(std::string_view text) {
  constexpr std::string_view space = " \t\r\n";
  // Questions and models nest far less deeply. The limit bounds the recursion of every function
  // that walks an expression.
  constexpr std::size_t max_depth = 1000;
  std::vector<std::vector<Expression>> open(1);
  while (!text.empty()) {
    const char first = text.front();
    if (space.find(first) != std::string_view::npos) {
      text.remove_prefix(1);
    } else if (first == ';') {
      text.remove_prefix(std::min(text.find('\n'), text.size()));
    } else if (first == '(') {
      if (open.size() > max_depth) throw std::invalid_argument("nested too deeply");
      open.emplace_back();
      text.remove_prefix(1);
    } else if (first == ')') {
      if (open.size() == 1) throw std::invalid_argument("one ) too many");
      Expression list{.list = std::move(open.back())};
      open.pop_back();
      open.back().push_back(std::move(list));
      text.remove_prefix(1);
    } else {
      const std::size_t end = std::min(text.find_first_of(" \t\r\n();"), text.size());
      open.back().push_back({.atom = std::string(text.substr(0, end))});
      text.remove_prefix(end);
    }
  }
  if (open.size() > 1) throw std::invalid_argument("a ) is missing");
  return std::move(open.front());
}

std::string text_of(const Expression& expression) {
  if (expression.is_atom()) return expression.atom;
  std::string text = "(";
  for (const Expression& part : expression.list) {
    if (text.size() > 1) text += ' ';
    text += text_of(part);
  }
  return text + ')';
}

}  // namespace fixproof::proof
