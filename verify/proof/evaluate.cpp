#include "verify/proof/evaluate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <stdexcept>
#include <string_view>

namespace fixproof::proof {

namespace {

using boost::multiprecision::cpp_int;
using Kind = Sort::Kind;
using Values = std::vector<Value>;

constexpr Sort boolean{Kind::boolean, 0};
constexpr Sort integer{Kind::integer, 0};
/// Of every bit vector: far more than any of the questions has.
constexpr unsigned max_width = 1024;
/// The largest integer, in bits and in decimal digits. Without a limit, a few definitions that each
/// square the one before would fill the memory.
constexpr unsigned max_integer_bits = 4096;
constexpr std::size_t max_digits = 1233;

[[noreturn]] void refuse(std::string_view what) { throw std::invalid_argument(std::string(what)); }

unsigned number_in(std::string_view text) {
  unsigned number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || number > max_width) {
    refuse(fmt::format("'{}' is not a size", text));
  }
  return number;
}

Value truth(bool is) { return {boolean, is ? 1 : 0}; }

/// Refuses a bit vector that has no bits, or too many.
unsigned checked_width(std::size_t width) {
  if (width == 0 || width > max_width) refuse(fmt::format("a bit vector has {} bits", width));
  return static_cast<unsigned>(width);
}

/// Keeps the lower `width` bits of any integer.
Value bits(unsigned width, const cpp_int& number) {
  checked_width(width);
  const cpp_int modulus = cpp_int(1) << width;
  cpp_int rest = number % modulus;
  if (rest < 0) rest += modulus;
  return {{Kind::bits, width}, rest};
}

bool is_true(const Value& value) {
  if (value.sort != boolean) refuse("not a Boolean, where one is needed");
  return value.number != 0;
}

cpp_int signed_of(const Value& value) {
  const cpp_int top = cpp_int(1) << (value.sort.width - 1);
  return value.number < top ? value.number : value.number - 2 * top;
}

/// Rounds towards zero, as SMT-LIB divides bit vectors.
cpp_int signed_remainder(const Value& a, const Value& b) {
  if (b.number == 0) return signed_of(a);
  return signed_of(a) % signed_of(b);
}
cpp_int signed_quotient(const Value& a, const Value& b) {
  if (b.number == 0) return signed_of(a) < 0 ? 1 : -1;
  return signed_of(a) / signed_of(b);
}

/// SMT-LIB's division of integers: the remainder is never negative.
cpp_int remainder(const cpp_int& a, const cpp_int& b) {
  if (b == 0) refuse("an integer division by zero");
  const cpp_int rest = a % b;
  return rest < 0 ? cpp_int(rest + abs(b)) : rest;
}

cpp_int shifted(const Value& a, const Value& by, bool left) {
  if (by.number >= a.sort.width) return 0;
  const auto places = static_cast<unsigned>(by.number);
  return left ? cpp_int(a.number << places) : cpp_int(a.number >> places);
}

using OfBits = std::function<cpp_int(const Value&, const Value&)>;
using OfBitsTruth = std::function<bool(const Value&, const Value&)>;

/// Operations of two bit vectors of one width, with a result of that width.
const std::map<std::string_view, OfBits>& arithmetic() {
  static const std::map<std::string_view, OfBits> all{
      {"bvadd", [](auto& a, auto& b) { return cpp_int(a.number + b.number); }},
      {"bvsub", [](auto& a, auto& b) { return cpp_int(a.number - b.number); }},
      {"bvmul", [](auto& a, auto& b) { return cpp_int(a.number * b.number); }},
      {"bvand", [](auto& a, auto& b) { return cpp_int(a.number & b.number); }},
      {"bvor", [](auto& a, auto& b) { return cpp_int(a.number | b.number); }},
      {"bvxor", [](auto& a, auto& b) { return cpp_int(a.number ^ b.number); }},
      {"bvudiv",
       [](auto& a, auto& b) { return b.number == 0 ? cpp_int(-1) : cpp_int(a.number / b.number); }},
      {"bvurem",
       [](auto& a, auto& b) { return b.number == 0 ? a.number : cpp_int(a.number % b.number); }},
      {"bvsdiv", signed_quotient},
      {"bvsrem", signed_remainder},
      {"bvshl", [](auto& a, auto& b) { return shifted(a, b, true); }},
      {"bvlshr", [](auto& a, auto& b) { return shifted(a, b, false); }}};
  return all;
}

const std::map<std::string_view, OfBitsTruth>& comparisons() {
  static const std::map<std::string_view, OfBitsTruth> all{
      {"bvult", [](auto& a, auto& b) { return a.number < b.number; }},
      {"bvule", [](auto& a, auto& b) { return a.number <= b.number; }},
      {"bvugt", [](auto& a, auto& b) { return a.number > b.number; }},
      {"bvuge", [](auto& a, auto& b) { return a.number >= b.number; }},
      {"bvslt", [](auto& a, auto& b) { return signed_of(a) < signed_of(b); }},
      {"bvsle", [](auto& a, auto& b) { return signed_of(a) <= signed_of(b); }},
      {"bvsgt", [](auto& a, auto& b) { return signed_of(a) > signed_of(b); }},
      {"bvsge", [](auto& a, auto& b) { return signed_of(a) >= signed_of(b); }}};
  return all;
}

bool all_of_sort(const Values& values, Sort sort) {
  return std::all_of(values.begin(), values.end(), [&](const Value& v) { return v.sort == sort; });
}

bool all_of_kind(const Values& values, Kind kind) {
  return std::all_of(values.begin(), values.end(),
                     [&](const Value& v) { return v.sort.kind == kind; });
}

/// Operations of bit vectors. @return false for another operation or other arguments
bool apply_to_bits(std::string_view name, const Values& of, Value& result) {
  if (of.empty() || !all_of_kind(of, Kind::bits)) return false;
  const unsigned width = of[0].sort.width;
  if (name == "concat") {
    result = of[0];
    for (std::size_t i = 1; i < of.size(); ++i) {
      const unsigned more = of[i].sort.width;
      if (result.sort.width + more > max_width) return false;
      result = bits(result.sort.width + more, (result.number << more) + of[i].number);
    }
    return true;
  }
  if (!all_of_sort(of, of[0].sort)) return false;
  if (of.size() == 1) {
    if (name == "bvneg") result = bits(width, -of[0].number);
    if (name == "bvnot") result = bits(width, -of[0].number - 1);
    return name == "bvneg" || name == "bvnot";
  }
  if (const auto found = arithmetic().find(name); found != arithmetic().end()) {
    result = of[0];
    for (std::size_t i = 1; i < of.size(); ++i) {
      result = bits(width, found->second(result, of[i]));
    }
    return true;
  }
  const auto found = comparisons().find(name);
  if (found == comparisons().end() || of.size() != 2) return false;
  result = truth(found->second(of[0], of[1]));
  return true;
}

/// Tells whether every neighbouring pair is in order.
template <class InOrder>
Value chained(const Values& of, InOrder in_order) {
  for (std::size_t i = 1; i < of.size(); ++i) {
    if (!in_order(of[i - 1].number, of[i].number)) return truth(false);
  }
  return truth(true);
}

bool apply_to_integers(std::string_view name, const Values& of, Value& result) {
  if (of.empty() || !all_of_sort(of, integer)) return false;
  if (name == "<") return result = chained(of, std::less<>()), true;
  if (name == "<=") return result = chained(of, std::less_equal<>()), true;
  if (name == ">") return result = chained(of, std::greater<>()), true;
  if (name == ">=") return result = chained(of, std::greater_equal<>()), true;
  result = of[0];
  if (name == "-" && of.size() == 1) return result.number = -of[0].number, true;
  for (std::size_t i = 1; i < of.size(); ++i) {
    const cpp_int& n = of[i].number;
    const cpp_int before = result.number;
    if (name == "+") result.number = before + n;
    if (name == "-") result.number = before - n;
    if (name == "*") result.number = before * n;
    if (name == "mod") result.number = remainder(before, n);
    if (name == "div") result.number = (before - remainder(before, n)) / n;
    if (result.number != 0 && msb(abs(result.number)) >= max_integer_bits) {
      refuse(fmt::format("an integer has more than {} bits", max_integer_bits));
    }
  }
  return name == "+" || name == "*" ||
         (of.size() > 1 && (name == "-" || name == "mod" || name == "div"));
}

bool apply_to_booleans(std::string_view name, const Values& of, Value& result) {
  if (!all_of_sort(of, boolean)) return false;
  const auto ones = std::count_if(of.begin(), of.end(), is_true);
  const auto all = static_cast<std::ptrdiff_t>(of.size());
  if (name == "and") return result = truth(ones == all), true;
  if (name == "or") return result = truth(ones > 0), true;
  if (name == "xor") return result = truth(ones % 2 == 1), true;
  if (name == "not" && all == 1) return result = truth(ones == 0), true;
  if (name == "=>" && all == 2) return result = truth(!is_true(of[0]) || is_true(of[1])), true;
  return false;
}

bool apply_to_any(std::string_view name, const Values& of, Value& result) {
  if (of.size() < 2 || !all_of_sort(of, of[0].sort)) return false;
  if (name == "=") {
    result = truth(std::all_of(of.begin(), of.end(), [&](const Value& v) { return v == of[0]; }));
    return true;
  }
  if (name != "distinct") return false;
  bool differ = true;
  for (std::size_t i = 0; i < of.size(); ++i) {
    differ = differ && std::find(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(i), of[i]) ==
                           of.begin() + static_cast<std::ptrdiff_t>(i);
  }
  result = truth(differ);
  return true;
}

/// `((_ NAME NUMBER...) ARGUMENT)`.
Value apply_indexed(const std::vector<Expression>& head, const Value& of) {
  if (of.sort.kind == Kind::bits && head.size() >= 3) {
    const std::string& name = head[1].atom;
    const unsigned first = number_in(head[2].atom);
    if (name == "extract" && head.size() == 4) {
      const unsigned last = number_in(head[3].atom);
      if (last <= first && first < of.sort.width) return bits(first - last + 1, of.number >> last);
    }
    if (name == "zero_extend") return bits(of.sort.width + first, of.number);
    if (name == "sign_extend") return bits(of.sort.width + first, signed_of(of));
  }
  refuse(fmt::format("cannot apply {}", text_of({.list = head})));
}

bool is_indexed(const Expression& expression) {
  return expression.list.size() >= 3 && expression.list[0].atom == "_";
}

cpp_int digits_in(std::string_view digits, unsigned bits_each) {
  cpp_int number = 0;
  for (const char c : digits) {
    const std::size_t digit = std::string_view("0123456789abcdef").find(static_cast<char>(c | ' '));
    if (digit >= std::size_t{1} << bits_each) refuse(fmt::format("'{}' is not a number", digits));
    number = (number << bits_each) + digit;
  }
  return number;
}

bool is_decimal(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

cpp_int decimal_in(std::string_view text) {
  // To cpp_int, a leading 0 means octal.
  const std::size_t first = text.find_first_not_of('0');
  if (first == std::string_view::npos) return 0;
  if (text.size() - first > max_digits) {
    refuse(fmt::format("a number has more than {} digits", max_digits));
  }
  return cpp_int(std::string(text.substr(first)));
}

}  // namespace

bool Function::has_sorts_of(const Function& other) const {
  return result == other.result &&
         std::equal(parameters.begin(), parameters.end(), other.parameters.begin(),
                    other.parameters.end(),
                    [](const auto& a, const auto& b) { return a.second == b.second; });
}

Sort sort_of(const Expression& expression) {
  if (expression.atom == "Bool") return boolean;
  if (expression.atom == "Int") return integer;
  if (is_indexed(expression) && expression.list.size() == 3 &&
      expression.list[1].atom == "BitVec") {
    if (const unsigned width = number_in(expression.list[2].atom); width > 0) {
      return {Kind::bits, width};
    }
  }
  refuse(fmt::format("unknown sort {}", text_of(expression)));
}

Function defined_function(const Expression& command) {
  const std::vector<Expression>& parts = command.list;
  if (parts.size() != 5 || parts[0].atom != "define-fun" || !parts[1].is_atom() ||
      parts[2].is_atom()) {
    refuse(fmt::format("not a definition: {}", text_of(command).substr(0, 60)));
  }
  Function function{.parameters = {}, .result = sort_of(parts[3]), .body = &parts[4]};
  for (const Expression& parameter : parts[2].list) {
    if (parameter.list.size() != 2) refuse("not a parameter");
    function.parameters.emplace_back(parameter.list[0].atom, sort_of(parameter.list[1]));
  }
  return function;
}

Value Evaluator::value_of(const Expression& term) { return value_of(term, {}); }

Value Evaluator::value_of(const Expression& term, const Scope& scope) {
  constexpr int max_depth = 1000;
  if (++depth_ > max_depth) refuse("nested too deeply");
  // A model may define functions that call each other so often that the value is never known.
  constexpr int max_steps = 1 << 20;
  if (++steps_ > max_steps) refuse("its evaluation takes too many steps");
  Value value = term.is_atom() ? value_of_atom(term.atom, scope) : value_of_list(term.list, scope);
  --depth_;
  return value;
}

Value Evaluator::value_of_atom(const std::string& atom, const Scope& scope) {
  const auto local = std::find_if(scope.rbegin(), scope.rend(),
                                  [&](const auto& entry) { return entry.first == atom; });
  if (local != scope.rend()) return local->second;
  if (atom == "true" || atom == "false") return truth(atom == "true");
  if (atom.size() > 2 && (atom.starts_with("#b") || atom.starts_with("#x"))) {
    const unsigned each = atom[1] == 'b' ? 1 : 4;
    const std::string_view digits = std::string_view(atom).substr(2);
    const unsigned width = checked_width(digits.size() * each);
    return bits(width, digits_in(digits, each));
  }
  if (is_decimal(atom)) return {integer, decimal_in(atom)};
  const auto found = functions_.find(atom);
  if (found == functions_.end()) refuse(fmt::format("unknown name {}", atom));
  return call(atom, found->second, {});
}

Value Evaluator::value_of_list(const std::vector<Expression>& list, const Scope& scope) {
  if (list.empty()) refuse("an empty list");
  if (list[0].atom == "_") {
    // A literal, (_ bvNUMBER WIDTH).
    const std::string& name = list.size() == 3 ? list[1].atom : list[0].atom;
    const std::string_view digits =
        std::string_view(name).substr(std::min<std::size_t>(2, name.size()));
    if (!name.starts_with("bv") || !is_decimal(digits)) {
      refuse(fmt::format("unknown literal {}", text_of({.list = list})));
    }
    return bits(number_in(list[2].atom), decimal_in(digits));
  }
  if (list[0].atom == "let" && list.size() == 3) {
    Scope inner = scope;
    for (const Expression& binding : list[1].list) {
      if (binding.list.size() != 2) refuse("not a binding of let");
      inner.emplace_back(binding.list[0].atom, value_of(binding.list[1], scope));
    }
    return value_of(list[2], inner);
  }
  if (list[0].atom == "ite" && list.size() == 4) {
    return value_of(is_true(value_of(list[1], scope)) ? list[2] : list[3], scope);
  }
  Values of;
  for (std::size_t i = 1; i < list.size(); ++i) of.push_back(value_of(list[i], scope));
  if (is_indexed(list[0]) && of.size() == 1) return apply_indexed(list[0].list, of[0]);
  // Operations come first, so that no model can define them anew.
  const std::string& name = list[0].atom;
  Value result;
  if (apply_to_bits(name, of, result) || apply_to_integers(name, of, result) ||
      apply_to_booleans(name, of, result) || apply_to_any(name, of, result)) {
    return result;
  }
  const auto found = functions_.find(name);
  if (found == functions_.end()) {
    refuse(fmt::format("cannot apply {} to {} arguments", text_of(list[0]), of.size()));
  }
  return call(name, found->second, std::move(of));
}

Value Evaluator::call(const std::string& name, const Function& function, Values arguments) {
  const bool is_constant = function.parameters.empty();
  if (const auto known = constants_.find(name); is_constant && known != constants_.end()) {
    return known->second;
  }
  if (arguments.size() != function.parameters.size()) {
    refuse(fmt::format("{} has {} parameters", name, function.parameters.size()));
  }
  Scope scope;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].sort != function.parameters[i].second) {
      refuse(fmt::format("argument {} of {} has another sort", i + 1, name));
    }
    scope.emplace_back(function.parameters[i].first, std::move(arguments[i]));
  }
  Value value =
      function.body == nullptr ? Value{function.result, 0} : value_of(*function.body, scope);
  if (value.sort != function.result) refuse(fmt::format("{} is of another sort", name));
  if (is_constant) constants_.emplace(name, value);
  return value;
}

}  // namespace fixproof::proof
