#include "judge/type/goal.hpp"

#include <fmt/format.h>

#include <array>
#include <initializer_list>

namespace fixproof::judge {

namespace {

using cases::Format;
using cases::Operation;
using check::Rules;

constexpr int bits_of_int = 32;
constexpr Parameter int_operand{.bits = bits_of_int};

class Goals {
 public:
  std::vector<Goal> all() {
    for (const Format& format : proven_formats()) of_format(format);
    for (const NumberType& type : build_types()) {
      add("*", type, 2, "x * y", products(type.format, type.rules(Operation::mul), exact_product));
      divide(type);
    }
    return std::move(goals_);
  }

 private:
  void of_format(const Format& format) {
    using oracle::Rounding;
    for (const Range range : {Range::wrap, Range::saturate, Range::trap}) {
      for (const Rounding rounding : type_roundings()) {
        // Each rounding, and each range: not each pair.
        if (range != Range::wrap && rounding != Rounding::half_up) continue;
        const NumberType type = number_type(format, rounding, range);
        add("*", type, 2, "x * y", products(format, type.rules(Operation::mul), exact_product));
        divide(type);
        add("mul_add", type, 3, "mul_add(x, y, z)",
            products(format, type.rules(Operation::mul), exact_mul_add));
        if (rounding == Rounding::half_up) exact_operations(type);
      }
      for (const Format& to : proven_formats()) {
        if (to != format) convert(format, number_type(to, Rounding::half_up, range));
      }
    }
    // Every rounding of a conversion that drops the most bits.
    for (const Rounding rounding : type_roundings()) {
      if (rounding == Rounding::half_up || format == cases::q8_8) continue;
      convert(format, number_type(cases::q8_8, rounding, Range::wrap));
    }
    const NumberType type = number_type(format, Rounding::half_up, Range::wrap);
    compare(type);
    to_integers(type);
    forms(type);
  }

  void divide(const NumberType& type) { add("/", type, 2, "x / y", quotients(type)); }

  /// Operations without rounding, but of any range.
  void exact_operations(const NumberType& type) {
    const Format& format = type.format;
    const Rules rules = type.rules(Operation::mul);
    add("+", type, 2, "x + y", rounded(exact_sum(format, "bvadd"), rules));
    add("-", type, 2, "x - y", rounded(exact_sum(format, "bvsub"), rules));
    add("negation", type, 1, "-x", rounded(exact_negative(format), rules));
    add("abs", type, 1, "abs(x)", rounded(exact_magnitude(format), rules));
    add("%", type, 2, "x % y", remainders(type));
    for (const bool is_right : {false, true}) {
      Goal& goal = add(is_right ? ">>" : "<<", type, 1, is_right ? "x >> b" : "x << b",
                       rounded(exact_shift(format, is_right), rules));
      goal.signature.operands.push_back(int_operand);
    }
    for (const Format& integer : integers) {
      Goal& goal =
          add("from integer", type, 0, "N(a)", rounded(exact_conversion(integer, format), rules));
      goal.type = fmt::format("{} to {}", cpp_of(integer), type.name);
      goal.signature.operands = {operand(integer)};
    }
  }

  void to_integers(const NumberType& type) {
    for (const Format& integer : integers) {
      Rules rules = type.rules(Operation::mul);
      rules.variant.format = integer;
      rules.rounding = oracle::Rounding::truncate;
      Goal& goal =
          add("to integer", type, 1, "", rounded(exact_conversion(type.format, integer), rules));
      goal.type = fmt::format("{} to {}", type.name, cpp_of(integer));
      goal.body = with_numbers(type, 1, fmt::format("static_cast<{}>(x)", cpp_of(integer)));
      goal.signature.result_bits = integer.word_bits;
    }
  }

  void convert(const Format& from, const NumberType& to) {
    const NumberType of = number_type(from, oracle::Rounding::half_up, Range::wrap);
    Goal& goal = add("conversion", of, 1, "",
                     rounded(exact_conversion(from, to.format), to.rules(Operation::mul)));
    goal.type = fmt::format("{} to {}", cases::name_of(from), to.name);
    goal.body = with_numbers(of, 1, fmt::format("{}(x).raw()", to.cpp));
    goal.signature.result_bits = to.format.word_bits;
  }

  void compare(const NumberType& type) {
    const char* const sign = type.format.is_signed ? "s" : "u";
    const std::string less = fmt::format("(bv{}lt a b)", sign);
    const std::string more = fmt::format("(bv{}gt a b)", sign);
    const std::pair<const char*, std::string> rows[]{
        {"==", "(= a b)"}, {"!=", "(distinct a b)"},
        {"<", less},       {"<=", fmt::format("(not {})", more)},
        {">", more},       {">=", fmt::format("(not {})", less)},
    };
    for (const auto& [sign_of_it, truth] : rows) {
      Goal& goal = add(
          "comparison", type, 2, "",
          {stated({.may_fault = "false",
                   .is_right = fmt::format("(= {{0}} (ite {} (_ bv1 32) (_ bv0 32)))", truth)})});
      goal.type = fmt::format("{} {}", cases::name_of(type.format), sign_of_it);
      goal.body = with_numbers(type, 2, fmt::format("x {} y", sign_of_it));
      goal.signature.result_bits = bits_of_int;
    }
  }

