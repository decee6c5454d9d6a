// Products and quotients of the sizes that listings lack. A product of numbers of up to 32 bits,
// however wide the instruction, is the abstract function smul32 or umul32 of them: the ones that
// claims speak of.
#include <optional>
#include <utility>
#include <vector>

#include "judge/code/abstract_functions.hpp"
#include "judge/code/user_instructions.hpp"

namespace fixproof::judge {

namespace {

using NumberTerm = x86model::symbolic::Term;
using x86model::Register;
using x86model::symbolic::Node;
using x86model::symbolic::Op;
using x86model::symbolic::Terms;

constexpr std::uint64_t lowest_64 = std::uint64_t{1} << 63U;

NumberTerm extended(Terms& t, NumberTerm value, int bits, bool is_signed) {
  return is_signed ? t.sign_extend(value, bits) : t.zero_extend(value, bits);
}

/// CMOVcc makes choices of choices; each of more levels than this would double the time.
constexpr int max_choices = 8;

/// The number of 32 bits that a term of 64 extends, if it does.
std::optional<NumberTerm> narrowed(Terms& t, NumberTerm wide, bool is_signed,
                                   int choices = max_choices) {
  const Node node = t[wide];
  if (node.op == Op::constant) {
    const NumberTerm low = t.extract(wide, 0, 32);
    return extended(t, low, 64, is_signed) == wide ? std::optional(low) : std::nullopt;
  }
  if (node.op == Op::ite && choices > 0) {
    const auto yes = narrowed(t, node.arguments[1], is_signed, choices - 1);
    const auto no = yes ? narrowed(t, node.arguments[2], is_signed, choices - 1) : std::nullopt;
    return no ? std::optional(t.ite(node.arguments[0], *yes, *no)) : std::nullopt;
  }
  if (is_signed && node.op == Op::sign_extend && t.width(node.arguments[0]) <= 32) {
    return t.sign_extend(node.arguments[0], 32);
  }
  const bool has_zeros =
      node.op == Op::concat && t.is_constant(node.arguments[0]) && t.value(node.arguments[0]) == 0;
  if (has_zeros && t.width(node.arguments[1]) <= (is_signed ? 31 : 32)) {
    return t.zero_extend(node.arguments[1], 32);
  }
  return std::nullopt;
}

NumberTerm applied(Terms& t, const char* function, std::vector<NumberTerm> arguments, int width) {
  bool are_constant = true;
  std::vector<std::uint64_t> values;
  for (const NumberTerm each : arguments) {
    are_constant &= t.is_constant(each);
    values.push_back(t.value(each));
  }
  if (are_constant) return t.constant(concrete_function(function, values), width);
  return t.apply(function, std::move(arguments), width);
}

/// A product of two terms by an abstract function. Factors commute, so they are in the order in
/// which they were made.
NumberTerm product_of(Terms& t, const char* function, NumberTerm x, NumberTerm y) {
  if (y < x) std::swap(x, y);
  return applied(t, function, {x, y}, 64);
}

/// Two numbers of 32 bits.
struct Factors {
  NumberTerm x;
  NumberTerm y;
};

/// The numbers that two terms of 64 bits extend, if both do. Their product is exact.
std::optional<Factors> narrow_factors(Terms& t, NumberTerm x, NumberTerm y, bool is_signed) {
  const auto a = narrowed(t, x, is_signed);
  const auto b = narrowed(t, y, is_signed);
  return a && b ? std::optional(Factors{*a, *b}) : std::nullopt;
}

/// A quotient times its divisor: the dividend less the remainder, modulo 2^64. Compilers so take a
/// remainder, or compare one with zero. Operands for which the divide faults are not on this path.
std::optional<NumberTerm> product_of_quotient(Terms& t, NumberTerm x, NumberTerm y) {
  const Node node = t[x];
  if (node.op != Op::apply || node.arguments.size() != 2 || node.arguments[1] != y) return {};
  const char* const remainder = node.name == quotient_64            ? remainder_64
                                : node.name == unsigned_quotient_64 ? unsigned_remainder_64
                                                                    : nullptr;
  if (remainder == nullptr) return {};
  return t.sub(node.arguments[0], t.apply(remainder, node.arguments, 64));
}

/// A product of a word of copies of one bit, which is 0 or -1.
std::optional<NumberTerm> product_of_sign(Terms& t, NumberTerm x, NumberTerm y) {
  const Node node = t[x];
  if (node.op != Op::sign_extend || t.width(node.arguments[0]) != 1) return {};
  const NumberTerm zero = t.constant(0, 64);
  return t.ite(t.bit(node.arguments[0], 0), t.sub(zero, y), zero);
}

/// The low half of a product of numbers of 64 bits.
NumberTerm low_product(Terms& t, NumberTerm x, NumberTerm y) {
  for (const auto known : {product_of_quotient, product_of_sign}) {
    if (const auto product = known(t, x, y)) return *product;
    if (const auto product = known(t, y, x)) return *product;
  }
  return product_of(t, low_product_64, x, y);
}

struct WideProduct {
  NumberTerm low;
  NumberTerm high;
};

/// The product of two numbers of 64 bits.
WideProduct wide_product(Terms& t, NumberTerm x, NumberTerm y, bool is_signed) {
  const auto of_signed = narrow_factors(t, x, y, true);
  const auto of_unsigned = narrow_factors(t, x, y, false);
  const NumberTerm low = of_signed     ? product_of(t, "smul32", of_signed->x, of_signed->y)
                         : of_unsigned ? product_of(t, "umul32", of_unsigned->x, of_unsigned->y)
                                       : low_product(t, x, y);
  // Two numbers of 32 bits without sign have a product of 64 bits, for IMUL too.
  if (of_unsigned) return {low, t.constant(0, 64)};
  if (of_signed && is_signed) return {low, t.sign_extend(t.extract(low, 63, 1), 64)};
  return {low, product_of(t, is_signed ? signed_high_product_64 : unsigned_high_product_64, x, y)};
}

/// The product of two numbers of up to 32 bits: 64 bits.
NumberTerm exact_product(Terms& t, NumberTerm x, NumberTerm y, bool is_signed) {
  return wide_product(t, extended(t, x, 64, is_signed), extended(t, y, 64, is_signed), is_signed)
      .low;
}

/// CF and OF tell whether the product needs more than its low half; the others are undefined.
void set_product_flags(const Execution& e, NumberTerm needs_more) {
  e.m.flags = x86model::alu::product(e.d, needs_more, needs_more).flags;
}

/// MUL and IMUL of the accumulator: bytes to AX, 64 bits to RDX:RAX.
void multiply_accumulator(const Execution& e, bool is_signed) {
  const NumberTerm x = e.read_register(Register::ax, e.bits);
  const NumberTerm y = e.value(0);
  WideProduct product{};
  if (e.bits == 8) {
    const NumberTerm exact = exact_product(e.t, x, y, is_signed);
    product = {e.t.extract(exact, 0, 8), e.t.extract(exact, 8, 8)};
    e.write_register(Register::ax, e.t.extract(exact, 0, 16));
  } else {
    product = wide_product(e.t, x, y, is_signed);
    e.write_register(Register::ax, product.low);
    e.write_register(Register::dx, product.high);
  }
  const NumberTerm extension = is_signed ? e.sign_of(product.low) : e.zero();
  set_product_flags(e, e.t.negation(e.t.equal(product.high, extension)));
}

/// What a divide leaves, and whether it faults.
struct DivideTerms {
  NumberTerm quotient;
  NumberTerm remainder;
  NumberTerm faults;
};

/// AX by a byte: as a divide of a dividend of 32 bits, whose quotient has 16.
DivideTerms byte_divide(const Execution& e, NumberTerm divisor, bool is_signed) {
  const NumberTerm dividend = e.read_register(Register::ax, 16);
  const std::vector<NumberTerm> both{extended(e.t, dividend, 32, is_signed),
                                     extended(e.t, divisor, 16, is_signed)};
  const NumberTerm quotient = applied(e.t, is_signed ? "sdiv16" : "udiv16", both, 16);
  const NumberTerm remainder = applied(e.t, is_signed ? "srem16" : "urem16", both, 16);
  const NumberTerm low = e.t.extract(quotient, 0, 8);
  const NumberTerm faults =
      is_signed ? e.t.either(applied(e.t, "sfault16", both, 0),
                             e.t.negation(e.t.equal(quotient, e.t.sign_extend(low, 16))))
                : x86model::alu::div_faults(e.d, e.t.extract(dividend, 8, 8), divisor);
  return {low, e.t.extract(remainder, 0, 8), faults};
}

/// RDX:RAX by 64 bits. A dividend that fits 64 bits has functions of its own.
DivideTerms unsigned_divide_64(const Execution& e, NumberTerm divisor) {
  const NumberTerm high = e.read_register(Register::dx, 64);
  const NumberTerm low = e.read_register(Register::ax, 64);
  if (high == e.zero()) {
    return {applied(e.t, unsigned_quotient_64, {low, divisor}, 64),
            applied(e.t, unsigned_remainder_64, {low, divisor}, 64), e.is_zero(divisor)};
  }
  return {applied(e.t, unsigned_quotient_128, {high, low, divisor}, 64),
          applied(e.t, unsigned_remainder_128, {high, low, divisor}, 64),
          x86model::alu::div_faults(e.d, high, divisor)};
}

DivideTerms signed_divide_64(const Execution& e, NumberTerm divisor) {
  const NumberTerm high = e.read_register(Register::dx, 64);
  const NumberTerm low = e.read_register(Register::ax, 64);
  if (high != e.sign_of(low)) {
    return {applied(e.t, signed_quotient_128, {high, low, divisor}, 64),
            applied(e.t, signed_remainder_128, {high, low, divisor}, 64),
            applied(e.t, signed_quotient_overflows_128, {high, low, divisor}, 0)};
  }
  const NumberTerm does_not_fit = e.t.both(e.t.equal(low, e.number(lowest_64)),
                                           e.t.equal(divisor, e.number(~std::uint64_t{0})));
  return {applied(e.t, quotient_64, {low, divisor}, 64),
          applied(e.t, remainder_64, {low, divisor}, 64),
          e.t.either(e.is_zero(divisor), does_not_fit)};
}

void divide_accumulator(const Execution& e, bool is_signed) {
  const NumberTerm divisor = e.value(0);
  const DivideTerms divide = e.bits == 8 ? byte_divide(e, divisor, is_signed)
                             : is_signed ? signed_divide_64(e, divisor)
                                         : unsigned_divide_64(e, divisor);
  e.m.faults_if(divide.faults);
  if (e.bits == 8) {
    e.write_register(Register::ax, e.t.concat(divide.remainder, divide.quotient));
  } else {
    e.write_register(Register::ax, divide.quotient);
    e.write_register(Register::dx, divide.remainder);
  }
  e.m.flags = e.d.undefined_flags();
}

}  // namespace

namespace meaning {

void mul(const Execution& e) { multiply_accumulator(e, false); }
void imul(const Execution& e) { multiply_accumulator(e, true); }
void div(const Execution& e) { divide_accumulator(e, false); }
void idiv(const Execution& e) { divide_accumulator(e, true); }

void imul_to_register(const Execution& e) {
  const NumberTerm x = e.value(e.count() - 2);
  const NumberTerm y = e.value(e.count() - 1);
  if (e.bits == 64) {
    const WideProduct product = wide_product(e.t, x, y, true);
    e.write(0, product.low);
    set_product_flags(e, e.t.negation(e.t.equal(product.high, e.sign_of(product.low))));
    return;
  }
  const NumberTerm product = exact_product(e.t, x, y, true);
  const NumberTerm low = e.t.extract(product, 0, e.bits);
  e.write(0, low);
  set_product_flags(e, e.t.negation(e.t.equal(product, e.t.sign_extend(low, 64))));
}

/// The high half goes to the first operand, also if both are the same.
void mulx(const Execution& e) {
  const NumberTerm x = e.read_register(Register::dx, e.bits);
  const NumberTerm y = e.value(2);
  WideProduct product{};
  if (e.bits == 64) {
    product = wide_product(e.t, x, y, false);
  } else {
    const NumberTerm exact = exact_product(e.t, x, y, false);
    product = {e.t.extract(exact, 0, 32), e.t.extract(exact, 32, 32)};
  }
  e.write(1, product.low);
  e.write(0, product.high);
}

}  // namespace meaning

}  // namespace fixproof::judge
