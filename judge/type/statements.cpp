#include "judge/type/statements.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace fixproof::judge {

using cases::Format;
using check::Rules;

namespace {

/// The errors of the type end in UD2, because it is compiled without exceptions. It never faults.
Claim raised(Claim claim) {
  claim.may_trap = std::exchange(claim.may_fault, "false");
  return claim;
}

}  // namespace

Statements stated(const Claim& claim) {
  const Statement statement = [claim](x86model::symbolic::Terms& /*terms*/, const Path& /*path*/) {
    return claim;
  };
  return {{statement}, statement};
}

Statements rounded(const Exact& exact, const Rules& rules) {
  return stated(raised(rounded_claim(exact, rules)));
}

Statements any_of(const std::vector<Statements>& all) {
  Statements any;
  for (const Statements& each : all) {
    any.ways.insert(any.ways.end(), each.ways.begin(), each.ways.end());
    any.definition = each.definition;
  }
  return any;
}

Statements products(const Format& format, const Rules& rules,
                    Exact (*exact)(const Format&, Shape)) {
  std::vector<Statements> all;
  for (const Shape shape : {Shape::of_signed, Shape::of_magnitudes, Shape::of_extended}) {
    if (has_product(format, shape)) all.push_back(rounded(exact(format, shape), rules));
  }
  return any_of(all);
}

namespace {

/// The divide of the operands themselves.
/// @param places that the dividend is shifted by
MachineDivide own_divide(x86model::symbolic::Terms& t, const NumberType& type, int places) {
  constexpr int bits = 64;
  const Format& format = type.format;
  const auto extended = [&](std::size_t operand) {
    const auto word = t.variable(operand_name(operand), format.word_bits);
    return format.is_signed ? t.sign_extend(word, bits) : t.zero_extend(word, bits);
  };
  auto dividend = extended(0);
  auto divisor = extended(1);
  if (type.divide.divides_by_whole_part) {
    const int f = format.fraction_bits;
    const auto zero = t.constant(0, bits);
    const auto is_negative = t.bit(divisor, bits - 1);
    const auto whole = [&](x86model::symbolic::Term size) {
      return t.zero_extend(t.extract(size, f, bits - f), bits);
    };
    divisor = t.ite(is_negative, t.sub(zero, whole(t.sub(zero, divisor))), whole(divisor));
  } else if (places > 0) {
    dividend = t.concat(t.extract(dividend, 0, bits - places), t.constant(0, places));
  }
  const auto apply = [&](const char* name) { return t.apply(name, {dividend, divisor}, bits); };
  return {.dividend = dividend,
          .divisor = divisor,
          .quotient = apply(quotient_64),
          .remainder = apply(remainder_64)};
}

}  // namespace

Statements quotients(const NumberType& type) {
  if (type.format.word_bits > 32) return {};
  const Rules rules = type.rules(cases::Operation::div);
  const auto statement = [&](auto divide_on, bool halves) -> Statement {
    return [=](x86model::symbolic::Terms& terms, const Path& path) {
      return raised(*quotient_claim(rules, terms, divide_on(terms, path), halves, type.divide));
    };
  };
  const auto own = [type](x86model::symbolic::Terms& terms, const Path& /*path*/) {
    return std::optional(own_divide(terms, type, type.format.fraction_bits));
  };
  return {{statement(divide_of, false), statement(divide_of, true)}, statement(own, false)};
}

Statements remainders(const NumberType& type) {
  if (type.format.word_bits > 32) return {};
  Rules rules = type.rules(cases::Operation::div);
  rules.overflow = check::Overflow::wrap;  // every remainder is in range
  const auto statement = [&](auto divide_on) -> Statement {
    return [=](x86model::symbolic::Terms& terms, const Path& path) {
      const auto divide = divide_on(terms, path);
      Claim claim = rounded_claim(exact_remainder(type.format, terms, divide), rules);
      if (divide) {
        claim.mentions = {divide->dividend, divide->divisor, divide->quotient, divide->remainder};
      }
      // A zero divisor is an error, or has the remainder 0.
      const std::string zero = fmt::format("(= b (_ bv0 {}))", type.format.word_bits);
      const bool refuses = rules.no_result == check::NoResult::error;
      claim.may_trap = refuses ? zero : "false";
      claim.may_fault = "false";
      claim.is_right =
          fmt::format("(ite {} (and {} (= {{0}} (_ bv0 {}))) (and is-of-operands {}))", zero,
                      refuses ? "false" : "true", type.format.word_bits, claim.is_right);
      return claim;
    };
  };
  const auto own = [type](x86model::symbolic::Terms& terms, const Path& /*path*/) {
    return std::optional(own_divide(terms, type, 0));
  };
  return {{statement(divide_of)}, statement(own)};
}

namespace {

/// Changes a statement about a result to one about what a form returns of it.
Statement in_form(Form form, const Statement& statement) {
  return [form, statement](x86model::symbolic::Terms& terms, const Path& path) {
    Claim claim = statement(terms, path);
    claim.may_trap = "false";
    switch (form) {
      case Form::has_value:
        claim.is_right = "(= {0} (ite (and fits (not lacks)) (_ bv1 32) (_ bv0 32)))";
        break;
      case Form::overflows:
        claim.is_right = "(= {0} (ite (and fits (not lacks)) (_ bv0 32) (_ bv1 32)))";
        break;
      case Form::value_or_zero:
        claim.is_right =
            "(ite (and fits (not lacks)) (and found (= {0} cut)) (= {0} (bvxor cut cut)))";
        break;
      case Form::as_is:
        break;
    }
    return claim;
  };
}

}  // namespace

Statements in_form(Form form, const Statements& of) {
  Statements all;
  for (const Statement& way : of.ways) all.ways.push_back(in_form(form, way));
  if (of.definition) all.definition = in_form(form, of.definition);
  return all;
}

}  // namespace fixproof::judge