  /// The functions of fixed/checked.hpp.
  void forms(const NumberType& wrap) {
    const Format& format = wrap.format;
    const NumberType saturate = number_type(format, wrap.products, Range::saturate);
    const auto both = [&](const char* name, const char* arguments, std::size_t operands,
                          const std::function<Statements(const NumberType&)>& of) {
      each_form(wrap, saturate, name, arguments, operands, of);
    };
    const auto exact = [](Exact value) {
      return [value = std::move(value)](const NumberType& type) {
        return rounded(value, type.rules(Operation::mul));
      };
    };
    both("add", "x, y", 2, exact(exact_sum(format, "bvadd")));
    both("subtract", "x, y", 2, exact(exact_sum(format, "bvsub")));
    both("negate", "x", 1, exact(exact_negative(format)));
    both("abs", "x", 1, exact(exact_magnitude(format)));
    both("shift_left", "x, b", 1, exact(exact_shift(format, false)));
    both("multiply", "x, y", 2, [&](const NumberType& type) {
      return products(format, type.rules(Operation::mul), exact_product);
    });
    both("mul_add", "x, y, z", 3, [&](const NumberType& type) {
      return products(format, type.rules(Operation::mul), exact_mul_add);
    });
    both("divide", "x, y", 2, quotients);
  }

  void each_form(const NumberType& wrap, const NumberType& saturate, const std::string& name,
                 const std::string& arguments, std::size_t operands,
                 const std::function<Statements(const NumberType&)>& of) {
    const auto add_form = [&](const std::string& operation, Form form, const std::string& result,
                              bool is_truth) {
      const NumberType& type = operation == "saturating_" ? saturate : wrap;
      Goal& goal = add(operation + "...", wrap, operands, "", in_form(form, of(type)));
      goal.type = fmt::format("{}, {}", cases::name_of(wrap.format), result);
      goal.body = with_numbers(wrap, operands, result);
      if (arguments == "x, b") goal.signature.operands.push_back(int_operand);
      if (is_truth) goal.signature.result_bits = bits_of_int;
    };
    const auto call = [&](const char* form) {
      return fmt::format("{}_{}({})", form, name, arguments);
    };
    add_form("checked_", Form::has_value, call("checked") + ".has_value()", true);
    add_form("checked_", Form::value_or_zero, call("checked") + ".value_or(N()).raw()", false);
    add_form("overflowing_", Form::overflows, call("overflowing") + ".overflow", true);
    add_form("overflowing_", Form::as_is, call("overflowing") + ".value.raw()", false);
    add_form("saturating_", Form::as_is, call("saturating") + ".raw()", false);
    add_form("wrapping_", Form::as_is, call("wrapping") + ".raw()", false);
  }

  /// Adds a goal about numbers x, y and z of a type, whose result is a number of it.
  Goal& add(std::string operation, const NumberType& type, std::size_t operands,
            const std::string& result, Statements statements) {
    return goals_.emplace_back(
        Goal{.operation = std::move(operation),
             .type = type.name,
             .format = cases::name_of(type.format),
             .body = with_numbers(type, operands, fmt::format("({}).raw()", result)),
             .symbol = fmt::format("goal_{}", goals_.size() + 1),
             .signature = {.operands = std::vector(operands, operand(type.format)),
                           .result_bits = type.format.word_bits},
             .says = std::move(statements)});
  }

  static std::string with_numbers(const NumberType& type, std::size_t operands,
                                  const std::string& result) {
    std::string body = fmt::format("using N = {}; ", type.cpp);
    for (std::size_t i = 0; i < operands; ++i) {
      body += fmt::format("const N {} = N::from_raw(static_cast<N::raw_type>({})); ", "xyz"[i],
                          "abc"[i]);
    }
    return body + fmt::format("return {};", result);
  }

  static Parameter operand(const Format& format) {
    return {.bits = format.word_bits, .is_signed = format.is_signed};
  }
  static std::string cpp_of(const Format& integer) {
    return fmt::format("std::{}int{}_t", integer.is_signed ? "" : "u", integer.word_bits);
  }

  static constexpr std::array<Format, 4> integers{
      {{32, 0, true}, {64, 0, true}, {32, 0, false}, {64, 0, false}}};

  std::vector<Goal> goals_;
};

/// A parameter or result: int or a wider integer, into which the convention puts a narrower one.
std::string cpp_of(int bits, bool is_signed) {
  return fmt::format("std::{}int{}_t", is_signed ? "" : "u", bits <= 32 ? 32 : 64);
}

}  // namespace

std::vector<Goal> goals() { return Goals().all(); }

std::string source_of(std::span<const Goal> goals) {
  std::string text =
      "#include <fixed/fixed.hpp>\nusing namespace fixproof;\n"
      "extern \"C\" {\n";
  for (const Goal& goal : goals) {
    std::string operands;
    for (std::size_t i = 0; i < goal.signature.operands.size(); ++i) {
      const Parameter& p = goal.signature.operands[i];
      operands +=
          fmt::format("{}{} {}", i == 0 ? "" : ", ", cpp_of(p.bits, p.is_signed), operand_name(i));
    }
    // Bits above the result may be anything, so its sign does not matter.
    text += fmt::format("{} {}({}) {{ {} }}\n", cpp_of(goal.signature.result_bits, true),
                        goal.symbol, operands, goal.body);
  }
  return text + "}\n";
}

}  // namespace fixproof::judge
